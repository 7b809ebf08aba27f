#include "forest/light/horizon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace forest {
namespace {

/// Height between the four cell centres around a point; NaN outside or beside a cell without height. Half a
/// cell along the border takes the border's cells.
double height_between(const config::Raster<double>& heights_m, double x_m, double y_m) {
    const config::GridFrame& frame = heights_m.frame;
    if (!frame.covers(x_m, y_m)) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    const double column =
        std::clamp((x_m - frame.x_west_m) / frame.cell_width_m - 0.5, 0.0, frame.columns - 1.0);
    const double row =
        std::clamp((frame.y_north_m() - y_m) / frame.cell_height_m - 0.5, 0.0, frame.rows - 1.0);
    const int west = std::min(static_cast<int>(column), std::max(frame.columns - 2, 0));
    const int north = std::min(static_cast<int>(row), std::max(frame.rows - 2, 0));
    const int east = std::min(west + 1, frame.columns - 1);
    const int south = std::min(north + 1, frame.rows - 1);
    const double to_east = column - west;
    const double to_south = row - north;
    const double upper =
        (1.0 - to_east) * heights_m.at({west, north}) + to_east * heights_m.at({east, north});
    const double lower =
        (1.0 - to_east) * heights_m.at({west, south}) + to_east * heights_m.at({east, south});
    return (1.0 - to_south) * upper + to_south * lower;
}

double steepest_look(const config::Raster<double>& heights_m, double x_m, double y_m, double eye_m,
                     Turn azimuth, double reach_m) {
    const double cell_m = std::max(heights_m.frame.cell_width_m, heights_m.frame.cell_height_m);
    double tangent = -std::numeric_limits<double>::infinity();
    for (double distance_m = cell_m; distance_m <= reach_m;
         distance_m += std::max(cell_m, 0.02 * distance_m)) {
        const double there_x_m = x_m + distance_m * azimuth.sin;
        const double there_y_m = y_m + distance_m * azimuth.cos;
        if (!heights_m.frame.covers(there_x_m, there_y_m)) {
            break;
        }
        const double rise_m = height_between(heights_m, there_x_m, there_y_m) - eye_m;
        if (rise_m > tangent * distance_m || (std::isinf(tangent) && !std::isnan(rise_m))) {
            tangent = rise_m / distance_m;
        }
    }
    return std::isinf(tangent) ? 0.0 : tangent;
}

}  // namespace

double Horizon::tangent_at(config::Angle azimuth) const {
    const double place = azimuth.in_degrees() * sectors / 360.0;
    const double below = std::floor(place);
    const auto first = static_cast<std::size_t>(static_cast<int>(below) % sectors);
    const std::size_t second = (first + 1) % sectors;
    const double share = place - below;
    return (1.0 - share) * static_cast<double>(tangents_[first]) +
           share * static_cast<double>(tangents_[second]);
}

bool Horizon::clears(const Direction& towards, config::Angle azimuth) const {
    const double flat = std::sqrt(towards.x * towards.x + towards.y * towards.y);
    return towards.z > 0.0 && towards.z >= flat * tangent_at(azimuth);
}

Horizon horizon_at(const config::Raster<double>& heights_m, double x_m, double y_m, double reach_m) {
    const double eye_m = height_between(heights_m, x_m, y_m);
    std::array<float, Horizon::sectors> tangents{};
    if (std::isnan(eye_m)) {
        return Horizon{};
    }
    for (std::size_t sector = 0; sector < tangents.size(); ++sector) {
        const double degrees = 360.0 / Horizon::sectors * static_cast<double>(sector);
        const Turn azimuth = turn_of(config::Angle::from_degrees(degrees));
        tangents[sector] = static_cast<float>(steepest_look(heights_m, x_m, y_m, eye_m, azimuth, reach_m));
    }
    return Horizon{tangents};
}

}  // namespace forest
