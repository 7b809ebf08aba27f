#include "coupling/assessments/calibrate/search/emulator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <utility>

#include "coupling/assessments/calibrate/search/ruled_search.hpp"
#include "coupling/assessments/calibrate/search/ruling.hpp"
#include "coupling/assessments/calibrate/search/self_distance.hpp"

namespace coupling::calibrate::emulator_test {
namespace {

/// Chance of a test.
class Chance {
public:
    explicit Chance(std::uint32_t seed) : engine_{seed} {}
    double uniform() { return uniform_(engine_); }
    double normal() { return normal_(engine_); }
    Point point(std::size_t dimensions) {
        return point_by_widths(dimensions, [&] { return uniform(); });
    }

private:
    std::mt19937 engine_;
    std::uniform_real_distribution<double> uniform_{0.0, 1.0};
    std::normal_distribution<double> normal_;
};

TEST(Emulators, FollowAPolynomialOfTheSecondDegree) {
    Chance chance{1};
    const auto figure = [](const Point& x) { return 2.0 - x[0] + 0.5 * x[1] * x[2] + 0.25 * x[2] * x[2]; };
    std::vector<Point> points;
    std::vector<double> values;
    for (int i = 0; i < 60; ++i) {
        points.push_back(chance.point(3));
        values.push_back(figure(points.back()));
    }
    const std::vector<Emulator> emulators = fitted_emulators(points, {values});
    ASSERT_EQ(emulators.size(), 1U);
    EXPECT_EQ(emulators.front().form, Form::full);
    EXPECT_LT(emulators.front().error, 1e-3);
    EXPECT_NEAR(emulators.front().explained, 1.0, 1e-5);
    const Point elsewhere = chance.point(3);
    EXPECT_NEAR(emulators.front().at(terms_at(elsewhere)), figure(elsewhere), 1e-3);
}

TEST(Emulators, JudgeThemselvesBySetsThatAreLeftOut) {
    Chance chance{2};
    std::vector<Point> points;
    std::vector<double> values;
    for (int i = 0; i < 9; ++i) {  // too few for squares
        points.push_back(chance.point(2));
        values.push_back(points.back()[0] + chance.normal());
    }
    double squares = 0.0;
    for (std::size_t out = 0; out < points.size(); ++out) {
        std::vector<Point> others = points;
        std::vector<double> their_values = values;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(out));
        their_values.erase(their_values.begin() + static_cast<std::ptrdiff_t>(out));
        const Emulator without = fitted_emulators(others, {their_values}).front();
        squares += std::pow(values[out] - without.at(terms_at(points[out])), 2);
    }
    const Emulator emulator = fitted_emulators(points, {values}).front();
    EXPECT_EQ(emulator.form, Form::linear);
    EXPECT_NEAR(emulator.error, std::sqrt(squares / 9.0), 1e-4);
}

TEST(Emulators, AreNoneOfTooFewSets) {
    Chance chance{3};
    EXPECT_TRUE(fitted_emulators({chance.point(4)}, {{1.0}}).empty());
    EXPECT_TRUE(fitted_emulators({}, {}).empty());
}

/// Keeps |x_0| <= 0.6: a figure that is x_0, seen as 0.
Ruling of_first_number() {
    Ruling ruling;
    ruling.rules.push_back({0, {Form::linear, {0.0, 1.0, 0.0}, 0.2, 1.0}, 0.0, 0.2});
    return ruling;
}
const double left_of_first_number = std::erf(0.6 / std::sqrt(2.0)) / std::erf(3.0 / std::sqrt(2.0));

TEST(Rulings, LeaveTheShareOfTheWidthsThatTheyKeep) {
    Chance chance{4};
    const std::vector<Ruling> rulings{of_first_number()};
    const double share = share_left(rulings, 2, [&] { return chance.uniform(); });
    const double p = left_of_first_number;
    EXPECT_NEAR(share, p, 4.0 * std::sqrt(p * (1.0 - p) / 20'000));
    const std::vector<double> shares = shares_ruled_out(rulings, 2, {1}, 2, [&] { return chance.uniform(); });
    EXPECT_EQ(shares[0], 0.0);
    EXPECT_NEAR(shares[1], 1.0 - p, 4.0 * std::sqrt(p * (1.0 - p) / 20'000));
}

/// Sets of all rounds together, weighted, are a sample by the widths: nothing is lost of what is ruled out.
TEST(Rulings, LeaveWeightedSetsThatStandForAllOfTheWidths) {
    Chance chance{5};
    std::vector<Ruling> rulings{of_first_number()};
    rulings.front().left = left_of_first_number;
    constexpr std::uint64_t first = 4'000;
    const std::vector<RuledRound> rounds{{.sets = 8'000, .not_run = 0, .checks = 0.05}};
    std::vector<Point> points;
    for (std::uint64_t i = 0; i < first + rounds.front().sets; ++i) {
        const bool is_check = i >= first && chance.uniform() < rounds.front().checks;
        Point point = chance.point(2);
        while (i >= first && keep(rulings, point) == is_check) {
            point = chance.point(2);
        }
        points.push_back(point);
    }
    // Means over the widths, with standard errors from the weighted terms themselves.
    const auto expect_mean = [&](double known, const auto& figure) {
        std::vector<double> terms;
        for (const Point& point : points) {
            terms.push_back(mixture_weight(point, first, rounds, rulings) * figure(point));
        }
        const double sum = std::accumulate(terms.begin(), terms.end(), 0.0);
        double squares = 0.0;
        for (const double term : terms) {
            squares += term * term;
        }
        EXPECT_NEAR(sum, known, 4.0 * std::sqrt(squares)) << "not a sample of the widths";
        EXPECT_LT(4.0 * std::sqrt(squares), 0.2 * known) << "says nothing";
    };
    expect_mean(1.0, [](const Point&) { return 1.0; });
    expect_mean(left_of_first_number, [&](const Point& x) { return std::abs(x[0]) <= 0.6 ? 1.0 : 0.0; });
    expect_mean(1.0 - left_of_first_number, [&](const Point& x) { return std::abs(x[0]) > 0.6 ? 1.0 : 0.0; });
    expect_mean(0.9973,
                [](const Point& x) { return x[0] * x[0] + 0.014; });  // variance of the cut normal: 0.9733
}

/// Forty values around a mean that is no polynomial of the parameters, one of which decides their spread.
Sample shown_by(const Point& x, Chance& chance) {
    const double mean = 4.0 * std::tanh(0.6 * x[0]) + 0.5 * x[1];
    const double spread = std::exp(0.4 * x[2]);
    std::vector<double> values;
    for (int i = 0; i < 40; ++i) {
        values.push_back(mean + spread * chance.normal());
    }
    return sample_of_values(values);
}

/// Of sets by the widths: those within the goal, and of these those that a ruling cuts off.
struct Lost {
    double kept = 0.0;
    double lost = 0.0;
    double lost_if_bold = 0.0;  ///< with a quarter of the deviations
    double left = 0.0;
};
Lost count_lost(std::uint32_t seed) {
    constexpr std::size_t dimensions = 4;
    Chance chance{seed};
    const Point truth = 0.7 * chance.point(dimensions);
    const Sample observed = shown_by(truth, chance);
    std::vector<std::vector<Sample>> at_truth;
    std::vector<std::vector<double>> summaries;
    for (int i = 0; i < 20; ++i) {
        at_truth.push_back({shown_by(truth, chance)});
        add_summary(at_truth.back().front(), {}, summaries.emplace_back());
    }
    const SelfDistance scale = self_distance(at_truth, {{40, 0}}, seed, 3);
    std::vector<Point> points;
    std::vector<std::vector<double>> first(300);
    std::vector<std::pair<double, std::size_t>> nearest;
    for (std::vector<double>& summary : first) {
        points.push_back(chance.point(dimensions));
        const Sample shown = shown_by(points.back(), chance);
        add_summary(shown, {}, summary);
        nearest.emplace_back(energy_distance(observed, shown), nearest.size());
    }
    std::sort(nearest.begin(), nearest.end());
    std::vector<Fallen> fallen;
    std::vector<Fallen> near;
    for (std::size_t i = 0; i < points.size(); ++i) {
        fallen.push_back({&points[i], &first[i]});
        if (const std::size_t k = nearest[i].second; i < 20) {
            near.push_back({&points[k], &first[k]});
        }
    }
    std::vector<double> seen;
    add_summary(observed, {}, seen);
    const std::vector<Ruling> rulings{
        ruling_of({}, fallen, seen, tolerated(deviations_of(summaries), near, seen))};
    std::vector<Ruling> bold = rulings;
    for (Rule& rule : bold.front().rules) {
        rule.deviation *= 0.25;
    }
    Lost lost;
    for (int i = 0; i < 4'000; ++i) {
        const Point point = chance.point(dimensions);
        const bool is_left = keep(rulings, point);
        lost.left += is_left ? 1.0 / 4'000 : 0.0;
        if (scale.together({energy_distance(observed, shown_by(point, chance))}) <= scale.at_90) {
            lost.kept += 1.0;
            lost.lost += is_left ? 0.0 : 1.0;
            lost.lost_if_bold += keep(bold, point) ? 0.0 : 1.0;
        }
    }
    return lost;
}

/// What an unrestricted search keeps lies in what is left, but for one in a hundred.
TEST(Rulings, CutOffNothingThatAnUnrestrictedSearchKeeps) {
    Lost all;
    for (std::uint32_t seed = 1; seed <= 6; ++seed) {
        const Lost lost = count_lost(seed);
        all.kept += lost.kept;
        all.lost += lost.lost;
        all.lost_if_bold += lost.lost_if_bold;
        all.left += lost.left / 6.0;
    }
    ASSERT_GT(all.kept, 400.0);
    EXPECT_LT(all.left, 0.7) << "hardly anything is ruled out: the test says nothing";
    const double stated = 0.01 * all.kept;
    EXPECT_LE(all.lost, stated + 4.0 * std::sqrt(stated));
    EXPECT_GT(all.lost_if_bold, stated + 4.0 * std::sqrt(stated)) << "the count would not see a bad bound";
}

TEST(Emulates, ByItselfWhereRocksHaveAShape) {
    int by_themselves = 0;
    for (const rockfall::MotionModel model : rockfall::all_models()) {
        const bool has_shape = rockfall::description_of(model).has_shape;
        by_themselves += has_shape ? 1 : 0;
        EXPECT_EQ(emulates(Emulates::by_model, model), has_shape);
        EXPECT_TRUE(emulates(Emulates::yes, model));
        EXPECT_FALSE(emulates(Emulates::no, model));
    }
    EXPECT_EQ(by_themselves, 1) << "rigid blocks";
}

}  // namespace
}  // namespace coupling::calibrate::emulator_test
