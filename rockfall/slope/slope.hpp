#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rockfall/laws/block_ground.hpp"
#include "rockfall/laws/restitution.hpp"
#include "rockfall/laws/soil.hpp"
#include "rockfall/laws/stopping.hpp"
#include "rockfall/terrain/surface.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace rockfall {

/// What sets one ground type apart.
struct SurfaceType {
    int code = 0;  ///< in the user's surface grid
    std::string label;
    Restitution restitution;               ///< below the reference speed, with the laws of the default
    std::optional<Restitution> published;  ///< of the paper, where fitted ones stand above
    double jump_angle_factor = 1.0;        ///< jump angles on this ground by those of the law [-]
    StopCurve stopping;                    ///< probability that a ground impact stops a rock [-]
    StopCurve rolling_stops_per_m;         ///< rate at which a rolling rock is caught [1/m]
    double rolling_friction = 0.0;         ///< of a rolling rock [-]; 0: that of the law
    double sliding_friction = 0.0;         ///< coefficient of a sliding rock [-]; 0: none of its own
    std::optional<Soil> soil;              ///< for motion models that take the ground from soils
    double roughness_m = 0.0;              ///< standard deviation of heights below the cells, for blocks
    BlockGround block;                     ///< for rigid blocks: friction, restitution, resistance
    std::string like{};                    ///< the shipped type that it is or comes from; "": none

    /// The coefficients before any fit.
    [[nodiscard]] Restitution as_published() const { return published.value_or(restitution); }
};

/// The ground that rocks fall on.
struct Slope {
    Terrain terrain;
    SurfaceMap surface;
    std::vector<SurfaceType> types;

    [[nodiscard]] const SurfaceType& type_at(double x_m, double y_m) const {
        return types[static_cast<std::size_t>(surface.at(x_m, y_m))];
    }
    /// Ground at a point of a triangle: that of the triangle if it has its own, else that of the map.
    [[nodiscard]] const SurfaceType& type_at(std::uint32_t triangle, double x_m, double y_m) const {
        const std::uint32_t own = terrain.triangles()[triangle].surface;
        return own > 0 ? types[own - 1] : type_at(x_m, y_m);
    }
};

/// A slope as one rock meets it: the terrain of all rocks, and the ground types that hold for this one.
class SlopeView {
public:
    SlopeView() = default;
    /// Keeps a pointer; implicit, as most rocks meet the types of the slope itself.
    SlopeView(const Slope& slope) : SlopeView{slope, slope.types} {}  // NOLINT(google-explicit-constructor)
    /// Requires as many types as the slope has.
    SlopeView(const Slope& slope, std::span<const SurfaceType> types) : slope_{&slope}, types_{types} {}

    [[nodiscard]] const Terrain& terrain() const { return slope_->terrain; }
    [[nodiscard]] std::span<const SurfaceType> types() const { return types_; }
    /// As Slope::type_at.
    [[nodiscard]] const SurfaceType& type_at(std::uint32_t triangle, double x_m, double y_m) const {
        const std::uint32_t own = slope_->terrain.triangles()[triangle].surface;
        return own > 0 ? types_[own - 1] : types_[static_cast<std::size_t>(slope_->surface.at(x_m, y_m))];
    }

private:
    const Slope* slope_ = nullptr;
    std::span<const SurfaceType> types_;
};

}  // namespace rockfall
