#pragma once

#include <string>

#include "coupling/inputs/formats/layer.hpp"

namespace coupling::systems {

/// What there is to say about a layer that was brought into another coordinate system.
struct Transformed {
    std::string note;     ///< names both systems, the way between them and how accurate it is
    std::string warning;  ///< what was found; "" where the way is accurate enough
};

/// Transforms the shapes of a layer (its column `wkt`) from its own coordinate system into `target`,
/// well-known text, and puts that in the place of its own. Heights and measures stay as they are. Coordinates
/// are rounded to a tenth of a millimetre. `like` names the file that has the target system.
///
/// PROJ chooses the way by the place of the layer. Throws InputError (data) where the datum of one of the two
/// is not known, so that no way between them is: a shift of up to several hundred metres would be left out in
/// silence. Also for systems and coordinates that PROJ cannot transform. A way that is less accurate than 5 m
/// [choice] is a warning.
Transformed transform_layer(formats::Layer& layer, const std::string& target, const std::string& like);

}  // namespace coupling::systems
