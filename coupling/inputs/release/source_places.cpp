#include "coupling/inputs/release/source_places.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/plausible/share_on_terrain.hpp"
#include "coupling/inputs/plausible/slope_field.hpp"
#include "coupling/inputs/reading/declared_tables.hpp"
#include "coupling/inputs/scenario/net_settings.hpp"
#include "coupling/inputs/scenario/target_settings.hpp"

namespace coupling::plausible {
namespace {

using config::joined;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Scree comes to rest at 30 to 38 degrees; ground flatter than this sets no rock free [choice].
constexpr double gentle_deg = 25.0;
/// By how much the mean slope of all sources may grow by one move, and from which slope on they lie where
/// rocks break off whatever lies beside them [choices].
struct Beside {
    double gained_deg;
    double steep_deg;
};
/// Sources in many places: on the shipped slopes right ones gain at most 1.5 degrees by any move, those that
/// were shifted by 83 to 125 m between 9 and 24.
constexpr Beside in_many_places{6.0, 60.0};
/// Sources in few places gain 10 to 20 degrees by chance: there only gentle ones are spoken of.
constexpr Beside in_few_places{10.0, 40.0};
/// In mirrored heights sources in many places lie by so much less steep than in the right ones [choice]. Of
/// parts of three slopes (their cells above 40 to 50 degrees in a random rectangle) at most 2 % would gain as
/// much by a mirror, of the same parts in mirrored heights 40 to 97 % do. All sources of the shipped slopes
/// lose 14 degrees or more.
constexpr double gained_by_mirror_deg = 10.0;
/// A place is a square of 50 m.
constexpr double place_m = 50.0;
constexpr std::size_t many_places = 8;
constexpr double nearest_move_m = 40.0;
constexpr double farthest_move_m = 200.0;
/// Release zones cover 3 to 15 % of the shipped slopes, which are parts of few places [choice].
constexpr double most_covered = 0.5;
/// [choice]: chance alone gives one half. On the example `tyrol`, the one slope that was measured, right
/// sources are steeper than the rest in 80 to 99 of 100 comparisons, in 33 on its mirror, in 1 with an
/// inverted mask.
constexpr double least_steeper = 0.5;
/// A shift that takes more of the rocks off the terrain is none that could be meant.
constexpr double most_stay_on_terrain = 0.9;

Eigen::Vector2d middle_of(const rockfall::ReleaseSource& source) {
    return 0.5 * (source.first_m + source.last_m);
}

/// Median of values with weights; NaN without any.
double weighted_median(std::vector<std::pair<double, double>> values) {
    std::sort(values.begin(), values.end());
    const double all = std::accumulate(values.begin(), values.end(), 0.0,
                                       [](double sum, const auto& value) { return sum + value.second; });
    double sum = 0.0;
    for (const auto& [value, weight] : values) {
        sum += weight;
        if (sum >= 0.5 * all) {
            return value;
        }
    }
    return std::numeric_limits<double>::quiet_NaN();
}

/// Mean slope of the sources, each at the place that `place_of` gives its cell; nothing where too many leave
/// the terrain.
template <class PlaceOf>
double mean_slope_deg(const SlopeField& field, const std::vector<std::pair<config::Cell, double>>& rocks,
                      PlaceOf place_of, double least_on_terrain) {
    double sum = 0.0;
    double on = 0.0;
    double all = 0.0;
    for (const auto& [cell, weight] : rocks) {
        const double slope_deg = field.steepest_deg(place_of(cell));
        all += weight;
        if (!std::isnan(slope_deg)) {
            on += weight;
            sum += weight * slope_deg;
        }
    }
    return on > 0.0 && on >= least_on_terrain * all ? sum / on : -infinity;
}

/// How often a value of the first list is above one of the second [-]; 1 without any.
double share_above(const std::vector<double>& values, std::vector<double> rest) {
    if (values.empty() || rest.empty()) {
        return 1.0;
    }
    std::sort(rest.begin(), rest.end());
    double above = 0.0;
    for (const double value : values) {
        const auto place = std::lower_bound(rest.begin(), rest.end(), value);
        above += static_cast<double>(place - rest.begin());
    }
    return above / static_cast<double>(values.size()) / static_cast<double>(rest.size());
}

/// How the cells with sources look beside those without.
void compare_with_rest(const SlopeField& field,
                       const std::map<std::size_t, std::pair<config::Cell, double>>& in_cells,
                       SourceSlopes& found) {
    std::vector<double> with_deg;
    std::vector<double> without_deg;
    const std::vector<double>& all_deg = field.all_steepest_deg();
    for (std::size_t i = 0; i < all_deg.size(); ++i) {
        if (!std::isnan(all_deg[i])) {
            (in_cells.contains(i) ? with_deg : without_deg).push_back(all_deg[i]);
        }
    }
    const auto with = static_cast<double>(with_deg.size());
    const double all = with + static_cast<double>(without_deg.size());
    found.covered = all > 0.0 ? with / all : 0.0;
    found.steeper_than_rest = share_above(with_deg, std::move(without_deg));
}

/// Lowest ground under the corners of a line and in steps of 2 m between them; infinite off the terrain.
void take_lowest(std::span<const Eigen::Vector2d> line, const rockfall::Terrain& terrain, double& lowest_m) {
    constexpr double step_m = 2.0;
    constexpr double most_steps = 1000.0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const Eigen::Vector2d way = i + 1 < line.size() ? Eigen::Vector2d{line[i + 1] - line[i]}
                                                        : Eigen::Vector2d{Eigen::Vector2d::Zero()};
        const int steps = static_cast<int>(std::ceil(std::clamp(way.norm() / step_m, 1.0, most_steps)));
        for (int k = 0; k < steps; ++k) {
            const Eigen::Vector2d place = line[i] + static_cast<double>(k) / steps * way;
            lowest_m = std::min(lowest_m, terrain.height_m(place.x(), place.y()).value_or(infinity));
        }
    }
}

std::string names_of(const std::vector<std::size_t>& places, const std::vector<std::string>& names) {
    constexpr std::size_t most = 3;
    std::string text;
    for (std::size_t i = 0; i < std::min(most, places.size()); ++i) {
        text += joined(i > 0 ? ", " : "", config::in_quotes(names[places[i]]));
    }
    return joined(text, places.size() > most ? ", ..." : "");
}

/// "north-east": of eight directions the nearest, y northwards.
const char* direction_of(const Eigen::Vector2d& move_m) {
    static constexpr const char* names[]{"east", "north-east", "north", "north-west",
                                         "west", "south-west", "south", "south-east"};
    const double eighths = std::atan2(move_m.y(), move_m.x()) / (0.25 * std::numbers::pi);
    return names[static_cast<std::size_t>(std::lround(eighths) + 8) % 8];
}

const char* mirror_in_words(const SourceSlopes& slopes) {
    return slopes.mirrored_west_east && slopes.mirrored_north_south ? "turned by 180 degrees"
           : slopes.mirrored_west_east                              ? "mirrored from west to east"
                                                                    : "mirrored from north to south";
}

/// Sources that lie where no cliffs are on this terrain, wherever else they might fit.
void judge_cover(const SourceSlopes& slopes, const std::string& file, Reading& reading) {
    if (slopes.covered > most_covered) {
        reading.warn(
            {file}, joined("sources on ", percent_in_words(slopes.covered), " of the terrain"),
            "cliffs and other steep ground, from which rocks break off",
            "check whether cells without sources hold 0, and whether the mask is the wrong way round",
            config::Effect::answer);
    } else if (slopes.places >= many_places && slopes.steeper_than_rest < least_steeper) {
        reading.warn({file},
                     joined("sources on ground that is less steep than the rest of the terrain in ",
                            percent_in_words(1.0 - slopes.steeper_than_rest), " of all comparisons"),
                     "cliffs and other steep ground, from which rocks break off",
                     "check the place of the sources, and whether the heights are mirrored or upside down",
                     config::Effect::answer);
    }
}

void judge_slopes(const SourceSlopes& slopes, const std::string& file, Reading& reading) {
    const auto degrees = [](double value) { return std::to_string(std::lround(value)); };
    const bool many = slopes.places >= many_places;
    const Beside limits = many ? in_many_places : in_few_places;
    const bool is_mirrored = many && slopes.mean_deg < limits.steep_deg &&
                             slopes.best_mirrored_deg > slopes.best_mean_deg &&
                             slopes.best_mirrored_deg > slopes.mean_deg + gained_by_mirror_deg;
    if (is_mirrored) {
        reading.warn(
            {file},
            joined("sources whose ground is ", degrees(slopes.mean_deg),
                   " degrees steep on average, while with the heights ", mirror_in_words(slopes),
                   " it would be ", degrees(slopes.best_mirrored_deg), " degrees"),
            "sources on the steep ground",
            "compare both files on a map: rows or columns of one of them may stand in the wrong order",
            config::Effect::answer);
    } else if (slopes.mean_deg < limits.steep_deg &&
               slopes.best_mean_deg > slopes.mean_deg + limits.gained_deg) {
        reading.warn(
            {file},
            joined("sources whose ground is ", degrees(slopes.mean_deg), " degrees steep on average, while ",
                   degrees(slopes.best_move_m.norm()), " m further ", direction_of(slopes.best_move_m),
                   " it would be ", degrees(slopes.best_mean_deg), " degrees"),
            "sources on the steep ground",
            "compare the coordinate systems of both files (a datum of another country shifts by 50 to "
            "200 m), and look at the sources on the map",
            config::Effect::answer);
    }
    if (slopes.median_deg < gentle_deg) {
        reading.warn({file},
                     joined("sources on gentle ground: half of the rocks start where it is less than ",
                            degrees(std::max(1.0, slopes.median_deg)), " degrees steep"),
                     "cliffs or other steep ground, from which rocks break off",
                     "check the place of the sources, their coordinate system and the heights",
                     config::Effect::answer);
    }
}

void judge_reach(const OnSlope& site, const std::string& file, Reading& reading) {
    const BelowWhat below = sources_below(site);
    std::vector<std::string> target_names;
    for (const rockfall::Target& target : site.targets) {
        target_names.push_back(target.name);
    }
    std::vector<std::string> net_names;
    for (const NetRecord& net : site.nets) {
        net_names.push_back(net.name);
    }
    if (!site.targets.empty() && below.targets.size() == site.targets.size()) {
        reading.refuse(
            {file}, "all sources below all targets, which no rock can reach",
            "sources above what is to be protected",
            "check which way the heights go (upside down?), and the place and coordinate system of "
            "the sources and of the targets");
        return;
    }
    if (!below.targets.empty()) {
        reading.warn(
            {shown_tables(reading.targets().file, reading)},
            joined(below.targets.size() == 1 ? "a target above all sources: " : "targets above all sources: ",
                   names_of(below.targets, target_names), "; no rock can arrive there"),
            "sources above what is to be protected", "check the place of the sources and of the targets",
            config::Effect::answer);
    }
    if (below.rocks_below_all > 0.5) {
        reading.warn(
            {file}, joined(percent_in_words(below.rocks_below_all), " of the rocks start below every target"),
            "sources above what is to be protected", "check the place of the sources",
            config::Effect::answer);
    }
    if (below.rocks_inside > 0.5) {
        reading.warn(
            {file}, joined(percent_in_words(below.rocks_inside), " of the rocks start inside a target"),
            "sources above what is to be protected",
            "name what is to be protected as targets, such as roads and houses, not the area of study",
            config::Effect::answer);
    }
    if (!below.nets.empty()) {
        reading.warn({shown_tables(reading.nets().file, reading)},
                     joined(below.nets.size() == 1 ? "a net above all sources: " : "nets above all sources: ",
                            names_of(below.nets, net_names),
                            below.nets.size() == 1 ? "; no rock can reach it" : "; no rock can reach them"),
                     "nets below the sources", "check the place of the nets", config::Effect::answer);
    }
}

}  // namespace

