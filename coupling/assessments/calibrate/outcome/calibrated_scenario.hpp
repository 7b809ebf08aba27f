#pragma once

#include <filesystem>
#include <string>

#include "coupling/inputs/scenario/scenario.hpp"

namespace coupling::calibrate {

/// The settings of a scenario that differ from the defaults, as a scenario in the folder `folder`, with
/// `parameters` as its run.parameters. Names of files lead from there to where they lie. `opening`: lines of
/// comment that say where it comes from.
std::string calibrated_scenario(const Scenario& scenario, const std::filesystem::path& folder,
                                const std::string& parameters, const std::string& opening);

}  // namespace coupling::calibrate
