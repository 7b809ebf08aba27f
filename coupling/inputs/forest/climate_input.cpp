#include "coupling/inputs/forest/climate_input.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/climate/sunshine.hpp"
#include "coupling/inputs/forest/climate_variants.hpp"
#include "coupling/inputs/reading/declared_tables.hpp"
#include "coupling/inputs/scenario/forest_settings.hpp"
#include "coupling/inputs/scenario/run_settings.hpp"
#include "forest/climate/summary.hpp"

namespace coupling {

struct ClimateChangeRow {
    std::size_t month = 1;
    double temperature_k = 0.0;
    double precipitation = 1.0;
};

namespace {

using config::ExitCode;
using config::joined;

std::string years_of(const forest::ClimateSeries& series) {
    return joined(std::to_string(series.first_year()), " to ", std::to_string(series.last_year()));
}

/// The elevation of the place, from the table or the setting; NaN never comes back.
double elevation_of(const forest::ClimateSeries& series, const ClimateAsked& asked, Reading& reading) {
    const double set_m = asked.settings.climate_elevation_m;
    const bool was_set = asked.was_set("climate.elevation_m");
    if (!was_set && !series.elevation_m) {
        config::fail(ExitCode::settings, asked.place_of("climate.file"),
                     joined("neither climate.elevation_m nor a column elev_m in ",
                            reading.shown(asked.settings.climate)),
                     "the height of the place that the series is of", "set climate.elevation_m");
    }
    if (was_set && series.elevation_m && *series.elevation_m != set_m) {
        config::fail(ExitCode::settings, asked.place_of("climate.elevation_m"),
                     joined(asked.prefix(), "climate.elevation_m ", config::to_text(set_m)),
                     joined("the elev_m of the series, ", config::to_text(*series.elevation_m),
                            ", or no climate.elevation_m"));
    }
    return series.elevation_m.value_or(set_m);
}

/// Only the years of the window, of which there is one at least.
forest::ClimateSeries cut(forest::ClimateSeries series, const ClimateAsked& asked, Reading& reading) {
    const ForestSettings& s = asked.settings;
    config::Problems problems;
    const auto bound = [&](const std::string& key, std::uint64_t asked_for, int otherwise) {
        if (asked_for == 0) {
            return otherwise;
        }
        const int year = static_cast<int>(asked_for);
        if (series.find(year) == nullptr) {
            problems.add(ExitCode::settings, asked.place_of(key),
                         joined(asked.prefix(), key, " ", std::to_string(year)),
                         joined("a year of ", reading.shown(s.climate), ", ", years_of(series)));
        }
        return year;
    };
    const int first = bound("climate.window_first_year", s.window_first_year, series.first_year());
    const int last = bound("climate.window_last_year", s.window_last_year, series.last_year());
    if (problems.empty() && last < first) {
        problems.add(ExitCode::settings, asked.place_of("climate.window_last_year"),
                     joined(asked.prefix(), "climate.window_last_year ", std::to_string(last)),
                     joined("no year before climate.window_first_year ", std::to_string(first)),
                     "exchange the two years");
    }
    problems.throw_if_any();
    std::vector<forest::ClimateYear> kept;
    std::copy_if(series.years.begin(), series.years.end(), std::back_inserter(kept),
                 [&](const forest::ClimateYear& year) { return year.year >= first && year.year <= last; });
    series.years = std::move(kept);
    return series;
}

void check_reach(const ClimateSource& climate, const ClimateAsked& asked, Reading& reading) {
    if (climate.order != ClimateOrder::once) {
        return;
    }
    const int last = climate.first_year + static_cast<int>(reading.run().years) - 1;
    const std::string file = reading.shown(asked.settings.climate);
    for (int year = climate.first_year; year <= last; ++year) {
        if (climate.series.find(year) == nullptr) {
            const bool own_file = asked.given.contains("climate.file");
            reading.refuse(own_file ? asked.place_of("climate.file") : config::Place{file},
                           joined(asked.prefix(), own_file ? joined(file, " has ") : "", "years ",
                                  years_of(climate.series), ", but none for ", std::to_string(year)),
                           joined("all years of the run, ", std::to_string(climate.first_year), " to ",
                                  std::to_string(last), ", or climate.sequence = repeat or random"));
            return;
        }
    }
}

forest::ClimateChange read_change(const ClimateAsked& asked, Reading& reading) {
    const ForestSettings& s = asked.settings;
    if (s.climate_change.empty()) {
        return forest::ClimateChange::of(s.temperature_change_k, s.precipitation_change);
    }
    const config::Table table = reading.table_at(
        asked.place_of("climate.change"), asked.role("climate.change", "climate_change"), s.climate_change);
    check_columns(table, climate_change_columns(), reading);
    config::RowProblems wrong{table};
    forest::ClimateChange change;
    std::array<bool, 12> given{};
    for (const config::Read<ClimateChangeRow>& row : climate_change_columns().rows(table, wrong)) {
        const std::size_t m = row.month - 1;
        given[m] = true;
        change.temperature_k[m] = row.temperature_k;
        change.precipitation[m] = row.precipitation;
    }
    for (std::size_t m = 0; m < given.size() && table.rows() < given.size(); ++m) {
        if (!given[m]) {
            wrong.refuse(joined("no month ", std::to_string(m + 1)), "all twelve",
                         "add a row for it; a change of 0 is allowed");
        }
    }
    wrong.throw_first();
    return change;
}

/// Series by file: climates that differ in their change alone share one, which is read once. Nothing for one
/// that cannot be read.
using SeriesOfFiles = std::map<std::string, std::optional<forest::ClimateSeries>>;

forest::ClimateSeries read_file(const ClimateAsked& asked, Reading& reading) {
    config::Table table = reading.table_at(asked.place_of("climate.file"),
                                           asked.role("climate.file", "climate"), asked.settings.climate);
    config::Warnings found;
    if (const std::string made =
            climate::take_sunshine(table, config::Angle::from_degrees(asked.settings.latitude_deg));
        !made.empty()) {
        found.add(made);
    }
    forest::ClimateSeries series = forest::read_climate_of_one_place(table, found);
    reading.take(found);
    return series;
}

std::optional<forest::ClimateSeries> read_series(const ClimateAsked& asked, SeriesOfFiles& files,
                                                 Reading& reading) {
    auto found = files.find(asked.settings.climate);
    if (found == files.end()) {
        found =
            files.emplace(asked.settings.climate, reading.attempt([&] { return read_file(asked, reading); }))
                .first;
    }
    if (!found->second) {
        return std::nullopt;
    }
    return reading.attempt([&] {
        forest::ClimateSeries series = *found->second;
        series.elevation_m = elevation_of(series, asked, reading);
        return cut(std::move(series), asked, reading);
    });
}

/// What climate.dry_years add to the months April to September.
forest::ClimateChange dry_season(const ForestSettings& settings) {
    forest::ClimateChange change;
    for (std::size_t m = 3; m < 9; ++m) {
        change.temperature_k[m] = settings.dry_season_k;
        change.precipitation[m] = settings.dry_season_precipitation;
    }
    return change;
}

/// `first_year`: of all climates; 0 for the first one, which says it.
std::optional<ClimateSource> read_source(const ClimateAsked& asked, int first_year, SeriesOfFiles& files,
                                         Reading& reading) {
    auto series = read_series(asked, files, reading);
    const auto change = reading.attempt([&] { return read_change(asked, reading); });
    if (!series || !change) {
        return std::nullopt;
    }
    const ForestSettings& s = asked.settings;
    ClimateSource climate;
    climate.series = std::move(*series);
    climate.order = s.order;
    climate.seed = reading.run().seed;
    climate.change = *change;
    climate.change_years = static_cast<int>(s.change_years);
    climate.dry_years = s.dry_years;
    climate.dry_season = dry_season(s);
    climate.first_year = first_year > 0     ? first_year
                         : s.first_year > 0 ? static_cast<int>(s.first_year)
                                            : climate.series.first_year();
    if (s.co2_ppm > 0.0) {
        climate.co2 = forest::Co2Series::constant(s.co2_ppm);
    }
    climate.co2_response = s.parameters.processes.co2_response;
    check_reach(climate, asked, reading);
    return climate;
}

}  // namespace

const config::Schema<ClimateChangeRow>& climate_change_columns() {
    // clang-format off
    static const config::Schema<ClimateChangeRow> columns{
        {.role = "climate_change", .setting = "climate.change", .row = "monthly change"},
        {{"month", &ClimateChangeRow::month, "1 January to 12", {.range = {1.0, 12.0}, .unique = true, .advice = "delete or renumber one of the rows"}},
         {"temperature_k", &ClimateChangeRow::temperature_k, "added", {.unit = "K", .range = {-15.0, 15.0}}},
         {"precipitation", &ClimateChangeRow::precipitation, "factor", {.unit = "-", .range = {0.0, 5.0}}}}};
    // clang-format on
    return columns;
}

int ClimateSource::source_of(int year, std::uint32_t replicate) const {
    const forest::YearWindow window{series.first_year(), series.last_year()};
    switch (order) {
        case ClimateOrder::once:
            return year;
        case ClimateOrder::random:
            return forest::YearSequence::drawn(window, seed, replicate).source_of(year);
        case ClimateOrder::repeat:
            break;
    }
    return forest::YearSequence::repeating(series, window).source_of(year);
}

bool ClimateSource::changes() const {
    return std::any_of(change.temperature_k.begin(), change.temperature_k.end(),
                       [](double k) { return k != 0.0; }) ||
           std::any_of(change.precipitation.begin(), change.precipitation.end(),
                       [](double factor) { return factor != 1.0; });
}

double ClimateSource::share_of_change(int year) const {
    if (year < first_year) {
        return 0.0;
    }
    return change_years == 0 ? 1.0 : std::min(1.0, static_cast<double>(year - first_year + 1) / change_years);
}

forest::ClimateChange ClimateSource::change_of(int year) const {
    forest::ClimateChange part = change.scaled(share_of_change(year));
    if (std::find(dry_years.begin(), dry_years.end(), year) != dry_years.end()) {
        for (std::size_t m = 0; m < 12; ++m) {
            part.temperature_k[m] += dry_season.temperature_k[m];
            part.precipitation[m] *= dry_season.precipitation[m];
        }
    }
    return part;
}

YearWeather ClimateSource::weather(int year, std::uint32_t replicate,
                                   std::span<const double> elevations_m) const {
    YearWeather weather;
    weather.source_year = source_of(year, replicate);
    weather.co2_ppm = co2.ppm(year);
    weather.co2_response = co2_response;
    const forest::ClimateYear& source = *series.find(weather.source_year);
    const forest::ClimateChange part = change_of(year);
    weather.units.reserve(elevations_m.size());
    for (const double elevation_m : elevations_m) {
        forest::ClimateChange both =
            change_with_elevation(series, elevation_m - *series.elevation_m, lapse_rates);
        for (std::size_t m = 0; m < 12; ++m) {
            both.temperature_k[m] += part.temperature_k[m];
            both.precipitation[m] *= part.precipitation[m];
        }
        weather.units.push_back(changed(source, both));
        weather.units.back().year = year;
    }
    return weather;
}

double ClimateSource::usual_summer_mm(double elevation_m) const {
    const forest::ClimateSeries there = at_elevation(series, elevation_m - *series.elevation_m, lapse_rates);
    double sum_mm = 0.0;
    for (const forest::ClimateYear& year : there.years) {
        for (const std::size_t month : {5, 6, 7}) {
            sum_mm += year.months[month].prec_mm;
        }
    }
    return sum_mm / static_cast<double>(there.years.size());
}

double ClimateSource::degree_days(double elevation_m) const {
    const forest::ClimateSeries there = at_elevation(series, elevation_m - *series.elevation_m, lapse_rates);
    double sum = 0.0;
    for (const forest::ClimateYear& year : there.years) {
        sum += forest::degree_days(year);
    }
    return sum / static_cast<double>(there.years.size());
}

std::array<double, 12> ClimateSource::mean_radiation_mjpm2() const {
    std::array<double, 12> mean{};
    for (const forest::ClimateYear& year : series.years) {
        for (std::size_t m = 0; m < 12; ++m) {
            mean[m] += year.months[m].radiation_mjpm2 / static_cast<double>(series.years.size());
        }
    }
    return mean;
}

std::vector<NamedClimate> read_climates(Reading& reading) {
    const auto all_asked = reading.attempt([&] { return asked_climates(reading); });
    if (!all_asked) {
        return {};
    }
    std::vector<NamedClimate> climates;
    SeriesOfFiles files;
    for (const ClimateAsked& asked : *all_asked) {
        const int first_year = climates.empty() ? 0 : climates.front().source.first_year;
        if (auto source = read_source(asked, first_year, files, reading)) {
            climates.push_back({asked.name, std::move(*source)});
        }
    }
    return climates.size() == all_asked->size() ? std::move(climates) : std::vector<NamedClimate>{};
}

}  // namespace coupling
