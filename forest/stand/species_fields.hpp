#pragma once

#include "config/table/schema.hpp"
#include "forest/stand/species.hpp"

namespace forest {

/// The columns of a species table: unit, what each may hold, where it goes.
const config::Schema<Species>& species_columns();

}  // namespace forest
