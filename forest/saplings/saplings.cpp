#include "forest/saplings/saplings.hpp"

#include <algorithm>
#include <cmath>

#include "config/math/elementary.hpp"
#include "forest/production/light_response.hpp"

namespace forest {

namespace {

constexpr double browsed_from_m = 0.1;
constexpr double browsed_to_m = 1.3;
constexpr double pressure_power = 1.81;  // of the odds of being browsed
constexpr double height_spread = 0.4;    // of a cohort, each way
constexpr double cut_back_from_m = 0.3;
constexpr double cut_back_m = 0.1;
constexpr double cut_back_share = 1.0 / 3.0;

constexpr double tall_from_m = 0.5;
constexpr double death_of_seedling = 0.25;
constexpr std::uint16_t seedling_years = 7;
constexpr double death_of_small = 0.03;
constexpr double death_of_tall = 0.015;
constexpr double death_by_snow = 0.05;
constexpr double suffering_class = 4.0;  // of browsing, from which on stems often die of it
constexpr double death_of_suffering = 0.1;
constexpr double death_of_tolerant = 0.03;
/// 20 % in two years: 1 - 0.8^(1/2).
constexpr double death_of_planted = 0.1056;
constexpr std::uint16_t planting_shock_years = 2;

double mean_height_m(const Cohort& cohort, double growth_m, double browsed) {
    const double lost_m = cohort.height_m >= cut_back_from_m ? cut_back_share * cut_back_m : 0.0;
    return std::max(seedling_height_m, cohort.height_m + (1.0 - browsed) * growth_m - browsed * lost_m);
}

/// Takes a share off the stems that are left; the part of a stem is decided by u.
std::uint32_t take(std::uint32_t& left, double share, double u) {
    const auto taken = std::min(left, static_cast<std::uint32_t>(left * std::min(share, 1.0) + u));
    left -= taken;
    return taken;
}

}  // namespace

double potential_height_m(const Saplings& species, double height_m) {
    if (height_m >= species.max_height_m) {
        return height_m;
    }
    const double place = config::pow_of(height_m / species.max_height_m, 1.0 / 3.0);
    const double next = 1.0 - (1.0 - place) * config::exp_of(-species.rate_pyear);
    return species.max_height_m * next * next * next;
}

double browsing_chance(const Saplings& species, double pressure) {
    const double p = species.browsing_probability;
    if (pressure <= 0.0 || p <= 0.0) {
        return 0.0;
    }
    const double odds = p * config::pow_of(pressure, pressure_power);
    return odds / (1.0 - p + odds);
}

std::optional<double> pressure_of_browsing(const Saplings& species, double chance) {
    const double p = species.browsing_probability;
    if (p <= 0.0 || p >= 1.0 || chance >= 1.0) {
        return std::nullopt;
    }
    if (chance <= 0.0) {
        return 0.0;
    }
    return config::pow_of(chance / (1.0 - chance) * (1.0 - p) / p, 1.0 / pressure_power);
}

bool is_in_reach(double mean_height_m) {
    return mean_height_m >= browsed_from_m && mean_height_m < browsed_to_m;
}

double share_in_reach(double mean_height_m) {
    if (mean_height_m <= browsed_from_m) {
        return 0.0;
    }
    const double least_m = (1.0 - height_spread) * mean_height_m;
    return std::clamp((browsed_to_m - least_m) / (2.0 * height_spread * mean_height_m), 0.0, 1.0);
}

SaplingYear year_of_cohort(const Species& species, const Cohort& cohort, const SaplingPlace& place,
                           const config::FourUniforms& chance) {
    const double share = place.environment * light_response(species.light.response_class, place.ground_light);
    const double potential_m = potential_height_m(species.saplings, cohort.height_m) - cohort.height_m;
    const bool found_by_deer = chance[3] < browsing_chance(species.saplings, place.deer);
    const double browsed = found_by_deer ? share_in_reach(cohort.height_m) : 0.0;

    SaplingYear year;
    year.growth.height_m = mean_height_m(cohort, potential_m * share, browsed);
    year.growth.browsed = found_by_deer;
    const bool bad = share < species.saplings.stress_threshold;
    year.growth.stress_years = bad ? static_cast<std::uint16_t>(cohort.stress_years + 1) : std::uint16_t{0};

    std::uint32_t left = cohort.stems;
    if (year.growth.stress_years > species.saplings.max_stress_years) {
        year.stressed = left;
        return year;
    }
    const bool suffers = species.saplings.browsing_class >= suffering_class;
    year.browsed = take(left, browsed * (suffers ? death_of_suffering : death_of_tolerant), chance[0]);
    if (place.snow_glides) {
        year.torn_out = take(left, death_by_snow, chance[1]);
    }
    const bool planted_lately = cohort.origin == Origin::planted && cohort.age_years < planting_shock_years;
    const bool seedling =
        cohort.origin == Origin::seed && cohort.age_years < seedling_years && cohort.height_m < tall_from_m;
    const double death = (seedling                        ? death_of_seedling
                          : cohort.height_m < tall_from_m ? death_of_small
                                                          : death_of_tall) +
                         (planted_lately ? death_of_planted : 0.0);
    year.background = take(left, death, chance[2]);
    return year;
}

double room_of_stem(double height_m) {
    constexpr double most_pha_at_1m = 10'000.0;
    constexpr double m2_pha = 10'000.0;
    const double most =
        most_pha_at_1m * patch_area_m2 / m2_pha * config::pow_of(std::max(height_m, tall_from_m), -1.2);
    return 1.0 / most;
}

}  // namespace forest
