#pragma once

#include <ostream>

#include "config/errors/warnings.hpp"
#include "coupling/assessments/decades/members/management.hpp"
#include "coupling/inputs/site.hpp"

namespace coupling {
struct Scenario;
}

namespace coupling::decades {

/// The page of `bannwald check --page`: where the regimes of a scenario act, before anything is simulated,
/// below the warnings about its inputs.
void write_plan_page(std::ostream& out, const Scenario& scenario, const Site& site,
                     const Management& management, const config::Warnings& warnings);

}  // namespace coupling::decades
