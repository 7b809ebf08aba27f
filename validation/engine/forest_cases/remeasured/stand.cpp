#include "validation/engine/forest_cases/remeasured/stand.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "config/table/schema.hpp"
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

/// Two measurements of a living stem may differ a little; more is another tree or a slip [choice].
constexpr double thinnest_of_before = 0.8;

/// A row of a table of trees.
struct TreeIn : MeasuredTree {
    std::string species_name;
};
struct SaplingsIn : forest::SaplingRecord {
    std::string species_name;
};

// clang-format off
config::Schema<MeasuredStand> site_columns() {
    using S = MeasuredStand;
    return {{.role = "site", .setting = "site.csv", .row = "plot"},
            {{"width_m", &S::width_m, "", {.range = {10.0, 2000.0}}},
             {"length_m", &S::length_m, "", {.range = {10.0, 2000.0}}},
             {"elevation_m", &S::elevation_m, "", {.range = {-100.0, 4000.0}}},
             {"latitude_deg", &S::latitude, "", {.range = {-66.0, 66.0}}},
             {"slope_deg", &S::slope, "", {.range = {0.0, 60.0}}},
             {"aspect_deg", &S::aspect, "", {.range = {0.0, 360.0}}},
             {"fertility", [](S& s) -> auto& { return s.soil.fertility; }, "", {.range = {0.0, 1.0}}},
             {"water_mm", [](S& s) -> auto& { return s.soil.water_capacity_mm; }, "", {.range = {1.0, 600.0}}},
             {"nitrogen_kg_ha_yr", [](S& s) -> auto& { return s.soil.nitrogen_kg_per_ha_year; }, "", {.range = {0.0, 200.0}}},
             {"ph", [](S& s) -> auto& { return s.soil.ph; }, "", {.range = {2.5, 9.0}}},
             {"soil_class", [](S& s) -> auto& { return s.soil.texture_class; }, "", {.range = {1.0, 4.0}, .optional = true}},
             {"first_year", &S::first_year, "", {.range = {1.0, 9999.0}}},
             {"last_year", &S::last_year, "", {.range = {1.0, 9999.0}}},
             {"least_dbh_cm", &S::least_dbh_cm, "", {.range = {1.0, 100.0}}}}};
}

/// At the start with places; of the end only what both measured.
config::Schema<TreeIn> tree_columns(bool at_start) {
    std::vector<config::ColumnOf<TreeIn>> columns{
        {"tree_id", &TreeIn::id, "", {.range = {0.0, 1e12}, .unique = true}},
        {"x_m", &TreeIn::x_m, "", {.optional = !at_start}},
        {"y_m", &TreeIn::y_m, "", {.optional = !at_start}},
        {"species", &TreeIn::species_name, "", {.may_be_empty = true}}};
    if (at_start) {
        columns.push_back({"dbh_cm", &TreeIn::dbh_cm, "", {.range = {0.1, 300.0}}});
        columns.push_back({"height_m", &TreeIn::height_m, "", {.range = {1.3, 80.0, config::above}}});
        columns.push_back({"age_years", &TreeIn::age_years, "", {.range = {1.0, 1500.0}}});
    } else {
        columns.push_back({"dbh_cm", ""});
    }
    return {{.role = "trees", .setting = at_start ? "trees.csv" : "trees_end.csv", .row = "tree",
             .no_rows = at_start ? "a row for each tree" : "a row for each tree that lived at the second measurement"}, std::move(columns)};
}

config::Schema<SaplingsIn> sapling_columns() {
    using S = SaplingsIn;
    return {{.role = "saplings", .setting = "saplings.csv", .row = "record"},
            {{"species", &S::species_name, "", {.may_be_empty = true}},
             {"stems_pha", &S::stems_pha, "", {.range = {0.0, 1e6, config::above}}},
             {"height_m", &S::height_m, "", {.range = {0.0, 1.9, config::above}}},
             {"age_years", &S::age_years, "", {.range = {0.0, 200.0}, .optional = true}}}};
}
// clang-format on

MeasuredStand read_site(const Table& table) {
    config::RowProblems wrong{table};
    const auto plots = site_columns().rows(table, wrong);
    if (table.rows() != 1) {
        wrong.refuse(joined(std::to_string(table.rows()), " rows"), "one: the plot");
    }
    for (const config::Read<MeasuredStand>& plot : plots) {
        for (const auto& [column, side_m] :
             {std::pair{"width_m", plot.width_m}, std::pair{"length_m", plot.length_m}}) {
            if (std::fmod(side_m, forest::patch_side_m) != 0.0) {
                wrong.refuse(plot.row, column, joined(column, " ", table.text(plot.row, column)),
                             "a multiple of 10 m, the width of a patch",
                             "cut the plot, and leave out the trees beyond");
            }
        }
        if (plot.last_year <= plot.first_year) {
            wrong.refuse(plot.row, "last_year", joined("last_year ", std::to_string(plot.last_year)),
                         joined("a year after first_year (", std::to_string(plot.first_year), ")"));
        }
    }
    wrong.throw_first();
    return plots.front();
}

