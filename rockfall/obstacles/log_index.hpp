#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "rockfall/laws/flight.hpp"
#include "rockfall/obstacles/log.hpp"
#include "rockfall/obstacles/plan_bins.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace rockfall {

/// "No log".
inline constexpr std::uint32_t no_log = 0xFFFFFFFFU;

/// A straight piece of a log as the inner loop needs it, in coordinates of the terrain.
///
/// Its axis runs as far above the ground, normal to it, as clearance and radius say.
struct LogPiece {
    Eigen::Vector3d first_m;  ///< one end of the axis
    Eigen::Vector3d along;    ///< from there to the other end
    Eigen::Vector3d normal;   ///< of the ground below
    double radius_m;
    double largest_energy_j;  ///< that the log takes here
    std::uint32_t log;

    /// The point of the axis that is nearest to a place.
    [[nodiscard]] Eigen::Vector3d nearest_to(const Eigen::Vector3d& place_m) const {
        const double share = along.dot(place_m - first_m) / along.squaredNorm();
        return first_m + (share <= 0.0 ? 0.0 : share >= 1.0 ? 1.0 : share) * along;
    }
};

/// A hit: which log, where, when, and how the rock lies against it.
struct LogHit {
    std::uint32_t log;
    std::uint32_t piece;
    double time_s;
    Eigen::Vector3d towards_rock;  ///< unit vector from the axis to the rock's centre
};

/// All lying logs of a slope, found by place.
///
/// A log follows the ground: it is cut into pieces of at most 2 m, each over the plane of the ground at its
/// middle and as thick as the log is there. A rock is a sphere that touches the ground with the point that
/// moves; its centre lies one radius from there along the normal. It hits where the centre comes as near to
/// the axis as rock radius + log radius, so that it passes below a log whose clearance is larger than the
/// rock, and above one that it jumps over.
class LogIndex {
public:
    LogIndex() = default;
    /// Pieces without ground below are not placed, nor are logs of strength 0. A log that is not supported
    /// takes `loose_share` of the energy of one that is.
    LogIndex(std::span<const Log> logs, const Terrain& terrain, double largest_rock_radius_m,
             double loose_share);

    /// No log at all was given.
    [[nodiscard]] bool empty() const { return count_ == 0; }
    /// How many logs were given; they keep their order and number.
    [[nodiscard]] std::size_t count() const { return count_; }
    [[nodiscard]] std::span<const LogPiece> pieces() const { return pieces_; }

    /// The first log that a rock meets between the start of a flight and `until_s`, the rock moving towards
    /// it. Logs that are `ignored` (met and not yet left) or marked in `gone` (empty: none) are passed over.
    /// A log is met when a millimetre is left between the two. A rock that begins within a log (released
    /// there, or turned into it) may leave it; it meets the log once it moves towards its axis, as deep as it
    /// is then, at most a centimetre of way later.
    [[nodiscard]] std::optional<LogHit> first_hit(const Flight& flight, double until_s, double rock_radius_m,
                                                  std::span<const std::uint32_t> ignored,
                                                  std::span<const std::uint8_t> gone) const;

    /// The same for a rock that rolls along a straight piece, `velocity_mps` constant.
    [[nodiscard]] std::optional<LogHit> first_hit_rolling(const Eigen::Vector3d& start_m,
                                                          const Eigen::Vector3d& velocity_mps, double until_s,
                                                          double rock_radius_m,
                                                          std::span<const std::uint32_t> ignored,
                                                          std::span<const std::uint8_t> gone) const;

    /// Whether a rock is more than a centimetre away from a log.
    [[nodiscard]] bool is_left(std::uint32_t log, const Eigen::Vector3d& position_m,
                               double rock_radius_m) const;

private:
    struct Path;
    [[nodiscard]] std::optional<LogHit> search(const Path& path) const;

    std::size_t count_ = 0;
    std::vector<LogPiece> pieces_;
    std::vector<std::uint32_t> first_piece_;  ///< of each log; one more at the end
    PlanBins bins_;
};

}  // namespace rockfall
