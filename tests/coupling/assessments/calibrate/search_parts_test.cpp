#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <set>

#include "coupling/assessments/calibrate/model/sample.hpp"
#include "coupling/assessments/calibrate/model/source_distance.hpp"
#include "coupling/assessments/calibrate/search/adjustment.hpp"
#include "coupling/assessments/calibrate/search/learned.hpp"
#include "coupling/assessments/calibrate/search/search_part.hpp"
#include "coupling/assessments/calibrate/search/self_distance.hpp"
#include "tests/coupling/inputs/sample_project.hpp"

namespace coupling::calibrate::search_parts_test {
namespace {

/// Places or values between -50 and 50.
Sample any_sample(bool is_plane, std::size_t least) {
    Sample sample{.is_plane = is_plane};
    const auto size = least + *rc::gen::inRange<std::size_t>(0, 20);
    for (std::size_t i = 0; i < size; ++i) {
        const double x = 0.01 * *rc::gen::inRange(-5000, 5000);
        sample.points.emplace_back(x, is_plane ? 0.01 * *rc::gen::inRange(-5000, 5000) : 0.0);
    }
    return sample;
}

RC_GTEST_PROP(EnergyDistance, IsThatOfItsDefinition, ()) {
    const bool is_plane = *rc::gen::arbitrary<bool>();
    const Sample a = any_sample(is_plane, 1);
    const Sample b = any_sample(is_plane, 1);
    const double by_definition = 2.0 * mean_distance(a, b) - mean_distance(a, a) - mean_distance(b, b);
    RC_ASSERT(std::abs(energy_distance(a, b) - by_definition) < 1e-9);
    RC_ASSERT(std::abs(energy_distance(a, a)) < 1e-9);
    RC_ASSERT(std::abs(energy_distance(a, b) - energy_distance(b, a)) < 1e-9);
}

TEST(EnergyDistance, OfNothingIsInfinite) {
    EXPECT_TRUE(std::isinf(energy_distance({}, sample_of_values({1.0}))));
}

RC_GTEST_PROP(SourceDistances, AreThoseOfAllPairs, ()) {
    const auto size = *rc::gen::inRange<std::size_t>(1, 30);
    const double step = 0.5 * *rc::gen::inRange(1, 20);
    std::vector<double> values;
    for (std::size_t i = 0; i < size; ++i) {
        values.push_back(*rc::gen::element(0.0, 1e20, 25.0, 3.0));
    }
    std::vector<double> added = values;
    add_distances(added, step);
    for (std::size_t i = 0; i < size; ++i) {
        double least = 1e300;
        for (std::size_t k = 0; k < size; ++k) {
            const double off = step * (static_cast<double>(i) - static_cast<double>(k));
            least = std::min(least, values[k] + off * off);
        }
        RC_ASSERT(std::abs(added[i] - least) <= 1e-9 * std::max(1.0, least));
    }
}

RC_GTEST_PROP(DrawnSamples, RepeatNothingWhileThereIsEnough, ()) {
    std::vector<double> values(*rc::gen::inRange<std::size_t>(1, 40));
    std::iota(values.begin(), values.end(), 0.0);
    const Sample pool = sample_of_values(values);
    std::mt19937 engine{*rc::gen::arbitrary<std::uint32_t>()};
    std::uniform_real_distribution<double> uniform{0.0, 1.0};
    const auto wanted = *rc::gen::inRange<std::size_t>(1, values.size() + 1);
    const Sample drawn = drawn_from({&pool}, 1, wanted, [&] { return uniform(engine); });
    std::set<double> different;
    for (const Eigen::Vector2d& point : drawn.points) {
        different.insert(point.x());
    }
    RC_ASSERT(drawn.size() == wanted);
    RC_ASSERT(different.size() == wanted);
}

/// One unknown number z of which z + noise is seen: known of it then is normal with half the value seen and a
/// variance of a half.
TEST(Adjustment, GivesTheKnownAnswerOfANormalModel) {
    std::mt19937 engine{7};
    std::normal_distribution<double> normal;
    constexpr int sets = 4000;
    constexpr double seen = 0.8;
    std::vector<Member> members;
    for (int i = 0; i < sets; ++i) {
        Member member{.point = Point::Constant(1, normal(engine)), .weight = 1.0 / sets};
        member.summary = {member.point[0] + normal(engine)};
        members.push_back(std::move(member));
    }
    adjust(members, {seen});
    double mean = 0.0;
    double squares = 0.0;
    for (const Member& member : members) {
        mean += member.point[0] / sets;
    }
    for (const Member& member : members) {
        squares += (member.point[0] - mean) * (member.point[0] - mean) / sets;
    }
    // Four standard errors; the ridge takes one hundredth of the slope.
    EXPECT_NEAR(mean, 0.5 * seen, 4.0 * std::sqrt(0.5 / sets) + 0.01);
    EXPECT_NEAR(squares, 0.5, 4.0 * 0.5 * std::sqrt(2.0 / sets) + 0.01);
}

/// Eight figures that say nothing of a number, and sets of unequal weights: the number stays as wide as it
/// was.
TEST(Adjustment, LearnsNothingFromFiguresThatSayNothing) {
    std::mt19937 engine{11};
    std::normal_distribution<double> normal;
    std::exponential_distribution<double> weight;
    constexpr int sets = 100;
    constexpr int repetitions = 200;
    double ratio = 0.0;
    for (int repetition = 0; repetition < repetitions; ++repetition) {
        std::vector<Member> members;
        double sum = 0.0;
        for (int i = 0; i < sets; ++i) {
            Member member{.point = Point::Constant(1, 0.5 * normal(engine)), .weight = weight(engine)};
            for (int figure = 0; figure < 8; ++figure) {
                member.summary.push_back(normal(engine));
            }
            sum += member.weight;
            members.push_back(std::move(member));
        }
        const auto variance = [&] {
            double mean = 0.0;
            double squares = 0.0;
            for (const Member& member : members) {
                mean += member.weight * member.point[0];
                squares += member.weight * member.point[0] * member.point[0];
            }
            return squares - mean * mean;
        };
        for (Member& member : members) {
            member.weight /= sum;
        }
        const double before = variance();
        adjust(members, std::vector<double>(8, 0.0));
        ratio += variance() / before / repetitions;
    }
    // Without the widening 1 - 8 * 2 / 100 = 0.84. The ratio of one repetition scatters by less than a tenth.
    EXPECT_NEAR(ratio, 1.0, 4.0 * 0.1 / std::sqrt(repetitions));
}

TEST(Adjustment, MovesNothingWithTooFewSets) {
    std::vector<Member> members(9, {.point = Point::Ones(1), .weight = 1.0 / 9.0, .summary = {1.0, 2.0}});
    adjust(members, {3.0, 4.0});
    EXPECT_EQ(members.front().point[0], 1.0);
}

/// Sets as a search draws them: by a normal density of so many times the variance of what was known before,
/// cut off as that is, with weights that make up for it.
struct Drawn {
    int sets = 0;
    Eigen::Index parameters = 1;
    double variance = 1.0;
    int figures = 0;          ///< that say nothing of any parameter
    double true_width = 1.0;  ///< of what is known
};

std::vector<Member> members_of(const Drawn& drawn, std::mt19937& engine) {
    std::normal_distribution<double> normal;
    std::vector<Member> members;
    double sum = 0.0;
    for (int i = 0; i < drawn.sets; ++i) {
        Member member{.point = Point::Zero(drawn.parameters)};
        for (double& number : member.point) {
            do {
                number = std::sqrt(drawn.variance) * normal(engine);
            } while (std::abs(number) > 3.0);
        }
        member.weight = std::exp(-0.5 * (1.0 - 1.0 / drawn.variance) * member.point.squaredNorm());
        member.point *= drawn.true_width;
        for (int figure = 0; figure < drawn.figures; ++figure) {
            member.summary.push_back(normal(engine));
        }
        sum += member.weight;
        members.push_back(std::move(member));
    }
    for (Member& member : members) {
        member.weight /= sum;
    }
    return members;
}

constexpr int repetitions = 2000;

/// So often does the first parameter seem to be learned.
double share_beyond_chance(const Drawn& drawn) {
    std::mt19937 engine{static_cast<std::uint32_t>(drawn.sets + drawn.figures)};
    const Space space{std::vector<ParameterDraws::Component>(static_cast<std::size_t>(drawn.parameters),
                                                             {.parameter = "losses", .width = 0.2})};
    int found = 0;
    for (int repetition = 0; repetition < repetitions; ++repetition) {
        std::vector<Member> members = members_of(drawn, engine);
        const Adjustment adjustment =
            adjust(members, std::vector<double>(static_cast<std::size_t>(drawn.figures), 0.0));
        found += learned_of(space, members, adjustment).front().is_beyond_chance() ? 1 : 0;
    }
    return static_cast<double>(found) / repetitions;
}

/// Within four standard errors of a share of 5 % among so many, for equal weights and for unequal ones. With
/// as many degrees of freedom as equal sets of the same worth have, 1 % of the weighted ones are beyond.
TEST(Learned, IsBeyondChanceInOneOfTwentyCasesWhereNothingWas) {
    const double allowed = 4.0 * std::sqrt(0.05 * 0.95 / repetitions);
    EXPECT_NEAR(share_beyond_chance({.sets = 74}), 0.05, allowed);
    EXPECT_NEAR(share_beyond_chance({.sets = 500}), 0.05, allowed);
    EXPECT_NEAR(share_beyond_chance({.sets = 74, .figures = 10}), 0.05, allowed);
    EXPECT_NEAR(share_beyond_chance({.sets = 200, .parameters = 5, .variance = 2.0}), 0.05, allowed);
    EXPECT_NEAR(share_beyond_chance({.sets = 200, .parameters = 5, .variance = 3.0}), 0.05, allowed);
    EXPECT_NEAR(share_beyond_chance({.sets = 200, .parameters = 5, .variance = 2.0, .figures = 8}), 0.05,
                allowed);
}

/// A narrow sample has the level of one of which nothing is known.
TEST(Learned, IsSeenWhereMuchIs) {
    EXPECT_GT(share_beyond_chance({.sets = 74, .true_width = 0.7}), 0.95) << "a third narrower";
    EXPECT_GT(share_beyond_chance({.sets = 200, .parameters = 5, .variance = 2.0, .true_width = 0.7}), 0.95);
}

Adjustment nothing_moved(std::size_t sets) {
    return {.before = {}, .pulls = std::vector<double>(sets, 0.0)};
}

TEST(Learned, OfEqualWeightsHasTheLevelOfASampleVariance) {
    std::mt19937 engine{3};
    std::normal_distribution<double> normal;
    const auto level = [&](std::size_t sets, double width) {
        std::vector<double> values(sets);
        std::generate(values.begin(), values.end(), [&] { return width * normal(engine); });
        const std::vector<double> weights(sets, 1.0 / static_cast<double>(sets));
        return chance_of(values, weights, nothing_moved(sets));
    };
    // 1 - sqrt(q / 100) with the 5 % quantile 77.046 of chi-square with 99 degrees of freedom, whatever the
    // values are.
    EXPECT_NEAR(level(100, 1.0).degrees, 99.0, 1e-9);
    EXPECT_NEAR(level(100, 1.0).narrower(), 1.0 - std::sqrt(77.046 / 100.0), 1e-5);
    EXPECT_NEAR(level(100, 0.3).narrower(), 1.0 - std::sqrt(77.046 / 100.0), 1e-5);
    EXPECT_LT(level(500, 1.0).narrower(), 0.06);
    EXPECT_EQ(level(1, 1.0).narrower(), 1.0) << "one set says nothing";
    EXPECT_TRUE(std::isinf(level(1, 1.0).wider()));
}

TEST(Learned, TakesTheDegreesThatTheRegressionFollowed) {
    std::mt19937 engine{5};
    const std::vector<double> observed(8, 0.0);
    std::vector<Member> few = members_of({.sets = 39, .figures = 8}, engine);
    const Adjustment none = adjust(few, observed);
    EXPECT_EQ(none.followed, 0.0) << "fewer than five sets a figure: nothing moves";
    EXPECT_FALSE(none.is_capped);
    std::vector<Member> unknown = members_of({.sets = 80, .figures = 8}, engine);
    unknown.front().summary.front() = std::nan("");
    EXPECT_EQ(adjust(unknown, observed).followed, 0.0);
    // Of equal weights as many hundredths as figures, but for the ridge.
    std::vector<Member> enough = members_of({.sets = 100, .figures = 8}, engine);
    const Adjustment moved = adjust(enough, observed);
    EXPECT_NEAR(moved.followed, 0.08, 0.002);
    EXPECT_FALSE(moved.is_capped);
    // Weights of which few count: the plane goes through these.
    std::vector<Member> unequal = members_of({.sets = 80, .figures = 8}, engine);
    for (std::size_t i = 0; i < unequal.size(); ++i) {
        unequal[i].weight = i < 8 ? 0.12 : 0.04 / 72.0;
    }
    const Adjustment capped = adjust(unequal, observed);
    EXPECT_TRUE(capped.is_capped);
    const Space space{{{.parameter = "losses", .width = 0.2}}};
    EXPECT_TRUE(learned_of(space, unequal, capped).front().has_too_few_sets());
    EXPECT_FALSE(learned_of(space, unequal, capped).front().is_beyond_chance());
}

TEST(SelfDistances, CountObservationsByWhatTheyCanTell) {
    std::mt19937 engine{3};
    std::normal_distribution<double> normal;
    std::vector<std::vector<Sample>> sets(10);
    for (std::vector<Sample>& set : sets) {
        std::vector<double> values(300);
        std::generate(values.begin(), values.end(), [&] { return normal(engine); });
        set = {sample_of_values(values), sample_of_values(values)};
    }
    const SelfDistance scale = self_distance(sets, {{10, 0}, {200, 1}}, 1, 3);
    EXPECT_GT(scale.medians[0], 3.0 * scale.medians[1]);
    EXPECT_GT(scale.at_90, scale.together(scale.medians));
    EXPECT_GT(scale.at_95, scale.at_90);
    // What was not observed counts nothing.
    const SelfDistance one = self_distance(sets, {{10, 0}, {0, 1}}, 1, 3);
    EXPECT_EQ(one.together({one.medians[0], 1e9}), 1.0);
}

// The same rocks seen twice tell as much as once: distances of both together have the quantiles of one.
TEST(SelfDistances, OfTwoViewsOfTheSameRocksAreThoseOfOne) {
    std::mt19937 engine{5};
    std::normal_distribution<double> normal;
    std::vector<std::vector<Sample>> sets(10);
    for (std::vector<Sample>& set : sets) {
        std::vector<double> values(300);
        std::generate(values.begin(), values.end(), [&] { return normal(engine); });
        set = {sample_of_values(values), sample_of_values(values)};
    }
    const SelfDistance twice = self_distance(sets, {{40, 0}, {40, 0}}, 1, 3);
    const SelfDistance once = self_distance(sets, {{40, 0}, {0, 1}}, 1, 3);
    EXPECT_EQ(twice.medians[0], twice.medians[1]);
    EXPECT_DOUBLE_EQ(twice.at_90, once.at_90);
    EXPECT_LT(self_distance(sets, {{40, 0}, {40, 1}}, 1, 3).at_90, once.at_90);
}

TEST(Clouds, HaveWeightedMeansAndCovariances) {
    const Cloud cloud = cloud_of({Point::Constant(1, 0.0), Point::Constant(1, 4.0)}, {3.0, 1.0});
    EXPECT_DOUBLE_EQ(cloud.mean[0], 1.0);
    EXPECT_DOUBLE_EQ(cloud.covariance(0, 0), 3.0);
}

TEST(SearchParts, ComeBackAsTheyWere) {
    const SampleProject project;
    SearchState state;
    state.waves = {{.tolerance = 2.5, .goal = 1.5, .tried = 100, .kept = 30}};
    state.first = {{Point::Constant(3, 0.25), 0.5, {1.0, 2.0}, {3.0}, {4.0, 5.0, 6.0}}};
    state.population = {{Point::Constant(3, -0.25), 1.0, {7.0, 8.0}, {9.0}, {}}};
    state.scale = {{0.5, 0.25}, 3.0, 4.0};
    state.begun = {.tolerance = 2.0, .goal = 1.25, .tried = 17, .kept = 0};
    state.accepted = state.population;
    state.is_done = true;
    state.end = SearchEnd::budget;
    state.ruled.fallen = state.first;
    state.ruled.rounds = {{.sets = 64, .not_run = 12, .checks = 0.05}};
    state.ruled.rulings = {{{{2, {Form::squares, {1.0, 2.0, 3.0}, 0.5, 0.75}, 4.0, 0.625}}, 0.125}};
    state.ruled.scatter = {0.25};
    state.ruled.beyond = 3;
    state.ruled.beyond_kept = 2;
    state.ruled.beyond_weight = 0.0625;
    write_search(project.file("search.part"), state);
    const SearchState back = read_search(project.file("search.part"));
    EXPECT_EQ(back.waves.front().tolerance, 2.5);
    EXPECT_EQ(back.first.front().figures, state.first.front().figures);
    EXPECT_EQ(back.population.front().point, state.population.front().point);
    EXPECT_EQ(back.population.front().summary, state.population.front().summary);
    EXPECT_EQ(back.scale.medians, state.scale.medians);
    EXPECT_EQ(back.tried(), 117U);
    EXPECT_EQ(back.accepted.size(), 1U);
    EXPECT_TRUE(back.is_done);
    EXPECT_EQ(back.end, SearchEnd::budget);
    EXPECT_EQ(back.ruled.fallen.front().figures, state.first.front().figures);
    EXPECT_EQ(back.ruled.not_run(), 12U);
    EXPECT_EQ(back.ruled.rounds.front().checks, 0.05);
    EXPECT_EQ(back.left(), 0.125);
    const Rule& rule = back.ruled.rulings.front().rules.front();
    EXPECT_EQ(rule.figure, 2U);
    EXPECT_EQ(rule.emulator.form, Form::squares);
    EXPECT_EQ(rule.emulator.coefficients, (std::vector<double>{1.0, 2.0, 3.0}));
    EXPECT_EQ(rule.emulator.error, 0.5);
    EXPECT_EQ(rule.emulator.explained, 0.75);
    EXPECT_EQ(rule.observed, 4.0);
    EXPECT_EQ(rule.deviation, 0.625);
    EXPECT_EQ(back.ruled.scatter, state.ruled.scatter);
    EXPECT_EQ(back.ruled.beyond, 3U);
    EXPECT_EQ(back.ruled.beyond_kept, 2U);
    EXPECT_EQ(back.ruled.beyond_weight, 0.0625);
    const std::string bytes = project.read("search.part");
    project.write("search.part", bytes.substr(0, bytes.size() / 2));
    EXPECT_THROW((void)read_search(project.file("search.part")), config::InputError);
}

}  // namespace
}  // namespace coupling::calibrate::search_parts_test
