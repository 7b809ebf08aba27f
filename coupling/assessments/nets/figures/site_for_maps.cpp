#include "coupling/assessments/nets/figures/site_for_maps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "coupling/results/text/markup.hpp"

namespace coupling {

config::GridFrame map_frame_of(const rockfall::Terrain& terrain) {
    constexpr double cells_a_side = 400.0;
    Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Vector2d high = -low;
    for (const rockfall::Vertex& vertex : terrain.vertices()) {
        low = low.cwiseMin(Eigen::Vector2d{vertex.x_m, vertex.y_m});
        high = high.cwiseMax(Eigen::Vector2d{vertex.x_m, vertex.y_m});
    }
    const double cell_m = report::nice_step((high - low).maxCoeff() / cells_a_side);
    const auto cells = [&](double length) {
        return std::max(1, static_cast<int>(std::ceil(length / cell_m)));
    };
    return {cells(high.x() - low.x()), cells(high.y() - low.y()), low.x(), low.y(), cell_m, cell_m};
}

Site site_for_maps(const rockfall::Terrain& terrain, config::GridFrame frame,
                   std::vector<rockfall::Target> targets, std::vector<NetRecord> nets) {
    config::Raster<double> heights_m{frame, std::numeric_limits<double>::quiet_NaN()};
    std::uint32_t hint = 0;
    for (std::size_t i = 0; i < heights_m.values.size(); ++i) {
        const config::Cell cell = frame.cell_of(i);
        const double x_m = frame.x_centre_m(cell.column);
        const double y_m = frame.y_centre_m(cell.row);
        if (const auto triangle = terrain.locate(x_m, y_m, hint)) {
            hint = *triangle;
            heights_m.values[i] = terrain.plane_of(*triangle).height_m(x_m, y_m);
        }
    }
    frame.x_west_m += terrain.origin_m().x();
    frame.y_south_m += terrain.origin_m().y();
    heights_m.frame = frame;
    return {{terrain, rockfall::SurfaceMap::uniform(rockfall::SurfaceId{0}), {}},
            heights_m,
            {},
            {},
            frame,
            {},
            {},
            {},
            std::move(targets),
            std::move(nets),
            {},
            {},
            {}};
}

}  // namespace coupling
