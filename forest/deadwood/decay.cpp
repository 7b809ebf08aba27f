#include "forest/deadwood/decay.hpp"

#include <algorithm>

#include "config/math/elementary.hpp"
#include "forest/climate/calendar.hpp"

namespace forest {

namespace {

constexpr double strength_power = 1.5;

double strength_of_density(double density_share) {
    return config::pow_of(density_share, strength_power);
}

}  // namespace

double decay_speed(double mean_degc, double wetness) {
    constexpr double activation_k = 308.56;
    constexpr double zero_degc = -46.02;
    constexpr double reference_degc = 10.0;
    // Below this nothing rots, and the law would have its pole.
    constexpr double least_degc = -30.0;
    const double by_warmth =
        config::exp_of(activation_k * (1.0 / (reference_degc - zero_degc) -
                                       1.0 / (std::max(mean_degc, least_degc) - zero_degc)));
    return by_warmth / (1.0 + 30.0 * config::exp_of(-8.5 * wetness));
}

double potential_evapotranspiration_mm(const ClimateYear& year) {
    constexpr double cal_pcm2_per_mjpm2 = 23.885;
    double sum_mm = 0.0;
    for (const ClimateMonth& month : year.months) {
        const double warmth_degc = std::max(month.tave_degc, 0.0);
        sum_mm +=
            0.4 * warmth_degc / (warmth_degc + 15.0) * (cal_pcm2_per_mjpm2 * month.radiation_mjpm2 + 50.0);
    }
    return sum_mm;
}

double decay_speed(const ClimateYear& year) {
    double mean_degc = 0.0;
    double rain_mm = 0.0;
    double days_of_year = 0.0;
    for (int month = 1; month <= 12; ++month) {
        const ClimateMonth& climate = year.months[static_cast<std::size_t>(month - 1)];
        const double days = days_in_month(month);
        mean_degc += days * climate.tave_degc;
        days_of_year += days;
        rain_mm += climate.prec_mm;
    }
    mean_degc /= days_of_year;
    const double demand_mm = potential_evapotranspiration_mm(year);
    constexpr double plenty = 10.0;
    return decay_speed(mean_degc, demand_mm > 0.0 ? std::min(plenty, rain_mm / demand_mm) : plenty);
}

double lying_decay_pyear(const Deadwood& species) {
    constexpr double of_residence = 1.69;
    return of_residence * species.log_decay_pyear;
}

double yearly_density_left(double rate_pyear, double speed) {
    return config::exp_of(-rate_pyear * speed);
}

double fall_chance(const Deadwood& species, double dbh_cm, double speed) {
    constexpr double thin_cm = 25.0;
    constexpr double ln_two = 0.693147180559945309;
    const double haste = dbh_cm < thin_cm ? 2.0 : 1.0;
    return 1.0 - config::exp_of(-ln_two * haste * speed / species.snag_half_life_years);
}

double breakage_chance(const Snag& snag, int year, double speed) {
    constexpr double thin_cm = 25.0;
    constexpr int sound_years = 3;
    constexpr double chance = 0.1;
    constexpr double reference_speed = 0.7;
    if (snag.cut || snag.height_m < snag.tree_height_m || snag.dbh_cm <= thin_cm ||
        year - snag.year < sound_years) {
        return 0.0;
    }
    return std::min(1.0, chance * speed / reference_speed);
}

double clearance_m(double fresh_m, double years) {
    constexpr double settling_years = 12.0;
    constexpr double down_years = 25.0;
    return years >= down_years ? 0.0 : fresh_m * config::exp_of(-years / settling_years);
}

double strength_share(const Log& log, int year) {
    constexpr double gone_years = 80.0;
    const double age_years = std::max(0, year - log.year);
    return strength_of_density(log.density_share) * std::max(0.0, 1.0 - age_years / gone_years);
}

double strength_share(const Snag& snag, int year) {
    constexpr double holding_years = 15.0;
    constexpr double gone_years = 20.0;
    const double age_years = std::max(0, year - snag.year);
    const double of_roots =
        snag.cut ? std::clamp((gone_years - age_years) / (gone_years - holding_years), 0.0, 1.0) : 1.0;
    return strength_of_density(snag.density_share) * of_roots;
}

}  // namespace forest
