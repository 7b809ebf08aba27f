#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <set>

#include "config/random/distributions.hpp"
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

/// Sets that were drawn by the widths and moved by figures that say nothing: so often does one parameter seem
/// to be learned.
double share_learned_of_nothing(int sets, int figures, bool are_weights_equal, double true_width) {
    std::mt19937 engine{static_cast<std::uint32_t>(sets + figures)};
    std::uniform_real_distribution<double> uniform;
    std::normal_distribution<double> normal;
    std::exponential_distribution<double> weight;
    const config::TruncatedNormal within_cut_off{3.0};
    const Space space{{{.parameter = "losses", .width = 0.2}}};
    constexpr int repetitions = 2000;
    int found = 0;
    for (int repetition = 0; repetition < repetitions; ++repetition) {
        std::vector<Member> members;
        double sum = 0.0;
        for (int i = 0; i < sets; ++i) {
            const double own = are_weights_equal ? 1.0 : weight(engine);
            members.push_back(
                {.point = Point::Constant(1, true_width * within_cut_off(uniform(engine))), .weight = own});
            for (int figure = 0; figure < figures; ++figure) {
                members.back().summary.push_back(normal(engine));
            }
            sum += own;
        }
        for (Member& member : members) {
            member.weight /= sum;
        }
        adjust(members, std::vector<double>(static_cast<std::size_t>(figures), 0.0));
        found += learned_of(space, members, static_cast<std::size_t>(figures)).front().is_beyond_chance();
    }
    return static_cast<double>(found) / repetitions;
}

TEST(Learned, IsBeyondChanceInOneOfTwentyCasesWhereNothingWas) {
    constexpr double scatter = 0.005;  // of a share of 5 % among 2000
    EXPECT_NEAR(share_learned_of_nothing(74, 0, true, 1.0), 0.05, 4.0 * scatter);
    EXPECT_NEAR(share_learned_of_nothing(500, 0, true, 1.0), 0.05, 4.0 * scatter);
    EXPECT_NEAR(share_learned_of_nothing(150, 0, false, 1.0), 0.05, 5.0 * scatter);
    EXPECT_NEAR(share_learned_of_nothing(150, 10, false, 1.0), 0.05, 5.0 * scatter);
    EXPECT_GT(share_learned_of_nothing(74, 0, true, 0.7), 0.95) << "a third narrower";
}

TEST(Learned, NeedsLessWithMoreSets) {
    // 1 - sqrt(q / 100) with the 5 % quantile 77.046 of chi-square with 99 degrees of freedom.
    EXPECT_NEAR(learned_by_chance(100.0, 0), 1.0 - std::sqrt(77.046 / 100.0), 1e-5);
    EXPECT_LT(learned_by_chance(500.0, 0), 0.06);
    EXPECT_GT(learned_by_chance(74.0, 10), learned_by_chance(74.0, 0));
    EXPECT_EQ(learned_by_chance(1.0, 0), 1.0);
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
