#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "config/grid/raster.hpp"
#include "rockfall/motion/fall.hpp"
#include "rockfall/tally/cell_steps.hpp"
#include "rockfall/tally/cell_tally.hpp"
#include "rockfall/tally/ground_below.hpp"
#include "rockfall/tally/target.hpp"
#include "rockfall/tally/target_index.hpp"
#include "rockfall/terrain/rim.hpp"

namespace rockfall {

/// Impacts of one rock on one ground.
struct GroundCount {
    int ground = 0;  ///< code of the ground type
    std::uint32_t impacts = 0;
};

/// One fall in numbers: a row of the table of rocks.
struct RockRecord {
    std::uint64_t rock = 0;
    std::uint32_t source = 0;
    StopReason reason = StopReason::at_rest;
    RimPart left_over = RimPart::north;  ///< where a rock left the terrain
    float diameter_m = 0.0F;
    Eigen::Vector3d start_m = Eigen::Vector3d::Zero();  ///< in coordinates of the terrain
    Eigen::Vector3d end_m = Eigen::Vector3d::Zero();
    double path_m = 0.0;  ///< length of the path in space: arcs of flights, straight pieces on the ground
    double time_s = 0.0;
    double max_speed_mps = 0.0;
    double min_speed_mps = 0.0;      ///< 0 where it starts at rest or rolls to a stop
    double max_energy_j = 0.0;       ///< translation and rotation
    double max_height_m = 0.0;       ///< of the underside above the ground, vertical
    double jump_height_sum_m = 0.0;  ///< sum over the flights of their largest heights
    std::uint32_t jumps = 0;
    std::uint32_t long_jumps = 0;    ///< of at least `least_jump_m`: those whose lengths count
    double jump_length_sum_m = 0.0;  ///< straight lengths from launch to end
    double min_jump_length_m = 0.0;  ///< 0 without a jump
    double max_jump_length_m = 0.0;
    std::uint32_t ground_impacts = 0;
    std::vector<GroundCount> impacts_by_ground;  ///< in the order of their first impacts
    std::uint32_t tree_hits = 0;
    std::uint32_t trees_broken = 0;
    double tree_energy_j = 0.0;  ///< taken by trees
    std::uint32_t log_hits = 0;
    std::uint32_t logs_broken = 0;
    double log_energy_j = 0.0;   ///< taken by logs
    double dissipated_j = 0.0;   ///< of models that keep a ledger of energy
    double residual_j = 0.0;     ///< what that ledger misses
    double corrected_j = 0.0;    ///< of a rock that lies still and is lowered to the ground; never above 0
    std::uint32_t unsolved = 0;  ///< percussions whose solver met its limit

    [[nodiscard]] double run_out_m() const { return (end_m - start_m).head<2>().norm(); }
    [[nodiscard]] double mean_speed_mps() const { return time_s > 0.0 ? path_m / time_s : 0.0; }
    [[nodiscard]] double mean_jump_height_m() const { return jumps > 0 ? jump_height_sum_m / jumps : 0.0; }
    [[nodiscard]] double mean_jump_length_m() const {
        return long_jumps > 0 ? jump_length_sum_m / long_jumps : 0.0;
    }
};

/// A corner of a drawn path.
struct PathPoint {
    Eigen::Vector3d position_m;
    float energy_j;
    float height_m;
    float time_s = 0.0F;              ///< since the release
    float speed_mps = 0.0F;           ///< of the centre
    std::array<float, 4> attitude{};  ///< quaternion (w, x, y, z) of a block's principal axes; 0: a ball
};

/// A tree hit as the tables show it.
struct TreeHitRecord {
    std::uint32_t stem;
    Eigen::Vector3d position_m;  ///< underside of the rock
    float height_m;              ///< of the rock's centre above the ground at the stem
    float energy_j;              ///< of the rock before the hit
    float loss_j;
    HitType type;
    bool broken;
    bool stopped;
};

/// A hit on a lying log as the tables show it.
struct LogHitRecord {
    std::uint32_t log;
    Eigen::Vector3d position_m;  ///< underside of the rock
    float energy_j;              ///< of the rock before the hit
    float loss_j;
    LogOutcome outcome;
};

/// A rock in the plane of a net as the tables show it.
struct NetCrossingRecord {
    std::uint32_t net;
    float x_m;  ///< in coordinates of the terrain
    float y_m;
    float along_m;   ///< along the line of the net, from its first corner
    float height_m;  ///< of the rock's centre above the ground, vertical
    float radius_m;  ///< of the rock
    float energy_j;  ///< before the net: translation and rotation
    float translational_j;
    float speed_mps;
    NetOutcome outcome;
    bool first;  ///< the rock has not crossed the line of this net before
};

/// Watches one rock: the cells it passes with its exact largest values there, its record, its arrivals at
/// targets, its hits, and its path if wanted. Reused from rock to rock without allocating.
class Footprint {
public:
    /// `frame` in coordinates of the terrain; without cells none are kept, and everything else is.
    Footprint(const Terrain& terrain, const config::GridFrame& frame, std::span<const Target> targets);

