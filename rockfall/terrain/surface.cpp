#include "rockfall/terrain/surface.hpp"

#include <cassert>
#include <utility>

namespace rockfall {

SurfaceMap::SurfaceMap(const config::GridFrame& frame, std::vector<std::uint8_t> ids)
    : x_west_m_{frame.x_west_m},
      y_north_m_{frame.y_north_m()},
      columns_per_m_{1.0 / frame.cell_width_m},
      rows_per_m_{1.0 / frame.cell_height_m},
      last_column_{frame.columns - 1.0},
      last_row_{frame.rows - 1.0},
      columns_{static_cast<std::size_t>(frame.columns)},
      ids_{std::move(ids)} {
    assert(!ids_.empty() && ids_.size() == frame.size());
}

SurfaceMap SurfaceMap::uniform(SurfaceId id) {
    return {{.columns = 1, .rows = 1}, {static_cast<std::uint8_t>(id)}};
}

}  // namespace rockfall
