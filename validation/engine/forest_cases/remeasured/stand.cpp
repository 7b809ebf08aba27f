#include "validation/engine/forest_cases/remeasured/stand.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/exchange/regimes/fell_list.hpp"
#include "forest/climate/change.hpp"
#include "validation/engine/forest_cases/remeasured/growth_check.hpp"
#include "validation/engine/forest_cases/shared/plot_checks.hpp"
#include "validation/engine/forest_cases/shared/slip_checks.hpp"
#include "validation/engine/forest_cases/shared/unknown_columns.hpp"

namespace coupling::validation::forest_cases::remeasured {
namespace {

using config::ExitCode;
using config::joined;
using config::Problems;
using config::Table;

constexpr double highest_tree_id = 1e12;
/// Two measurements of a living stem may differ a little; more is another tree or a slip [choice].
constexpr double thinnest_of_before = 0.8;

double number(const Table& table, std::size_t row, const char* column, config::NumberRange range,
              Problems& problems) {
    return table.number(row, column, range, problems).value_or(range.low);
}

std::optional<double> optional_number(const Table& table, std::size_t row, const char* column,
                                      config::NumberRange range, Problems& problems) {
    return table.has(column) && !table.text(row, column).empty() ? table.number(row, column, range, problems)
                                                                 : std::nullopt;
}

int whole(const Table& table, std::size_t row, const char* column, double low, double high,
          Problems& problems) {
    return static_cast<int>(table.whole(row, column, {low, high}, problems).value_or(0));
}

void check_side(const Table& table, const char* column, double side_m, Problems& problems) {
    if (std::fmod(side_m, forest::patch_side_m) != 0.0) {
        problems.add(ExitCode::data, table.place(0, column), joined(column, " ", table.text(0, column)),
                     "a multiple of 10 m, the width of a patch",
                     "cut the plot, and leave out the trees beyond");
    }
}

void read_site(const Table& table, MeasuredStand& stand, Problems& problems) {
    if (!table.require(
            {"width_m", "length_m", "elevation_m", "latitude_deg", "slope_deg", "aspect_deg", "fertility",
             "water_mm", "nitrogen_kg_ha_yr", "ph", "first_year", "last_year", "least_dbh_cm"},
            problems)) {
        problems.throw_if_any();
    }
    if (table.rows() != 1) {
        problems.add(ExitCode::data, {table.file()}, joined(std::to_string(table.rows()), " rows"),
                     "one: the plot");
        problems.throw_if_any();
    }
    const auto of = [&](const char* column, double low, double high) {
        return number(table, 0, column, {.low = low, .high = high}, problems);
    };
    stand.width_m = of("width_m", 10.0, 2000.0);
    stand.length_m = of("length_m", 10.0, 2000.0);
    check_side(table, "width_m", stand.width_m, problems);
    check_side(table, "length_m", stand.length_m, problems);
    stand.elevation_m = of("elevation_m", -100.0, 4000.0);
    stand.latitude = config::Angle::from_degrees(of("latitude_deg", -66.0, 66.0));
    stand.slope = config::Angle::from_degrees(of("slope_deg", 0.0, 60.0));
    stand.aspect = config::Angle::from_degrees(of("aspect_deg", 0.0, 360.0));
    stand.soil.fertility = of("fertility", 0.0, 1.0);
    stand.soil.water_capacity_mm = of("water_mm", 1.0, 600.0);
    stand.soil.nitrogen_kg_per_ha_year = of("nitrogen_kg_ha_yr", 0.0, 200.0);
    stand.soil.ph = of("ph", 2.5, 9.0);
    if (table.has("soil_class")) {
        stand.soil.texture_class = whole(table, 0, "soil_class", 1.0, 4.0, problems);
    }
    const std::size_t problems_before = problems.list().size();
    stand.first_year = whole(table, 0, "first_year", 1.0, 9999.0, problems);
    stand.last_year = whole(table, 0, "last_year", 1.0, 9999.0, problems);
    if (problems.list().size() == problems_before && stand.last_year <= stand.first_year) {
        problems.add(ExitCode::data, table.place(0, "last_year"),
                     joined("last_year ", table.text(0, "last_year")),
                     joined("a year after first_year (", table.text(0, "first_year"), ")"));
    }
    stand.least_dbh_cm = of("least_dbh_cm", 1.0, 100.0);
    problems.throw_if_any();
}

/// Rows of a table of trees by their numbers.
std::map<std::uint64_t, std::size_t> rows_by_id(const Table& table, Problems& problems) {
    std::map<std::uint64_t, std::size_t> rows;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const auto id = table.whole(row, "tree_id", {0.0, highest_tree_id}, problems);
        if (!id) {
            continue;
        }
        const auto [first, is_new] = rows.emplace(static_cast<std::uint64_t>(*id), row);
        if (!is_new) {
            problems.add(ExitCode::data, table.place(row, "tree_id"),
                         joined("tree_id ", table.text(row, "tree_id"), " a second time, as in line ",
                                std::to_string(table.place(first->second, "tree_id").line)),
                         "one tree_id for each tree");
        }
    }
    return rows;
}

MeasuredTree tree_in(const Table& table, std::size_t row, std::uint64_t id,
                     const forest::SpeciesTable& species, const MeasuredStand& stand, Problems& problems) {
    MeasuredTree tree;
    tree.id = id;
    tree.species = species.find(table.text(row, "species"), table.place(row, "species"), problems)
                       .value_or(forest::SpeciesId{});
    // Trees on the edges stand a little inside: patches there end before them.
    constexpr double inside_m = 0.01;
    tree.x_m = std::clamp(number(table, row, "x_m", {.low = 0.0, .high = stand.width_m}, problems), inside_m,
                          stand.width_m - inside_m);
    tree.y_m = std::clamp(number(table, row, "y_m", {.low = 0.0, .high = stand.length_m}, problems), inside_m,
                          stand.length_m - inside_m);
    const auto dbh_cm = table.number(row, "dbh_cm", {.low = 0.1, .high = 300.0}, problems);
    tree.dbh_cm = dbh_cm.value_or(stand.least_dbh_cm);
    if (dbh_cm && *dbh_cm < stand.least_dbh_cm) {
        problems.add(ExitCode::data, table.place(row, "dbh_cm"),
                     joined("tree ", std::to_string(id), " with dbh_cm ", table.text(row, "dbh_cm")),
                     joined("least_dbh_cm of site.csv or more, ", config::to_text(stand.least_dbh_cm)),
                     "leave the tree out of both tables: thinner trees were not all counted");
    }
    tree.height_m =
        optional_number(table, row, "height_m", {.low = 1.3, .high = 80.0, .low_excluded = true}, problems);
    tree.age_years = optional_number(table, row, "age_years", {.low = 1.0, .high = 1500.0}, problems);
    return tree;
}

void read_start(const Table& table, const forest::SpeciesTable& species, MeasuredStand& stand,
                Problems& problems) {
    if (!table.require({"tree_id", "x_m", "y_m", "species", "dbh_cm"}, problems)) {
        problems.throw_if_any();
    }
    for (const auto& [id, row] : rows_by_id(table, problems)) {
        stand.trees.push_back(tree_in(table, row, id, species, stand, problems));
    }
    if (table.rows() == 0) {
        problems.add(ExitCode::data, {table.file()}, "no tree", "a row for each tree");
    }
    problems.throw_if_any();
}

MeasuredTree* tree_with(MeasuredStand& stand, std::uint64_t id) {
    const auto at = std::lower_bound(stand.trees.begin(), stand.trees.end(), id,
                                     [](const MeasuredTree& tree, std::uint64_t n) { return tree.id < n; });
    return at != stand.trees.end() && at->id == id ? &*at : nullptr;
}

/// How field tables mark a tree that was not there any more.
bool is_no_diameter(const std::string& text) {
    return text.empty() || text == "NA" || text == "-" || config::parse_number(text) == 0.0;
}

void read_end(const Table& table, const forest::SpeciesTable& species, MeasuredStand& stand,
              config::Warnings& warnings, Problems& problems) {
    if (!table.require({"tree_id", "species", "dbh_cm"}, problems)) {
        problems.throw_if_any();
    }
    if (table.rows() == 0) {
        problems.add(ExitCode::data, {table.file()}, "no tree",
                     "a row for each tree that lived at the second measurement");
    }
    GrowthCheck growth{stand};
    std::size_t survivors = 0;
    for (const auto& [id, row] : rows_by_id(table, problems)) {
        const auto kind = species.find(table.text(row, "species"), table.place(row, "species"), problems);
        if (is_no_diameter(table.text(row, "dbh_cm"))) {
            problems.add(ExitCode::data, table.place(row, "dbh_cm"),
                         joined("tree ", std::to_string(id), " without a dbh_cm"), "living trees alone",
                         "leave the row out if the tree is dead or was felled");
            continue;
        }
        const auto dbh_cm = table.number(row, "dbh_cm", {.low = 0.1, .high = 300.0}, problems);
        MeasuredTree* const tree = tree_with(stand, id);
        if (tree != nullptr && kind && *kind != tree->species) {
            problems.add(ExitCode::data, table.place(row, "species"),
                         joined("tree ", std::to_string(id), " is ", table.text(row, "species")),
                         joined("the species of the first measurement, ", species[tree->species].latin_name));
        }
        if (!dbh_cm || !kind) {
            continue;
        }
        const std::size_t line = table.place(row, "dbh_cm").line;
        if (tree == nullptr) {
            if (*dbh_cm >= stand.least_dbh_cm) {
                stand.ingrown.push_back({*kind, *dbh_cm});
                growth.add_new(*dbh_cm, line);
            }
            continue;
        }
        ++survivors;
        tree->end_dbh_cm = *dbh_cm;
        if (*dbh_cm < thinnest_of_before * tree->dbh_cm) {
            problems.add(ExitCode::data, table.place(row, "dbh_cm"),
                         joined("tree ", std::to_string(id), " with dbh_cm ", table.text(row, "dbh_cm"), ", ",
                                config::to_text(tree->dbh_cm), " cm before"),
                         "no tree thinner by more than a fifth",
                         "correct the number or the diameter, or leave the tree out of both tables");
        }
        growth.add(*tree, line);
    }
    if (problems.empty() && survivors == 0 && growth.has_thick_new_trees()) {
        problems.add(ExitCode::data, {table.file()},
                     "no tree_id of the first measurement, and new trees that are too thick for ingrowth",
                     "the same tree_id for a tree in both tables", "correct tree_id");
    }
    if (problems.empty()) {
        growth.report(table, warnings, problems);
    }
    problems.throw_if_any();
}

/// The field with the number of a tree.
config::Place place_of_tree(const Table& table, std::uint64_t id) {
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (config::parse_whole(table.text(row, "tree_id")) == static_cast<long long>(id)) {
            return table.place(row, "tree_id");
        }
    }
    return {table.file()};
}

