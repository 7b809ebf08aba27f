#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "config/geometry/shape.hpp"
#include "coupling/assessments/calibrate/model/source_distance.hpp"
#include "coupling/inputs/scenario/calibrate_settings.hpp"
#include "coupling/inputs/site.hpp"

namespace coupling::calibrate {

/// An outline that somebody drew around blocks: a share of so many of them lies within, and of those outside
/// half lie beyond its far end.
struct Outline {
    Outline(const Site& site, const CalibrateSettings& settings);

    std::vector<config::Shape> polygons;  ///< in coordinates of the terrain
    SourceDistance sources;
    double share_within = 0.0;  ///< of the blocks [-]
    std::size_t blocks = 0;
    double reach_m = 0.0;  ///< of its corners and sides, the furthest from the nearest source

    [[nodiscard]] bool holds(const Eigen::Vector2d& place_m) const;
    /// Reaches of the outlines that would be drawn around as many stops each, every stop in one of them, from
    /// distances of stops to the nearest source. One outline of too few stops; none without any.
    [[nodiscard]] std::vector<double> reaches_around(std::span<const double> distances_m) const;
};

/// Whether a place lies in one of some polygons.
bool lies_within(std::span<const config::Shape> polygons, const Eigen::Vector2d& place_m);

/// Moves polygons of the input files to coordinates of the terrain.
void move_to_terrain(std::vector<config::Shape>& polygons, const Site& site);

}  // namespace coupling::calibrate
