#include "coupling/inputs/forest/tree_input.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>

#include "config/random/distributions.hpp"
#include "config/random/stream.hpp"
#include "config/text/coordinates.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/forest/species_table.hpp"
#include "coupling/inputs/forest/tops/canopy_input.hpp"
#include "coupling/inputs/forest/tops/species_of_tops.hpp"
#include "coupling/inputs/forest/unplaced_trees.hpp"
#include "coupling/inputs/plausible/close_trees.hpp"
#include "coupling/inputs/plausible/cut_command.hpp"
#include "coupling/inputs/plausible/odd_trees.hpp"
#include "coupling/inputs/plausible/off_terrain.hpp"
#include "coupling/inputs/plausible/repeated_trees.hpp"
#include "coupling/inputs/plausible/tree_warnings.hpp"
#include "coupling/inputs/plausible/units.hpp"
#include "coupling/inputs/reading/declared_tables.hpp"
#include "coupling/inputs/reading/doubled_ids.hpp"
#include "coupling/inputs/scenario/run_settings.hpp"
#include "coupling/inputs/scenario/tree_settings.hpp"
#include "coupling/inputs/tables/needed_columns.hpp"
#include "forest/start/diameter_of_height.hpp"
#include "forest/start/height_curve.hpp"

namespace coupling {
namespace {

using config::joined;

std::vector<config::ColumnOf<TreeRow>> tree_fields(bool may_be_dead) {
    using config::above;
    // clang-format off
    std::vector<config::ColumnOf<TreeRow>> fields{
        {"tree_id", &TreeRow::id, "number or name, for results; else the number of the row", {.optional = true}},
        {"x_m", &TreeRow::x_m, "east"},
        {"y_m", &TreeRow::y_m, "north"},
        {"species", "code or name; no column: trees.species for all", config::FieldRules{.may_be_empty = true, .instead = "set trees.species: to one of all trees, or to shares (PIAB 60, FASY 40)"}},
        {"dbh_cm", &TreeRow::dbh_cm, "diameter at 1.3 m; empty, or no column: from height_m and the kind of tree", {.range = {0.0, 500.0, above}, .optional = true}},
        {"height_m", &TreeRow::height_m, "of the whole tree; empty: from a curve through the measured ones, or one of the Prealps", {.range = {0.0, 150.0, above}, .advice = "leave the field empty where the height is unknown"}},
        {"age_years", &TreeRow::age_years, "for a forest over years", {.range = {0.0, 2000.0}}}};
    // clang-format on
    if (!may_be_dead) {
        fields.push_back({"state",
                          &TreeRow::state,
                          "alive",
                          {.optional = true,
                           .words = {"living"},
                           .advice = "leave it out of the list: a growing forest has dead wood of its own"}});
        return fields;
    }
    // clang-format off
    fields.push_back(
        {"state", &TreeRow::state, "what stands", {.optional = true, .words = {"living", "snag", "stump"}}});
    // clang-format on
    fields.push_back({"strength",
                      &TreeRow::strength,
                      "share of that of sound wood; empty: 1",
                      {.unit = "-", .range = {0.0, 1.0}, .optional = true}});
    fields.push_back({"broken_at_m",
                      &TreeRow::broken_at_m,
                      "the stem ends here, height_m being that of the whole tree",
                      {.range = {0.0, 150.0, above}, .optional = true}});
    return fields;
}

/// The curve through all measured heights. Where they do not rise with the diameter it is that through the
/// mean tree, with a warning if any height is missing.
forest::HeightFit fit_of_all(const std::vector<forest::MeasuredHeight>& all,
                             const std::vector<ListedRow>& rows, const std::string& file, Reading& reading) {
    forest::HeightFit fit = forest::fit_heights(all);
    const bool any_missing =
        std::any_of(rows.begin(), rows.end(), [](const ListedRow& row) { return !row.height_m; });
    if (fit.trees > 0 || all.size() < forest::fewest_fitted_trees || !any_missing) {
        return fit;
    }
    const auto n = static_cast<double>(all.size());
    double dbh_cm = 0.0;
    double height_m = 0.0;
    for (const forest::MeasuredHeight& tree : all) {
        dbh_cm += tree.dbh_cm / n;
        height_m += tree.height_m / n;
    }
    constexpr double lowest_m = 1.6;  // the curve needs a mean tree above 1.5 m
    if (height_m < lowest_m) {
        return fit;
    }
    fit.curve = forest::curve_through(dbh_cm, height_m);
    fit.trees = all.size();
    double squares = 0.0;
    for (const forest::MeasuredHeight& tree : all) {
        const double miss_m = tree.height_m - fit.curve.height_m(tree.dbh_cm);
        squares += miss_m * miss_m;
    }
    fit.standard_error_m = std::sqrt(squares / (n - 1.0));
    reading.warn({file},
                 joined(counted(all.size(), "measured height"), " that do not rise with the diameter"),
                 "taller trees where they are thicker",
                 "check dbh_cm and height_m: missing heights are filled in from the mean tree");
    return fit;
}

/// Fills heights from a curve through the measured ones of the species, else of all species, else of another
/// stand, with a note or a warning.
std::vector<TreeRecord> with_heights(const std::vector<ListedRow>& rows, const SpeciesTable& species,
                                     const config::Table& table, Reading& reading) {
    std::map<std::size_t, std::vector<forest::MeasuredHeight>> measured;
    std::vector<forest::MeasuredHeight> all;
    for (const ListedRow& row : rows) {
        if (row.height_m && *row.height_m > 1.3 && !row.is_dead()) {
            measured[row.species].push_back({row.dbh_cm, *row.height_m});
            all.push_back({row.dbh_cm, *row.height_m});
        }
    }
    const forest::HeightFit of_all = fit_of_all(all, rows, table.file(), reading);
    std::map<std::size_t, forest::HeightFit> fits;
    std::map<std::size_t, std::size_t> filled;
    std::vector<TreeRecord> trees;
    trees.reserve(rows.size());
    for (const ListedRow& row : rows) {
        double height_m = row.height_m.value_or(0.0);
        if (!row.height_m) {
            const auto [fit, is_new] = fits.try_emplace(row.species);
            if (is_new) {
                fit->second = forest::fit_heights(measured[row.species]);
            }
            ++filled[row.species];
            const forest::HeightFit& used = fit->second.trees > 0 ? fit->second : of_all;
            height_m = (used.trees > 0 ? used.curve : forest::curve_of_prealps).height_m(row.dbh_cm);
        }
        const Species& kind = species.all()[row.species];
        trees.push_back(
            {row.id,
             kind.code,
             {row.x_m, row.y_m, row.dbh_cm, height_m, kind.fracture_energy, row.strength, row.broken_at_m},
             row.has_derived_dbh});
    }
    std::size_t from_elsewhere = 0;
    for (const auto& [place, count] : filled) {
        const bool has_own = fits[place].trees > 0;
        const forest::HeightFit& used = has_own ? fits[place] : of_all;
        if (used.trees == 0) {
            from_elsewhere += count;
            continue;
        }
        std::ostringstream error;
        error << std::fixed << std::setprecision(1) << used.standard_error_m;
        reading.note(joined(table.file(), ": ", counted(count, "height"), " of ", species.all()[place].code,
                            " filled in from a height curve through ", std::to_string(used.trees),
                            " measured trees", has_own ? "" : " of all species", " (standard error ",
                            error.str(), " m)"));
    }
    if (from_elsewhere > 0) {
        reading.warn({table.file()},
                     joined(counted(from_elsewhere, "tree"), " without height_m, and ",
                            counted(all.size(), "measured height")),
                     "measured heights of five trees of different diameters at least",
                     "heights are those of a stand in the French Prealps, one tree +- 2.4 m; what stops a "
                     "rock is the diameter");
    }
    return trees;
}

/// A list needs of each tree its diameter or its height, beside the columns that all need.
void require_needed(const config::Table& table, bool may_be_dead) {
    config::Problems missing;
    require_columns(table, tree_columns(may_be_dead), missing);
    if (!table.find("dbh_cm") && !table.find("height_m")) {
        require_columns(table, "trees", {"dbh_cm"}, missing);
    }
    missing.throw_if_any();
}

/// Of the random numbers of a tree. Tops of a raster are known by their place in mm, so that they stay what
/// they are where the raster begins elsewhere; places 16.8 km apart share numbers.
std::uint64_t draw_key_of(const ListedRow& tree, const TreeSettings& trees) {
    return trees.canopy.empty() ? tree.row : key_of_place(tree.x_m, tree.y_m);
}

/// Of rows that have none, from their heights, with a warning.
void derive_diameters(std::vector<ListedRow>& rows, const config::Table& table, const SpeciesLookup& lookup,
                      config::RowProblems& wrong, Reading& reading) {
    std::vector<double> heights_m;
    for (ListedRow& tree : rows) {
        if (tree.dbh_cm > 0.0) {
            continue;
        }
        if (!tree.height_m || *tree.height_m <= rockfall::breast_height_m) {
            wrong.refuse(tree.row, table.has("dbh_cm") ? "dbh_cm" : "height_m",
                         "a tree without dbh_cm and without a height above 1.3 m",
                         "the diameter at 1.3 m, or a height to derive it from");
            continue;
        }
        const config::RandomStream stream{{reading.run().seed, 0, 0, draw_key_of(tree, reading.trees())},
                                          config::Purpose::stand};
        const forest::DiameterOfHeight& law =
            lookup.is_conifer(tree.species) ? forest::diameter_of_conifer : forest::diameter_of_broadleaf;
        tree.dbh_cm = law.dbh_cm(*tree.height_m, config::normal_quantile(stream.uniforms_of(0)[0]));
        tree.has_derived_dbh = true;
        heights_m.push_back(*tree.height_m);
    }
    if (!heights_m.empty()) {
        reading.warn(
            {table.file()}, joined(counted(heights_m.size(), "tree"), " without dbh_cm"),
            "measured diameters",
            "they are derived from heights (conifers 1.28 H^1.085, others 1.11 H^1.032, one tree "
            "+- 24 %, a whole stand +- 22 %), and trees that stand below the crowns of others are "
            "missing in a laser scan: measure some, or say in what you publish that they are derived",
            config::Effect::answer);
    }
    plausible::judge_heights_without_dbh(std::move(heights_m), table.file(), reading);
}

void warn_of_borrowers(const SpeciesColumn& column, const SpeciesTable& known, const std::string& file,
                       Reading& reading) {
    std::map<std::string, std::string> sentences;
    for (const auto& [place, count] : column.counts()) {
        const Species& species = known.all()[place];
        if (!species.stand_in.empty()) {
            sentences[species.code] =
                joined(file, ": ", counted(count, "tree"), " of ", species.code, " (", species.latin_name,
                       ") taken like ", species.stand_in, ", but with their own fracture energy of ",
                       config::to_text(species.fracture_energy),
                       "; write another code if another species comes nearer");
        }
    }
    for (const auto& [code, sentence] : sentences) {
        reading.note(sentence);
    }
}

void warn_of_doubled_places(const std::vector<ListedRow>& rows, const std::string& file, Reading& reading) {
    std::set<std::pair<double, double>> places;
    for (const ListedRow& row : rows) {
        places.emplace(row.x_m, row.y_m);
    }
    if (places.size() < rows.size()) {
        reading.note(
            joined(file, ": ", counted(rows.size() - places.size(), "tree"), " on the same spot as another"));
    }
}

std::vector<TreeRecord> read_tree_table(Reading& reading) {
    const config::Table table = tree_table(reading);
    const SpeciesTable known = SpeciesTable::shipped();
    const ListedTrees trees = read_listed_rows(table, lookup_in(known), reading, true);
    warn_of_borrowers(trees.species, known, table.file(), reading);
    warn_of_doubled_places(trees.rows, table.file(), reading);
    return with_heights(trees.rows, known, table, reading);
}

/// Places that are those of parts of a plot, or twice too small, put a forest into a garden.
void judge_density(const std::vector<TreeRecord>& trees, Reading& reading) {
    constexpr double most_m2pha = 100.0;        // [choice] stands of the thickest firs have 80
    constexpr double impossible_m2pha = 500.0;  // [choice] plots of the thickest redwoods have 450
    std::vector<plausible::PlacedTree> placed;
    for (const TreeRecord& tree : trees) {
        placed.push_back({tree.stem.x_m, tree.stem.y_m, tree.stem.dbh_cm});
    }
    const double found_m2pha = plausible::basal_area_where_trees_stand_m2pha(placed);
    if (found_m2pha <= most_m2pha) {
        return;
    }
    const config::Place place{reading.shown(reading.trees().source())};
    const std::string found = joined("trees that make ", config::to_text(std::round(found_m2pha)),
                                     " m2/ha of basal area where they stand (cells of 20 m)");
    const char* const advice =
        "check dbh_cm (diameters in cm, no girths) and the places: in metres, and of the whole map, not in "
        "parts of a plot";
    if (found_m2pha > impossible_m2pha) {
        reading.refuse(place, found, "at most 100 m2/ha", advice);
    } else {
        reading.warn(place, found, "at most 100 m2/ha", advice, config::Effect::answer);
    }
}

}  // namespace

const config::Schema<TreeRow>& tree_columns(bool may_be_dead) {
    const auto rules = [](const char* row) {
        return config::TableRules{.role = "trees", .setting = "trees.file", .row = row};
    };
    static const config::Schema<TreeRow> any{rules("tree"), tree_fields(true)};
    static const config::Schema<TreeRow> living{rules("tree of a growing forest"), tree_fields(false)};
    return may_be_dead ? any : living;
}

config::Table tree_table(Reading& reading) {
    config::Table table = reading.trees().canopy.empty()
                              ? reading.table("trees.file", "trees", reading.trees().file)
                              : canopy_table(reading);
    const TreeSettings& settings = reading.trees();
    const bool is_given = !settings.species.empty() || !settings.species_areas.empty();
    if (is_given && !table.has("species") && table.has("x_m") && table.has("y_m")) {
        const SpeciesTable known = SpeciesTable::shipped();
        const SpeciesLookup lookup = lookup_in(known);
        const auto expected_instead = [&](const std::string& name) {
            return lookup.find(name) ? std::string{} : lookup.expected(name);
        };
        table.add_column("species", species_of_tops(table, reading, expected_instead), "x_m");
    } else if (is_given && table.has("species")) {
        reading.note(joined("trees.species and trees.species_areas have no effect: ", table.file(),
                            " has a column species"));
    }
    return table;
}

ListedTrees read_listed_rows(const config::Table& table, const SpeciesLookup& lookup, Reading& reading,
                             bool may_be_dead) {
    plausible::refuse_girths_alone(table);
    refuse_unplaced_trees(table);
    require_needed(table, may_be_dead);
    check_columns(table, tree_columns(may_be_dead), reading);
    plausible::judge_repeated_trees(table, reading);
    plausible::check_tree_units(table);
    plausible::judge_odd_trees(table, reading);
    config::RowProblems wrong{table};
    SpeciesColumn species{table, lookup, wrong};
    std::vector<ListedRow> rows = tree_columns(may_be_dead).rows(table, wrong);
    const bool has_heights = table.has("height_m");
    for (ListedRow& tree : rows) {
        tree.species = species.find(tree.row).value_or(0);
        tree.id = tree.id.empty() ? std::to_string(tree.row + 1) : std::move(tree.id);
        if (tree.is_dead() && !tree.height_m && has_heights) {
            wrong.refuse(tree.row, "height_m", "height_m empty", "the height of each snag and stump");
        }
        if (reading.trees().swap_xy) {
            std::swap(tree.x_m, tree.y_m);
        }
    }
    derive_diameters(rows, table, lookup, wrong, reading);
    wrong.throw_first();
    if (rows.empty() && reading.trees().canopy.empty()) {
        reading.warn({table.file()}, "no trees", "at least one, or no trees.file for a bare slope");
    }
    warn_of_doubled_ids(rows, "tree_id",
                        "keep the rows of one census; with several plots write the plot before the number",
                        table.file(), reading);
    return {std::move(rows), std::move(species)};
}

std::string_view swap_tree_advice(const TreeSettings& trees) {
    return trees.swap_xy ? "set trees.swap_xy = no: the columns x_m and y_m are right as they are"
                         : "set trees.swap_xy = yes, or exchange the columns x_m and y_m";
}

std::optional<std::vector<TreeRecord>> read_trees(Reading& reading) {
    if (reading.trees().source().empty()) {
        return std::vector<TreeRecord>{};
    }
    return reading.attempt([&] { return read_tree_table(reading); });
}

std::vector<TreeRecord> on_terrain(std::vector<TreeRecord> trees, const rockfall::Terrain& terrain,
                                   Reading& reading, std::size_t others) {
    const Eigen::Vector2d origin_m = terrain.origin_m();
    const auto is_on = [&](const TreeRecord& tree) {
        return terrain.locate(tree.stem.x_m - origin_m.x(), tree.stem.y_m - origin_m.y()).has_value();
    };
    std::vector<config::Point2> places;
    for (const TreeRecord& tree : trees) {
        places.push_back({tree.stem.x_m, tree.stem.y_m});
    }
    const auto outside = std::stable_partition(trees.begin(), trees.end(), is_on);
    if (outside != trees.end() && outside != trees.begin() && !reading.trees().canopy.empty()) {
        // A raster of a larger area is no fault.
        reading.note(joined(reading.shown(reading.trees().source()), ": ",
                            counted(static_cast<std::size_t>(trees.end() - outside), "tree top"),
                            " beyond the terrain left out"));
        trees.erase(outside, trees.end());
    } else if (outside != trees.end()) {
        plausible::OffTerrain judged;  // field by field: g++ 12 takes a half-made temporary for uninitialised
        judged.place = {reading.shown(reading.trees().source())};
        judged.singular = "tree";
        judged.all = trees.size() + others;
        judged.off = static_cast<std::size_t>(trees.end() - outside);
        judged.example = joined("tree ", config::in_quotes(outside->id), " (x ",
                                config::metres_in_words(outside->stem.x_m), ", y ",
                                config::metres_in_words(outside->stem.y_m), ")");
        judged.places = places;
        judged.swap_advice = swap_tree_advice(reading.trees());
        const plausible::Extent extent = plausible::extent_of(terrain);
        judged.cut = plausible::cut_command(reading, "trees", reading.trees().file, extent);
        plausible::judge_off_terrain(judged, extent, reading);
        trees.erase(outside, trees.end());
    }
    if (reading.run().years == 0) {  // a forest that grows has a check of its own
        judge_density(trees, reading);
    }
    return trees;
}

}  // namespace coupling
