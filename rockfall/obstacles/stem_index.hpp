#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "rockfall/laws/flight.hpp"
#include "rockfall/obstacles/plan_bins.hpp"
#include "rockfall/obstacles/stem.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace rockfall {

/// "No stem".
inline constexpr std::uint32_t no_stem = 0xFFFFFFFFU;

/// A stem as the inner loop needs it, in coordinates of the terrain.
struct PlacedStem {
    double x_m;
    double y_m;
    double ground_m;         ///< height of the terrain at the stem
    double height_m;         ///< of the whole tree: how the stem tapers
    double top_m;            ///< where it ends above the ground; lower where it is broken off
    double breast_radius_m;  ///< DBH / 2
    double largest_energy_j;
};

/// A hit: which stem, when, and where on it.
struct StemHit {
    std::uint32_t stem;
    double time_s;
    double offset_m;  ///< signed distance of the path from the stem's axis, > 0: axis left of the path
    double reach_m;   ///< rock radius + stem radius at the hit
    double height_m;  ///< of the rock's centre above the ground at the stem
};

/// The part of a box that lies within a circle. A straight way between two places in it stays in it.
struct ClearPlace {
    PlanBox box{};
    Eigen::Vector2d centre_m = Eigen::Vector2d::Zero();
    double squared_radius = -1.0;  ///< below 0: nowhere

    [[nodiscard]] bool has(double x_m, double y_m) const {
        const double dx = x_m - centre_m.x();
        const double dy = y_m - centre_m.y();
        return dx * dx + dy * dy < squared_radius && box.has(x_m, y_m);
    }
};

/// All stems of a slope, found by place.
///
/// Each stem is entered in every bin that its circle, widened by the largest rock's radius, touches. A query
/// therefore looks only into the bins under the path and still sees every stem that the rock's edge can
/// touch, however many stand in a bin.
class StemIndex {
public:
    StemIndex() = default;
    /// Stems outside the terrain are not placed; `placed()` keeps the order and number of the input, and
    /// `outside()` lists those without ground below.
    StemIndex(std::span<const Stem> stems, const Terrain& terrain, double largest_rock_radius_m,
              bool with_taper);

    [[nodiscard]] bool empty() const { return stems_.empty(); }
    [[nodiscard]] std::span<const PlacedStem> placed() const { return stems_; }
    [[nodiscard]] std::span<const std::uint32_t> outside() const { return outside_; }

    /// The first stem that a rock meets between the start of a flight and `until_s`.
    ///
    /// A hit is where the rock's centre comes as near to the axis as rock radius + stem radius at that
    /// height, the rock's underside below the tree top. `ignored` (stems hit and not yet left) are passed
    /// over, as are stems marked in `gone` (empty: none). A rock that starts within reach of a stem meets it
    /// at once if it moves towards the axis.
    [[nodiscard]] std::optional<StemHit> first_hit(const Flight& flight, double until_s, double rock_radius_m,
                                                   std::span<const std::uint32_t> ignored,
                                                   std::span<const std::uint8_t> gone) const;

    /// The same for a rock that rolls on the ground along a straight piece, `velocity_mps` constant.
    [[nodiscard]] std::optional<StemHit> first_hit_rolling(const Eigen::Vector3d& start_m,
                                                           const Eigen::Vector3d& velocity_mps,
                                                           double until_s, double rock_radius_m,
                                                           std::span<const std::uint32_t> ignored,
                                                           std::span<const std::uint8_t> gone) const;

    /// Whether a rock is more than a centimetre away from a stem.
    [[nodiscard]] bool is_left(std::uint32_t stem, const Eigen::Vector3d& position_m,
                               double rock_radius_m) const {
        const double dx = position_m.x() - stems_[stem].x_m;
        const double dy = position_m.y() - stems_[stem].y_m;
        const double clear_m = rock_radius_m + taper_at_ground * stems_[stem].breast_radius_m + 0.01;
        return dx * dx + dy * dy > clear_m * clear_m;
    }

    /// Where a rock of that radius surely meets no stem: around a place, as far as its bin reaches.
    [[nodiscard]] ClearPlace clear_place(const Eigen::Vector2d& centre_m, double rock_radius_m) const;

private:
    struct Path;
    [[nodiscard]] std::optional<StemHit> search(const Path& path) const;
    void look_into(std::span<const std::uint32_t> numbers, const Path& path, StemHit& first) const;

    std::vector<PlacedStem> stems_;
    std::vector<std::uint32_t> outside_;
    bool with_taper_ = true;
    PlanBins bins_;
};

}  // namespace rockfall
