#include "coupling/inputs/forest/climate_variants.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/forest/climate_input.hpp"
#include "coupling/inputs/reading/declared_tables.hpp"
#include "coupling/inputs/reading/result_name.hpp"
#include "coupling/inputs/scenario/forest_settings.hpp"

namespace coupling {

/// What a climate has in place of the settings of [climate].
struct ClimateRow {
    std::string name;
    std::optional<std::string> file, change;
    std::optional<double> elevation_m, temperature_change_k, precipitation_change, co2_ppm;
    std::optional<std::uint64_t> window_first_year, window_last_year, change_years;
};

namespace {

using config::joined;

/// The rows of climate.variants, each as the settings with what it gives in their place.
class VariantRows {
public:
    VariantRows(const config::Table& table, const Reading& reading)
        : table_{table}, reading_{reading}, wrong_{table} {}

    /// Throws one config::InputError for all that is wrong with the rows.
    std::vector<ClimateAsked> all() {
        std::vector<ClimateAsked> climates;
        for (const config::Read<ClimateRow>& row : climate_variant_columns().rows(table_, wrong_)) {
            climates.push_back(asked_in(row));
            check(row.row, climates.back());
        }
        wrong_.throw_first();
        return climates;
    }

private:
    ClimateAsked asked_in(const config::Read<ClimateRow>& row) {
        ClimateAsked asked{row.name, reading_.forest(), {}, *reading_.settings().options};
        ForestSettings& s = asked.settings;
        const auto take = [&](const char* column, const auto& given, auto& value) {
            if (given) {
                value = *given;
                asked.given[joined("climate.", column)] = table_.place(row.row, column);
            }
        };
        take("file", row.file, s.climate);
        take("elevation_m", row.elevation_m, s.climate_elevation_m);
        take("window_first_year", row.window_first_year, s.window_first_year);
        take("window_last_year", row.window_last_year, s.window_last_year);
        take("change_years", row.change_years, s.change_years);
        take("co2_ppm", row.co2_ppm, s.co2_ppm);
        // A row that gives a change gives all of it: nothing of the other kind is added.
        const bool numbers_given = row.temperature_change_k || row.precipitation_change;
        if (row.change && numbers_given) {
            wrong_.refuse(row.row, "change", "change beside temperature_change_k or precipitation_change",
                          "only one of them", "leave one of the fields empty");
        }
        if (row.change) {
            s.temperature_change_k = 0.0;
            s.precipitation_change = 1.0;
        } else if (numbers_given) {
            s.climate_change.clear();
        }
        take("change", row.change, s.climate_change);
        take("temperature_change_k", row.temperature_change_k, s.temperature_change_k);
        take("precipitation_change", row.precipitation_change, s.precipitation_change);
        return asked;
    }

    void check(std::size_t row, const ClimateAsked& asked) {
        if (!is_result_name(asked.name)) {
            wrong_.refuse(row, "name", joined("name ", config::in_quotes(asked.name)), result_name_in_words);
        }
        if (asked.settings.climate.empty()) {
            wrong_.refuse(row, "name", joined(asked.prefix(), "neither a file in its row nor climate.file"),
                          "a table of monthly climate", "name one in the column file or set climate.file");
        }
        if (asked.given.contains("climate.co2_ppm") && !asked.settings.parameters.processes.co2_response) {
            wrong_.refuse(row, "co2_ppm", "co2_ppm without forest.co2_response", "forest.co2_response = yes",
                          "set it, or leave co2_ppm empty");
        }
    }

