#pragma once

#include <array>

#include "config/grid/raster.hpp"
#include "config/units/angle.hpp"
#include "forest/light/direction.hpp"

namespace forest {

/// How high the terrain stands around a point, as the tangent of its elevation at every 10 degrees of
/// azimuth, clockwise from the grid's y axis. Negative where the ground falls away.
class Horizon {
public:
    static constexpr int sectors = 36;

    /// Level ground on all sides.
    Horizon() = default;
    explicit Horizon(const std::array<float, sectors>& tangents) : tangents_{tangents} {}

    [[nodiscard]] const std::array<float, sectors>& tangents() const { return tangents_; }

    /// Between two azimuths the tangent is interpolated.
    [[nodiscard]] double tangent_at(config::Angle azimuth) const;

    /// Whether light from a direction with that azimuth clears the terrain.
    [[nodiscard]] bool clears(const Direction& towards, config::Angle azimuth) const;

private:
    std::array<float, sectors> tangents_{};
};

/// Horizon of a point of the ground, from heights that may reach far beyond the forest.
///
/// Looks outwards in steps of a cell near the point that grow to a fiftieth of the distance, as far as the
/// raster reaches or `reach_m`. Cells without a height (NaN) hide nothing. The earth is flat.
///
/// Level on all sides if the point itself has no height.
[[nodiscard]] Horizon horizon_at(const config::Raster<double>& heights_m, double x_m, double y_m,
                                 double reach_m = 20'000.0);

}  // namespace forest
