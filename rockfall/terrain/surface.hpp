#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "config/grid/raster.hpp"

namespace rockfall {

/// Place of a ground type in the list of types.
enum class SurfaceId : std::uint8_t {};

/// Which ground lies where: a grid of ground types in terrain coordinates (metres from the terrain's origin).
class SurfaceMap {
public:
    /// Types row by row from the north-west. Requires as many as the frame has cells, and at least one.
    SurfaceMap(const config::GridFrame& frame, std::vector<std::uint8_t> ids);

    /// The same ground everywhere.
    [[nodiscard]] static SurfaceMap uniform(SurfaceId id);

    /// Ground at a point; outside the grid that of the nearest cell. Called at every impact, so without
    /// branches.
    [[nodiscard]] SurfaceId at(double x_m, double y_m) const {
        // In this order of arguments a NaN becomes 0 instead of an index.
        const double column = std::min(std::max(0.0, (x_m - x_west_m_) * columns_per_m_), last_column_);
        const double row = std::min(std::max(0.0, (y_north_m_ - y_m) * rows_per_m_), last_row_);
        const std::size_t index = static_cast<std::size_t>(static_cast<std::uint32_t>(row)) * columns_ +
                                  static_cast<std::uint32_t>(column);
        return SurfaceId{ids_[index]};
    }

private:
    double x_west_m_;
    double y_north_m_;
    double columns_per_m_;
    double rows_per_m_;
    double last_column_;
    double last_row_;
    std::size_t columns_;
    std::vector<std::uint8_t> ids_;
};

}  // namespace rockfall
