#include "coupling/inputs/forest/unplaced_trees.hpp"

#include <algorithm>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "coupling/inputs/formats/column_names.hpp"
#include "coupling/inputs/tables/words.hpp"

namespace coupling {
namespace {

bool has_any(const config::Table& table, std::initializer_list<const char*> columns) {
    return std::any_of(columns.begin(), columns.end(),
                       [&](const char* column) { return table.find(column).has_value(); });
}

bool may_mean(const config::Table& table, const std::string& column) {
    return !formats::columns_by_part(table, "trees", column).empty();
}

}  // namespace

void refuse_unplaced_trees(const config::Table& trees) {
    const bool may_have_places =
        has_any(trees, {"x_m", "y_m", "wkt"}) || may_mean(trees, "x_m") || may_mean(trees, "y_m");
    const bool are_trees = has_any(trees, {"species", "dbh_cm", "height_m"}) || may_mean(trees, "species") ||
                           may_mean(trees, "dbh_cm");
    if (may_have_places || !are_trees) {
        return;
    }
    config::fail(
        config::ExitCode::data, {trees.file()},
        config::joined("a list of ", counted(trees.rows(), "tree"),
                       " without places: no columns x_m and y_m"),
        "x_m and y_m of each tree, or a layer of points",
        "trees that were counted and not mapped belong to stands: take trees.file out and set "
        "stands.dbh_classes to a table of stand, species, dbh_from_cm, dbh_to_cm, stems_pha (the counts of "
        "each "
        "class divided by the area in ha; all the terrain is stand 1 unless stands.polygons says which stand "
        "grows where), or take polygons with stems, basal area or mean diameter (bannwald init --stands)");
}

}  // namespace coupling
