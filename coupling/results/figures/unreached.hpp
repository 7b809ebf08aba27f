#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "config/errors/warnings.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/results/figures/departures.hpp"

namespace coupling {

/// A target or a net that no rock reached on any slope.
struct Unreached {
    std::string what;  ///< "target" or "net"
    std::string name;
    bool source_above = true;  ///< some source lies higher than its lowest place
    std::optional<double>
        nearest_m;  ///< from it to the nearest cell that a rock passed, where cells are known
};

/// Height of the highest source; NaN without any on the terrain.
double highest_source_m(const Site& site);

/// Whether a height lies above the lowest of these places, in coordinates of the terrain. True for places off
/// the terrain, of which nothing is known.
bool lies_above(double height_m, const rockfall::Terrain& terrain,
                const std::vector<std::vector<Eigen::Vector2d>>& places_m);

/// Distance in plan from lines to the middle of the nearest cell that a rock passed; nothing where none did.
std::optional<double> nearest_passage_m(const std::vector<std::vector<Eigen::Vector2d>>& lines_m,
                                        const config::GridFrame& frame_on_terrain,
                                        std::span<const rockfall::CellSums> cells);

/// What it means that rocks stop before a target or net.
enum class StopsBefore {
    is_usual,         ///< a target beside others that are reached, as in a village: a note
    costs_its_point,  ///< a net: it protects nothing
    ends_the_answer,  ///< all targets: "no rock arrives" is the whole answer, and may be wrong
};

/// Says that no rock reaches it, with the likely reason: no source above it, rocks that leave the terrain
/// before, or rocks that stop before. Those of one reason share a sentence that lists them; all are of one
/// kind.
void warn_of_unreached(const std::vector<Unreached>& unreached, const Departures& bare, StopsBefore meaning,
                       config::Warnings& warnings);

}  // namespace coupling
