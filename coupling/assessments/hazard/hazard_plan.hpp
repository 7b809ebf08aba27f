#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "coupling/assessments/hazard/hazard_matrix.hpp"
#include "coupling/assessments/hazard/risk/risk_results.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/inputs/site.hpp"

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
/// Beginning of the names of the folders beside it that hold the results of the return periods.
inline constexpr const char* period_prefix = "return_period_";
std::string period_folder(double return_period_years);

}  // namespace coupling::hazard
