#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "config/errors/input_error.hpp"

namespace coupling {

/// A setting, and the layers of run.drawing that it names and that hold nothing yet.
struct Undrawn {
    std::string key;
    std::vector<std::string> layers;
    bool is_all = false;  ///< nothing else is left of the setting: it counts as not given
};

/// A setting that names layers, its value, and the layers and files that it names one after the other.
struct LayerSetting {
    const char* key;
    std::string& value;
    std::vector<std::string> names;
};

/// The GeoPackage that is being drawn.
struct Drawing {
    std::string name;     ///< as the scenario has it
    config::Place place;  ///< of run.drawing
    /// Where a file that the scenario names lies.
    std::function<std::filesystem::path(const std::string& name)> path_of;
};

/// Takes the empty layers of a GeoPackage that is still being drawn out of the settings that name them:
/// whoever asks for a setting then finds what was drawn, or that it is not given. Layers of other files stay,
/// empty or not. Returns what was taken out, in the order of the settings.
///
/// Throws InputError: (file) where the drawing is not there, (settings) where its name is that of a layer,
/// (data) where it is no GeoPackage.
std::vector<Undrawn> take_out_undrawn(const Drawing& drawing, std::span<const LayerSetting> settings);

}  // namespace coupling
