#include "validation/engine/forest_cases/yield_trial/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "config/text/numbers.hpp"
#include "forest/stand/allometry.hpp"

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

double above_zero(const config::Table& table, std::size_t row, const char* column, double high,
                  config::Problems& problems) {
    return table.number(row, column, {.low = 0.0, .high = high, .low_excluded = true}, problems)
        .value_or(1.0);
}

/// The class of a table, in its own words.
std::string class_in(const config::Table& table, std::size_t row, config::Problems& problems) {
    const std::string& text = table.text(row, "class");
    if (text.empty()) {
        problems.add(config::ExitCode::data, table.place(row, "class"), "no class",
                     "the site class or yield level as the table names it, such as 2, II.5 or M34");
    }
    return text;
}

void require(const config::Table& table, const std::vector<std::string>& columns) {
    config::Problems problems;
    table.require(columns, problems);
    problems.throw_if_any();
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

StandAtAge stand_of(const YieldTableRow& row) {
    return {.age_years = row.age_years,
            .stems_pha = row.stems_pha,
            .mean_dbh_cm = row.mean_dbh_cm,
            .mean_height_m = row.mean_height_m};
}

bool agrees(double simulated, double published) {
    constexpr double within = 0.15;
    return std::abs(simulated / published - 1.0) <= within;
}

}  // namespace

std::vector<std::string> site_columns() {
    return {"site",  "species", "elevation_m",       "fertility",
            "table", "class",   "nitrogen_kg_ha_yr", "latitude_deg"};
}

std::vector<std::string> row_columns() {
    return {"table",     "class",       "age_years",    "mean_height_m",
            "stems_pha", "mean_dbh_cm", "volume_m3pha", "basal_area_m2pha"};
}

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
        site.soil.fertility = number_in(table, row, "fertility", 0.0, 1.0, problems);
        site.table = table.text(row, "table");
        if (!site.table.empty()) {
            site.site_class = class_in(table, row, problems);
        }
        if (table.has("nitrogen_kg_ha_yr")) {
            site.soil.nitrogen_kg_per_ha_year =
                number_in(table, row, "nitrogen_kg_ha_yr", 0.0, 200.0, problems);
        }
        if (table.has("latitude_deg")) {
            site.latitude =
                config::Angle::from_degrees(number_in(table, row, "latitude_deg", -66.0, 66.0, problems));
        }
        sites.push_back(site);
    }
    problems.throw_if_any();
    return sites;
}

std::vector<YieldTableRow> read_yield_rows(const config::Table& table) {
    require(table,
            {"table", "class", "age_years", "mean_height_m", "stems_pha", "mean_dbh_cm", "volume_m3pha"});
    config::Problems problems;
    std::vector<YieldTableRow> rows;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        rows.push_back({.table = table.text(row, "table"),
                        .site_class = class_in(table, row, problems),
                        .age_years = whole_in(table, row, "age_years", 1, 1000, problems),
                        .mean_height_m = above_zero(table, row, "mean_height_m", 100.0, problems),
                        .mean_dbh_cm = above_zero(table, row, "mean_dbh_cm", 300.0, problems),
                        .stems_pha = above_zero(table, row, "stems_pha", 100'000.0, problems),
                        .volume_m3pha = above_zero(table, row, "volume_m3pha", 5000.0, problems)});
        YieldTableRow& last = rows.back();
        last.basal_area_m2pha = table.has("basal_area_m2pha")
                                    ? above_zero(table, row, "basal_area_m2pha", 200.0, problems)
                                    : last.stems_pha * forest::basal_area_m2(last.mean_dbh_cm);
        for (std::size_t other = 0; other < row; ++other) {
            if (rows[other].table == last.table && rows[other].age_years == last.age_years &&
                is_same_class(rows[other].site_class, last.site_class)) {
                problems.add(config::ExitCode::data, table.place(row, "age_years"),
                             "age " + std::to_string(last.age_years) + " of " + last.table + ", class " +
                                 last.site_class + ", a second time",
                             "each age of a class once", "leave one of the rows out");
            }
        }
    }
    problems.throw_if_any();
    return rows;
}

std::vector<YieldTableRow> rows_of(const YieldCase& data, const YieldSite& site) {
    std::vector<YieldTableRow> rows;
    std::copy_if(data.rows.begin(), data.rows.end(), std::back_inserter(rows), [&](const YieldTableRow& row) {
        return !site.table.empty() && row.table == site.table &&
               is_same_class(row.site_class, site.site_class);
    });
    std::sort(rows.begin(), rows.end(),
              [](const YieldTableRow& a, const YieldTableRow& b) { return a.age_years < b.age_years; });
    return rows;
}

bool is_same_class(const std::string& a, const std::string& b) {
    const std::optional<double> first = config::parse_number(a);
    const std::optional<double> second = config::parse_number(b);
    return first && second ? *first == *second : a == b;
}

std::vector<int> ages_of_tables(const YieldCase& data) {
    std::set<int> ages;
    for (const YieldSite& site : data.sites) {
        const std::vector<YieldTableRow> rows = rows_of(data, site);
        for (std::size_t i = 1; i < rows.size(); ++i) {
            ages.insert(rows[i].age_years);
        }
    }
    return {ages.begin(), ages.end()};
}

