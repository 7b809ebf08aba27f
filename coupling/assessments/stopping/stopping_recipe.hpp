#pragma once

#include <optional>
#include <string>
#include <vector>

#include "config/table/declared.hpp"
#include "config/table/table.hpp"
#include "rockfall/virtual_surface/block_cover.hpp"

namespace coupling {

/// What lies on one ground type, and where its row says so.
struct SurfaceRecipe {
    std::string name;         ///< letters, digits, _ and -
    std::optional<int> code;  ///< in the user's surface grid, if the recipe has the column
    std::vector<rockfall::BlockKind> kinds;
};

struct RecipeRow;
const config::Schema<RecipeRow>& recipe_columns();

/// The surfaces of a recipe in the order of their first rows.
///
/// Diameters stand in `block_low_m` and `block_high_m`, or in `block_sizes_m`. Other columns (a reason, a
/// source) are for people. Several rows of one name are kinds of blocks on one surface, laid in the order of
/// the rows. Throws one InputError (data) with all problems, each with file, line and column.
std::vector<SurfaceRecipe> read_recipe(const config::Table& table);

}  // namespace coupling