SourceSlopes source_slopes(const OnSlope& site) {
    const SlopeField field{site.terrain, site.spacing_m};
    std::map<std::size_t, std::pair<config::Cell, double>> in_cells;
    std::vector<std::pair<double, double>> slopes;
    std::set<std::pair<long, long>> places;
    for (const rockfall::ReleaseSource& source : site.sources) {
        const Eigen::Vector2d middle_m = middle_of(source);
        const auto weight = static_cast<double>(source.rocks);
        const config::Cell cell = field.cell_at(middle_m);
        auto& in_cell = in_cells[field.place_of(cell)];
        in_cell = {cell, in_cell.second + weight};
        const Eigen::Vector2d from_middle = (middle_m - field.middle_m()) / place_m;
        places.emplace(std::lround(std::floor(from_middle.x())), std::lround(std::floor(from_middle.y())));
        if (const double slope_deg = field.steepest_deg(cell); !std::isnan(slope_deg)) {
            slopes.emplace_back(slope_deg, weight);
        }
    }
    std::vector<std::pair<config::Cell, double>> rocks;
    for (const auto& [place, in_cell] : in_cells) {
        rocks.push_back(in_cell);
    }
    const auto as_it_is = [](const config::Cell& cell) { return cell; };
    SourceSlopes found;
    found.places = places.size();
    compare_with_rest(field, in_cells, found);
    found.median_deg = weighted_median(slopes);
    found.mean_deg = std::max(0.0, mean_slope_deg(field, rocks, as_it_is, 0.0));
    found.best_mean_deg = found.mean_deg;
    // Steps of 10 m, or wider ones where so many cells have sources that these would take a second.
    const double wanted_step_m = 10.0 * std::max(1.0, std::sqrt(static_cast<double>(rocks.size()) / 1e5));
    const int step = std::max(1, static_cast<int>(std::lround(wanted_step_m / field.cell_m())));
    const int reach = step * static_cast<int>(std::ceil(farthest_move_m / (step * field.cell_m())));
    for (int rows = -reach; rows <= reach; rows += step) {
        for (int columns = -reach; columns <= reach; columns += step) {
            const Eigen::Vector2d move_m = field.cell_m() * Eigen::Vector2d{columns, -rows};
            if (move_m.norm() < nearest_move_m || move_m.norm() > farthest_move_m) {
                continue;
            }
            const auto moved = [&](const config::Cell& cell) {
                return config::Cell{cell.column + columns, cell.row + rows};
            };
            const double mean_deg = mean_slope_deg(field, rocks, moved, most_stay_on_terrain);
            if (mean_deg > found.best_mean_deg) {
                found.best_mean_deg = mean_deg;
                found.best_move_m = move_m;
            }
        }
    }
    for (const auto& [west_east, north_south] : {std::pair{true, false}, {false, true}, {true, true}}) {
        const auto mirrored = [&, we = west_east, ns = north_south](const config::Cell& cell) {
            return field.mirrored(cell, we, ns);
        };
        const double mean_deg = mean_slope_deg(field, rocks, mirrored, most_stay_on_terrain);
        if (mean_deg > found.best_mirrored_deg) {
            found.best_mirrored_deg = mean_deg;
            found.mirrored_west_east = west_east;
            found.mirrored_north_south = north_south;
        }
    }
    return found;
}

