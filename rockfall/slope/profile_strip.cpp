#include "rockfall/slope/profile_strip.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "config/math/elementary.hpp"

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

/// Standard deviation of the noise of a profile that was sampled in equal steps, from a grid for instance, by
/// the median fourth difference, which has the variance 70 times that of the noise. 0 for a profile of
/// corners: somebody saw these.
double noise_along_m(std::span<const ProfilePoint> profile) {
    constexpr std::size_t fewest_points = 30;
    constexpr double equal = 0.02;  // of the step
    if (profile.size() < fewest_points) {
        return 0.0;
    }
    const double step_m =
        (profile.back().distance_m - profile.front().distance_m) / static_cast<double>(profile.size() - 1);
    std::vector<double> off_m;
    for (std::size_t i = 0; i + 4 < profile.size(); ++i) {
        const std::span<const ProfilePoint> at = profile.subspan(i, 5);
        if (std::abs(at[1].distance_m - at[0].distance_m - step_m) > equal * step_m) {
            return 0.0;
        }
        off_m.push_back(std::abs(at[0].height_m - 4.0 * at[1].height_m + 6.0 * at[2].height_m -
                                 4.0 * at[3].height_m + at[4].height_m));
    }
    const auto middle = off_m.begin() + static_cast<std::ptrdiff_t>(off_m.size() / 2);
    std::nth_element(off_m.begin(), middle, off_m.end());
    return *middle / (0.6744897501960817 * std::sqrt(70.0));
}

/// Noise is the same across a strip, so that the zone averages along it only: the slope error of noise 1 at
/// points 1 apart is 1.665 / r^1.5, by the same integral as slope_of_noise.
double radius_along(std::span<const ProfilePoint> profile, const ContactLaw& law) {
    if (law.given_radius_m) {
        return *law.given_radius_m;
    }
    constexpr double slope_of_noise_along = 1.665;
    const double step_m =
        (profile.back().distance_m - profile.front().distance_m) / static_cast<double>(profile.size() - 1);
    const double for_noise_m = config::pow_of(
        slope_of_noise_along * noise_along_m(profile) * std::sqrt(step_m) / law.slope_error, 2.0 / 3.0);
    constexpr double most_steps = 10.0;
    return std::max(law.least_radius_m, std::min(for_noise_m, most_steps * step_m));
}

}  // namespace

Slope strip_slope(std::span<const ProfilePoint> profile, std::vector<SurfaceType> types) {
    assert(profile.size() >= 2);
    return {strip_terrain(profile), surfaces_along(profile), std::move(types)};
}

std::vector<ProfilePoint> contact_zone(std::span<const ProfilePoint> profile, const ContactLaw& law) {
    const double radius_m = radius_along(profile, law);
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
    ContactLaw of_strip = law;
    of_strip.given_radius_m = radius_m;
    const std::vector<Eigen::Vector3d> felt = contact_zone(strip, of_strip, HeightNoise{});
    const auto width = static_cast<std::size_t>(2 * rows + 1);
    for (std::size_t i = 0; i < points.size(); ++i) {
        points[i].height_m = felt[i * width + static_cast<std::size_t>(rows)].z();
    }
    return points;
}

}  // namespace rockfall
