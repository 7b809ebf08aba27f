#include "coupling/inputs/terrain/slope_tangent.hpp"

#include <cmath>
#include <cstdlib>

#include "config/math/elementary.hpp"
#include "config/units/angle.hpp"
#include "rockfall/terrain/local_plane.hpp"

namespace coupling {
namespace {

std::optional<double> tangent_on_grid(const config::Raster<double>& grid, std::size_t index) {
    const config::Cell centre = grid.frame.cell_of(index);
    const double here_m = grid.values[index];
    if (std::isnan(here_m)) {
        return std::nullopt;
    }
    rockfall::LocalPlane plane;
    for (int row = -1; row <= 1; ++row) {
        for (int column = -1; column <= 1; ++column) {
            const config::Cell cell{centre.column + column, centre.row + row};
            if (grid.frame.contains(cell) && !std::isnan(grid.at(cell))) {
                const double weight = (column == 0 ? 2.0 : 1.0) * (row == 0 ? 2.0 : 1.0);
                plane.add(column * grid.frame.cell_width_m, -row * grid.frame.cell_height_m,
                          grid.at(cell) - here_m, weight);
            }
        }
    }
    const auto fitted = plane.fit();
    return fitted ? std::optional{fitted->head<2>().norm()} : std::nullopt;
}

}  // namespace

std::optional<double> slope_tangent(const HeightInput& heights, const config::GridFrame& frame,
                                    const rockfall::Terrain& terrain, std::size_t cell) {
    if (heights.grid) {
        return tangent_on_grid(*heights.grid, cell);
    }
    const config::Cell place = frame.cell_of(cell);
    const auto triangle = terrain.locate(frame.x_centre_m(place.column) - terrain.origin_m().x(),
                                         frame.y_centre_m(place.row) - terrain.origin_m().y());
    return triangle ? std::optional{terrain.plane_of(*triangle).gradient.norm()} : std::nullopt;
}

double tangent_of_deg(double angle_deg) {
    const config::SinCos of = config::sin_cos_of(config::Angle::from_degrees(angle_deg).in_radians());
    return of.sin / of.cos;
}

}  // namespace coupling
