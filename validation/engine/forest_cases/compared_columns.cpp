#include "validation/engine/forest_cases/compared_columns.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "config/text/joined.hpp"

namespace coupling::validation::forest_cases {
namespace {

using config::joined;

namespace check = plain_3pg;

/// Columns of r3PG that our run does not have: carbon isotopes, size distributions and sums of these.
constexpr std::array<const char*, 28> only_of_r3pg{"Gc_mol",
                                                   "Dweibullscale",
                                                   "Gw_mol",
                                                   "Dweibullshape",
                                                   "D13CNewPS",
                                                   "Dweibulllocation",
                                                   "D13CTissue",
                                                   "wsweibullscale",
                                                   "InterCi",
                                                   "wsweibullshape",
                                                   "epsilon_gpp",
                                                   "volume_extracted",
                                                   "wsweibulllocation",
                                                   "height_rel",
                                                   "epsilon_npp",
                                                   "CVdbhDistribution",
                                                   "epsilon_biom_stem",
                                                   "wue",
                                                   "CVwsDistribution",
                                                   "wue_transp",
                                                   "wsrelBias",
                                                   "delta13c",
                                                   "DrelBiaspFS",
                                                   "DrelBiasheight",
                                                   "DrelBiasBasArea",
                                                   "water_runoff_polled",
                                                   "DrelBiasLCL",
                                                   "DrelBiasCrowndiameter"};

/// A number; nothing for what has not been computed: an empty field, or NA as R writes it.
std::optional<double> figure_in(const config::Table& table, std::size_t row, std::string_view column,
                                config::Problems& problems) {
    const std::string& text = table.text(row, column);
    return text.empty() || text == "NA" ? std::nullopt : table.number(row, column, {}, problems);
}

/// What r3PG repeats of its climate table: it agrees whatever the model does.
constexpr std::array<std::string_view, 7> weather_columns{"tmp_min",   "tmp_max", "tmp_ave", "frost_days",
                                                          "solar_rad", "prcp",    "co2"};

}  // namespace

std::vector<std::string> known_columns() {
    std::vector<std::string> known{"date", "species", "year", "month", "month_number"};
    known.insert(known.end(), only_of_r3pg.begin(), only_of_r3pg.end());
    for (const check::Column& column : check::columns()) {
        known.emplace_back(column.name);
    }
    return known;
}

std::string unread_columns(const ReferenceRun& run) {
    const std::vector<std::string> known = known_columns();
    std::string list;
    for (const std::string& column : run.table.columns()) {
        if (std::find(known.begin(), known.end(), column) == known.end()) {
            list += joined(list.empty() ? "; not read: " : ", ", column);
        }
    }
    return list;
}

std::vector<ComparedColumn> compared_columns(const ReferenceRun& run) {
    config::Problems problems;
    std::vector<ComparedColumn> compared;
    for (const check::Column& column : check::columns()) {
        ComparedColumn found{&column, {}};
        for (std::size_t i = 0; run.table.has(column.name) && i < run.table.rows(); ++i) {
            const std::size_t row = run.row_in_run[i];
            const std::optional<double> figure = figure_in(run.table, i, column.name, problems);
            const bool before_the_first_month = row < run.inputs.species.size() && figure == 0.0;
            if (figure && !before_the_first_month) {
                found.figures.push_back({row, *figure});
            }
        }
        if (!found.figures.empty()) {
            compared.push_back(std::move(found));
        }
    }
    const bool is_weather_alone =
        std::all_of(compared.begin(), compared.end(), [](const ComparedColumn& one) {
            return std::find(weather_columns.begin(), weather_columns.end(), one.column->name) !=
                   weather_columns.end();
        });
    if (problems.empty() && !compared.empty() && is_weather_alone) {
        problems.add(
            config::ExitCode::data, {run.table.file()},
            joined("no figure to compare but weather, which both programs are given", unread_columns(run)),
            "columns of r3PG such as biom_stem, dbh, lai or npp, with numbers",
            "add what the other program computed");
    }
    if (problems.empty() && compared.empty()) {
        const bool is_long = run.table.has("variable") && run.table.has("value");
        problems.add(config::ExitCode::data, {run.table.file()},
                     joined("no figure to compare", unread_columns(run)),
                     "columns of r3PG such as biom_stem, dbh, lai or npp, with numbers",
                     is_long ? "turn the table: a column for each `variable` with its `value`"
                             : "name the columns as r3PG does (README.md of forest_production)");
    }
    problems.throw_if_any();
    return compared;
}

}  // namespace coupling::validation::forest_cases
