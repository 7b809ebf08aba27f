#pragma once

#include <vector>

#include "forest/light/light.hpp"

namespace benchmarks {

/// Season means over all columns, relative to the open.
struct MarchedLight {
    double ground = 0.0;
    double cells = 0.0;  ///< of the centres of the cells that have leaves or stand below some
};

/// Light the ordinary way: from every cell and the ground towards every zone in steps of 1 m, looking up the
/// leaf area where the step lies, in double, with the exponential of the C library.
class LightMarch {
public:
    LightMarch(const forest::LightGround& ground, const forest::Canopy& canopy,
               const forest::PaddedGround& padded);

    [[nodiscard]] MarchedLight season(const forest::LightSite& site, const forest::LightYear& year) const;

private:
    [[nodiscard]] double transmittance(double x_m, double y_m, double z_m,
                                       const forest::Direction& towards) const;
    [[nodiscard]] double ground_at(double x_m, double y_m) const;

    const forest::Canopy& canopy_;
    config::Raster<double> ground_m_;
    std::vector<double> extinction_per_m_;  ///< by cell
    double top_m_;
};

/// Mean over the cells up to the highest leaves of their column of the season's fluence relative to the open.
[[nodiscard]] double mean_transmittance(const forest::LightSite& site, const forest::Canopy& canopy,
                                        const forest::LightField& field);

}  // namespace benchmarks
