#include "coupling/inputs/rockyfor3d/nets.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <queue>

#include "config/text/joined.hpp"

namespace coupling::rockyfor3d {
namespace {

using config::Cell;
using config::GridFrame;
using config::joined;
using config::Point2;

constexpr double corner_tolerance_cells = 0.5;  ///< of the grid's own staircase [choice]
constexpr double width_of_net_cells = 1.5;      ///< cells that a drawn line may be thick, each way [choice]

Point2 centre_of(const GridFrame& frame, std::size_t index) {
    const Cell cell = frame.cell_of(index);
    return {frame.x_centre_m(cell.column), frame.y_centre_m(cell.row)};
}

double distance_m(const Point2& a, const Point2& b) {
    return std::hypot(b.x_m - a.x_m, b.y_m - a.y_m);
}

double distance_m(const Point2& place, const Point2& from, const Point2& to) {
    const double length_m = distance_m(from, to);
    if (!(length_m > 0.0)) {
        return distance_m(place, from);
    }
    const double along =
        ((place.x_m - from.x_m) * (to.x_m - from.x_m) + (place.y_m - from.y_m) * (to.y_m - from.y_m)) /
        (length_m * length_m);
    const double share = std::clamp(along, 0.0, 1.0);
    return distance_m(place,
                      {from.x_m + share * (to.x_m - from.x_m), from.y_m + share * (to.y_m - from.y_m)});
}

/// The cells around a cell that are inside the frame.
template <class Take>
void for_neighbours(const GridFrame& frame, std::size_t index, Take take) {
    const Cell cell = frame.cell_of(index);
    for (int row = std::max(cell.row - 1, 0); row <= std::min(cell.row + 1, frame.rows - 1); ++row) {
        for (int column = std::max(cell.column - 1, 0);
             column <= std::min(cell.column + 1, frame.columns - 1); ++column) {
            if (row != cell.row || column != cell.column) {
                take(frame.index({column, row}));
            }
        }
    }
}

/// Whether the terrain goes on all around a cell.
bool is_inside(const config::Raster<double>& dem, std::size_t index) {
    const Cell cell = dem.frame.cell_of(index);
    bool inside = cell.column > 0 && cell.row > 0 && cell.column < dem.frame.columns - 1 &&
                  cell.row < dem.frame.rows - 1 && !std::isnan(dem.values[index]);
    for_neighbours(dem.frame, index,
                   [&](std::size_t other) { inside = inside && !std::isnan(dem.values[other]); });
    return inside;
}

/// Cells of one number that touch each other.
using Patch = std::vector<std::size_t>;

/// The way from a cell to the one furthest from it through a patch, both included.
Patch furthest_way(const GridFrame& frame, const Patch& patch, std::size_t start) {
    std::map<std::size_t, double> length_m;
    std::map<std::size_t, std::size_t> before;
    for (const std::size_t cell : patch) {
        length_m[cell] = std::numeric_limits<double>::infinity();
    }
    using Reached = std::pair<double, std::size_t>;
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> open;
    length_m[start] = 0.0;
    open.push({0.0, start});
    while (!open.empty()) {
        const auto [so_far_m, cell] = open.top();
        open.pop();
        if (so_far_m > length_m[cell]) {
            continue;
        }
        for_neighbours(frame, cell, [&, so_far_m = so_far_m, cell = cell](std::size_t next) {
            const auto known = length_m.find(next);
            const double longer_m = so_far_m + distance_m(centre_of(frame, cell), centre_of(frame, next));
            if (known != length_m.end() && longer_m < known->second) {
                known->second = longer_m;
                before[next] = cell;
                open.push({longer_m, next});
            }
        });
    }
    const auto end = std::max_element(length_m.begin(), length_m.end(),
                                      [](const auto& a, const auto& b) { return a.second < b.second; });
    Patch way{end->first};
    while (way.back() != start) {
        way.push_back(before.at(way.back()));
    }
    return way;
}

/// Leaves out the corners that lie within a tolerance of the line without them (Douglas and Peucker 1973).
std::vector<Point2> without_corners(const std::vector<Point2>& line, double tolerance_m) {
    if (line.size() < 3) {
        return line;
    }
    std::size_t furthest = 0;
    double most_m = tolerance_m;
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
        if (const double off_m = distance_m(line[i], line.front(), line.back()); off_m > most_m) {
            most_m = off_m;
            furthest = i;
        }
    }
    if (furthest == 0) {
        return {line.front(), line.back()};
    }
    const auto middle = line.begin() + static_cast<std::ptrdiff_t>(furthest);
    std::vector<Point2> first = without_corners({line.begin(), middle + 1}, tolerance_m);
    const std::vector<Point2> second = without_corners({middle, line.end()}, tolerance_m);
    first.insert(first.end(), second.begin() + 1, second.end());
    return first;
}

/// The width of a cell across the fall line, through its centre.
std::vector<Point2> across_fall_line(const config::Raster<double>& dem, std::size_t index) {
    const Cell cell = dem.frame.cell_of(index);
    const double east = dem.at({cell.column + 1, cell.row}) - dem.at({cell.column - 1, cell.row});
    const double north = dem.at({cell.column, cell.row - 1}) - dem.at({cell.column, cell.row + 1});
    const double steep = std::hypot(east, north);
    const Point2 along = steep > 0.0 ? Point2{-north / steep, east / steep} : Point2{1.0, 0.0};
    const double half_m = 0.5 * dem.frame.cell_width_m;
    const Point2 centre = centre_of(dem.frame, index);
    return {{centre.x_m - half_m * along.x_m, centre.y_m - half_m * along.y_m},
            {centre.x_m + half_m * along.x_m, centre.y_m + half_m * along.y_m}};
}

std::vector<Point2> line_of(const Folder& folder, const Patch& patch) {
    const GridFrame& frame = folder.dem.frame;
    if (patch.size() == 1) {
        return across_fall_line(folder.dem, patch.front());
    }
    const Patch way = furthest_way(frame, patch, furthest_way(frame, patch, patch.front()).front());
    std::vector<Point2> line;
    for (const std::size_t cell : way) {
        line.push_back(centre_of(frame, cell));
    }
    return without_corners(line, corner_tolerance_cells * frame.cell_width_m);
}

/// Cells of a patch that lie beside its line.
std::size_t cells_off(const std::vector<Point2>& line, const GridFrame& frame, const Patch& patch) {
    return static_cast<std::size_t>(std::count_if(patch.begin(), patch.end(), [&](std::size_t cell) {
        double nearest_m = std::numeric_limits<double>::infinity();
        for (std::size_t i = 1; i < line.size(); ++i) {
            nearest_m = std::min(nearest_m, distance_m(centre_of(frame, cell), line[i - 1], line[i]));
        }
        return nearest_m > width_of_net_cells * frame.cell_width_m;
    }));
}

Net net_of(const Folder& folder, const Patch& patch, std::string name) {
    Net net{.name = std::move(name), .line = line_of(folder, patch)};
    const auto by = [](const config::Raster<double>& raster) {
        return [&raster](std::size_t a, std::size_t b) { return raster.values[a] < raster.values[b]; };
    };
    const auto heights = std::minmax_element(patch.begin(), patch.end(), by(*folder.net_height));
    const auto energies = std::minmax_element(patch.begin(), patch.end(), by(*folder.net_energy));
    net.height_m = folder.net_height->values[*heights.first];
    net.capacity_kj = folder.net_energy->values[*energies.first];
    net.varies = net.height_m != folder.net_height->values[*heights.second] ||
                 net.capacity_kj != folder.net_energy->values[*energies.second];
    net.off_line = cells_off(net.line, folder.dem.frame, patch);
    return net;
}

/// The patches of each number, in the order of their first cells.
std::map<long long, std::vector<Patch>> patches_of(const Folder& folder, std::size_t& left_out) {
    const config::Raster<double>& numbers = *folder.net_number;
    std::vector<char> is_open(numbers.values.size(), 0);
    for (std::size_t i = 0; i < is_open.size(); ++i) {
        const bool is_net = numbers.values[i] > 0.0;
        is_open[i] = is_net && is_inside(folder.dem, i) ? 1 : 0;
        left_out += is_net && is_open[i] == 0 ? 1 : 0;
    }
    std::map<long long, std::vector<Patch>> patches;
    for (std::size_t i = 0; i < is_open.size(); ++i) {
        if (is_open[i] == 0) {
            continue;
        }
        is_open[i] = 0;
        Patch patch{i};
        for (std::size_t at = 0; at < patch.size(); ++at) {
            for_neighbours(numbers.frame, patch[at], [&](std::size_t next) {
                if (is_open[next] != 0 && numbers.values[next] == numbers.values[i]) {
                    is_open[next] = 0;
                    patch.push_back(next);
                }
            });
        }
        patches[std::llround(numbers.values[i])].push_back(std::move(patch));
    }
    return patches;
}

/// "a", ..., "z", "aa", ...
std::string letters(std::size_t number) {
    std::string text;
    for (++number; number > 0; number = (number - 1) / 26) {
        text.insert(text.begin(), static_cast<char>('a' + (number - 1) % 26));
    }
    return text;
}

}  // namespace

Nets nets_of(const Folder& folder) {
    Nets nets;
    if (!folder.net_number) {
        return nets;
    }
    for (const auto& [number, patches] : patches_of(folder, nets.left_out)) {
        for (std::size_t i = 0; i < patches.size(); ++i) {
            const std::string name =
                joined("net ", std::to_string(number), patches.size() == 1 ? "" : letters(i));
            nets.nets.push_back(net_of(folder, patches[i], name));
        }
    }
    return nets;
}

}  // namespace coupling::rockyfor3d
