#include "coupling/validation/forest_cases/yield_trial/comparison.hpp"

#include <algorithm>
#include <cmath>

namespace coupling::validation::forest_cases::yield_trial {

namespace {

using forest::SpeciesId;
using forest::SpeciesTable;
using forest::StandFigures;

/// The number in a field, 0 with a problem added.
double number_in(const config::Table& table, std::size_t row, const char* column, double low, double high,
                 config::Problems& problems) {
    return table.number(row, column, {.low = low, .high = high}, problems).value_or(0.0);
}

int whole_in(const config::Table& table, std::size_t row, const char* column, int low, int high,
             config::Problems& problems) {
    const config::NumberRange range{.low = static_cast<double>(low), .high = static_cast<double>(high)};
    return static_cast<int>(table.whole(row, column, range, problems).value_or(low));
}

void require(const config::Table& table, const std::vector<std::string>& columns) {
    config::Problems problems;
    table.require(columns, problems);
    problems.throw_if_any();
}

const YieldTableRow* find_row(const YieldCase& data, const YieldSite& site, int age_years) {
    const auto row = std::find_if(data.rows.begin(), data.rows.end(), [&](const YieldTableRow& candidate) {
        return candidate.table == site.table && candidate.site_class == site.site_class &&
               candidate.age_years == age_years;
    });
    return row == data.rows.end() ? nullptr : &*row;
}

const forest::ClimateSeries& climate_of(const YieldCase& data, const YieldSite& site) {
    for (const forest::ClimateSeries& series : data.climates) {
        if (series.elevation_m == site.elevation_m) {
            return series;
        }
    }
    config::fail(config::ExitCode::data, {}, "no climate at the elevation of site " + site.name,
                 "a climate for each elevation of the sites: add its rows with that elev_m");
}

double mean_height_m(const StandFigures& figures) {
    return mean_per_lorey_height * figures.lorey_height_m;
}

}  // namespace

std::vector<YieldSite> read_yield_sites(const config::Table& table, const SpeciesTable& species) {
    require(table, {"site", "species", "elevation_m", "fertility", "table", "class"});
    config::Problems problems;
    std::vector<YieldSite> sites;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        YieldSite site;
        site.name = table.text(row, "site");
        const auto kind = species.find(table.text(row, "species"), table.place(row, "species"), problems);
        site.species = kind.value_or(SpeciesId{});
        site.elevation_m = number_in(table, row, "elevation_m", 0.0, 4000.0, problems);
        site.fertility = number_in(table, row, "fertility", 0.0, 1.0, problems);
        site.table = table.text(row, "table");
        if (!site.table.empty()) {
            site.site_class = number_in(table, row, "class", 0.0, 10.0, problems);
        }
        sites.push_back(site);
    }
    problems.throw_if_any();
    return sites;
}

std::vector<YieldTableRow> read_yield_rows(const config::Table& table) {
    require(table, {"table", "class", "age_years", "mean_height_m", "stems_pha", "basal_area_m2pha",
                    "mean_dbh_cm", "volume_m3pha"});
    config::Problems problems;
    std::vector<YieldTableRow> rows;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        rows.push_back({.table = table.text(row, "table"),
                        .site_class = number_in(table, row, "class", 0.0, 10.0, problems),
                        .age_years = whole_in(table, row, "age_years", 1, 1000, problems),
                        .mean_height_m = number_in(table, row, "mean_height_m", 0.0, 100.0, problems),
                        .mean_dbh_cm = number_in(table, row, "mean_dbh_cm", 0.0, 300.0, problems),
                        .stems_pha = number_in(table, row, "stems_pha", 0.0, 100'000.0, problems),
                        .basal_area_m2pha = number_in(table, row, "basal_area_m2pha", 0.0, 200.0, problems),
                        .volume_m3pha = number_in(table, row, "volume_m3pha", 0.0, 5000.0, problems)});
    }
    problems.throw_if_any();
    return rows;
}

std::vector<YieldComparison> compare_yields(const YieldCase& data, const SpeciesTable& species,
                                            forest::TreeLight light, const std::vector<int>& ages_years) {
    std::vector<YieldComparison> comparisons;
    for (const YieldSite& site : data.sites) {
        YieldTrial trial;
        trial.species = site.species;
        trial.soil.fertility = site.fertility;
        trial.weather = climate_of(data, site).years;
        trial.parameters = data.parameters;
        trial.parameters.processes.light = light;
        for (const TrialState& state : grow_trial(trial, species, ages_years)) {
            YieldComparison comparison{site.name, state.age_years, state.figures, {}};
            const YieldTableRow* const row = find_row(data, site, state.age_years);
            if (row != nullptr) {
                comparison.published = *row;
            } else if (!site.table.empty()) {
                config::fail(config::ExitCode::data, {},
                             "no row of table " + config::in_quotes(site.table) + " for site " + site.name +
                                 " at age " + std::to_string(state.age_years));
            }
            comparisons.push_back(comparison);
        }
    }
    return comparisons;
}

std::vector<std::pair<std::string, double>> yield_figures(const std::vector<YieldComparison>& comparisons) {
    std::vector<std::pair<std::string, double>> figures;
    for (const YieldComparison& one : comparisons) {
        const std::string place = ":" + one.site + ":" + std::to_string(one.age_years);
        const StandFigures& stand = one.simulated;
        figures.emplace_back("volume_m3pha" + place, stand.volume_m3pha);
        figures.emplace_back("dbh_cm" + place, stand.mean_dbh_cm);
        figures.emplace_back("height_m" + place, mean_height_m(stand));
        figures.emplace_back("stems_pha" + place, stand.stems_pha);
        if (one.published) {
            const YieldTableRow& table = *one.published;
            figures.emplace_back("volume_ratio" + place, stand.volume_m3pha / table.volume_m3pha);
            figures.emplace_back("dbh_ratio" + place, stand.mean_dbh_cm / table.mean_dbh_cm);
            figures.emplace_back("height_ratio" + place, mean_height_m(stand) / table.mean_height_m);
            figures.emplace_back("stems_ratio" + place, stand.stems_pha / table.stems_pha);
        }
    }
    return figures;
}

}  // namespace coupling::validation::forest_cases::yield_trial
