#pragma once

#include <string>
#include <vector>

#include "coupling/inputs/rockyfor3d/folder.hpp"

namespace coupling::rockyfor3d {

/// A ground type of the project: a soil type of Rockyfor3D with a roughness.
struct Ground {
    int code = 0;
    int soil_type = 0;
    double rg70_m = 0.0, rg20_m = 0.0, rg10_m = 0.0;
    double r_n = 0.0;  ///< [-]
    double r_t = 0.0;  ///< [-]; at most the largest that ground types may have, 0.99
    /// Soil type 0, in which rocks sink, and a roughness of 100 m: each contact stops the rock, with r_n =
    /// r_t = 0.
    bool stops_all = false;
    std::string like;  ///< shipped ground type that lends its soil, and its stopping where not all stop
    std::size_t cells = 0;

    /// Root mean square of the obstacles that are met with 70, 20 and 10 %: for rocks with a shape [choice].
    [[nodiscard]] double roughness_m() const;
};

struct Grounds {
    config::Raster<double> codes;  ///< NaN where the DEM has none
    std::vector<Ground> types;
    double step_m = 0.0;  ///< roughness was rounded to this; 0: to the centimetre
};

/// Share of the speed along the slope that a rock keeps at a contact [-], from the roughness heights of
/// Rockyfor3D.
///
/// Its energy factor is 1 / (1 + MOH / R), in [0.1, 0.99], here the mean over the heights that are met with
/// 70, 20 and 10 %, without the depth of penetration. A rolling sphere that keeps this share r of its
/// translational energy and all of its rotation leaves with sqrt((0.4 + r) / 1.4) of its speed (Dorren 2016
/// as summarised by others; the step to a share of speed is a choice).
double tangential_share(double rg70_m, double rg20_m, double rg10_m, double rock_radius_m);

/// The shipped ground type of like origin and roughness [choice]; for soil type 0, in which rocks sink, the
/// softest.
std::string like_ground(int soil_type, double mean_roughness_m);

/// Every soil type and roughness that occurs. `rock_radius_m` is that of a middling rock.
Grounds grounds_of(const Folder& folder, double rock_radius_m, std::size_t most_types = 200);

}  // namespace coupling::rockyfor3d