void read_cuts(const Table& table, MeasuredStand& stand, Problems& problems) {
    for (const coupling::ListedTree& felled : read_fell_list(table)) {
        MeasuredTree* const tree = tree_with(stand, felled.tree);
        const std::string who = joined("tree_id ", std::to_string(felled.tree));
        if (tree == nullptr) {
            problems.add(ExitCode::data, place_of_tree(table, felled.tree),
                         joined(who, " felled, which the first measurement has not"), "trees of trees.csv",
                         "correct tree_id, or leave the row out");
        } else if (tree->end_dbh_cm) {
            problems.add(ExitCode::data, place_of_tree(table, felled.tree),
                         joined(who, " felled, but measured at the end"),
                         "trees that are not in trees_end.csv", "leave it out of one of the tables");
        } else if (felled.year < stand.first_year || felled.year > stand.last_year) {
            problems.add(ExitCode::data, place_of_tree(table, felled.tree),
                         joined(who, " felled in ", std::to_string(felled.year)),
                         joined("a calendar year from ", std::to_string(stand.first_year), " to ",
                                std::to_string(stand.last_year)));
        } else {
            tree->felled = felled.year;
        }
    }
    problems.throw_if_any();
}

void read_saplings(const Table& table, const forest::SpeciesTable& species, MeasuredStand& stand,
                   Problems& problems) {
    if (!table.require({"species", "stems_pha", "height_m"}, problems)) {
        problems.throw_if_any();
    }
    for (std::size_t row = 0; row < table.rows(); ++row) {
        forest::SaplingRecord record;
        record.species = species.find(table.text(row, "species"), table.place(row, "species"), problems)
                             .value_or(forest::SpeciesId{});
        record.stems_pha =
            number(table, row, "stems_pha", {.low = 0.0, .high = 1e6, .low_excluded = true}, problems);
        record.height_m =
            number(table, row, "height_m", {.low = 0.0, .high = 1.9, .low_excluded = true}, problems);
        if (table.has("age_years")) {
            record.age_years = whole(table, row, "age_years", 0.0, 200.0, problems);
        }
        stand.saplings.push_back(record);
    }
    problems.throw_if_any();
}

