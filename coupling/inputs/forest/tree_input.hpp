#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "config/table/schema.hpp"
#include "coupling/inputs/forest/species_column.hpp"
#include "coupling/inputs/places/records.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "coupling/inputs/scenario/tree_settings.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace coupling {

enum class TreeState : std::uint8_t { living, snag, stump };

/// What a row of a tree list says.
struct TreeRow {
    std::string id;           ///< the row's number where the list gives none
    std::size_t species = 0;  ///< place in the table that the lookup knows
    double x_m = 0.0;
    double y_m = 0.0;
    double dbh_cm = 0.0;           ///< measured, else derived
    bool has_derived_dbh = false;  ///< from the height
    std::optional<double> height_m{};
    std::optional<double> age_years{};
    TreeState state = TreeState::living;
    double strength = 1.0;     ///< share of that of sound wood [-]
    double broken_at_m = 0.0;  ///< > 0: ends here, `height_m` being that of the whole tree

    /// A snag or stump: its height stands in no height curve.
    [[nodiscard]] bool is_dead() const { return state != TreeState::living; }
};
using ListedRow = config::Read<TreeRow>;

/// Tree lists; of a forest that grows, all trees are alive.
const config::Schema<TreeRow>& tree_columns(bool may_be_dead);

/// The tree list of the scenario; where it has no column species, those of trees.species and
/// trees.species_areas.
config::Table tree_table(Reading& reading);

struct ListedTrees {
    std::vector<ListedRow> rows;
    SpeciesColumn species;
};

/// The rows of a tree list. A diameter that is missing is derived from the height
/// (forest/start/diameter_of_height.hpp), with a warning. trees.swap_xy exchanges the axes. Identities used
/// twice are reported. Throws InputError (data) where the medians show another unit (plausible/units.hpp) and
/// for up to 20 other faults.
ListedTrees read_listed_rows(const config::Table& table, const SpeciesLookup& lookup, Reading& reading,
                             bool may_be_dead);

/// Reads and checks the tree list of the scenario; an empty list without one.
///
/// Missing heights come from a curve through the measured ones (forest/start/height_curve.hpp), where there
/// are too few of them through those of another stand: both are reported, as are species that borrow
/// parameters.
std::optional<std::vector<TreeRecord>> read_trees(Reading& reading);

/// What to do about exchanged axes of the tree list.
std::string_view swap_tree_advice(const TreeSettings& trees);

/// Drops trees that do not stand on the terrain and warns of them; refuses a list of which most do not.
/// `others` trees of the same list are known to stand on it.
std::vector<TreeRecord> on_terrain(std::vector<TreeRecord> trees, const rockfall::Terrain& terrain,
                                   Reading& reading, std::size_t others = 0);

}  // namespace coupling
