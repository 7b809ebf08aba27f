#pragma once

#include <Eigen/Core>
#include <vector>

#include "rockfall/release/release.hpp"
#include "rockfall/slope/slope.hpp"
#include "rockfall/tally/target.hpp"
#include "validation/engine/case/profile.hpp"
#include "validation/engine/slope/recipe.hpp"

namespace coupling::validation {

/// The slope goes on by this much above and beyond the profile, along its first and last piece.
inline constexpr double margin_m = 10.0;

/// A slope made of a profile. Plan coordinates of the recipe: x along the profile from its origin, y to the
/// left, 0 in the axis.
struct RebuiltSlope {
    rockfall::Slope slope;
    Profile profile;                  ///< as used: with the recipe's slope change
    double width_m = 0.0;             ///< from -width / 2 to width / 2
    bool released_in_flight = false;  ///< rocks begin above the ground: their first flight is no jump

    [[nodiscard]] double upper_m() const { return profile.front().distance_m; }
    [[nodiscard]] double lower_m() const { return profile.back().distance_m; }
    /// A place of the recipe in coordinates of the terrain.
    [[nodiscard]] Eigen::Vector2d on_terrain(double distance_m, double across_m) const {
        return Eigen::Vector2d{distance_m, across_m} - slope.terrain.origin_m();
    }
    /// The line across the slope at a distance.
    [[nodiscard]] rockfall::Target line_at(const std::string& name, double distance_m) const;
};

/// Rebuilds a slope: raster of the profile times the cross-section plus relief, through the contact zone of
/// the recipe's settings, triangulated; for a profile the strip of triangles along it.
RebuiltSlope rebuild(const Recipe& recipe, const Profile& surveyed);

/// How the rocks of a recipe begin to move.
rockfall::StartLaw start_law(const Recipe& recipe);

}  // namespace coupling::validation
