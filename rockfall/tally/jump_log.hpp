#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "rockfall/motion/fall.hpp"

namespace rockfall {

/// Shorter flights begin and end on one spot, as at the foot of a wall: no jumps to be counted. Choice.
inline constexpr double least_jump_m = 1e-3;

/// A flight of a rock's underside, from the ground or an obstacle to the next of either. The first flight of
/// a rock released above the ground begins at its release.
struct Jump {
    Eigen::Vector3d from_m = Eigen::Vector3d::Zero();
    Eigen::Vector3d to_m = Eigen::Vector3d::Zero();
    double highest_m = 0.0;  ///< largest vertical height above ground
    double launch_mps = 0.0;
    double impact_mps = 0.0;
    double time_s = 0.0;
    bool landed =
        false;  ///< ended with a ground impact; false: at an obstacle, at the border, at rest in a pit

    [[nodiscard]] double length_m() const { return (to_m - from_m).norm(); }
    [[nodiscard]] double plan_length_m() const { return (to_m - from_m).head<2>().norm(); }
};

/// Watches one rock and keeps each of its jumps. Reused from rock to rock.
class JumpLog {
public:
    explicit JumpLog(const Terrain& terrain) : terrain_{&terrain} {}
    void begin() {
        jumps_.clear();
        in_flight_ = false;
    }

    void flew(const Rock& rock, const Flight& flight, double until_s, std::span<const Stretch> stretches,
              double spin_radps);
    void rolled(const Rock&, const RollingPiece&, std::uint32_t) { in_flight_ = false; }
    void impacted(const Eigen::Vector3d& place_m, int ground);
    void met_stem(const Eigen::Vector3d&, const StemHit&, const TreeImpact&, double) { in_flight_ = false; }
    void met_log(const Eigen::Vector3d&, const LogHit&, const LogImpact&, double) { in_flight_ = false; }
    void crossed_net(const Eigen::Vector3d&, const NetCrossing&) {}

    [[nodiscard]] std::span<const Jump> jumps() const { return jumps_; }

private:
    const Terrain* terrain_;
    std::vector<Jump> jumps_;
    bool in_flight_ = false;  ///< the last event was a flight: an impact now is its end
};

/// Two observers of one fall.
template <class First, class Second>
struct BothWatch {
    First& first;
    Second& second;

    void flew(const Rock& rock, const Flight& flight, double until_s, std::span<const Stretch> stretches,
              double spin_radps) {
        first.flew(rock, flight, until_s, stretches, spin_radps);
        second.flew(rock, flight, until_s, stretches, spin_radps);
    }
    void rolled(const Rock& rock, const RollingPiece& piece, std::uint32_t triangle) {
        first.rolled(rock, piece, triangle);
        second.rolled(rock, piece, triangle);
    }
    void impacted(const Eigen::Vector3d& place_m, int ground) {
        first.impacted(place_m, ground);
        second.impacted(place_m, ground);
    }
    void met_stem(const Eigen::Vector3d& position_m, const StemHit& hit, const TreeImpact& impact,
                  double energy_j) {
        first.met_stem(position_m, hit, impact, energy_j);
        second.met_stem(position_m, hit, impact, energy_j);
    }
    void met_log(const Eigen::Vector3d& position_m, const LogHit& hit, const LogImpact& impact,
                 double energy_j) {
        first.met_log(position_m, hit, impact, energy_j);
        second.met_log(position_m, hit, impact, energy_j);
    }
    void crossed_net(const Eigen::Vector3d& position_m, const NetCrossing& crossing) {
        first.crossed_net(position_m, crossing);
        second.crossed_net(position_m, crossing);
    }
};

}  // namespace rockfall
