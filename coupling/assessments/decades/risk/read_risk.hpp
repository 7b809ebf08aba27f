#pragma once

#include <optional>

#include "config/errors/warnings.hpp"
#include "coupling/assessments/consequences/risk_plan.hpp"
#include "coupling/inputs/site.hpp"

namespace coupling {
struct Scenario;
}

namespace coupling::decades {

/// With risk.assess: what is exposed, and the curves. Their files join the inputs of the site, so that other
/// traffic makes a run another one; call it after its members have their keys. Warns of curves that are a
/// choice, and of amounts in another currency than the timber. Throws config::InputError.
std::optional<consequences::RiskPlan> read_risk(const Scenario& scenario, Site& site,
                                                config::Warnings& warnings);

/// Rocks that really start in a year: risk.rocks_per_year, else feedback.rocks_per_year.
double real_rocks_per_year(const Scenario& scenario);

/// Currency of timber and work.
inline constexpr const char* currency_of_timber = "EUR";

}  // namespace coupling::decades
