#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <vector>

#include "config/grid/raster.hpp"
#include "coupling/inputs/site.hpp"

namespace coupling::calibrate {

/// Plan distance to the nearest source, everywhere on a map: how far a stop is from where rocks start, where
/// nobody knows from which place it came. The same is done to observed and simulated stops.
class SourceDistance {
public:
    /// Of sources of the zones; of none: of all. On cells of the map, or larger ones on a large map.
    /// `largest_cell_m`: smaller ones where a map is not too large for them.
    SourceDistance(const Site& site, const std::vector<std::uint32_t>& zones,
                   double largest_cell_m = std::numeric_limits<double>::infinity());

    /// Of a place in coordinates of the terrain; beyond the map that of its border.
    [[nodiscard]] double at(const Eigen::Vector2d& place_m) const;
    /// Distances closer than this count as equal.
    [[nodiscard]] double cell_m() const { return metres_.frame.cell_width_m; }

private:
    config::Raster<float> metres_;
};

/// Replaces each value of a row or column by min over k of values[k] + step^2 (i - k)^2 (Felzenszwalb &
/// Huttenlocher 2012): squared distances, one direction after the other.
void add_distances(std::vector<double>& values, double step);

}  // namespace coupling::calibrate
