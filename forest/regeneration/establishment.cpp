#include "forest/regeneration/establishment.hpp"

#include <algorithm>
#include <cmath>

#include "config/math/elementary.hpp"
#include "forest/climate/calendar.hpp"
#include "forest/climate/normal.hpp"
#include "forest/climate/summary.hpp"
#include "forest/stand/species_drought.hpp"

namespace forest {

namespace {

/// Scatter of days around the mean of a month, for chilling days [choice].
constexpr double chilling_scatter_k = 4.0;
constexpr double chilling_from_degc = -5.0;
constexpr double chilling_to_degc = 5.0;
constexpr int last_month_of_late_frost = 7;

/// Degree-days above 5.5 degC below which a site counts as subalpine [choice].
constexpr double subalpine_degree_days = 900.0;
constexpr double wanted_sun_hours = 2.0;

double chilling_days(const ClimateYear& year) {
    double days = 0.0;
    for (int month = 1; month <= 12; ++month) {
        const double mean_degc = year.months[static_cast<std::size_t>(month - 1)].tave_degc;
        days += days_in_month(month) *
                (normal_probability((chilling_to_degc - mean_degc) / chilling_scatter_k) -
                 normal_probability((chilling_from_degc - mean_degc) / chilling_scatter_k));
    }
    return days;
}

/// Frost days between bud burst and July.
double late_frost_days(const Establishment& species, const ClimateYear& year) {
    double before = 0.0;
    double frosts = 0.0;
    for (int month = 1; month <= last_month_of_late_frost; ++month) {
        const ClimateMonth& climate = year.months[static_cast<std::size_t>(month - 1)];
        const double gain = degree_days(climate, month, species.base_degc);
        const double missing = species.budburst_degree_days - before;
        const double share_in_leaf =
            gain > 0.0 ? std::clamp(1.0 - missing / gain, 0.0, 1.0) : (missing <= 0.0 ? 1.0 : 0.0);
        frosts += share_in_leaf * climate.frost_days;
        before += gain;
    }
    return frosts;
}

}  // namespace

double degree_day_response(const Response& species, double degree_days) {
    const double low = species.min_degree_days;
    const double high = species.max_degree_days;
    if (degree_days <= low || degree_days >= high) {
        return 0.0;
    }
    constexpr double steepness = 0.0013;
    const double cold = 1.0 - config::exp_of(-steepness * (degree_days - low));
    const bool is_warm = degree_days > 0.5 * (low + high);
    const double warm =
        is_warm ? 4.0 * (degree_days - low) * (high - degree_days) / ((high - low) * (high - low)) : 1.0;
    return cold * warm;
}

double climate_chance(const Species& species, const ClimateYear& year) {
    const Establishment& limits = species.establishment;
    const ClimateSummary summary = summary_of(year);
    double coldest_minimum_degc = year.months.front().tmin_degc;
    for (const ClimateMonth& month : year.months) {
        coldest_minimum_degc = std::min(coldest_minimum_degc, month.tmin_degc);
    }
    const double warmth = degree_days(year, limits.base_degc);
    const bool possible = coldest_minimum_degc > limits.min_degc &&
                          summary.coldest_month_degc >= species.response.min_winter_degc &&
                          chilling_days(year) >= limits.chilling_days && warmth >= limits.min_degree_days &&
                          warmth <= limits.max_degree_days &&
                          summary.frost_free_days >= limits.frost_free_days;
    if (!possible) {
        return 0.0;
    }
    const double frosts = late_frost_days(limits, year);
    if (limits.frost_tolerance <= 0.0) {
        return frosts > 0.0 ? 0.0 : 1.0;
    }
    return config::pow_of(limits.frost_tolerance, std::sqrt(frosts));
}

double light_chance(const Light& species, double ground_light) {
    constexpr double beyond = 0.1;
    return std::clamp((ground_light - species.min_sapling) / (species.min_sapling + beyond), 0.0, 1.0);
}

double water_chance(double drought) {
    return std::clamp(1.0 - drought / tolerated_drought, 0.0, 1.0);
}

double sun_chance(double degree_days, double june_sun_hours) {
    return degree_days >= subalpine_degree_days ? 1.0
                                                : std::clamp(june_sun_hours / wanted_sun_hours, 0.2, 1.0);
}

SeedBed seed_bed(const Species& species, const GroundCover& cover) {
    constexpr double on_litter = 0.038;
    constexpr double under_herbs = 0.2;
    const double on_wood = species.conifer && species.evergreen ? 10.0 : 5.0;
    const double bare = std::max(0.0, 1.0 - cover.rotten_wood - cover.fresh_wood);
    const double free = on_litter * (1.0 - (1.0 - under_herbs) * cover.herbs);
    return {.ground = free * bare, .wood = free * cover.rotten_wood * on_wood};
}

}  // namespace forest
