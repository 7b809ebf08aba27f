#pragma once

#include <optional>
#include <vector>

#include "config/table/declared.hpp"
#include "coupling/inputs/forest/forest_species.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "forest/start/starting_dead_wood.hpp"

namespace coupling {

/// Dead wood and saplings at the start by stand; degree-days of the stands are not filled in.
struct StartingWood {
    std::vector<forest::OnPatches<forest::DeadWoodRecord>> dead_wood;
    std::vector<forest::OnPatches<forest::SaplingRecord>> saplings;
};

struct DeadWoodRow;
struct SaplingRow;
const config::Schema<DeadWoodRow>& dead_wood_columns();
const config::Schema<SaplingRow>& sapling_columns();

/// Reads stands.dead_wood and stands.saplings, empty without them. Refuses rows of stands that are not in the
/// forest and values out of range; `stand` may be `all`.
std::optional<StartingWood> read_starting_wood(const ForestSpecies& species, const forest::PatchGrid& grid,
                                               Reading& reading);

}  // namespace coupling
