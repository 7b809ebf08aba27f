#pragma once

#include <tuple>

#include "config/options/options.hpp"
#include "rockfall/motion/fall.hpp"
#include "rockfall/release/release.hpp"
#include "rockfall/terrain/contact_zone.hpp"

namespace rockfall {

/// How the ground of the DEM becomes the ground that rocks feel.
struct GroundLaw {
    double vertical_tolerance_m = 0.0;  ///< thinning of the TIN; 0 keeps every point
    /// Radius of the contact zone, the same everywhere; 0: the heights as they are; below 0: by rock and
    /// noise.
    double contact_radius_m = -1.0;
    double contact_diameters = 1.0;        ///< least radius by rock and noise, in mean diameters of the rocks
    double contact_slope_error_deg = 1.0;  ///< that noise of the heights may leave
    double contact_shift_m = 1.0;          ///< largest shift of a point by the contact zone

    bool as_it_is = false;  ///< rocks have a shape of their own and feel the TIN as it is: no contact zone

    /// The contact zone for rocks of this mean diameter.
    [[nodiscard]] ContactLaw contact_law(double mean_diameter_m) const;
};

/// Settings that users write in another form than the laws use them: angles in degrees, counts.
struct WrittenLaw {
    SharedSettings shared;
    EachModel<WrittenOf>::type of_models;

    template <class Model>
    [[nodiscard]] auto& of() {
        return std::get<place_in_list<Model>>(of_models);
    }
    template <class Model>
    [[nodiscard]] const auto& of() const {
        return std::get<place_in_list<Model>>(of_models);
    }
};

/// All rockfall settings that a user can change, with their defaults.
struct Parameters {
    Parameters();
    GroundLaw ground;
    FallLaw fall;
    WrittenLaw written;
};

/// Declares the settings [rockfall], those of each motion model, [tree_impact] and [log_impact]; each
/// carries its presets `strict`, `paper_rebound`, `paper_initial`. After reading, `take_over` brings the laws
/// up to date.
void declare(config::Options& options, Parameters& parameters);

/// Turns what users wrote into what the laws use. Throws InputError (settings) where settings contradict each
/// other.
void take_over(Parameters& parameters, const config::Options& options);

/// Makes rocks stay in their vertical plane under every motion model; to be called before `take_over`.
void stay_in_plane(Parameters& parameters);

/// How the chosen model turns rocks sideways at impacts.
SidewaysTurn sideways_turn(const Parameters& parameters);

/// The shipped deviation matrix (config/data/tree_deviation.csv).
DeviationMatrix shipped_deviation_matrix();

/// The same from the text of such a table. Throws InputError (data) where classes or shares do not fit.
DeviationMatrix read_deviation_matrix(std::string_view text, const std::string& file);

}  // namespace rockfall