    void begin(const RockStart& start, bool with_path);
    void finish(const FallEnd& end);
    /// Takes the place of `begin`: goes on from what another, with the same frame and targets, has seen of a
    /// fall so far.
    void go_on_from(const Footprint& other);

    // The observer's part.
    void flew(const Rock& rock, const Flight& flight, double until_s, std::span<const Stretch> stretches,
              double spin_radps);
    void rolled(const Rock& rock, const RollingPiece& piece, std::uint32_t triangle);
    /// Follows `flew` and `rolled` of a block: `pose_at` gives its pose at a time since their start, what
    /// arrivals and the drawn path need of it.
    template <class PoseAt>
    void turned(const PoseAt& pose_at) {
        for (const PosedMoment& moment : moments_) {
            take(moment, pose_at(moment.time_s));
        }
        moments_.clear();
        is_block_ = true;
    }
    void impacted(const Eigen::Vector3d& place_m, int ground);
    void met_stem(const Eigen::Vector3d& position_m, const StemHit& hit, const TreeImpact& impact,
                  double energy_j);
    void met_log(const Eigen::Vector3d& position_m, const LogHit& hit, const LogImpact& impact,
                 double energy_j);

    void crossed_net(const Eigen::Vector3d& position_m, const NetCrossing& crossing);

