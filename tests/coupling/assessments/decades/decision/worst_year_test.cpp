#include "coupling/assessments/decades/decision/worst_year.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "coupling/assessments/decades/decision/decision.hpp"

namespace coupling::decades::worst_year_test {
namespace {

constexpr int years = 40;

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
        for (int i = 0; i < 3000; ++i) {
            const auto course = law.course(engine);
            lowest.push_back(*std::min_element(course.protection.begin(), course.protection.end()));
        }
        std::sort(lowest.begin(), lowest.end());
        const double threshold = lowest[static_cast<std::size_t>(between(0.03, 0.5) * 3000.0)];
        const double probability =
            static_cast<double>(lowest.end() - std::lower_bound(lowest.begin(), lowest.end(), threshold)) /
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
        const WorstYear worst = *worst_year(seen, 100.0 * threshold);
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

void expect_honest(int stands) {
    for (const bool with_events : {false, true}) {
        for (const double arriving : {60.0, 250.0}) {
            const Judged found = judged(stands, arriving, with_events);
            const auto share = [&](int count) { return static_cast<double>(count) / stands; };
            EXPECT_GT(share(found.inside), 0.90 - twice_deviation(stands)) << with_events << arriving;
            EXPECT_LT(share(found.wrong_yes), 0.05) << with_events << arriving;
            EXPECT_GT(found.yes, 0) << "it says something";
            // The lowest of 40 noisy years is not that of the forest: a count of them does not hold.
            EXPECT_LT(share(found.inside_of_count), 0.90 - twice_deviation(stands))
                << with_events << arriving;
            std::printf(
                "events %d, %.0f rocks arrive: 90 %% intervals hold %.1f %% of %d, of a count %.1f %%; "
                "yes %d, wrong %d\n",
                with_events ? 1 : 0, arriving, 100.0 * share(found.inside), stands,
                100.0 * share(found.inside_of_count), found.yes, found.wrong_yes);
        }
    }
}

TEST(WorstYears, AreThoseOfTheForestAndNotOfItsRocks) {
    expect_honest(40);
}

TEST(LongWorstYears, OfAThousandStandsAreThoseOfTheForest) {
    expect_honest(250);
}

TEST(WorstYears, WithoutNoiseAreCounted) {
    CourseYears seen;
    for (int replicate = 0; replicate < 20; ++replicate) {
        seen.of_replicates.push_back({{1, 95.0}, {2, replicate < 15 ? 91.0 : 80.0}});
    }
    const WorstYear worst = *worst_year(seen, 90.0);
    // Jeffreys: Beta(15.5, 5.5); 500 draws scatter its ends.
    EXPECT_NEAR(worst.median(), 0.744, 0.02);
    EXPECT_NEAR(worst.at(0.05), 0.570, 0.04);
    EXPECT_NEAR(worst.at(0.95), 0.881, 0.03);
    EXPECT_EQ(worst_year(seen, 90.0)->median(), worst.median()) << "the same course, the same answer";
}

TEST(WorstYears, TakeSixReplicates) {
    CourseYears seen;
    seen.of_replicates.assign(5, {{1, 95.0}});
    EXPECT_FALSE(worst_year(seen, 90.0));
    seen.of_replicates.push_back({{1, 95.0}});
    EXPECT_TRUE(worst_year(seen, 90.0));
    seen.of_replicates.back().clear();  // no year is known
    EXPECT_FALSE(worst_year(seen, 90.0));
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
        const auto worst = worst_year(course, 50.0);
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
