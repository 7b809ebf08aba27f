#include "coupling/results/figures/unreached.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"

namespace coupling {
namespace {

using config::joined;

double distance_m(const Eigen::Vector2d& place_m, const Eigen::Vector2d& from_m,
                  const Eigen::Vector2d& to_m) {
    const Eigen::Vector2d along_m = to_m - from_m;
    const double squared = along_m.squaredNorm();
    const double share =
        squared > 0.0 ? std::clamp((place_m - from_m).dot(along_m) / squared, 0.0, 1.0) : 0.0;
    return (place_m - from_m - share * along_m).norm();
}

double distance_m(const Eigen::Vector2d& place_m, const std::vector<std::vector<Eigen::Vector2d>>& lines_m) {
    double least_m = std::numeric_limits<double>::infinity();
    for (const std::vector<Eigen::Vector2d>& line : lines_m) {
        for (std::size_t i = 0; i < line.size(); ++i) {
            least_m = std::min(least_m, distance_m(place_m, line[i], line[std::min(i + 1, line.size() - 1)]));
        }
    }
    return least_m;
}

std::string reason_and_remedy(const Unreached& one, const Departures& bare) {
    if (!one.source_above) {
        return "no source lies above it; check its place, those of the sources and the heights of the "
               "terrain";
    }
    if (bare.share() >= departures_to_warn_of && one.nearest_m) {
        return joined(
            "the nearest rock passes ", std::to_string(std::llround(*one.nearest_m)), " m from it, and ",
            departure_percent(bare.share()),
            " % of the rocks leave the terrain; where they leave before it, give a terrain that "
            "reaches further; else check its place, the sources, the rock sizes and the ground types");
    }
    if (bare.share() >= departures_to_warn_of) {
        return joined(departure_percent(bare.share()),
                      " % of the rocks leave the terrain before; give a terrain that reaches further");
    }
    return joined(one.nearest_m ? joined("the nearest rock passes ",
                                         std::to_string(std::llround(*one.nearest_m)), " m from it")
                                : std::string{"all rocks stop before it"},
                  "; check its place, the sources, the rock sizes and the ground types");
}

std::string sentence_on(const Unreached& one, const Departures& bare) {
    return joined("no rock reaches the ", one.what, " ", config::in_quotes(one.name), ": ",
                  reason_and_remedy(one, bare));
}

/// "House (12 m), Barn (30 m), …"; metres as far as they are known.
std::string names_of(std::span<const Unreached> group) {
    constexpr std::size_t most_named = 20;
    std::string names;
    for (const Unreached& one : group.first(std::min(most_named, group.size()))) {
        names += joined(names.empty() ? "" : ", ", one.name);
        if (one.source_above && one.nearest_m) {
            names += joined(" (", std::to_string(std::llround(*one.nearest_m)), " m)");
        }
    }
    return names + (group.size() > most_named ? ", …" : "");
}

/// Of several of a kind that have the same reason.
std::string sentence_on(std::span<const Unreached> group, const Departures& bare) {
    const Unreached& first = group.front();
    const std::string what = first.what + "s";
    const std::string names =
        joined("no rock reaches ", std::to_string(group.size()), " ", what, ": ", names_of(group), ". ");
    if (!first.source_above) {
        return names +
               "No source lies above them; check their places, those of the sources and the heights of the "
               "terrain";
    }
    const bool is_near = std::any_of(group.begin(), group.end(),
                                     [](const Unreached& one) { return one.nearest_m.has_value(); });
    const std::string distances = is_near ? "Metres: how near the nearest rock passes. " : "";
    constexpr const char* to_check = "the sources, the rock sizes and the ground types";
    if (bare.share() >= departures_to_warn_of) {
        const std::string leave =
            joined(names, distances, departure_percent(bare.share()), " % of the rocks leave the terrain");
        return is_near ? joined(leave, "; where they leave before these ", what,
                                ", give a terrain that reaches further; else check the places of the ", what,
                                ", ", to_check)
                       : joined(leave, " before; give a terrain that reaches further");
    }
    return joined(names, is_near ? distances : "All rocks stop before them. ", "Check the places of the ",
                  what, ", ", to_check);
}

}  // namespace

double highest_source_m(const Site& site) {
    double highest_m = std::numeric_limits<double>::quiet_NaN();
    for (const rockfall::ReleaseSource& source : site.sources) {
        const Eigen::Vector2d middle_m = 0.5 * (source.first_m + source.last_m);
        if (const auto height_m = site.slope.terrain.height_m(middle_m.x(), middle_m.y())) {
            highest_m = std::fmax(highest_m, *height_m);
        }
    }
    return highest_m;
}

bool lies_above(double height_m, const rockfall::Terrain& terrain,
                const std::vector<std::vector<Eigen::Vector2d>>& places_m) {
    double lowest_m = std::numeric_limits<double>::infinity();
    for (const std::vector<Eigen::Vector2d>& line : places_m) {
        for (const Eigen::Vector2d& place : line) {
            lowest_m = std::min(lowest_m, terrain.height_m(place.x(), place.y()).value_or(lowest_m));
        }
    }
    return !(height_m <= lowest_m) || !std::isfinite(lowest_m);
}

std::optional<double> nearest_passage_m(const std::vector<std::vector<Eigen::Vector2d>>& lines_m,
                                        const config::GridFrame& frame_on_terrain,
                                        std::span<const rockfall::CellSums> cells) {
    double least_m = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (cells[i].passages > 0) {
            const config::Cell cell = frame_on_terrain.cell_of(i);
            least_m = std::min(least_m, distance_m({frame_on_terrain.x_centre_m(cell.column),
                                                    frame_on_terrain.y_centre_m(cell.row)},
                                                   lines_m));
        }
    }
    return std::isfinite(least_m) ? std::optional{least_m} : std::nullopt;
}

void warn_of_unreached(const std::vector<Unreached>& unreached, const Departures& bare, StopsBefore meaning,
                       config::Warnings& warnings) {
    for (const bool source_above : {false, true}) {
        std::vector<Unreached> group;
        std::copy_if(unreached.begin(), unreached.end(), std::back_inserter(group),
                     [&](const Unreached& one) { return one.source_above == source_above; });
        if (group.empty()) {
            continue;
        }
        std::string sentence =
            group.size() == 1 ? sentence_on(group.front(), bare) : sentence_on(group, bare);
        const bool stops_before = source_above && bare.share() < departures_to_warn_of;
        if (stops_before && meaning == StopsBefore::is_usual) {
            warnings.add_note(std::move(sentence));
        } else {
            const bool is_part = stops_before && meaning == StopsBefore::costs_its_point;
            warnings.add(std::move(sentence), is_part ? config::Effect::part : config::Effect::answer);
        }
    }
}

}  // namespace coupling
