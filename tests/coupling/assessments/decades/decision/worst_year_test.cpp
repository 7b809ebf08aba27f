#include "coupling/assessments/decades/decision/worst_year.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "coupling/assessments/decades/decision/decision.hpp"
#include "coupling/assessments/decades/decision/drawn_protection.hpp"

namespace coupling::decades::worst_year_test {
namespace {

constexpr int years = 40;

DrawnProtection protection_of(const CourseYears& seen, double at_least_percent) {
    std::vector<std::int32_t> rock_years(years);
    std::iota(rock_years.begin(), rock_years.end(), 1);
    return drawn_protection(seen, {}, {.protection_at_least_percent = at_least_percent, .years_beyond = 0.0},
                            rock_years);
}

/// Synthetic forests under one regime. Those of one stand differ by where they are, by what fades and, with
/// events, by storms at times of their own; all are cut in years 12 and 32.
struct SyntheticStand {
    double base = 0.0, stays = 0.0, fades = 0.0, rho = 0.0, cut = 0.0;
    double events = 0.0;  ///< a forest, in all years

    struct Course {
        std::vector<double> protection;  ///< [year - 1]
        std::vector<std::int32_t> events;
    };
    Course course(std::mt19937& engine) const {
        std::normal_distribution<double> normal;
        std::uniform_real_distribution<double> uniform;
        Course made;
        std::vector<double> lost(years + 1, 0.0);
        const int count = events > 0.0 ? std::poisson_distribution<int>{events}(engine) : 0;
        for (int i = 0; i < count; ++i) {
            const int first = 1 + static_cast<int>(uniform(engine) * years);
            const double depth = 0.02 + 0.10 * uniform(engine);
            made.events.push_back(first);
            for (int year = first; year <= years; ++year) {
                lost[static_cast<std::size_t>(year)] += depth * std::exp(-(year - first) / 8.0);
            }
        }
        const double own = stays * normal(engine);
        double now = fades / std::sqrt(1.0 - rho * rho) * normal(engine);
        for (int year = 1; year <= years; ++year) {
            now = rho * now + fades * normal(engine);
            const double since_cut = year >= 12 ? (year - 12) % 20 : 1e9;
            made.protection.push_back(std::clamp(
                base + own + now - cut * std::exp(-since_cut / 6.0) - lost[static_cast<std::size_t>(year)],
                0.0, 0.995));
        }
        return made;
    }
};

struct Judged {
    int inside = 0;           ///< of the interval of the probability
    int inside_of_count = 0;  ///< of that of a mere count
    int yes = 0, wrong_yes = 0;
    int years_inside = 0;  ///< of the interval of the years below
};

/// Stands with 20 replicates, `arriving` rocks over the bare slope in a year.
Judged judged(int stands, double arriving, bool with_events) {
    Judged found;
    for (int stand = 0; stand < stands; ++stand) {
        std::mt19937 engine{static_cast<std::uint32_t>(stand + 1)};
        const auto between = [&](double low, double high) {
            return std::uniform_real_distribution<double>{low, high}(engine);
        };
        const SyntheticStand law{.base = between(0.65, 0.86),
                                 .stays = between(0.005, 0.04),
                                 .fades = between(0.003, 0.015),
                                 .rho = between(0.5, 0.95),
                                 .cut = between(0.0, 0.15),
                                 .events = with_events ? 1.0 : 0.0};
        std::vector<double> lowest;
        std::vector<double> all_values;
        for (int i = 0; i < 3000; ++i) {
            const auto course = law.course(engine);
            lowest.push_back(*std::min_element(course.protection.begin(), course.protection.end()));
            all_values.insert(all_values.end(), course.protection.begin(), course.protection.end());
        }
        std::sort(lowest.begin(), lowest.end());
        const double threshold = lowest[static_cast<std::size_t>(between(0.03, 0.5) * 3000.0)];
        const double probability =
            static_cast<double>(lowest.end() - std::lower_bound(lowest.begin(), lowest.end(), threshold)) /
            3000.0;
        const double years_below =
            static_cast<double>(std::count_if(all_values.begin(), all_values.end(),
                                              [&](double value) { return value < threshold; })) /
            3000.0;
        CourseYears seen{.of_replicates = {}, .rock_variances = {}, .breaks = {12, 32}};
        std::size_t kept = 0;
        for (int replicate = 0; replicate < 20; ++replicate) {
            const auto course = law.course(engine);
            std::map<std::int32_t, double> values;
            std::map<std::int32_t, double> variances;
            for (int year = 1; year <= years; ++year) {
                const double p = course.protection[static_cast<std::size_t>(year - 1)];
                const double variance = p * (1.0 - p) / arriving;
                const double value = std::normal_distribution<double>{p, std::sqrt(variance)}(engine);
                values[year] = 100.0 * std::min(1.0, value);
                variances[year] = 1e4 * variance;
            }
            kept += std::all_of(values.begin(), values.end(),
                                [&](const auto& each) { return each.second >= 100.0 * threshold; })
                        ? 1
                        : 0;
            seen.of_replicates.push_back(std::move(values));
            seen.rock_variances.push_back(std::move(variances));
            seen.events.push_back(course.events);
        }
        const DrawnProtection drawn = protection_of(seen, 100.0 * threshold);
        const WorstYear& worst = *drawn.worst;
        found.years_inside +=
            drawn.years_below.low <= years_below && years_below <= drawn.years_below.high ? 1 : 0;
        found.inside += worst.at(0.05) <= probability && probability <= worst.at(0.95) ? 1 : 0;
        const KeptShare count = kept_share(kept, 20);
        found.inside_of_count += count.low <= probability && probability <= count.high ? 1 : 0;
        const bool is_yes = worst.at(0.05) >= 0.8;
        found.yes += is_yes ? 1 : 0;
        found.wrong_yes += is_yes && probability < 0.8 ? 1 : 0;
    }
    return found;
}

/// What a share of so many stands may be off, twice its deviation.
double twice_deviation(int stands) {
    return 2.0 * std::sqrt(0.9 * 0.1 / stands);
}

/// Returns the share of all intervals that hold.
double expect_honest(int stands) {
    double inside = 0.0;
    for (const bool with_events : {false, true}) {
        for (const double arriving : {60.0, 250.0}) {
            const Judged found = judged(stands, arriving, with_events);
            const auto share = [&](int count) { return static_cast<double>(count) / stands; };
            inside += share(found.inside) / 4.0;
            EXPECT_GT(share(found.inside), 0.90 - twice_deviation(stands)) << with_events << arriving;
            EXPECT_LT(share(found.wrong_yes), 0.05) << with_events << arriving;
            EXPECT_GT(found.yes, 0) << "it says something";
            // The lowest of 40 noisy years is not that of the forest: a count of them does not hold.
            EXPECT_LT(share(found.inside_of_count), 0.90 - twice_deviation(stands))
                << with_events << arriving;
            std::printf(
                "events %d, %.0f rocks arrive: 90 %% intervals hold %.1f %% of %d, of a count %.1f %%, of "
                "years below %.1f %%; yes %d, wrong %d\n",
                with_events ? 1 : 0, arriving, 100.0 * share(found.inside), stands,
                100.0 * share(found.inside_of_count), 100.0 * share(found.years_inside), found.yes,
                found.wrong_yes);
        }
    }
    return inside;
}

TEST(WorstYears, AreThoseOfTheForestAndNotOfItsRocks) {
    expect_honest(25);
}

TEST(LongWorstYears, OfAThousandStandsAreThoseOfTheForest) {
    const double inside = expect_honest(250);
    EXPECT_GT(inside, 0.87);
    EXPECT_LT(inside, 0.93) << "wider than it says is as wrong";
}

TEST(WorstYears, WithoutNoiseAreCounted) {
    CourseYears seen;
    for (int replicate = 0; replicate < 20; ++replicate) {
        seen.of_replicates.push_back({{1, 95.0}, {2, replicate < 15 ? 91.0 : 80.0}});
    }
    const DrawnProtection drawn = protection_of(seen, 90.0);
    const WorstYear& worst = *drawn.worst;
    // Jeffreys: Beta(15.5, 5.5); 1000 draws scatter its ends.
    EXPECT_NEAR(worst.median(), 0.744, 0.02);
    EXPECT_NEAR(worst.at(0.05), 0.570, 0.04);
    EXPECT_NEAR(worst.at(0.95), 0.881, 0.03);
    EXPECT_EQ(protection_of(seen, 90.0).worst->median(), worst.median())
        << "the same course, the same answer";
    EXPECT_NEAR(drawn.years_below.mean, 5.0 / 20.0, 0.01);
    EXPECT_NEAR(drawn.percent_years_lost.mean, 5.0 * 10.0 / 20.0, 0.05);
    EXPECT_EQ(drawn.lowest->year, 2);
    EXPECT_NEAR(drawn.lowest->value.band.mean, (15.0 * 91.0 + 5.0 * 80.0) / 20.0, 0.05);
}

TEST(WorstYears, TakeSixReplicates) {
    CourseAtTarget at;
    CourseYears seen;
    for (const std::size_t replicates : {1U, 5U, 6U}) {
        seen.of_replicates.assign(replicates, {{1, 95.0}});
        at.forest = protection_of(seen, 90.0);
        at.kept = kept_share(replicates, replicates);
        EXPECT_EQ(at.worst() != nullptr, replicates >= 6);
    }
    seen.of_replicates.assign(3, {});  // no year is known
    const DrawnProtection nothing = protection_of(seen, 90.0);
    EXPECT_FALSE(nothing.worst);
    EXPECT_FALSE(nothing.lowest);
    EXPECT_TRUE(std::isnan(nothing.years_below.mean));
}

/// No figure of a course contradicts another: all are sums over the same drawn courses.
RC_GTEST_PROP(DrawnProtection, SaysTheSameInAllItsFigures, ()) {
    std::mt19937 engine{*rc::gen::arbitrary<std::uint32_t>()};
    std::normal_distribution<double> normal;
    const auto replicates = *rc::gen::inRange<std::size_t>(1, 25);
    const double noise = 0.5 * *rc::gen::inRange(0, 20);
    const double at_least = 60.0 + *rc::gen::inRange(0, 30);
    CourseYears seen;
    std::vector<double> weights;
    std::vector<std::int32_t> rock_years;
    for (std::int32_t year = 1; year <= 12; year += *rc::gen::inRange(1, 4)) {
        rock_years.push_back(year);
    }
    for (std::size_t r = 0; r < replicates; ++r) {
        seen.of_replicates.emplace_back();
        seen.rock_variances.emplace_back();
        weights.push_back(1.0 + *rc::gen::inRange(0, 50));
        const double own = 75.0 + 5.0 * normal(engine);
        for (const std::int32_t year : rock_years) {
            seen.of_replicates[r][year] = own + noise * normal(engine);
            seen.rock_variances[r][year] = noise * noise;
        }
    }
    const DecisionSettings settings{.protection_at_least_percent = at_least, .years_beyond = 7.0};
    const DrawnProtection drawn = drawn_protection(seen, weights, settings, rock_years);
    double below = 0.0;
    double lost = 0.0;
    std::map<std::int32_t, double> mean_in_year;
    const double all_weights = std::accumulate(weights.begin(), weights.end(), 0.0);
    for (std::size_t r = 0; r < replicates; ++r) {
        std::int32_t before = 0;
        for (const ForestYear& year : drawn.records[r]->years) {
            RC_ASSERT(year.stands_for_years == static_cast<double>(year.year - before));
            RC_ASSERT(year.beyond_years == (year.year == rock_years.back() ? 7.0 : 0.0));
            RC_ASSERT((year.p_below > 0.0) == (year.missing_percent > 0.0));
            below += year.stands_for_years * year.p_below / static_cast<double>(replicates);
            lost += (year.stands_for_years + year.beyond_years) * year.missing_percent /
                    static_cast<double>(replicates);
            mean_in_year[year.year] += weights[r] / all_weights * year.protection_percent;
            before = year.year;
        }
    }
    RC_ASSERT(std::abs(below - drawn.years_below.mean) < 1e-9 * (1.0 + below));
    RC_ASSERT(std::isnan(drawn.years_below.high) || drawn.years_below.high <= rock_years.back());
    RC_ASSERT(std::abs(lost - drawn.percent_years_lost.mean) < 1e-9 * (1.0 + lost));
    const auto lowest = std::min_element(mean_in_year.begin(), mean_in_year.end(),
                                         [](const auto& a, const auto& b) { return a.second < b.second; });
    RC_ASSERT(std::abs(lowest->second - drawn.lowest->value.band.mean) < 1e-6);
    RC_ASSERT(drawn.lowest->year == lowest->first);
    if (drawn.years_below.mean == 0.0) {  // all replicates keep it in all draws: the count alone is open
        RC_ASSERT(drawn.worst->at_most(0.05) == 1.0);
    }
    if (drawn.worst->median() < 0.3) {  // most replicates do not keep it
        RC_ASSERT(drawn.years_below.mean > 0.3);
    }
}

/// The lowest of forty years with few rocks is that of the forest, not of the rocks.
TEST(DrawnProtection, DoesNotMakeTheLowestYearLower) {
    std::mt19937 engine{11};
    std::normal_distribution<double> normal;
    constexpr std::size_t replicates = 20;
    constexpr double noise = 8.0;
    constexpr int studies = 20;
    double off_seen = 0.0;
    double off_drawn = 0.0;
    for (int study = 0; study < studies; ++study) {
        CourseYears seen{.of_replicates = {}, .rock_variances = {}, .breaks = {13, 16}};
        std::vector<double> truth(years + 1, 0.0);
        std::vector<double> mean(years + 1, 0.0);
        for (std::size_t r = 0; r < replicates; ++r) {
            seen.of_replicates.emplace_back();
            seen.rock_variances.emplace_back();
            const double own = 1.5 * normal(engine);
            for (std::int32_t year = 1; year <= years; ++year) {
                const double dip = year >= 13 && year < 16 ? 5.0 : 0.0;
                const double forest = 85.0 - dip + own;
                const double value = forest + noise * normal(engine);
                seen.of_replicates[r][year] = value;
                seen.rock_variances[r][year] = noise * noise;
                truth[static_cast<std::size_t>(year)] += forest / replicates;
                mean[static_cast<std::size_t>(year)] += value / replicates;
            }
        }
        const double lowest = *std::min_element(truth.begin() + 1, truth.end());
        off_seen += (*std::min_element(mean.begin() + 1, mean.end()) - lowest) / studies;
        off_drawn += (protection_of(seen, 80.0).lowest->value.band.mean - lowest) / studies;
    }
    // The mean of 20 replicates has a deviation of 1.8 points: the least of three such lies 1.5 lower.
    EXPECT_LT(off_seen, -1.0);
    EXPECT_GT(off_drawn, 0.5 * off_seen);
    EXPECT_LT(off_drawn, 1.0);
}

/// All replicates keep the threshold by far: then a verdict rests on their number alone, and its bound is the
/// exact one. A bound that is too high would call ten of ten enough.
TEST(WorstYears, BoundTheProbabilityAsExactlyAsTheirNumberDoes) {
    for (const std::size_t replicates : {6U, 10U, 20U, 30U}) {
        CourseYears course;
        for (std::size_t r = 0; r < replicates; ++r) {
            course.of_replicates.push_back(
                {{1, 90.0 + 0.1 * static_cast<double>(r % 5)}, {2, 91.0}, {3, 90.5}});
            course.rock_variances.emplace_back();
        }
        const auto worst = protection_of(course, 50.0).worst;
        ASSERT_TRUE(worst);
        EXPECT_EQ(worst->at_most(0.01), 1.0);
        for (const double chance : {0.05, 0.0125}) {
            const auto n = static_cast<double>(replicates);
            const double exact = std::pow(chance, 1.0 / n);
            // Four deviations of a quantile of 1000 draws from Beta(n, 1).
            const double density = n * std::pow(exact, n - 1.0);
            const double tolerance = 4.0 * std::sqrt(chance * (1.0 - chance) / 1000.0) / density;
            EXPECT_NEAR(worst->at_least(chance), exact, tolerance) << replicates << " at " << chance;
            EXPECT_LE(worst->at_least(chance), worst->at(chance));
        }
    }
}

}  // namespace
}  // namespace coupling::decades::worst_year_test
