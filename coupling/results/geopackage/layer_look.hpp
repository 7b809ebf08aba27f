#pragma once

#include <string>
#include <vector>

#include "coupling/results/geopackage/package.hpp"

namespace coupling::geopackage {

/// How a layer is drawn in GIS programs, whatever their format.
struct LayerLook {
    Colour colour{0x96, 0x96, 0x96};    ///< where no column decides
    std::string energy_column{};        ///< decides by the classes of intensity (colours.hpp); empty: no
    std::string class_column{};         ///< decides by `classes`; empty: no
    std::vector<DrawnClass> classes{};  ///< values of it
    bool shown = false;                 ///< when it is opened
};

LayerLook look_of(const Plan& plan);

/// What a layer is called for people, in the language in use (results/text/writing_language.hpp): "Nets" for
/// `nets`. A layer without a title of its own has the sentence of its table.
std::string layer_title(const Plan& plan);

/// The sentence of a layer, table or raster without its full stop, in the language in use.
std::string words_of(const std::string& sentence);

}  // namespace coupling::geopackage