    const config::Table& table_;
    const Reading& reading_;
    config::RowProblems wrong_;
};

}  // namespace

bool ClimateAsked::was_set(const std::string& key) const {
    return given.contains(key) || options.was_set(key);
}

config::Place ClimateAsked::place_of(const std::string& key) const {
    const auto found = given.find(key);
    return found == given.end() ? options.place_of(key) : found->second;
}

std::string ClimateAsked::role(const std::string& key, const std::string& what) const {
    return given.contains(key) ? joined(what, " ", name) : what;
}

std::string ClimateAsked::prefix() const {
    return settings.climate_variants.empty() ? "" : joined("climate '", name, "': ");
}

namespace {

/// Whether a change of [climate] still holds for a row that may give the other kind of change.
bool applies(const ClimateAsked& asked, std::string_view key) {
    if (key == "change") {
        return !asked.settings.climate_change.empty();
    }
    if (key == "temperature_change_k" || key == "precipitation_change") {
        return asked.settings.climate_change.empty();
    }
    return true;
}

/// A row with a file of its own takes what it does not give from [climate], where it may be meant for another
/// place.
void warn_of_values_taken_over(const std::vector<ClimateAsked>& climates, Reading& reading) {
    for (const ClimateAsked& asked : climates) {
        if (!asked.given.contains("climate.file")) {
            continue;
        }
        std::string taken;
        for (const char* key : {"elevation_m", "window_first_year", "window_last_year", "change",
                                "temperature_change_k", "precipitation_change"}) {
            const std::string setting = joined("climate.", key);
            const bool replaced = asked.given.contains(setting) || !applies(asked, key);
            if (!replaced && asked.options.was_set(setting)) {
                taken += joined(taken.empty() ? "" : ", ", setting);
            }
        }
        if (!taken.empty()) {
            reading.note(joined(asked.prefix(), "a file of its own, but ", taken,
                                " as [climate] has it; the row can say otherwise"));
        }
    }
}

/// `--set climate...` is meant for all climates, but a row that gives the same, or the other kind of change,
/// goes before it.
void warn_of_replaced_overrides(const std::vector<ClimateAsked>& climates, Reading& reading) {
    for (const char* key : {"file", "elevation_m", "window_first_year", "window_last_year", "change",
                            "temperature_change_k", "precipitation_change", "change_years", "co2_ppm"}) {
        const std::string setting = joined("climate.", key);
        const config::Options& options = *reading.settings().options;
        if (!options.was_set(setting) || !options.place_of(setting).file.starts_with("--set ")) {
            continue;
        }
        std::string replaced;
        for (const ClimateAsked& asked : climates) {
            if (asked.given.contains(setting) || !applies(asked, key)) {
                replaced += joined(replaced.empty() ? "" : ", ", asked.name);
            }
        }
        if (!replaced.empty()) {
            reading.note(joined(options.place_of(setting).file, " has no effect on climate ", replaced,
                                ": the rows of climate.variants go before it; change the rows, or leave "
                                "climate.variants out"));
        }
    }
}

}  // namespace

const config::Schema<ClimateRow>& climate_variant_columns() {
    using R = ClimateRow;
    constexpr config::NumberRange years{0.0, 9999.0};
    // clang-format off
    static const config::Schema<R> columns{
        {.role = "climates", .setting = "climate.variants", .row = "climate", .no_rows = "a row for each climate, or no climate.variants", .others_refused = true},
        {{"name", &R::name, "in results", {.unique = true, .advice = "rename one of them"}},
         {"file", &R::file, "table of monthly climate; empty: climate.file"},
         {"elevation_m", &R::elevation_m, "of the place of the series", {.range = {-500.0, 9000.0}}},
         {"window_first_year", &R::window_first_year, "first year that is used", {.unit = "-", .range = years}},
         {"window_last_year", &R::window_last_year, "last year that is used", {.unit = "-", .range = years}},
         {"change", &R::change, "table of changes by month"},
         {"temperature_change_k", &R::temperature_change_k, "instead: added in all months", {.unit = "K", .range = {-15.0, 15.0}}},
         {"precipitation_change", &R::precipitation_change, "and factor", {.unit = "-", .range = {0.0, 5.0}}},
         {"change_years", &R::change_years, "until the change is full", {.range = {0.0, 1000.0}}},
         {"co2_ppm", &R::co2_ppm, "constant", {.unit = "ppm", .range = {100.0, 2000.0}}}}};
    // clang-format on
    return columns;
}

std::vector<ClimateAsked> asked_climates(Reading& reading) {
    const std::string& file = reading.forest().climate_variants;
    if (file.empty()) {
        return {ClimateAsked{only_climate, reading.forest(), {}, *reading.settings().options}};
    }
    const config::Table table = table_of(climate_variant_columns(), file, reading);
    std::vector<ClimateAsked> climates = VariantRows{table, reading}.all();
    warn_of_values_taken_over(climates, reading);
    warn_of_replaced_overrides(climates, reading);
    return climates;
}

}  // namespace coupling
