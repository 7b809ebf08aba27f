#include "coupling/assessments/collapse/handed_fall.hpp"

#include <cmath>

#include "config/units/constants.hpp"
#include "rockfall/motion/block_fall.hpp"

namespace coupling::collapse {
namespace {

using Eigen::Vector3d;
using rockfall::Rock;

/// Notes where a block is at equal intervals of time, and which stems it hits.
class MomentsOfFall {
public:
    MomentsOfFall(HandedFall& fall, double interval_s, const Eigen::Quaterniond& attitude)
        : fall_{fall}, interval_s_{interval_s}, attitude_{attitude} {}

    [[nodiscard]] double time_s() const { return time_s_; }

    void flew(const Rock& rock, const rockfall::Flight& flight, double until_s,
              std::span<const rockfall::Stretch>, double spin_radps) {
        const double rotation_j = 0.5 * rock.inertia_kgm2 * spin_radps * spin_radps;
        is_flight_ = true;
        note(until_s, [&](double after_s) {
            return moment(rock, flight.position_m(after_s), flight.velocity_at(after_s), rotation_j);
        });
    }
    void rolled(const Rock& rock, const rockfall::RollingPiece& piece, std::uint32_t) {
        is_flight_ = false;
        note(piece.duration_s, [&](double after_s) {
            HandedMoment made = moment(rock, piece.position_m(after_s), piece.velocity_at(after_s),
                                       piece.own_at(after_s).rotation_j);
            made.translation_j = 0.5 * rock.mass_kg * piece.own_at(after_s).squared_speed;
            return made;
        });
    }
    /// Attitudes of the moments noted last. A piece on the ground is shown as it is turned at its end: it
    /// turns evenly up to there.
    template <class PoseAt>
    void turned(const PoseAt& pose_at) {
        const double duration_s = time_s_ - piece_start_s_;
        const Eigen::Quaterniond end = pose_at(duration_s).attitude;
        for (std::size_t k = first_of_piece_; k < fall_.moments.size(); ++k) {
            const double after_s = static_cast<double>(k) * interval_s_ - piece_start_s_;
            fall_.moments[k].attitude =
                is_flight_ ? pose_at(after_s).attitude : attitude_.slerp(after_s / duration_s, end);
        }
        attitude_ = end;
    }
    void impacted(const Vector3d&, int) {}
    void met_stem(const Vector3d&, const rockfall::StemHit& hit, const rockfall::TreeImpact& impact, double) {
        fall_.blows.push_back({time_s_, hit.stem, impact.loss_j, impact.broken});
    }
    void met_log(const Vector3d&, const rockfall::LogHit&, const rockfall::LogImpact&, double) {}
    void crossed_net(const Vector3d&, const rockfall::NetCrossing&) {}

private:
    static HandedMoment moment(const Rock& rock, const Vector3d& underside_m, const Vector3d& velocity_mps,
                               double rotation_j) {
        HandedMoment made;
        made.centre_m = underside_m + Vector3d{0.0, 0.0, rock.radius_m};
        made.velocity_mps = velocity_mps;
        made.translation_j = 0.5 * rock.mass_kg * velocity_mps.squaredNorm();
        made.rotation_j = rotation_j;
        return made;
    }
    template <class MomentAt>
    void note(double duration_s, const MomentAt& moment_at) {
        piece_start_s_ = time_s_;
        first_of_piece_ = fall_.moments.size();
        time_s_ += duration_s;
        for (double at_s = static_cast<double>(fall_.moments.size()) * interval_s_; at_s <= time_s_;
             at_s = static_cast<double>(fall_.moments.size()) * interval_s_) {
            fall_.moments.push_back(moment_at(at_s - piece_start_s_));
        }
    }

    HandedFall& fall_;
    double interval_s_;
    Eigen::Quaterniond attitude_;  ///< at the end of the piece or flight noted last
    bool is_flight_ = false;
    double time_s_ = 0.0;
    double piece_start_s_ = 0.0;
    std::size_t first_of_piece_ = 0;
};

HandedMoment moment_of(const rockfall::MovingBlock& body, const rockfall::solids::Solid& solid) {
    return {body.centre_m, body.rotation.attitude, body.velocity_mps,
            0.5 * solid.mass_kg * body.velocity_mps.squaredNorm(),
            body.rotation.energy_j(solid.inertia_kgm2)};
}

}  // namespace

HandedFall follow(const HandedGround& ground, const FallSettings& settings,
                  const rockfall::rock_mass::HandedBlock& block,
                  std::shared_ptr<const rockfall::solids::Solid> solid, std::vector<std::uint8_t> gone,
                  std::uint32_t earlier_falls, double until_s) {
    HandedFall fall;
    fall.block = block;
    const rockfall::MovingBlock body{block.centre_m, block.velocity_mps, block.rotation};
    fall.moments.push_back(moment_of(body, *solid));
    const auto under = ground.slope().terrain.locate(block.centre_m.x(), block.centre_m.y());
    if (!under) {
        fall.end.reason = rockfall::StopReason::left_terrain;
        fall.last = {block.number, block.centre_m, block.velocity_mps, block.rotation};
        fall.start_j = fall.motion_end_j = block.motion_j;
        return fall;
    }
    rockfall::Obstacles obstacles;
    obstacles.stems = ground.stems().empty() ? nullptr : &ground.stems();
    obstacles.gone = gone;
    const config::StreamKey ground_key{settings.seed, 0, 0, block.number};
    const config::StreamKey key{settings.seed, earlier_falls, 0, block.number};
    rockfall::RockStart start;
    start.id = block.number;
    start.rock = Rock::sphere(solid->diameter_m(), solid->mass_kg / solid->volume_m3);
    start.block.solid = solid;
    start.triangle = *under;
    rockfall::FallScratch scratch;
    MomentsOfFall moments{fall, settings.moment_s, block.rotation.attitude};
    const auto& law = settings.law->motion.of<rockfall::BlockModel>();
    rockfall::BlockFall<MomentsOfFall> motion{ground.slope(),
                                              obstacles,
                                              *settings.law,
                                              rockfall::BlockModel::Motion{law, key, start.rock},
                                              key,
                                              start,
                                              scratch,
                                              moments,
                                              solid,
                                              {body, *under, block.on_ground},
                                              ground_key};
    fall.end = motion.run_until(until_s);
    fall.has_ended = motion.has_ended();
    const rockfall::MovingBlock& last = motion.block().body();
    fall.last = {block.number, last.centre_m, last.velocity_mps, last.rotation};
    fall.moments.push_back(moment_of(last, *solid));
    fall.motion_end_j = fall.moments.back().translation_j + fall.moments.back().rotation_j;
    fall.duration_s = fall.has_ended ? moments.time_s() : until_s;
    const double height_m = block.centre_m.z() - fall.moments.back().centre_m.z();
    fall.start_j = block.motion_j + solid->mass_kg * config::gravity_mps2 * height_m;
    return fall;
}

}  // namespace coupling::collapse
