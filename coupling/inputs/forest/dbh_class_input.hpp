#pragma once

#include <cstdint>
#include <map>

#include "config/table/declared.hpp"
#include "coupling/inputs/forest/forest_species.hpp"
#include "coupling/inputs/forest/stand_input.hpp"
#include "coupling/inputs/reading/reading.hpp"

namespace coupling {

struct DbhClassRow;
const config::Schema<DbhClassRow>& dbh_class_columns();

/// Adds the stands of stands.dbh_classes (stems by species and diameter class) to those of stands.records.
/// Nothing without that setting. Refuses classes that overlap, classes without width, stands that both
/// tables have, and values out of range. Returns false where something is wrong.
bool add_dbh_classes(const ForestSpecies& species, Reading& reading,
                     std::map<std::uint32_t, InventoriedStand>& stands);

}  // namespace coupling
