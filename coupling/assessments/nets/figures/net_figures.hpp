#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "coupling/assessments/nets/figures/barrier_design.hpp"
#include "coupling/inputs/nets/net_record.hpp"
#include "coupling/results/figures/indicators.hpp"
#include "rockfall/draws/strata.hpp"

namespace coupling {

/// A quantity over the rocks that reach a net or a work: NaN without any, and where fewer than one rock lies
/// above a percentile, as in all results (percentile_is_known()).
struct NetQuantity {
    double mean = std::numeric_limits<double>::quiet_NaN();
    double p50 = mean, p90 = mean;
    QuantileEstimate p95, p99;
    double max = mean;
};

NetQuantity net_quantity_of(std::vector<double> values);

/// A net on one slope. Each rock counts once, as it first crosses the line of the net.
struct NetFigures {
    std::uint32_t net = 0;
    rockfall::Cover cover = rockfall::Cover::bare;
    Share reached;                                      ///< of all rocks that fell
    std::array<Share, rockfall::net_outcomes> outcome;  ///< of those that reached it
    NetQuantity energy_kj;                              ///< translation and rotation
    NetQuantity height_m;       ///< of passage: the rock's upper edge above the ground
    std::uint64_t inexact = 0;  ///< rocks of which it is not known whether they reach it: net_try.hpp
    std::optional<BarrierDesign> design;  ///< what the rocks that reach it ask for
    std::vector<ClassOutcome> classes;    ///< at the height of the design; empty without one
};

/// "held", "over", "below", "broke".
const char* name_of(rockfall::NetOutcome outcome);

/// The length of the line in plan.
double length_m(const rockfall::Net& net);

/// The figures of all nets on one slope. `rocks`: how many fell there; `strata`: of the draws of what is not
/// known.
std::vector<NetFigures> net_figures(std::span<const NetRecord> nets, std::span<const NetRow> rows,
                                    rockfall::Cover cover, std::uint64_t rocks,
                                    const DesignSettings& settings, const rockfall::Strata& strata = {});

}  // namespace coupling
