#pragma once

#include <vector>

#include "config/errors/input_error.hpp"
#include "config/table/table.hpp"
#include "coupling/exchange/regimes/intervention.hpp"
#include "forest/stand/species.hpp"

namespace coupling {

/// The rows of a regime, each checked by itself and against the rows it names; the ground they lie on is not
/// looked at (coupling/exchange/regimes/regime.hpp does). A row with `after` gets the ground of the row it
/// follows.
///
/// Adds a problem with file, line and column for unknown columns, treatments, places and species (with the
/// nearest word), fields missing or without meaning for their treatment, values out of range, and what
/// contradicts itself within a row. Rows with problems are left out.
std::vector<Intervention> read_interventions(const config::Table& table, const forest::SpeciesTable& species,
                                             config::Problems& problems);

}  // namespace coupling
