#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "coupling/inputs/nets/net_record.hpp"
#include "coupling/results/figures/indicators.hpp"

namespace coupling {

/// A quantity over the rocks that reach a net: NaN without any, and where fewer than one rock lies above a
/// percentile, as in all results (percentile_is_known()).
struct NetQuantity {
    double mean = std::numeric_limits<double>::quiet_NaN();
    double p50 = mean, p90 = mean;
    QuantileEstimate p95, p99;
    double max = mean;
};

/// What a class has to be high to hold a wanted share of the rocks.
struct NetNeed {
    std::string energy_class;
    double mel_kj;                   ///< infinite for the open class
    std::optional<double> height_m;  ///< nothing: not at any height
    Share held;                      ///< by that class at that height; at any height where none suffices
};

/// A net on one slope. Each rock counts once, as it first crosses the line of the net.
struct NetFigures {
    std::uint32_t net = 0;
    rockfall::Cover cover = rockfall::Cover::bare;
    Share reached;                                      ///< of all rocks that fell
    std::array<Share, rockfall::net_outcomes> outcome;  ///< of those that reached it
    NetQuantity energy_kj;                              ///< translation and rotation
    NetQuantity height_m;                               ///< of the rock's centre above the ground
    std::uint64_t inexact = 0;    ///< rocks of which it is not known whether they reach it: net_try.hpp
    std::vector<NetNeed> needs;   ///< by class; empty with fewer than rocks_to_tell()
    std::size_t recommended = 0;  ///< number in `needs`
    double energy_needed_kj = std::numeric_limits<double>::quiet_NaN();
};

/// "held", "over", "below", "broke".
const char* name_of(rockfall::NetOutcome outcome);

/// The length of the line in plan.
double length_m(const rockfall::Net& net);

/// A quantile as an order statistic: the smallest value that at least the share of all does not exceed. Its
/// interval lies between two order statistics. Requires values in order, not empty.
QuantileEstimate quantile_of(std::span<const double> sorted, double share);

/// So many rocks must reach a net before it can be said what holds a share of them: one that may pass.
std::uint64_t rocks_to_tell(double wanted_share);

/// The lowest height at which each class holds the wanted share of the rocks, and what class and height to
/// choose.
///
/// Both margins are one requirement: of all rocks that reach the net the wanted share must have no more
/// energy than the class and, the same rocks, centres no higher than the upper edge. Of what may pass half is
/// left to the energy: the class is the weakest that takes the energy of (1 + wanted) / 2 of the rocks. Then
/// the height is the lowest with which that class holds the wanted share; the other classes show what a
/// weaker net must be higher, a stronger one lower. Heights are rounded up to 10 cm [choice]. A net without a
/// gap is meant. Nothing is found from fewer than rocks_to_tell().
void find_needs(NetFigures& figures, std::span<const double> energies_kj, std::span<const double> heights_m,
                double wanted_share);

/// The figures of all nets on one slope. `rocks`: how many fell there.
std::vector<NetFigures> net_figures(std::span<const NetRecord> nets, std::span<const NetRow> rows,
                                    rockfall::Cover cover, std::uint64_t rocks, double wanted_share);

}  // namespace coupling
