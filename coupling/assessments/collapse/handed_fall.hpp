#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "coupling/assessments/collapse/handed_ground.hpp"
#include "rockfall/motion/fall.hpp"
#include "rockfall/rock_mass/lone_blocks.hpp"

namespace coupling::collapse {

/// A handed block at a time.
struct HandedMoment {
    Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();
    Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();  ///< of its principal axes
    Eigen::Vector3d velocity_mps = Eigen::Vector3d::Zero();
    double translation_j = 0.0;
    double rotation_j = 0.0;
};

/// A stem that a handed block hit.
struct StemBlow {
    double after_s = 0.0;  ///< since the block was handed over
    std::uint32_t stem = 0;
    double energy_j = 0.0;  ///< that the tree took
    bool broken = false;
};

/// The way of a block after its mass handed it over, up to its end or to the time of its return.
struct HandedFall {
    rockfall::rock_mass::HandedBlock block;
    std::vector<HandedMoment> moments;    ///< at equal intervals; the last one where it ends
    std::vector<StemBlow> blows;          ///< in the order of time
    rockfall::FallEnd end;                ///< its reason counts only if it has ended
    bool has_ended = true;                ///< false: it came back into the mass on its way
    rockfall::rock_mass::BlockBack last;  ///< the state in which it ends
    double duration_s = 0.0;
    double start_j = 0.0;       ///< motion and height above the end with which it began
    double motion_end_j = 0.0;  ///< translation and rotation at the end
};

/// What a fall takes from the run.
struct FallSettings {
    const rockfall::FallLaw* law = nullptr;  ///< with that of rockfall::BlockModel, whichever model is chosen
    std::uint64_t seed = 0;
    double moment_s = 0.0;  ///< interval of the moments
};

/// Follows a block from the state in which it left its mass, up to a time after that at most. `gone` marks
/// stems that no longer stand. Its chance is keyed by its number and by how often it left the mass before;
/// the bumps of the ground by its number alone, as ground stays the same. What happens before that time is
/// the same, bit by bit, as on its whole way.
HandedFall follow(const HandedGround& ground, const FallSettings& settings,
                  const rockfall::rock_mass::HandedBlock& block,
                  std::shared_ptr<const rockfall::solids::Solid> solid, std::vector<std::uint8_t> gone,
                  std::uint32_t earlier_falls, double until_s = std::numeric_limits<double>::infinity());

}  // namespace coupling::collapse
