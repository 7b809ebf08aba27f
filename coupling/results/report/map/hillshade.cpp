#include "coupling/results/report/map/hillshade.hpp"

#include <algorithm>
#include <cmath>

namespace coupling::report {
namespace {

/// Heights around a cell, row by row from the north-west.
std::array<double, 9> neighbourhood(const config::Raster<double>& heights_m, config::Cell cell) {
    std::array<double, 9> around{};
    const double own_m = heights_m.at(cell);
    std::size_t i = 0;
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            const config::Cell next{cell.column + dx, cell.row + dy};
            const double height_m = heights_m.frame.contains(next) ? heights_m.at(next) : own_m;
            around[i++] = std::isnan(height_m) ? own_m : height_m;
        }
    }
    return around;
}

}  // namespace

config::Raster<float> illumination(const config::Raster<double>& heights_m, const Light& light) {
    const double azimuth_rad = light.azimuth.in_radians();
    const double altitude_rad = light.altitude.in_radians();
    const double east = std::cos(altitude_rad) * std::sin(azimuth_rad);
    const double north = std::cos(altitude_rad) * std::cos(azimuth_rad);
    const double up = std::sin(altitude_rad);

    config::Raster<float> lit{heights_m.frame, std::numeric_limits<float>::quiet_NaN()};
    for (std::size_t i = 0; i < lit.values.size(); ++i) {
        if (std::isnan(heights_m.values[i])) {
            continue;
        }
        const auto [a, b, c, d, e, f, g, h, k] = neighbourhood(heights_m, heights_m.frame.cell_of(i));
        const double per_east =
            ((c + 2.0 * f + k) - (a + 2.0 * d + g)) / (8.0 * heights_m.frame.cell_width_m);
        const double per_north =
            ((a + 2.0 * b + c) - (g + 2.0 * h + k)) / (8.0 * heights_m.frame.cell_height_m);
        const double length = std::sqrt(1.0 + per_east * per_east + per_north * per_north);
        lit.values[i] =
            static_cast<float>(std::max(0.0, (up - east * per_east - north * per_north) / length));
    }
    return lit;
}

GreyPicture hillshade(const config::Raster<float>& lit) {
    constexpr float darkest = 96.0F;
    constexpr float span = 155.0F;
    GreyPicture picture{lit.frame.columns, lit.frame.rows, std::vector<std::uint8_t>(lit.values.size(), 255)};
    for (std::size_t i = 0; i < lit.values.size(); ++i) {
        if (!std::isnan(lit.values[i])) {
            picture.pixels[i] = static_cast<std::uint8_t>(std::lround(darkest + span * lit.values[i]));
        }
    }
    return picture;
}

}  // namespace coupling::report
