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

/// Opens the figures at the end of a sentence that differ from return period to return period.
constexpr std::string_view opening_of_distance = " (the nearest rock passes ";
constexpr std::string_view opening_of_held = " (rocks held over the bare slope, of ";

std::string distance_in_words(const std::optional<double>& nearest_m, const char* from) {
    return nearest_m ? joined(std::string{opening_of_distance},
                              std::to_string(std::max(1LL, std::llround(*nearest_m))), " m from ", from, ")")
                     : std::string{};
}

std::string reason_and_remedy(const Unreached& one, const Departures& bare) {
    if (!one.source_above) {
        return "no source lies above it; check its place, those of the sources and the heights of the "
               "terrain";
    }
    // Rocks may run past it: that they stop before it is not known.
    return joined(bare.share() < departures_to_warn_of
                      ? "no rock crosses it; check its place"
                      : "rocks leave the terrain; where they leave before it, give a terrain that reaches "
                        "further; else check its place",
                  ", the sources, the rock sizes and the ground types",
                  distance_in_words(one.nearest_m, "it"));
}

/// "House, Barn, …".
template <class Named>
std::string names_of(std::span<const Named> group) {
    constexpr std::size_t most_named = 20;
    std::string names;
    for (const Named& one : group.first(std::min(most_named, group.size()))) {
        names += joined(names.empty() ? "" : ", ", one.name);
    }
    return names + (group.size() > most_named ? ", …" : "");
}

/// Opens each sentence, of one or of several of a kind.
std::string unreached_opening(std::span<const Unreached> group) {
    const Unreached& first = group.front();
    return group.size() == 1 ? joined("no rock reaches the ", first.what, " ", config::in_quotes(first.name))
                             : joined("no rock reaches ", std::to_string(group.size()), " ", first.what,
                                      "s: ", names_of(group));
}

/// Of several of a kind that have the same reason.
std::string sentence_on(std::span<const Unreached> group, const Departures& bare) {
    const Unreached& first = group.front();
    if (group.size() == 1) {
        return joined(unreached_opening(group), ": ", reason_and_remedy(first, bare));
    }
    const std::string what = first.what + "s";
    const std::string names = unreached_opening(group) + ". ";
    if (!first.source_above) {
        return names +
               "No source lies above them; check their places, those of the sources and the heights of the "
               "terrain";
    }
    std::optional<double> nearest_m;
    for (const Unreached& one : group) {
        nearest_m = one.nearest_m ? std::min(*one.nearest_m, nearest_m.value_or(*one.nearest_m)) : nearest_m;
    }
    return joined(names,
                  bare.share() < departures_to_warn_of
                      ? std::string{"No rock crosses them. Check"}
                      : joined("Rocks leave the terrain; where they leave before these ", what,
                               ", give a terrain that reaches further; else check"),
                  " the places of the ", what, ", the sources, the rock sizes and the ground types",
                  distance_in_words(nearest_m, "one of them"));
}

/// Of many nets and works those that hold most.
std::string sentence_on(std::vector<Holder> holders, std::uint64_t rocks) {
    constexpr std::size_t most_named = 5;
    if (holders.size() > most_named) {  // else as in the files, in each return period
        std::stable_sort(holders.begin(), holders.end(),
                         [](const Holder& a, const Holder& b) { return a.rocks > b.rocks; });
        holders.resize(most_named);
    }
    std::string held;
    for (const Holder& holder : holders) {
        held += joined(held.empty() ? "" : ", ", std::to_string(holder.rocks));
    }
    return joined(". Nets and works above hold rocks: ", names_of(std::span<const Holder>{holders}),
                  "; a run without them shows what would arrive", opening_of_held, std::to_string(rocks),
                  ": ", held, ")");
}

/// Places that no rock reaches, and the nets and works above them that hold rocks.
struct BelowHolders {
    std::vector<Unreached> group;
    std::vector<Holder> above;
};