/// The rows of a table of trees by their numbers, with their species where it is known.
std::vector<config::Read<TreeIn>> trees_in(const Table& table, bool at_start, config::RowProblems& wrong) {
    std::vector<config::Read<TreeIn>> trees = tree_columns(at_start).rows(table, wrong);
    std::sort(trees.begin(), trees.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
    return trees;
}

void read_start(const Table& table, const forest::SpeciesTable& species, MeasuredStand& stand) {
    // Trees on the edges stand a little inside: patches there end before them.
    constexpr double inside_m = 0.01;
    config::RowProblems wrong{table};
    for (config::Read<TreeIn>& tree : trees_in(table, true, wrong)) {
        tree.species = species.find(tree.species_name, table.place(tree.row, "species"), wrong)
                           .value_or(forest::SpeciesId{});
        table.number(tree.row, "x_m", {0.0, stand.width_m}, wrong);
        table.number(tree.row, "y_m", {0.0, stand.length_m}, wrong);
        tree.x_m = std::clamp(tree.x_m, inside_m, stand.width_m - inside_m);
        tree.y_m = std::clamp(tree.y_m, inside_m, stand.length_m - inside_m);
        if (tree.dbh_cm < stand.least_dbh_cm) {
            wrong.refuse(
                tree.row, "dbh_cm",
                joined("tree ", std::to_string(tree.id), " with dbh_cm ", table.text(tree.row, "dbh_cm")),
                joined("least_dbh_cm of site.csv or more, ", config::to_text(stand.least_dbh_cm)),
                "leave the tree out of both tables: thinner trees were not all counted");
        }
        stand.trees.push_back(tree);
    }
    wrong.throw_first();
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
              config::Warnings& warnings) {
    config::RowProblems wrong{table};
    GrowthCheck growth{stand};
    std::size_t survivors = 0;
    for (const config::Read<TreeIn>& row : trees_in(table, false, wrong)) {
        const std::string who = joined("tree ", std::to_string(row.id));
        const auto kind = species.find(row.species_name, table.place(row.row, "species"), wrong);
        const std::string& dbh_text = table.text(row.row, "dbh_cm");
        if (is_no_diameter(dbh_text)) {
            wrong.refuse(row.row, "dbh_cm", joined(who, " without a dbh_cm"), "living trees alone",
                         "leave the row out if the tree is dead or was felled");
            continue;
        }
        const auto dbh_cm = table.number(row.row, "dbh_cm", {.low = 0.1, .high = 300.0}, wrong);
        MeasuredTree* const tree = tree_with(stand, row.id);
        if (tree != nullptr && kind && *kind != tree->species) {
            wrong.refuse(row.row, "species", joined(who, " is ", row.species_name),
                         joined("the species of the first measurement, ", species[tree->species].latin_name));
        }
        if (!dbh_cm || !kind) {
            continue;
        }
        const std::size_t line = table.place(row.row, "dbh_cm").line;
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
            wrong.refuse(
                row.row, "dbh_cm",
                joined(who, " with dbh_cm ", dbh_text, ", ", config::to_text(tree->dbh_cm), " cm before"),
                "no tree thinner by more than a fifth",
                "correct the number or the diameter, or leave the tree out of both tables");
        }
        growth.add(*tree, line);
    }
    if (wrong.empty() && survivors == 0 && growth.has_thick_new_trees()) {
        wrong.refuse("no tree_id of the first measurement, and new trees that are too thick for ingrowth",
                     "the same tree_id for a tree in both tables", "correct tree_id");
    }
    if (wrong.empty()) {
        growth.report(table, warnings, wrong);
    }
    wrong.throw_first();
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

void read_cuts(const Table& table, MeasuredStand& stand) {
    Problems problems;
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

void read_saplings(const Table& table, const forest::SpeciesTable& species, MeasuredStand& stand) {
    config::RowProblems wrong{table};
    for (config::Read<SaplingsIn>& row : sapling_columns().rows(table, wrong)) {
        row.species = species.find(row.species_name, table.place(row.row, "species"), wrong)
                          .value_or(forest::SpeciesId{});
        stand.saplings.push_back(row);
    }
    wrong.throw_first();
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
    warn_of_unknown_columns(tables.site, site_columns().names(), warnings);
    const std::vector<std::string> of_trees = tree_columns(true).names();
    warn_of_unknown_columns(tables.trees, of_trees, warnings);
    warn_of_unknown_columns(tables.trees_end, of_trees, warnings);
    if (tables.fell_list) {
        warn_of_unknown_columns(*tables.fell_list, {"tree_id", "year"}, warnings);
    }
    if (tables.saplings) {
        warn_of_unknown_columns(*tables.saplings, sapling_columns().names(), warnings);
    }
}

}  // namespace

MeasuredStand read_measured_stand(const MeasuredTables& tables, const forest::SpeciesTable& species,
                                  config::Warnings& warnings) {
    warn_of_columns(tables, warnings);
    MeasuredStand stand = read_site(tables.site);
    read_start(tables.trees, species, stand);
    read_end(tables.trees_end, species, stand, warnings);
    if (tables.fell_list) {
        read_cuts(*tables.fell_list, stand);
    }
    if (tables.saplings) {
        read_saplings(*tables.saplings, species, stand);
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
