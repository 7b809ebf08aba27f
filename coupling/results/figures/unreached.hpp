#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
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
    double lowest_m = std::numeric_limits<double>::infinity();  ///< of the ground below it; infinite: unknown
};

/// A net or a work that holds rocks.
struct Holder {
    std::string name;
    std::uint64_t rocks = 0;                                      ///< that it holds over the bare slope
    double highest_m = -std::numeric_limits<double>::infinity();  ///< of the ground below it
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

/// What it means that rocks stop before a target or net, or run past it.
enum class StopsBefore {
    is_usual,         ///< a target beside others that are reached, as in a village: a note
    costs_its_point,  ///< a net: it protects nothing
    ends_the_answer,  ///< all targets: "no rock arrives" is the whole answer, and may be wrong
};

/// Says that no rock reaches it, with the likely reason: no source above it, rocks that leave the terrain,
/// or rocks that stop before it or run past it; then which nets and works above it hold rocks, and how many.
/// Where these hold half of all rocks or more, they are the reason, and that nothing arrives is no sign of a
/// wrong input. Those of one reason below the same nets and works share a sentence that lists them; all are
/// of one kind. `rocks_with_holders`: that fell where they held these.
void warn_of_unreached(const std::vector<Unreached>& unreached, const Departures& bare, StopsBefore meaning,
                       config::Warnings& warnings, const std::vector<Holder>& holders = {},
                       std::uint64_t rocks_with_holders = 0);

/// A sentence of warn_of_unreached() without the metres and counts at its end, which differ between runs that
/// say the same; any other sentence as it is.
std::string_view without_figures_of_unreached(std::string_view sentence);

/// Whether a sentence is one of warn_of_unreached() on targets.
bool is_of_unreached_targets(std::string_view sentence);

/// The lowest, and the highest, ground at places, in coordinates of the terrain; infinite off the terrain.
double lowest_ground_m(const rockfall::Terrain& terrain,
                       const std::vector<std::vector<Eigen::Vector2d>>& places_m);
double highest_ground_m(const rockfall::Terrain& terrain, const std::vector<Eigen::Vector2d>& places_m);

}  // namespace coupling
