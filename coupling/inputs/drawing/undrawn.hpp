#pragma once

#include <span>
#include <string>
#include <vector>

#include "coupling/inputs/scenario/scenario_file.hpp"

namespace coupling {

/// A setting, and the layers of run.drawing that it names and that hold nothing yet.
struct Undrawn {
    std::string key;
    std::vector<std::string> layers;
    bool is_all = false;  ///< nothing else is left of the setting: it counts as not given
};

/// A setting that names layers, and its value.
struct LayerSetting {
    const char* key;
    std::string& value;
};

/// Takes the empty layers of a GeoPackage that is still being drawn (`drawing`: as the scenario names it) out
/// of the settings that name them: whoever asks for a setting then finds what was drawn, or that it is not
/// given. Layers of other files stay, empty or not. Returns what was taken out, in the order of the settings.
///
/// Throws InputError: (file) where the drawing is not there, (settings) where `drawing` names a layer, (data)
/// where it is no GeoPackage.
std::vector<Undrawn> take_out_undrawn(const ScenarioFile& scenario, const std::string& drawing,
                                      std::span<const LayerSetting> settings);

}  // namespace coupling