void check_seasons_of(const MeasuredStand& stand, const Table& site, const Table& climate) {
    Problems problems;
    check_temperature_seasons(stand.latitude.in_degrees(), site.place(0, "latitude_deg"),
                              joined("latitude_deg ", site.text(0, "latitude_deg")), stand.climate,
                              climate.file(), problems);
    problems.throw_if_any();
}

void read_weather(const Table& table, MeasuredStand& stand, config::Warnings& warnings) {
    stand.climate = forest::read_climate_of_one_place(table, warnings);
    if (stand.climate.elevation_m && *stand.climate.elevation_m != stand.elevation_m) {
        stand.climate = forest::at_elevation(stand.climate, stand.elevation_m - *stand.climate.elevation_m,
                                             forest::LapseRates::shipped());
    }
    for (int year = stand.first_year + 1; year <= stand.last_year; ++year) {
        if (stand.climate.find(year) == nullptr) {
            config::fail(ExitCode::data, {table.file()}, joined("no year ", std::to_string(year)),
                         joined("the months of the years ", std::to_string(stand.first_year + 1), " to ",
                                std::to_string(stand.last_year)),
                         "add the months, or correct first_year and last_year of site.csv");
        }
    }
}

/// Columns of the climate are those of forest/README.md; what is made there is noted there.
void warn_of_columns(const MeasuredTables& tables, config::Warnings& warnings) {
    warn_of_unknown_columns(
        tables.site,
        {"width_m", "length_m", "elevation_m", "latitude_deg", "slope_deg", "aspect_deg", "fertility",
         "water_mm", "nitrogen_kg_ha_yr", "ph", "first_year", "last_year", "least_dbh_cm", "soil_class"},
        warnings);
    const std::vector<std::string> of_trees{"tree_id", "x_m",      "y_m",      "species",
                                            "dbh_cm",  "height_m", "age_years"};
    warn_of_unknown_columns(tables.trees, of_trees, warnings);
    warn_of_unknown_columns(tables.trees_end, of_trees, warnings);
    if (tables.fell_list) {
        warn_of_unknown_columns(*tables.fell_list, {"tree_id", "year"}, warnings);
    }
    if (tables.saplings) {
        warn_of_unknown_columns(*tables.saplings, {"species", "stems_pha", "height_m", "age_years"},
                                warnings);
    }
}

}  // namespace

