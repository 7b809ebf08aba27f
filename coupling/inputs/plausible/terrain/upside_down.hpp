#pragma once

#include <optional>

#include "coupling/inputs/plausible/terrain/finding.hpp"
#include "coupling/inputs/plausible/terrain/height_field.hpp"

namespace coupling::plausible::terrain {

/// Mean depth of water in the closed hollows of a terrain, and of the same terrain upside down.
struct Hollows {
    double upright_m = 0.0;
    double inverted_m = 0.0;
};

/// Of a field averaged to about 20 000 cells; NODATA and the rim drain.
Hollows hollows_of(const HeightField& field);

/// Heights with the wrong sign, or subtracted from the highest. Valleys drain and ridges have summits, so
/// real ground has shallow closed hollows and many closed tops. Says nothing of a single slope, which has
/// neither: there the places of sources and targets show it.
std::optional<Finding> judge_upside_down(const HeightField& field);

}  // namespace coupling::plausible::terrain