BelowWhat sources_below(const OnSlope& site) {
    std::vector<double> lowest_of_target_m;
    for (const rockfall::Target& target : site.targets) {
        double& lowest_m = lowest_of_target_m.emplace_back(infinity);
        for (const auto& part : target.parts) {
            take_lowest(part, site.terrain, lowest_m);
        }
    }
    double highest_source_m = -infinity;
    double all = 0.0;
    double below = 0.0;
    double inside = 0.0;
    // A target off the terrain is infinitely high: nothing is said of its height.
    double lowest_m = infinity;
    for (const double lowest : lowest_of_target_m) {
        lowest_m = std::min(lowest_m, lowest);
    }
    lowest_m = std::isfinite(lowest_m) ? lowest_m : -infinity;
    for (const rockfall::ReleaseSource& source : site.sources) {
        for (const Eigen::Vector2d& place : {source.first_m, middle_of(source), source.last_m}) {
            const auto height_m = site.terrain.height_m(place.x(), place.y());
            highest_source_m = std::max(highest_source_m, height_m.value_or(-infinity));
        }
        const Eigen::Vector2d middle_m = middle_of(source);
        const double height_m = site.terrain.height_m(middle_m.x(), middle_m.y()).value_or(infinity);
        all += source.rocks;
        const bool starts_inside =
            std::any_of(site.targets.begin(), site.targets.end(), [&](const rockfall::Target& target) {
                return target.is_area && rockfall::is_inside(target, middle_m);
            });
        inside += starts_inside ? source.rocks : 0.0;
        below += height_m < lowest_m && !starts_inside ? source.rocks : 0.0;
    }
    BelowWhat found;
    found.rocks_below_all = all > 0.0 ? below / all : 0.0;
    found.rocks_inside = all > 0.0 ? inside / all : 0.0;
    const auto is_out_of_reach = [&](double lowest) {
        return std::isfinite(lowest) && std::isfinite(highest_source_m) && highest_source_m < lowest;
    };
    for (std::size_t i = 0; i < lowest_of_target_m.size(); ++i) {
        if (is_out_of_reach(lowest_of_target_m[i])) {
            found.targets.push_back(i);
        }
    }
    for (std::size_t i = 0; i < site.nets.size(); ++i) {
        double lowest_of_net_m = infinity;
        take_lowest(site.nets[i].net.line_m, site.terrain, lowest_of_net_m);
        if (is_out_of_reach(lowest_of_net_m)) {
            found.nets.push_back(i);
        }
    }
    return found;
}

double spacing_of(const HeightInput& heights) {
    const config::GridFrame frame = heights.grid ? heights.grid->frame : frame_over(heights.points, 0.0);
    return std::max(frame.cell_width_m, frame.cell_height_m);
}

void judge_source_places(const OnSlope& site, const std::string& file, Reading& reading) {
    if (site.sources.empty()) {
        return;
    }
    judge_reach(site, file, reading);
    const SourceSlopes slopes = source_slopes(site);
    judge_cover(slopes, file, reading);
    judge_slopes(slopes, file, reading);
}

}  // namespace coupling::plausible
