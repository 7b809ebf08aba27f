#pragma once

#include <Eigen/Core>
#include <array>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "config/math/elementary.hpp"
#include "rockfall/terrain/local_plane.hpp"

namespace rockfall {

/// Cleveland 1979: 1 at the centre, 0 from the radius on, smooth at both.
inline double tricube(double distance_m, double radius_m) {
    const double ratio = distance_m / radius_m;
    const double rest = 1.0 - ratio * ratio * ratio;
    return ratio < 1.0 ? rest * rest * rest : 0.0;
}

/// A point as seen from the one whose contact zone it is in, and its distance in plan.
struct PointApart {
    double x_m;
    double y_m;
    double z_m;
    double distance_m;
};

/// Unit vectors in the directions of the compass, each 22.5 degrees from the next.
inline const std::array<Eigen::Vector2d, 16>& zone_directions() {
    static const std::array<Eigen::Vector2d, 16> all = [] {
        const auto turned = [](double share_of_right_angle) {
            return config::sin_cos_of(0.5 * std::numbers::pi * share_of_right_angle);
        };
        std::array<Eigen::Vector2d, 16> compass;
        for (std::size_t i = 0; i < 4; ++i) {
            const config::SinCos angle = turned(0.25 * static_cast<double>(i));
            compass[i] = {angle.cos, angle.sin};
            compass[i + 4] = {-angle.sin, angle.cos};
            compass[i + 8] = -compass[i];
            compass[i + 12] = -compass[i + 4];
        }
        return compass;
    }();
    return all;
}

/// The planes of the halves of a zone, by the direction in which they lie.
using ZoneHalves = std::array<std::optional<Eigen::Vector3d>, 16>;

/// The points of a zone with what they add to planes through them: the same to that of all and to those of
/// eight halves.
class WeighedPoints {
public:
    void weigh(std::span<const PointApart> around, double radius_m) {
        points_.clear();
        radius_m_ = radius_m;
        for (const PointApart& one : around) {
            if (one.distance_m < radius_m) {
                points_.push_back(
                    {LocalPlane::terms_of(one.x_m, one.y_m, one.z_m, tricube(one.distance_m, radius_m)),
                     one.x_m, one.y_m});
            }
        }
    }
    [[nodiscard]] std::optional<Eigen::Vector3d> plane() const {
        LocalPlane plane;
        plane.add(0.0, 0.0, 0.0, 1.0);
        for (const Weighed& one : points_) {
            plane.add(one.terms);
        }
        return plane.fit();
    }
    /// Without the centre: a single wrong height is in neither half and so makes no break.
    [[nodiscard]] ZoneHalves halves() const {
        ZoneHalves found;
        for (std::size_t i = 0; i < found.size() / 2; ++i) {
            const Eigen::Vector2d& inwards = zone_directions()[i];
            const double least_m = -1e-6 * radius_m_;
            LocalPlane here;
            LocalPlane across;
            for (const Weighed& one : points_) {
                const double inside_m = inwards.x() * one.x_m + inwards.y() * one.y_m;
                if (inside_m > least_m) {
                    here.add(one.terms);
                }
                if (-inside_m > least_m) {
                    across.add(one.terms);
                }
            }
            found[i] = here.fit();
            found[i + found.size() / 2] = across.fit();
        }
        return found;
    }

private:
    struct Weighed {
        LocalPlane::Terms terms;
        double x_m;
        double y_m;
    };
    std::vector<Weighed> points_;
    double radius_m_ = 0.0;
};

}  // namespace rockfall
