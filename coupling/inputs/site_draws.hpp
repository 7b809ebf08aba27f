#pragma once

#include <cstdint>

#include "coupling/inputs/parameters/parameter_draws.hpp"
#include "coupling/inputs/site.hpp"

namespace coupling {

struct Scenario;

/// What is not known, drawn for the strata of the rocks of today. Empty where run.parameter_draws is off.
ParameterDraws draws_on(const Scenario& scenario, const Site& site);

/// The draw of a replicate of a run over years; empty for the first one, which falls by the central values.
ParameterDraws draw_of_replicate_on(const Scenario& scenario, const Site& site, std::uint32_t replicate);

}  // namespace coupling
