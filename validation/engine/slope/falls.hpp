#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "coupling/run/interrupt.hpp"
#include "coupling/run/watched_falls.hpp"
#include "validation/engine/slope/rebuild.hpp"

namespace coupling::validation {

/// What the figures of a case need of one fall. Distances are plan distances along the profile.
struct RockFacts {
    rockfall::StopReason reason = rockfall::StopReason::at_rest;
    double end_m = 0.0;
    double max_speed_mps = 0.0;
    double mean_speed_mps = 0.0;  ///< length of the path divided by its time
    double max_height_m = 0.0;    ///< of the underside, vertical, over its jumps
    double jump_height_sum_m = 0.0;
    double jump_length_sum_m = 0.0;  ///< in plan, of jumps that ended on the ground
    std::uint32_t jumps = 0;
    std::uint32_t landed_jumps = 0;
    std::uint32_t impacts = 0;
    std::uint32_t tree_hits = 0;
    std::uint32_t trees_broken = 0;

    [[nodiscard]] bool stopped() const { return rockfall::came_to_rest(reason); }
};

/// The jumps that end in one stretch of slope length, before the mean is taken.
struct JumpSums {
    std::uint64_t jumps = 0;
    double shortest_m = 0.0;
    double sum_m = 0.0;
    double longest_m = 0.0;
    double squares_m2 = 0.0;    ///< of the lengths
    double height_sum_m = 0.0;  ///< of their largest heights above the ground
    double highest_m = 0.0;

    void add(double length_m, double height_m);
    void add(const JumpSums& other);
};

/// Stretches of slope length by which jumps are distinguished (Rammer et al. 2010, section 2.4.2).
inline constexpr double jump_segment_m = 10.0;

/// Rocks that fell, in rock order.
struct Falls {
    std::size_t lines = 0;  ///< at which arrivals were looked at: the stations and the lower end
    std::vector<RockFacts> rocks;
    std::vector<rockfall::Arrival> arrivals;  ///< rock by rock, line by line; y across from the axis
    std::vector<float> hit_heights_m;         ///< of the rock's centre above the ground at the stem
    std::vector<JumpSums> segments;           ///< by slope length in which the jump ends

    void add(const WatchedFall& fall, const RebuiltSlope& slope, const SlopeLength& length);
    void append(const Falls& other);
    [[nodiscard]] const rockfall::Arrival& arrival(std::size_t rock, std::size_t line) const {
        return arrivals[rock * lines + line];
    }
};

/// All falls of one variant: one large ensemble, and small series as an experiment has them.
struct Ensembles {
    Falls large;
    std::vector<Falls> series;
    Falls open_large;  ///< the same rocks over the bare slope; empty unless asked for
    std::vector<Falls> open_series;
};

/// How the rocks fall: threads do not change the outcome.
struct FallRequest {
    bool open_too = false;  ///< also over the bare slope; for recipes with a stand
    int threads = 1;
    std::function<void(std::uint64_t)>
        fallen;  ///< called with rocks as they come; from any thread, one at a time
};

/// How many rocks a recipe lets fall, in the large ensemble and the series.
std::uint64_t rocks_of(const Recipe& recipe);

/// "10000 rocks, 100 series of 100".
std::string extent_of(const Recipe& recipe);

/// Lets the rocks of a recipe fall. With a stand, series i falls through stand i modulo their number, and the
/// large ensemble is shared evenly among the stands. Series i has replicate i + 1, the large ensemble 0.
/// Where broken trees fall, every series begins with its whole stand, and so do each 250 rocks of the large
/// ensemble in a stand. Throws Interrupted.
Ensembles simulate_falls(const Recipe& recipe, const RebuiltSlope& slope, const FallRequest& request);

}  // namespace coupling::validation
