#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "coupling/assessments/consequences/risk_curves.hpp"
#include "coupling/inputs/places/target_exposure.hpp"
#include "coupling/inputs/scenario/hazard_settings.hpp"
#include "rockfall/tally/target.hpp"

namespace coupling::consequences {

/// What a risk is assessed of: read before any rock falls.
struct RiskPlan {
    std::vector<ExposedTarget> targets;
    Curves curves;
    RiskSettings settings;
};

/// The exposed targets and the curves of a scenario with risk.assess. What is wrong with them joins the
/// problems of `reading`.
RiskPlan read_risk_plan(Reading& reading, const RiskSettings& settings);

/// The plan for the targets that a site has: those of the file that lie wholly beyond its terrain are left
/// out, as its reader has noted. Throws config::InputError (data) where no exposed target is left.
RiskPlan on_site(RiskPlan plan, std::span<const rockfall::Target> targets);

/// What each assessment warns of where no curves were given.
inline constexpr const char* shipped_curves_warning =
    "risk: lethality and damage by energy are a choice of this program, not figures of an office; give those "
    "of your office in risk.curves";

/// The place of a target of the plan among those of a site. Throws config::InputError (data) where it is none
/// of them.
std::size_t place_among(const std::string& id, std::span<const rockfall::Target> targets);

}  // namespace coupling::consequences
