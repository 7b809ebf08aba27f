#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "coupling/assessments/nets/figures/barrier_design.hpp"
#include "coupling/results/figures/indicators.hpp"

namespace coupling::siting {

/// A rock that comes to a stretch, as it crosses the line of a candidate before it is there.
struct Crossing {
    double along_m = 0.0;   ///< along the line of the candidate
    double height_m = 0.0;  ///< of the rock's centre above the ground
    double energy_kj = 0.0;
};

/// The crossings of one rock, in their order; none where it comes to the stretch past the candidate.
struct CrossingRock {
    std::vector<Crossing> crossings;
    double energy_on_line_kj = 0.0;  ///< as it comes to the stretch where no net stands
};

/// A rock as it crosses the line of a candidate, whether it comes to the line to protect or not.
struct PassingRock {
    std::uint32_t path = 0;  ///< rocks that cross more than once have the same
    float along_m = 0.0F;
    float energy_j = 0.0F;
    float centre_m = 0.0F;  ///< above the ground
    float radius_m = 0.0F;
    std::uint32_t stratum = 0;  ///< of the draws of what is not known
};

/// The rocks that come to a piece of the line, each as it first does: what a net there has to hold, as a run
/// with it counts them. Requires crossings in the order of paths.
std::vector<Passage> passages_within(std::span<const PassingRock> crossings, double from_m, double to_m);

/// A net for the rocks that come to a stretch.
///
/// Of those that may pass, half may pass beside its ends [choice]: they are those of the shortest piece of
/// the line that leaves no more beside it, rounded out to whole metres. Where fewer rocks cross the line than
/// it should hold, the share is that of those which cross. Class and height are those of the barrier that all
/// rocks ask for which come to this piece (barrier_design.hpp).
struct NetDesign : BarrierToOrder {
    double from_m = 0.0;  ///< along the line of the candidate
    double to_m = 0.0;
    [[nodiscard]] double length_m() const { return to_m - from_m; }
    [[nodiscard]] double area_m2() const { return length_m() * height_m; }
};

/// How a net is chosen.
struct NetWish {
    double share = 0.95;  ///< of the rocks that it should keep from the stretch
    DesignSettings design;
    std::uint32_t strata = 1;  ///< of the draws of what is not known; 1: all is known
};

/// Nothing with fewer rocks than are needed for an estimate (rocks_to_tell()) or where none crosses.
std::optional<NetDesign> design_net(std::span<const CrossingRock> rocks,
                                    std::span<const PassingRock> crossings, const NetWish& wish,
                                    double line_length_m);

/// What a net leaves of the rocks that come to a stretch.
struct Left {
    Share kept;                   ///< of the rocks that come to the stretch
    std::uint64_t over = 0;       ///< the others: those that pass over it,
    std::uint64_t through = 0;    ///< break through it,
    std::uint64_t beside = 0;     ///< come past its ends or start below it
    double energy_kj = 0.0;       ///< sum on the line of the rocks that it does not hold
    double energy_percent = 0.0;  ///< of what comes without it
    double largest_kj = 0.0;
};

/// Each rock meets the net where it crosses its line between its ends, the first time and, as long as it
/// passes over, again. A rock that breaks through counts with all its energy.
Left left_below(std::span<const CrossingRock> rocks, const NetDesign& net);

}  // namespace coupling::siting