/// One entry for those that stand below the same nets and works. The higher a place, the fewer stand above
/// it, so that their number says which.
std::vector<BelowHolders> by_holders_above(const std::vector<Unreached>& unreached, bool source_above,
                                           const std::vector<Holder>& holders) {
    std::vector<BelowHolders> all;
    for (const Unreached& one : unreached) {
        if (one.source_above != source_above) {
            continue;
        }
        std::vector<Holder> above;
        std::copy_if(holders.begin(), holders.end(), std::back_inserter(above), [&](const Holder& holder) {
            return source_above && holder.rocks > 0 && holder.highest_m > one.lowest_m;
        });
        const auto same = std::find_if(all.begin(), all.end(), [&](const BelowHolders& other) {
            return other.above.size() == above.size();
        });
        BelowHolders& entry =
            same != all.end() ? *same : all.emplace_back(BelowHolders{{}, std::move(above)});
        entry.group.push_back(one);
    }
    return all;
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

double highest_ground_m(const rockfall::Terrain& terrain, const std::vector<Eigen::Vector2d>& places_m) {
    double most_m = -std::numeric_limits<double>::infinity();
    for (const Eigen::Vector2d& place : places_m) {
        most_m = std::max(most_m, terrain.height_m(place.x(), place.y()).value_or(most_m));
    }
    return most_m;
}

double lowest_ground_m(const rockfall::Terrain& terrain,
                       const std::vector<std::vector<Eigen::Vector2d>>& places_m) {
    double least_m = std::numeric_limits<double>::infinity();
    for (const std::vector<Eigen::Vector2d>& line : places_m) {
        for (const Eigen::Vector2d& place : line) {
            least_m = std::min(least_m, terrain.height_m(place.x(), place.y()).value_or(least_m));
        }
    }
    return least_m;
}

bool is_of_unreached_targets(std::string_view sentence) {
    constexpr std::string_view begins = "no rock reaches ";
    if (!sentence.starts_with(begins)) {
        return false;
    }
    std::string_view rest = sentence.substr(begins.size());
    if (rest.starts_with("the target ")) {
        return true;
    }
    const std::size_t digits = rest.find_first_not_of("0123456789");
    return digits > 0 && digits != std::string_view::npos && rest.substr(digits).starts_with(" targets: ");
}

std::string_view without_figures_of_unreached(std::string_view sentence) {
    if (sentence.starts_with("no rock reaches ") && sentence.ends_with(')')) {
        for (const std::string_view opening_of : {opening_of_distance, opening_of_held}) {
            if (const std::size_t at = sentence.rfind(opening_of); at != std::string_view::npos) {
                return sentence.substr(0, at);
            }
        }
    }
    return sentence;
}

void warn_of_unreached(const std::vector<Unreached>& unreached, const Departures& bare, StopsBefore meaning,
                       config::Warnings& warnings, const std::vector<Holder>& holders,
                       std::uint64_t rocks_with_holders) {
    for (const bool source_above : {false, true}) {
        for (const auto& [group, above] : by_holders_above(unreached, source_above, holders)) {
            std::uint64_t held = 0;
            for (const Holder& holder : above) {
                held += holder.rocks;
            }
            // Fewer may be beside the reason: then both are said.
            const bool are_held = 2 * held >= rocks_with_holders && held > 0;
            const std::string sentence =
                joined(are_held ? unreached_opening(group) : sentence_on(group, bare),
                       above.empty() ? std::string{} : sentence_on(above, rocks_with_holders));
            const bool stops_before = source_above && bare.share() < departures_to_warn_of;
            if ((stops_before || are_held) && meaning == StopsBefore::is_usual) {
                warnings.add_note(sentence);
            } else {
                const bool is_part = are_held || (stops_before && meaning == StopsBefore::costs_its_point);
                warnings.add(sentence, is_part ? config::Effect::part : config::Effect::answer);
            }
        }
    }
}

}  // namespace coupling
