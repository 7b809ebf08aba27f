#include "coupling/inputs/forest/climate_variants.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "config/table/table.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/forest/climate_input.hpp"
#include "coupling/inputs/reading/result_name.hpp"

namespace coupling {
namespace {

using config::ExitCode;
using config::joined;

/// The rows of climate.variants, each as the settings with what it gives in their place.
class VariantRows {
public:
    VariantRows(const config::Table& table, const Scenario& scenario) : table_{table}, scenario_{scenario} {}

    /// Throws one config::InputError for all that is wrong with the rows.
    std::vector<ClimateAsked> all() {
        check_columns();
        std::vector<ClimateAsked> climates;
        for (std::size_t row = 0; row < table_.rows() && problems_.empty(); ++row) {
            climates.push_back(read(row));
        }
        for (std::size_t row = 0; row < climates.size(); ++row) {
            check(row, climates);
        }
        if (table_.rows() == 0) {
            problems_.add(ExitCode::data, {table_.file()}, "no climate", "a row for each climate",
                          "add rows, or leave climate.variants out");
        }
        problems_.throw_if_any();
        return climates;
    }

private:
    /// A misspelt column would leave the climate as it is, without a word.
    void check_columns() {
        static const std::vector<std::string> known{"name",
                                                    "file",
                                                    "elevation_m",
                                                    "window_first_year",
                                                    "window_last_year",
                                                    "change",
                                                    "temperature_change_k",
                                                    "precipitation_change",
                                                    "change_years",
                                                    "co2_ppm"};
        table_.require({"name"}, problems_);
        for (const std::string& column : table_.columns_beside(known)) {
            std::string list;
            for (const std::string& name : known) {
                list += joined(list.empty() ? "" : ", ", name);
            }
            problems_.add(ExitCode::data, {table_.file(), 1}, joined("column '", column, "'"),
                          joined("columns of ", list));
        }
    }

    ClimateAsked read(std::size_t row) {
        ClimateAsked asked{table_.text(row, "name"), scenario_.forest, {}, *scenario_.options};
        ForestSettings& s = asked.settings;
        text(row, "file", s.climate, asked);
        number(row, "elevation_m", {-500.0, 9000.0}, s.climate_elevation_m, asked);
        whole(row, "window_first_year", {0.0, 9999.0}, s.window_first_year, asked);
        whole(row, "window_last_year", {0.0, 9999.0}, s.window_last_year, asked);
        whole(row, "change_years", {0.0, 1000.0}, s.change_years, asked);
        number(row, "co2_ppm", {100.0, 2000.0}, s.co2_ppm, asked);
        // A row that gives a change gives all of it: nothing of the other kind is added.
        const bool table_given = has_value(table_, row, "change");
        const bool numbers_given =
            has_value(table_, row, "temperature_change_k") || has_value(table_, row, "precipitation_change");
        if (table_given && numbers_given) {
            problems_.add(ExitCode::data, table_.place(row, "change"),
                          "change beside temperature_change_k or precipitation_change", "only one of them",
                          "leave one of the fields empty");
        }
        if (table_given) {
            s.temperature_change_k = 0.0;
            s.precipitation_change = 1.0;
        } else if (numbers_given) {
            s.climate_change.clear();
        }
        text(row, "change", s.climate_change, asked);
        number(row, "temperature_change_k", {-15.0, 15.0}, s.temperature_change_k, asked);
        number(row, "precipitation_change", {0.0, 5.0}, s.precipitation_change, asked);
        return asked;
    }

    void check(std::size_t row, const std::vector<ClimateAsked>& climates) {
        const ClimateAsked& asked = climates[row];
        const config::Place place = table_.place(row, "name");
        if (!is_result_name(asked.name)) {
            problems_.add(ExitCode::data, place, joined("name ", config::in_quotes(asked.name)),
                          result_name_in_words);
        }
        const auto same = std::find_if(climates.begin(), climates.begin() + static_cast<std::ptrdiff_t>(row),
                                       [&](const ClimateAsked& other) { return other.name == asked.name; });
        if (same != climates.begin() + static_cast<std::ptrdiff_t>(row)) {
            problems_.add(ExitCode::data, place, joined("name '", asked.name, "' a second time"),
                          "climates of different names", "rename one of them");
        }
        if (asked.settings.climate.empty()) {
            problems_.add(ExitCode::data, place,
                          joined(asked.prefix(), "neither a file in its row nor climate.file"),
                          "a table of monthly climate", "name one in the column file or set climate.file");
        }
        if (asked.given.contains("climate.co2_ppm") && !asked.settings.parameters.processes.co2_response) {
            problems_.add(ExitCode::data, asked.place_of("climate.co2_ppm"),
                          "co2_ppm without forest.co2_response", "forest.co2_response = yes",
                          "set it, or leave co2_ppm empty");
        }
    }

    bool gives(std::size_t row, const std::string& column, ClimateAsked& asked) {
        if (!has_value(table_, row, column)) {
            return false;
        }
        asked.given[joined("climate.", column)] = table_.place(row, column);
        return true;
    }
    void text(std::size_t row, const std::string& column, std::string& value, ClimateAsked& asked) {
        if (gives(row, column, asked)) {
            value = table_.text(row, column);
        }
    }
    void number(std::size_t row, const std::string& column, config::NumberRange range, double& value,
                ClimateAsked& asked) {
        if (gives(row, column, asked)) {
            value = table_.number(row, column, range, problems_).value_or(value);
        }
    }
    void whole(std::size_t row, const std::string& column, config::NumberRange range, std::uint64_t& value,
               ClimateAsked& asked) {
        if (gives(row, column, asked)) {
            const auto read = table_.whole(row, column, range, problems_);
            value = read ? static_cast<std::uint64_t>(*read) : value;
        }
    }

    const config::Table& table_;
    const Scenario& scenario_;
    config::Problems problems_;
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
        const config::Options& options = *reading.scenario().options;
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

std::vector<ClimateAsked> asked_climates(Reading& reading) {
    const Scenario& scenario = reading.scenario();
    const std::string& file = scenario.forest.climate_variants;
    if (file.empty()) {
        return {ClimateAsked{only_climate, scenario.forest, {}, *scenario.options}};
    }
    const config::Table table = reading.table("climate.variants", "climates", file);
    std::vector<ClimateAsked> climates = VariantRows{table, scenario}.all();
    warn_of_values_taken_over(climates, reading);
    warn_of_replaced_overrides(climates, reading);
    return climates;
}

}  // namespace coupling
