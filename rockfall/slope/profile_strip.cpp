#include "rockfall/slope/profile_strip.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace rockfall {
namespace {

constexpr double half_width_m = 10.0;

Terrain strip_terrain(std::span<const ProfilePoint> profile) {
    std::vector<Vertex> vertices;
    for (const ProfilePoint& point : profile) {
        vertices.push_back({point.distance_m, -half_width_m, point.height_m});
        vertices.push_back({point.distance_m, half_width_m, point.height_m});
    }
    // Between the corners k and k + 1 lie the triangles 2 k (right of the diagonal) and 2 k + 1 (left of it).
    std::vector<Triangle> triangles;
    const auto pieces = static_cast<std::uint32_t>(profile.size()) - 1;
    for (std::uint32_t k = 0; k < pieces; ++k) {
        const std::uint32_t here = 2 * k;
        const std::uint32_t next = here + 2;
        const std::uint32_t beyond = k + 1 < pieces ? next + 1 : no_triangle;
        const std::uint32_t before = k > 0 ? here - 2 : no_triangle;
        triangles.push_back({{here, next, next + 1}, {no_triangle, beyond, here + 1}});
        triangles.push_back({{here, next + 1, here + 1}, {here, no_triangle, before}});
    }
    return Terrain{Eigen::Vector2d::Zero(), std::move(vertices), std::move(triangles)};
}

SurfaceMap surfaces_along(std::span<const ProfilePoint> profile) {
    const double length_m = profile.back().distance_m - profile.front().distance_m;
    const int columns = std::max(1, static_cast<int>(std::ceil(length_m / profile_surface_cell_m)));
    const config::GridFrame frame{
        columns, 1, profile.front().distance_m, -half_width_m, length_m / columns, 2.0 * half_width_m};
    std::vector<std::uint8_t> ids(frame.size());
    std::size_t corner = 0;
    for (int column = 0; column < columns; ++column) {
        while (corner + 2 < profile.size() && frame.x_centre_m(column) >= profile[corner + 1].distance_m) {
            ++corner;
        }
        ids[static_cast<std::size_t>(column)] = profile[corner].surface;
    }
    return SurfaceMap{frame, std::move(ids)};
}

/// Corners of the profile and points between them, no further apart than `spacing_m`.
std::vector<ProfilePoint> refined(std::span<const ProfilePoint> profile, double spacing_m) {
    std::vector<ProfilePoint> points;
    for (std::size_t k = 0; k + 1 < profile.size(); ++k) {
        const double length_m = profile[k + 1].distance_m - profile[k].distance_m;
        const double rise_m = profile[k + 1].height_m - profile[k].height_m;
        const int pieces = std::max(1, static_cast<int>(std::ceil(length_m / spacing_m)));
        for (int i = 0; i < pieces; ++i) {
            const double share = static_cast<double>(i) / pieces;
            points.push_back({profile[k].distance_m + share * length_m, profile[k].height_m + share * rise_m,
                              profile[k].surface});
        }
    }
    points.push_back(profile.back());
    return points;
}

}  // namespace

Slope strip_slope(std::span<const ProfilePoint> profile, std::vector<SurfaceType> types) {
    assert(profile.size() >= 2);
    return {strip_terrain(profile), surfaces_along(profile), std::move(types)};
}

std::vector<ProfilePoint> contact_zone(std::span<const ProfilePoint> profile, const ContactLaw& law) {
    const double radius_m = law.radius_m({});
    if (!(radius_m > 0.0) || law.moves_nothing()) {
        return {profile.begin(), profile.end()};
    }
    constexpr double spacing_m = 1.0;
    std::vector<ProfilePoint> points = refined(profile, spacing_m);
    // The strip as points: enough rows on both sides to fill the support of those in the middle.
    const int rows = static_cast<int>(std::ceil(radius_m / spacing_m));
    std::vector<Eigen::Vector3d> strip;
    for (const ProfilePoint& point : points) {
        for (int row = -rows; row <= rows; ++row) {
            strip.emplace_back(point.distance_m, row * spacing_m, point.height_m);
        }
    }
    const std::vector<Eigen::Vector3d> felt = contact_zone(strip, law, HeightNoise{});
    const auto width = static_cast<std::size_t>(2 * rows + 1);
    for (std::size_t i = 0; i < points.size(); ++i) {
        points[i].height_m = felt[i * width + static_cast<std::size_t>(rows)].z();
    }
    return points;
}

}  // namespace rockfall
