#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "rockfall/slope/slope.hpp"
#include "rockfall/tally/ensemble_tally.hpp"
#include "rockfall/tally/jump_log.hpp"

namespace rockfall {

/// A velocity against a face of the terrain.
struct Speeds {
    double along_mps = 0.0;   ///< in the face, not negative
    double normal_mps = 0.0;  ///< into it before an impact, off it after one

    [[nodiscard]] double whole_mps() const {
        return std::sqrt(along_mps * along_mps + normal_mps * normal_mps);
    }
};

/// A contact of a flying rock with the ground: how it came and how it went on.
struct GroundImpact {
    /// What the rock does after it.
    enum class Onward : std::uint8_t { jumps, rolls, stops };

    Eigen::Vector3d place_m = Eigen::Vector3d::Zero();  ///< of the underside, coordinates of the terrain
    int ground = 0;                                     ///< code of the ground type
    Speeds before;                                      ///< as it comes: into the ground
    Speeds after;                                       ///< as it leaves: off the ground; none where it stops
    Onward onward = Onward::stops;
    Jump jump;  ///< that ended here
};

/// The impacts of a rock over one slope, in their order.
struct RockImpacts {
    std::uint64_t rock = 0;
    Cover cover = Cover::bare;
    std::vector<GroundImpact> impacts;
};

/// Watches one rock and keeps each impact on the ground that ends a flight. Reused from rock to rock.
///
/// Velocities are split by the face of the terrain, not by the contact zone that the fall itself feels: that
/// is what somebody measures on the ground.
class ImpactLog {
public:
    explicit ImpactLog(const Slope& slope) : slope_{&slope}, jumps_{slope.terrain} {}
    void begin() {
        jumps_.begin();
        impacts_.clear();
        in_flight_ = false;
        open_ = false;
    }

    void flew(const Rock& rock, const Flight& flight, double until_s, std::span<const Stretch> stretches,
              double spin_radps);
    void rolled(const Rock& rock, const RollingPiece& piece, std::uint32_t triangle);
    void impacted(const Eigen::Vector3d& place_m, int ground);
    void met_stem(const Eigen::Vector3d& position_m, const StemHit& hit, const TreeImpact& impact,
                  double energy_j);
    void met_log(const Eigen::Vector3d& position_m, const LogHit& hit, const LogImpact& impact,
                 double energy_j);
    void crossed_net(const Eigen::Vector3d&, const NetCrossing&) {}

    [[nodiscard]] std::span<const GroundImpact> impacts() const { return impacts_; }

private:
    void go_on(GroundImpact::Onward onward, const Eigen::Vector3d& velocity_mps);

    const Slope* slope_;
    JumpLog jumps_;
    std::vector<GroundImpact> impacts_;
    Eigen::Vector3d arriving_mps_ = Eigen::Vector3d::Zero();  ///< at the end of the last flight
    Eigen::Vector3d normal_ = Eigen::Vector3d::UnitZ();       ///< of the face where it ended
    std::uint32_t triangle_ = 0;
    bool in_flight_ = false;  ///< the last event was a flight
    bool open_ = false;       ///< how the rock goes on after the last impact is not known yet
};

}  // namespace rockfall
