#include "coupling/program/actions/given_trees.hpp"

#include <set>
#include <string>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "coupling/inputs/forest/canopy_input.hpp"
#include "coupling/inputs/forest/canopy_tops.hpp"
#include "coupling/inputs/scenario/tree_settings.hpp"
#include "coupling/inputs/tables/words.hpp"

namespace coupling {

GivenTrees given_trees(config::Table& table) {
    const bool has_tops = table.has("height_m") && !table.has("dbh_cm");
    const bool has_species = table.has("species") || !has_tops;
    config::Problems problems;
    table.require({"x_m", "y_m", has_species ? "species" : "x_m", has_tops ? "height_m" : "dbh_cm"},
                  problems);
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
    polygons.require({"stand", "wkt"}, problems);
    records.require({"stand", "species"}, problems);
    problems.throw_if_any();
    std::set<std::string> stands;
    for (std::size_t row = 0; row < records.rows(); ++row) {
        stands.insert(records.text(row, "stand"));
    }
    return config::joined(counted(stands.size(), "stand"),
                          "; places and diameters of single trees are drawn");
}

}  // namespace coupling
