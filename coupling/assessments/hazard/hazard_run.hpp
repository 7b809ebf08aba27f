#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "coupling/assessments/hazard/hazard_matrix.hpp"
#include "coupling/assessments/hazard/risk/risk_results.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/run/run_request.hpp"

namespace coupling::hazard {

/// What a hazard map is made of, before any rock falls.
struct HazardPlan {
    std::vector<double> return_periods_years;  ///< rising
    Matrix matrix;
    std::vector<InputFile> inputs;
    std::optional<risk::RiskPlan> risk;  ///< with risk.assess
};

/// Reads hazard.blocks and hazard.matrix; with risk.assess what is exposed, too. Throws config::InputError.
/// Requires hazard.blocks.
HazardPlan read_plan(const Scenario& scenario);

/// The scenario of one of the return periods alone.
std::unique_ptr<Scenario> scenario_of(const std::filesystem::path& file, std::vector<std::string> overrides,
                                      double return_period_years,
                                      const std::filesystem::path& inputs_within = {});

/// Folder of the hazard map below that of the results.
inline constexpr const char* map_folder = "hazard";
/// Name of the folder beside it that holds the results of a return period.
std::string period_folder(double return_period_years);

/// Lets the rocks of each return period of hazard.blocks fall, each into a folder return_period_N of its own,
/// and makes the hazard map of them in the folder hazard. Return periods that are finished already stay as
/// they are.
///
/// Returns 0, or 75 if the user interrupted it: what is finished stays and the next call goes on from there.
/// Throws config::InputError. Requires a scenario of today with hazard.blocks.
int run_hazard(const RunRequest& request, const Scenario& scenario);

}  // namespace coupling::hazard
