#include "forest/climate/change.hpp"

#include <algorithm>

#include "config/data/shipped_tables.hpp"
#include "config/random/distributions.hpp"
#include "forest/climate/calendar.hpp"
#include "forest/climate/normal.hpp"
#include "forest/climate/vapour.hpp"

namespace forest {

namespace {

/// Minimum temperature at which a normal scatter of days gives the month's frost days.
///
/// None or nothing but frost says only on which side it lies: then the mean of the minima counts if it lies
/// farther.
double effective_minimum(const ClimateMonth& climate, double days) {
    const double half_a_day = 0.5 / days;
    const double share = std::clamp(climate.frost_days / days, half_a_day, 1.0 - half_a_day);
    const double minimum = -daily_scatter_k * config::normal_quantile(share);
    if (climate.frost_days <= 0.0) {
        return std::max(minimum, climate.tmin_degc);
    }
    return climate.frost_days >= days ? std::min(minimum, climate.tmin_degc) : minimum;
}

double shifted_frost_days(const ClimateMonth& climate, double days, double shift_k) {
    const double minimum = effective_minimum(climate, days) + shift_k;
    return days * normal_probability(-minimum / daily_scatter_k);
}

constexpr double degree_day_base_degc = 5.5;

double shifted_degree_days(const ClimateMonth& climate, double days, double shift_k) {
    const double before = mean_above(climate.tave_degc, degree_day_base_degc, daily_scatter_k);
    const double after = mean_above(climate.tave_degc + shift_k, degree_day_base_degc, daily_scatter_k);
    return std::max(0.0, *climate.degree_days + days * (after - before));
}

}  // namespace

ClimateMonth warmed(const ClimateMonth& climate, int month, double shift_k) {
    if (shift_k == 0.0) {
        return climate;
    }
    const double days = days_in_month(month);
    ClimateMonth result = climate;
    result.tmin_degc += shift_k;
    result.tmax_degc += shift_k;
    result.tave_degc += shift_k;
    result.vpd_kpa *= saturation_pressure_kpa(result.tmax_degc) / saturation_pressure_kpa(climate.tmax_degc);
    result.frost_days = shifted_frost_days(climate, days, shift_k);
    if (climate.degree_days) {
        result.degree_days = shifted_degree_days(climate, days, shift_k);
    }
    if (climate.abs_tmin_degc) {
        result.abs_tmin_degc = *climate.abs_tmin_degc + shift_k;
    }
    return result;
}

LapseRates LapseRates::read(const config::Table& table) {
    config::Problems problems;
    table.require({"month", "temperature", "precipitation"}, problems);
    problems.throw_if_any();
    LapseRates rates;
    std::array<bool, 12> given{};
    constexpr double hundred_m = 100.0;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const auto month = table.whole(row, "month", {1.0, 12.0}, problems);
        const auto temperature = table.number(row, "temperature", {-2.0, 2.0}, problems);
        const auto precipitation = table.number(row, "precipitation", {-50.0, 50.0}, problems);
        if (!month || !temperature || !precipitation) {
            continue;
        }
        const auto m = static_cast<std::size_t>(*month - 1);
        if (given[m]) {
            problems.add(config::ExitCode::data, table.place(row, "month"),
                         "month " + table.text(row, "month") + " a second time", "each month once");
        }
        given[m] = true;
        rates.temperature_kpm[m] = *temperature / hundred_m;
        rates.precipitation_mmpm[m] = *precipitation / hundred_m;
    }
    if (problems.empty() && std::find(given.begin(), given.end(), false) != given.end()) {
        problems.add(config::ExitCode::data, {table.file()}, std::to_string(table.rows()) + " months",
                     "all twelve");
    }
    problems.throw_if_any();
    return rates;
}

LapseRates LapseRates::shipped() {
    return read(config::read_shipped_table("lapse_rates.csv"));
}

ClimateChange change_with_elevation(const ClimateSeries& series, double difference_m,
                                    const LapseRates& rates) {
    ClimateChange change;
    for (std::size_t m = 0; m < 12; ++m) {
        change.temperature_k[m] = rates.temperature_kpm[m] * difference_m;
        double mean_mm = 0.0;
        for (const ClimateYear& year : series.years) {
            mean_mm += year.months[m].prec_mm / static_cast<double>(series.years.size());
        }
        const double added_mm = rates.precipitation_mmpm[m] * difference_m;
        change.precipitation[m] = mean_mm > 0.0 ? std::max(0.0, 1.0 + added_mm / mean_mm) : 1.0;
    }
    return change;
}

ClimateSeries at_elevation(const ClimateSeries& series, double difference_m, const LapseRates& rates) {
    ClimateSeries result;
    if (series.elevation_m) {
        result.elevation_m = *series.elevation_m + difference_m;
    }
    const ClimateChange change = change_with_elevation(series, difference_m, rates);
    result.years.reserve(series.years.size());
    for (const ClimateYear& year : series.years) {
        result.years.push_back(changed(year, change));
    }
    return result;
}

ClimateChange ClimateChange::of(double temperature_k, double precipitation) {
    ClimateChange change;
    change.temperature_k.fill(temperature_k);
    change.precipitation.fill(precipitation);
    return change;
}

ClimateChange ClimateChange::scaled(double share) const {
    ClimateChange part;
    for (std::size_t m = 0; m < 12; ++m) {
        part.temperature_k[m] = share * temperature_k[m];
        part.precipitation[m] = 1.0 + share * (precipitation[m] - 1.0);
    }
    return part;
}

ClimateYear changed(const ClimateYear& year, const ClimateChange& change) {
    ClimateYear result = year;
    for (std::size_t m = 0; m < 12; ++m) {
        result.months[m] = warmed(year.months[m], static_cast<int>(m + 1), change.temperature_k[m]);
        result.months[m].prec_mm *= change.precipitation[m];
    }
    return result;
}

}  // namespace forest
