#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config/errors/warnings.hpp"
#include "coupling/results/figures/figures.hpp"
#include "coupling/results/figures/json.hpp"
#include "coupling/results/figures/run_results.hpp"
#include "rockfall/terrain/rim.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace coupling {

/// From this share on, a run warns of the rocks that leave its terrain [choice]: at 3 % the 95th and the 98th
/// percentile of the run-out begin to depend on rocks whose end nobody knows.
inline constexpr double departures_to_warn_of = 0.03;

/// Rocks that left over one part of the rim of a terrain.
struct Departure {
    rockfall::RimPart part = rockfall::RimPart::north;
    Eigen::Vector2d hole_m = Eigen::Vector2d::Zero();  ///< easting and northing of the middle of a hole
    std::uint64_t rocks = 0;
};

/// Rocks that left the terrain on one slope, by part of its rim.
struct Departures {
    std::uint64_t rocks = 0;       ///< that fell
    std::vector<Departure> parts;  ///< by falling number of rocks; holes of one number from north to south

    [[nodiscard]] std::uint64_t left() const;
    [[nodiscard]] double share() const;
    [[nodiscard]] double share(const Departure& departure) const;
};

Departures departures_of(std::uint64_t rocks, const std::map<rockfall::RimPart, std::uint64_t>& left_over,
                         const rockfall::Terrain& terrain);

/// Of a run of today. Without a forest there are none with it.
Departures departures_of(const RunResults& results, Cover cover);

/// "north", "east", "south", "west" or "hole": in `summary.json`.
const char* name_of(rockfall::RimPart part);

/// Share of the rocks that leave, and each part of the rim over which they do.
Json json_departures(const Departures& departures);

/// From the `summary.json` of a finished run of today; no rocks where it has no such slope. Throws
/// config::InputError (data) for what no run of this program wrote.
Departures read_departures(std::string_view summary, Cover cover, const std::string& file);

/// Parts that sentences and pages name; the rest is added up as further holes.
inline constexpr std::size_t most_parts_named = 4;
/// The parts that are named, and the rocks of the others.
std::vector<Departure> named_parts(const Departures& departures);
std::uint64_t rocks_of_others(const Departures& departures);

/// A share in percent as sentences have it: one decimal, two below one per cent; the same in all languages.
std::string departure_percent(double share);

/// What all warnings say between the share that leaves and the remedy.
inline constexpr std::string_view what_departures_do =
    ": where they stop is not known, and the run-out of the others is too short, as rocks that run far leave "
    "first; ";

/// "3.2 % of the rocks leave the terrain over the bare slope (north edge: 2.1 %; ...)", for the screen.
std::string in_words(const Departures& departures, const std::string& slope);

/// The warning where at least departures_to_warn_of leave. `slope`: "over the bare slope" or "with forest".
std::optional<std::string> warning_of(const Departures& departures, const std::string& slope);

/// Adds the warning of that slope on which the larger share leaves, unless it is there already. `forest` has
/// no rocks where there is none.
void warn_of_departures(const Departures& bare, const Departures& forest, config::Warnings& warnings);

/// What a warning of rocks that leave is of, and how many do.
struct DepartingShare {
    std::string_view of_whom;  ///< what stands before the figure: "", or the motion model that warns
    double percent = 0.0;
};
/// Of a warning of departures, or of a motion model that warns of them; nothing of other sentences.
std::optional<DepartingShare> departing_share(std::string_view warning);

}  // namespace coupling
