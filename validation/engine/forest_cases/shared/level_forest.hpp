#pragma once

#include <span>

#include "config/units/angle.hpp"
#include "forest/climate/series.hpp"
#include "forest/site/site.hpp"
#include "forest/stand/patch.hpp"

namespace coupling::validation::forest_cases {

// Level ground that borders on itself, on which trials grow.

/// A square of patches with the same soil.
forest::PatchGrid level_patches(int side_patches, const forest::Soil& soil);

/// The site of level patches, without horizon. Mean radiation of the years shapes the sky. Requires at least
/// one year.
forest::Site level_site(const forest::PatchGrid& grid, config::Angle latitude,
                        std::span<const forest::ClimateYear> years);

}  // namespace coupling::validation::forest_cases
