#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "validation/engine/case/case_files.hpp"
#include "validation/engine/case/comparison.hpp"

namespace coupling::validation {

/// What case.ini of a field case says beside [case].
struct FieldSettings {
    std::string scenario = "scenario.ini";  ///< a scenario of `bannwald run` in the folder of the case
    std::string states;  ///< table of states of the scenario that are compared with each other; or none
    bool first_impacts = false;  ///< whether the first rebounds of each state are compared, too
    bool reach_angles = false;   ///< whether reach and shadow angles of each state are compared, too
    std::string presets;  ///< of the motion model, apart by blanks, side by side for each state; or none
    std::string trends;   ///< table of orders that figures of the states are expected to have; or none
};

/// Rocks of a scenario held against stops that were observed on real ground, once for each motion model.
///
/// The scenario is opened with each of the models; one that the scenario cannot serve (such as soils that
/// are missing) is left out with a note. `overrides` are settings of the scenario. Throws InputError where
/// the scenario has no observed.stops, or cannot be opened with its own model.
Comparison read_field(const CaseFiles& files, const FieldSettings& settings,
                      const std::vector<std::string>& overrides, std::vector<std::string>& notes);

}  // namespace coupling::validation