MeasuredStand read_measured_stand(const MeasuredTables& tables, const forest::SpeciesTable& species,
                                  config::Warnings& warnings) {
    MeasuredStand stand;
    warn_of_columns(tables, warnings);
    Problems problems;
    read_site(tables.site, stand, problems);
    read_start(tables.trees, species, stand, problems);
    read_end(tables.trees_end, species, stand, warnings, problems);
    if (tables.fell_list) {
        read_cuts(*tables.fell_list, stand, problems);
    }
    if (tables.saplings) {
        read_saplings(*tables.saplings, species, stand, problems);
    }
    read_weather(tables.climate, stand, warnings);
    check_seasons_of(stand, tables.site, tables.climate);
    warn_of_shared_places(tables.trees, warnings);
    warn_of_trees(tables.trees, stand.area_ha(), warnings);
    warn_of_latitude(stand.latitude.in_degrees(), tables.site.place(0, "latitude_deg"), warnings);
    warn_of_climate_of_another_place(stand.latitude.in_degrees(), stand.elevation_m, stand.climate,
                                     tables.climate.file(), warnings);
    warn_of_empty_edges(tables.trees, {stand.width_m, stand.length_m}, tables.site.file(), warnings);
    return stand;
}

}  // namespace coupling::validation::forest_cases::remeasured
