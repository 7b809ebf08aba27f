#pragma once

#include <ostream>

#include "coupling/assessments/decades/members/management.hpp"
#include "coupling/inputs/site.hpp"

namespace coupling {

struct Scenario;

/// Lists the forest of a run over years: ground, stands, soils, climate, what stands at the start, regimes,
/// members. Requires a site with a forest.
void describe_forest(const Scenario& scenario, const Site& site, const decades::Management& management,
                     std::ostream& out);

}  // namespace coupling
