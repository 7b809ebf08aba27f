#pragma once

#include "config/options/options.hpp"
#include "rockfall/release/release.hpp"
#include "rockfall/trajectory.hpp"

namespace rockfall {

/// How the ground of the DEM becomes the ground that rocks feel.
struct GroundLaw {
    double vertical_tolerance_m = 0.0;   ///< thinning of the TIN; 0 keeps every point
    double contact_support_m = 0.0;      ///< radius of the contact zone; 0: the TIN as it is (see contact_zone.hpp)
    double contact_shift_m = 0.0;        ///< largest shift of a point by the contact zone
};

/// All rockfall settings that a user can change, with their defaults.
struct Parameters {
    Parameters();
    GroundLaw ground;
    FallLaw fall;
};

/// Declares the settings [rockfall] and [trees]; each carries its presets `strict`, `paper_rebound`, `paper_initial`.
void declare(config::Options& options, Parameters& parameters);

/// The shipped deviation matrix (config/data/tree_deviation.csv).
DeviationMatrix shipped_deviation_matrix();

}  // namespace rockfall
