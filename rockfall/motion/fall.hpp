#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <span>
#include <vector>

#include "rockfall/laws/flight.hpp"
#include "rockfall/laws/rock.hpp"
#include "rockfall/laws/rolling.hpp"
#include "rockfall/motion/models.hpp"
#include "rockfall/obstacles/log_impact.hpp"
#include "rockfall/obstacles/nets/net.hpp"
#include "rockfall/obstacles/nets/net_watch.hpp"
#include "rockfall/obstacles/obstacles.hpp"
#include "rockfall/obstacles/tree_impact.hpp"
#include "rockfall/solids/block_shape.hpp"

namespace rockfall {

/// All settings of the fall of a rock.
struct FallLaw {
    MotionLaws motion;
    TreeImpactLaw tree;
    LogImpactLaw log;
};

/// A rock at the moment of its release, in coordinates of the terrain.
struct RockStart {
    std::uint64_t id = 0;                                  ///< key of its random numbers
    std::uint32_t source = 0;                              ///< which release source
    Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  ///< underside
    Eigen::Vector3d velocity_mps = Eigen::Vector3d::Zero();
    std::uint32_t triangle = 0;
    bool rolling = false;  ///< begins on the ground
    Rock rock;
    DrawnBlock block;  ///< its shape, for models whose rocks have one; else none
    Eigen::Vector2d heading = Eigen::Vector2d::Zero();  ///< unit, in plan, where it is sent
};

/// Why a rock no longer moves.
enum class StopReason : std::uint8_t {
    at_rest,       ///< kinetic energy used up on the ground
    caught,        ///< stopped by an obstacle of the surface (stopping probability)
    tree,          ///< stopped by a stem
    log,           ///< rests upslope of a lying log
    net,           ///< held by a net
    left_terrain,  ///< ran over the border or into a hole: not stopped
    gave_up,       ///< more impacts than the limit: not stopped
};

inline constexpr std::size_t stop_reasons = 7;

/// Whether the rock lies still; otherwise it left or was given up.
constexpr bool came_to_rest(StopReason reason) {
    return reason != StopReason::left_terrain && reason != StopReason::gave_up;
}

/// How a fall ended.
struct FallEnd {
    StopReason reason = StopReason::at_rest;
    Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
    std::uint32_t triangle = no_triangle;  ///< the last one below the rock
    std::uint32_t ground_impacts = 0;
    std::uint32_t tree_hits = 0;
    std::uint32_t log_hits = 0;
    std::uint32_t crossings = 0;  ///< triangle stretches flown over, for benchmarks
    double dissipated_j = 0.0;    ///< of models that keep a ledger: energy lost, and what the ledger misses
    double residual_j = 0.0;
    double corrected_j = 0.0;       ///< of a rock that lies still and is lowered to the ground; never above 0
    std::uint32_t unsolved = 0;     ///< percussions whose solver met its limit
    std::uint64_t percussions = 0;  ///< solved, for benchmarks
};

/// Memory that falls reuse.
struct FallScratch {
    std::vector<Stretch> stretches;
    NetScratch nets;
    EachModel<ScratchOf>::type of_models;

    template <class Model>
    [[nodiscard]] typename ScratchOf<Model>::type& of() {
        return std::get<place_in_list<Model>>(of_models);
    }
};

/// A block as it is turned at some moment.
struct ShownPose {
    Eigen::Quaterniond attitude;  ///< of its principal axes in space
    double above_centre_m;        ///< of its highest point
};

/// Watches nothing: for falls of which only the end counts.
struct NoObserver {
    void flew(const Rock&, const Flight&, double, std::span<const Stretch>, double) {}
    void rolled(const Rock&, const RollingPiece&, std::uint32_t) {}
    void impacted(const Eigen::Vector3d&, int) {}
    void met_stem(const Eigen::Vector3d&, const StemHit&, const TreeImpact&, double) {}
    void met_log(const Eigen::Vector3d&, const LogHit&, const LogImpact&, double) {}
    void crossed_net(const Eigen::Vector3d&, const NetCrossing&) {}
};

}  // namespace rockfall
