#pragma once

#include <cstdint>

#include "config/options/options.hpp"
#include "rockfall/fall.hpp"
#include "rockfall/release/release.hpp"

namespace rockfall {

/// How the ground of the DEM becomes the ground that rocks feel.
struct GroundLaw {
    double vertical_tolerance_m = 0.0;  ///< thinning of the TIN; 0 keeps every point
    double contact_support_m =
        4.0;                       ///< radius of the contact zone; 0: the TIN as it is (see contact_zone.hpp)
    double contact_shift_m = 1.0;  ///< largest shift of a point by the contact zone
};

/// Settings that users write in another form than the laws use them: angles in degrees, counts.
struct WrittenLaw {
    double jump_angle_coefficient_deg = 80.0;
    double jump_angle_cap_deg = 60.0;
    double lateral_slow_deg = 16.0;
    double lateral_fast_deg = 11.0;
    double rolling_edge_deg = 4.0;
    double classical_lateral_deg = 11.0;
    double classical_friction_deg = 30.0;
    std::uint64_t most_impacts = 20'000;
};

/// All rockfall settings that a user can change, with their defaults.
struct Parameters {
    Parameters();
    GroundLaw ground;
    FallLaw fall;
    WrittenLaw written;
};

/// Declares the settings [rockfall], [pir3d], [classical], [tree_impact] and [log_impact]; each carries its
/// presets `strict`, `paper_rebound`, `paper_initial`. After reading, `take_over` brings the laws up to date.
void declare(config::Options& options, Parameters& parameters);

/// Turns what users wrote into what the laws use. Throws InputError (settings) where settings contradict each
/// other.
void take_over(Parameters& parameters, const config::Options& options);

/// The shipped deviation matrix (config/data/tree_deviation.csv).
DeviationMatrix shipped_deviation_matrix();

/// The same from the text of such a table. Throws InputError (data) where classes or shares do not fit.
DeviationMatrix read_deviation_matrix(std::string_view text, const std::string& file);

}  // namespace rockfall
