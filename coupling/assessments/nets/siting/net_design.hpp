#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

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

/// What a net has to be so that it holds the wanted share of the rocks that come to a stretch.
///
/// Of the rocks that may pass, half may pass beside its ends, half of the others by their energy, the rest
/// over it [choice]. Its ends are those of the shortest piece of the line that leaves no more beside it,
/// rounded out to whole metres; its class is the weakest whose maximum energy level the others do not exceed;
/// then its height is the lowest with which it holds the wanted share, rounded up to 10 cm. Where fewer rocks
/// cross the line than it should hold, the share is that of those which cross.
struct NetDesign {
    double from_m = 0.0;  ///< along the line of the candidate
    double to_m = 0.0;
    std::string energy_class;
    double capacity_kj = 0.0;  ///< MEL of the class; of the open one the energy, rounded up to 100 kJ
    double height_m = 0.0;
    [[nodiscard]] double length_m() const { return to_m - from_m; }
    [[nodiscard]] double area_m2() const { return length_m() * height_m; }
};

/// Nothing with fewer rocks than are needed for an estimate (rocks_to_tell()) or where none crosses.
std::optional<NetDesign> design_net(std::span<const CrossingRock> rocks, double wanted_share,
                                    double line_length_m);

/// What a net leaves of the rocks that come to a stretch.
struct Left {
    Share kept;                   ///< of the rocks that come to the stretch
    double energy_kj = 0.0;       ///< sum on the line of the rocks that it does not hold
    double energy_percent = 0.0;  ///< of what comes without it
    double largest_kj = 0.0;
};

/// Each rock meets the net where it crosses its line between its ends, the first time and, as long as it
/// passes over, again. A rock that breaks through counts with all its energy.
Left left_below(std::span<const CrossingRock> rocks, const NetDesign& net);

}  // namespace coupling::siting