std::vector<int> ages_of(const YieldCase& data, const YieldSite& site, const std::vector<int>& ages_years) {
    if (site.table.empty()) {
        return ages_years;
    }
    const std::vector<YieldTableRow> rows = rows_of(data, site);
    std::vector<int> ages;
    std::copy_if(ages_years.begin(), ages_years.end(), std::back_inserter(ages), [&](int age_years) {
        return !rows.empty() && age_years > rows.front().age_years &&
               std::any_of(rows.begin(), rows.end(),
                           [&](const YieldTableRow& row) { return row.age_years == age_years; });
    });
    return ages;
}

SiteYields compare_yields(const YieldCase& data, const YieldSite& site, const SpeciesTable& species,
                          Treatment treatment, forest::TreeLight light, const std::vector<int>& ages_years) {
    const std::vector<YieldTableRow> rows = rows_of(data, site);
    if (rows.empty() && !site.table.empty()) {
        config::fail(
            config::ExitCode::data, {},
            "no row of table " + config::in_quotes(site.table) + " for the class of site " + site.name,
            "the rows of that class in yield_tables.csv");
    }
    YieldTrial trial;
    trial.species = site.species;
    trial.soil = site.soil;
    trial.latitude = site.latitude;
    trial.weather = climate_of(data, site).years;
    trial.parameters = data.parameters;
    trial.parameters.processes.light = light;
    if (!rows.empty()) {
        trial.start = stand_of(rows.front());
    }
    if (treatment == Treatment::as_the_table) {
        for (const YieldTableRow& row : rows) {
            trial.thinnings.push_back({row.age_years, row.stems_pha});
        }
    }
    const TrialRun run = grow_trial(trial, species, ages_of(data, site, ages_years));
    SiteYields yields{
        .ages = {}, .greatest_density = run.greatest_density, .density_at_25cm = run.density_at_25cm};
    for (const TrialState& state : run.states) {
        YieldComparison comparison{site.name, state.age_years, state, {}};
        const auto row = std::find_if(rows.begin(), rows.end(), [&](const YieldTableRow& candidate) {
            return candidate.age_years == state.age_years;
        });
        if (row != rows.end()) {
            comparison.published = *row;
        }
        yields.ages.push_back(std::move(comparison));
    }
    return yields;
}

std::vector<std::pair<std::string, double>> yield_figures(const SiteYields& yields) {
    std::vector<std::pair<std::string, double>> figures;
    for (const YieldComparison& one : yields.ages) {
        const std::string place = ":" + one.site + ":" + std::to_string(one.age_years);
        const StandFigures& stand = one.simulated.figures;
        figures.emplace_back("volume_m3pha" + place, stand.volume_m3pha);
        figures.emplace_back("dbh_cm" + place, stand.mean_dbh_cm);
        figures.emplace_back("height_m" + place, one.simulated.mean_height_m);
        figures.emplace_back("stems_pha" + place, stand.stems_pha);
        if (one.published) {
            const YieldTableRow& table = *one.published;
            figures.emplace_back("volume_ratio" + place, stand.volume_m3pha / table.volume_m3pha);
            figures.emplace_back("dbh_ratio" + place, stand.mean_dbh_cm / table.mean_dbh_cm);
            figures.emplace_back("height_ratio" + place, one.simulated.mean_height_m / table.mean_height_m);
            figures.emplace_back("stems_ratio" + place, stand.stems_pha / table.stems_pha);
        }
    }
    return figures;
}

std::vector<std::pair<std::string, double>> twin_figures(const SiteYields& yields) {
    std::vector<std::pair<std::string, double>> figures;
    for (const YieldComparison& one : yields.ages) {
        const std::string place = ":" + one.site + ":" + std::to_string(one.age_years);
        const StandFigures& stand = one.simulated.figures;
        figures.emplace_back("twin_volume_m3pha" + place, stand.volume_m3pha);
        figures.emplace_back("twin_stems_pha" + place, stand.stems_pha);
        figures.emplace_back("slenderness" + place, one.simulated.dominant_slenderness);
        if (one.published) {
            figures.emplace_back(
                "top_height_ratio" + place,
                stand.dominant_height_m / (top_per_mean_height * one.published->mean_height_m));
        }
    }
    if (!yields.ages.empty()) {
        const std::string& site = yields.ages.front().site;
        figures.emplace_back("greatest_density:" + site, yields.greatest_density);
        if (yields.density_at_25cm) {
            figures.emplace_back("density_at_25cm:" + site, *yields.density_at_25cm);
        }
    }
    return figures;
}

Agreement& Agreement::operator+=(const Agreement& other) {
    figures += other.figures;
    agree += other.agree;
    return *this;
}

Agreement agreement_of(const SiteYields& yields, int from_years, int to_years) {
    Agreement agreement;
    for (const YieldComparison& one : yields.ages) {
        if (!one.published || one.age_years < from_years || one.age_years > to_years) {
            continue;
        }
        const YieldTableRow& table = *one.published;
        agreement.figures += 3;
        agreement.agree += agrees(one.simulated.figures.volume_m3pha, table.volume_m3pha) ? 1 : 0;
        agreement.agree += agrees(one.simulated.figures.mean_dbh_cm, table.mean_dbh_cm) ? 1 : 0;
        agreement.agree += agrees(one.simulated.mean_height_m, table.mean_height_m) ? 1 : 0;
    }
    return agreement;
}

}  // namespace coupling::validation::forest_cases::yield_trial