    /// Of a finished fall.
    [[nodiscard]] std::span<const CellVisit> visits() const { return visits_; }
    [[nodiscard]] const RockRecord& record() const { return record_; }
    /// The targets that the rock reached, in rising order.
    [[nodiscard]] std::span<const TargetArrival> arrivals() const { return arrivals_; }
    [[nodiscard]] std::span<const TreeHitRecord> tree_hits() const { return tree_hits_; }
    [[nodiscard]] std::span<const LogHitRecord> log_hits() const { return log_hits_; }
    [[nodiscard]] std::span<const NetCrossingRecord> net_crossings() const { return net_crossings_; }
    [[nodiscard]] std::span<const PathPoint> path() const { return path_; }
    /// Cell in which the rock came to rest; frame.size() if it did not stop inside the frame.
    [[nodiscard]] std::size_t deposit_cell() const { return deposit_cell_; }

private:
    static constexpr std::uint32_t no_slot = 0xFFFFFFFFU;
    enum Reached : std::uint8_t { not_yet, by_centre, by_side };
    /// An arrival or a corner of the path that was shown last, whose pose is still to be known.
    struct PosedMoment {
        double time_s;
        bool is_arrival;    ///< else a corner of the path
        std::size_t place;  ///< in arrivals_ or path_
    };
    /// The largest values in one cell so far, of which `finish` makes a visit. Roots and floats rise with
    /// what they are taken of, so that they need be taken of the largest values alone.
    struct CellMaxima {
        double energy_j = 0.0;
        double squared_speed = 0.0;
        double height_m = 0.0;
        double energy_line_slope = std::numeric_limits<double>::infinity();  ///< the smallest one
        std::uint32_t cell = 0;
        std::uint32_t tree_impacts = 0;
    };
    struct CellSlot {
        std::uint32_t rock = 0;  ///< 0: none yet
        std::uint32_t slot = 0;  ///< place in maxima_ where `rock` is the present one
    };
    void begin_cells();
    void finish_cells();
    void forget_arrivals();
    void take(const PosedMoment& moment, const ShownPose& pose);
    CellMaxima& maxima_of(std::size_t cell) {
        const CellSlot& known = slots_[cell];
        return known.rock == present_rock_ ? maxima_[known.slot] : enter_cell(cell);
    }
    CellMaxima& enter_cell(std::size_t cell);
    void stand_in(const config::Cell& cell);
    void raise(CellMaxima& maxima, double energy_j, double squared_speed, double height_m, double x_m,
               double y_m, double ground_m) const;
    /// A piece on the ground with so much energy at its start and at its end.
    void walk_cells(const Rock& rock, const RollingPiece& piece, const Eigen::Vector3d& end_m, double begin2,
                    double end2, double begin_j, double end_j);
    /// Where on a straight piece the rock meets a target that it has not met yet.
    struct Meeting {
        double share;  ///< of the way
        bool by_side;
    };
    [[nodiscard]] std::optional<Meeting> meeting(std::uint32_t target, const Eigen::Vector2d& from_m,
                                                 const Eigen::Vector2d& to_m) const;
    /// The same of a target below roofs: the first meeting on which none of them holds the rock.
    /// `energy_j(share)`: on the way.
    template <class Energy>
    [[nodiscard]] std::optional<Meeting> meeting(std::uint32_t target, const Eigen::Vector2d& from_m,
                                                 const Eigen::Vector2d& to_m, const Energy& energy_j) const {
        if (targets_[target].roofs.empty()) {
            return meeting(target, from_m, to_m);
        }
        return meeting_beside_roofs(target, from_m, to_m, energy_j);
    }
    [[nodiscard]] std::optional<Meeting> meeting_beside_roofs(
        std::uint32_t target, const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m,
        const std::function<double(double)>& energy_j) const;
    /// Returns the place in arrivals_. What the side touched is forgotten when the centre arrives.
    std::size_t arrive(std::uint32_t target, bool by_side, const Eigen::Vector2d& place_m, double energy_j,
                       double translational_j, double speed_mps, double height_m);
    void wait_for_pose(double time_s) { moments_.push_back({time_s, false, path_.size() - 1}); }
    void wait_for_pose(double time_s, std::size_t arrival) { moments_.push_back({time_s, true, arrival}); }
    void watch_targets(const Rock& rock, const Flight& flight, double until_s,
                       std::span<const Stretch> stretches, double rotation_j);
    /// Largest height of the underside above the ground.
    double walk_cells(const Rock& rock, const Flight& flight, double until_s, GroundBelow& ground,
                      double rotation_j);
    [[nodiscard]] GroundBelow ground_below(const Flight& flight, std::span<const Stretch> stretches) const;
    void measure_jump(const Flight& flight, double until_s);
    /// A piece of the path. Those of a block are many and short: where one `joins` the next, corners closer
    /// than the rock's radius are left out.
    void draw_piece(const PathPoint& from, const PathPoint& to, double duration_s, bool joins);
    void draw(const Flight& flight, double until_s, std::span<const Stretch> stretches, const Rock& rock,
              double rotation_j);

    [[nodiscard]] bool keeps_cells() const { return !slots_.empty(); }

    const Terrain& terrain_;
    config::GridFrame frame_;
    std::span<const Target> targets_;
    TargetIndex target_index_;

    std::vector<CellVisit> visits_;
    std::vector<CellMaxima> maxima_;
    std::vector<CellSlot> slots_;  ///< by cell
    std::uint32_t present_rock_ = 0;
    CellInside cell_here_;  ///< where the way ended last: most pieces are short and stay there
    /// Place in maxima_ of cell_here_; `no_slot` where the rock has not left anything there yet.
    std::uint32_t slot_here_ = no_slot;
    double largest_squared_speed_ = 0.0;
    double least_squared_speed_ = 0.0;

    RockRecord record_;
    std::vector<TargetArrival> arrivals_;
    std::vector<std::uint8_t> reached_;  ///< by target, as Reached
    bool has_sides_ = false;             ///< some target is hit by sides of rocks
    double reach_m_ = 0.0;               ///< of target_index_
    std::vector<TreeHitRecord> tree_hits_;
    std::vector<LogHitRecord> log_hits_;
    std::vector<NetCrossingRecord> net_crossings_;
    std::vector<PathPoint> path_;
    std::vector<PosedMoment> moments_;
    double radius_m_ = 0.0;
    bool is_block_ = false;  ///< of a model whose rocks have poses
    bool joins_ = false;     ///< the last corner of the path ends a short piece of a block
    bool with_path_ = false;
    std::size_t deposit_cell_ = 0;
};

}  // namespace rockfall
