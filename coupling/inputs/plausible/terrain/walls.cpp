#include "coupling/inputs/plausible/terrain/walls.hpp"

#include <algorithm>
#include <cmath>

#include "config/units/angle.hpp"
#include "coupling/inputs/plausible/terrain/limits.hpp"

namespace coupling::plausible::terrain {
namespace {

double tangent_of(double slope_deg) {
    return std::tan(config::Angle::from_degrees(slope_deg).in_radians());
}

/// How often a line of cells steps up or down within `width` cells: steeply, bent against the ground on both
/// sides, and by `least_m` more than it.
std::size_t walls_along(const HeightField& field, const Axis& axis, int width, double least_m) {
    const double steep = tangent_of(limits::wall_deg);
    const double bent = tangent_of(limits::wall_bend_deg);
    const double bent_less = tangent_of(limits::wall_lesser_bend_deg);
    std::size_t walls = 0;
    visit_cells(field, axis, 1, axis.cells - width - 1, [&](int, int, const double* cell) {
        const double* const end = cell + width * axis.cell_step;
        const double wall = std::abs(*end - *cell) / (width * axis.spacing_m);
        if (!(wall > steep)) {
            return;
        }
        const double before = std::abs(*cell - cell[-axis.cell_step]) / axis.spacing_m;
        const double after = std::abs(end[axis.cell_step] - *end) / axis.spacing_m;
        const auto [gentle, steeper] = std::minmax(before, after);
        walls += wall - gentle > bent * (1.0 + wall * gentle) &&
                         wall - steeper > bent_less * (1.0 + wall * steeper) &&
                         (wall - steeper) * width * axis.spacing_m > least_m
                     ? 1
                     : 0;
    });
    return walls;
}

}  // namespace

std::size_t narrow_walls(const HeightField& field, double noise_m) {
    if (field.cell_m() <= limits::coarsest_for_walls_m) {
        return 0;
    }
    const double least_m = std::max(limits::wall_m, limits::wall_noises * noise_m);
    std::size_t walls = 0;
    for (const Axis& axis : {along_rows(field), along_columns(field)}) {
        walls += walls_along(field, axis, 1, least_m) + walls_along(field, axis, 2, least_m);
    }
    return walls;
}

}  // namespace coupling::plausible::terrain
