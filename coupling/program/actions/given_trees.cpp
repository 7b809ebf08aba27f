#include "coupling/program/actions/given_trees.hpp"

#include <set>
#include <string>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "coupling/inputs/forest/tops/canopy_input.hpp"
#include "coupling/inputs/forest/tops/canopy_tops.hpp"
#include "coupling/inputs/forest/unplaced_trees.hpp"
#include "coupling/inputs/formats/column_names.hpp"
#include "coupling/inputs/scenario/tree_settings.hpp"
#include "coupling/inputs/tables/needed_columns.hpp"
#include "coupling/inputs/tables/words.hpp"

namespace coupling {

GivenTrees given_trees(config::Table& table) {
    const bool has_tops = table.has("height_m") && !table.has("dbh_cm");
    // A column that may be meant is asked for; without any all trees are of one species, which is a guess.
    const bool has_species =
        table.has("species") || !formats::columns_by_part(table, "trees", "species").empty();
    config::Problems problems;
    refuse_unplaced_trees(table);
    std::vector<std::string> needed{"x_m", "y_m"};
    if (has_species) {
        needed.emplace_back("species");
    }
    needed.emplace_back(has_tops ? "height_m" : "dbh_cm");
    require_columns(table, "trees", needed, problems);
    problems.throw_if_any();
    const char* sizes = has_tops                ? ", diameters unknown: they come from the heights"
                        : table.has("height_m") ? ""
                                                : ", heights unknown: they come from a curve";
    return {has_species ? "" : "species = PIAB    ; GUESS: of all trees, the list names none\n",
            config::joined(counted(table.rows(), "tree"), sizes,
                           has_species ? "" : ", species unknown: all are taken for spruce")};
}

std::optional<GivenCanopy> given_canopy(GivenFile& file) {
    if (!file.is_grid()) {
        return std::nullopt;
    }
    formats::PlacedGrid grid = file.grid();
    refuse_wrong_canopy(grid.raster, grid.projection, file.name());
    clean_canopy(grid.raster);
    const TreeTops found = tree_tops(grid.raster, window_of_pitkaenen, TreeSettings{}.canopy_least_height_m);
    return GivenCanopy{{"species = PIAB    ; GUESS: of all trees, a raster names none\n",
                        config::joined("heights of the vegetation, ", to_string(grid.raster.frame), ", ",
                                       counted(found.tops.size(), "tree top"),
                                       "; trees below the crowns of others are missing, all are taken for "
                                       "spruce")},
                       grid.projection};
}

std::string given_stands(config::Table& polygons, config::Table& records) {
    config::Problems problems;
    require_columns(polygons, "stands", {"stand", "wkt"}, problems);
    // One file is read in two roles: what it lacks is said once.
    if (polygons.has("stand")) {
        require_columns(records, "stand_records", {"stand"}, problems);
    }
    require_columns(records, "stand_records", {"species"}, problems);
    problems.throw_if_any();
    std::set<std::string> stands;
    for (std::size_t row = 0; row < records.rows(); ++row) {
        stands.insert(records.text(row, "stand"));
    }
    return config::joined(counted(stands.size(), "stand"),
                          "; places and diameters of single trees are drawn");
}

}  // namespace coupling
