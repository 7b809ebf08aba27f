#include "coupling/inputs/plausible/odd_targets.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "config/text/joined.hpp"

namespace coupling::plausible {
namespace {

using config::joined;
using Line = std::vector<Eigen::Vector2d>;

/// Shorter lines and smaller areas are slips of drawing [choice]: a rock alone is as wide.
constexpr double shortest_line_m = 0.1;
constexpr double smallest_area_m2 = 0.01;

double length_of(const Line& line) {
    double sum_m = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        sum_m += (line[i] - line[i - 1]).norm();
    }
    return sum_m;
}

double turned_area(const Line& ring) {
    double twice_m2 = 0.0;
    const Eigen::Vector2d origin = ring.front();
    for (std::size_t i = 1; i < ring.size(); ++i) {
        const Eigen::Vector2d a = ring[i - 1] - origin;
        const Eigen::Vector2d b = ring[i] - origin;
        twice_m2 += a.x() * b.y() - a.y() * b.x();
    }
    return 0.5 * std::abs(twice_m2);
}

double side_of(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& point) {
    return (b.x() - a.x()) * (point.y() - a.y()) - (b.y() - a.y()) * (point.x() - a.x());
}

/// Whether two pieces cross between their ends.
bool cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
           const Eigen::Vector2d& d) {
    return side_of(a, b, c) * side_of(a, b, d) < 0.0 && side_of(c, d, a) * side_of(c, d, b) < 0.0;
}

bool has_no_extent(const rockfall::Target& target) {
    return std::all_of(target.parts.begin(), target.parts.end(), [&](const Line& part) {
        if (part.empty()) {
            return true;
        }
        return target.is_area ? turned_area(part) < smallest_area_m2 && !crosses_itself(part)
                              : length_of(part) < shortest_line_m;
    });
}

/// Parts from their smaller end, in order: a line drawn from either side is the same.
std::vector<std::vector<std::pair<double, double>>> plain_parts(const rockfall::Target& target) {
    std::vector<std::vector<std::pair<double, double>>> parts;
    for (const Line& part : target.parts) {
        std::vector<std::pair<double, double>>& plain = parts.emplace_back();
        for (const Eigen::Vector2d& corner : part) {
            plain.emplace_back(corner.x(), corner.y());
        }
        std::vector<std::pair<double, double>> reversed{plain.rbegin(), plain.rend()};
        plain = std::min(plain, reversed);
    }
    std::sort(parts.begin(), parts.end());
    return parts;
}

void note_same_shapes(const std::vector<rockfall::Target>& targets, const std::string& file,
                      Reading& reading) {
    std::vector<std::pair<std::vector<std::vector<std::pair<double, double>>>, std::size_t>> shapes;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        shapes.emplace_back(plain_parts(targets[i]), i);
    }
    std::sort(shapes.begin(), shapes.end());
    for (std::size_t i = 1; i < shapes.size(); ++i) {
        if (shapes[i].first == shapes[i - 1].first) {
            reading.note(joined(file, ": targets ", config::in_quotes(targets[shapes[i - 1].second].id),
                                " and ", config::in_quotes(targets[shapes[i].second].id),
                                " have the same shape and count the same rocks"));
        }
    }
}

}  // namespace

bool crosses_itself(const std::vector<Eigen::Vector2d>& ring) {
    // Pieces by their western end, so that only those are compared that overlap from west to east.
    const std::size_t pieces = ring.empty() ? 0 : ring.size() - 1;
    std::vector<std::size_t> order(pieces);
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto west = [&](std::size_t i) { return std::min(ring[i].x(), ring[i + 1].x()); };
    const auto east = [&](std::size_t i) { return std::max(ring[i].x(), ring[i + 1].x()); };
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return west(a) < west(b); });
    for (std::size_t i = 0; i < pieces; ++i) {
        for (std::size_t k = i + 1; k < pieces && west(order[k]) <= east(order[i]); ++k) {
            if (cross(ring[order[i]], ring[order[i] + 1], ring[order[k]], ring[order[k] + 1])) {
                return true;
            }
        }
    }
    return false;
}

std::vector<std::size_t> slivers_of(const std::vector<rockfall::Target>& targets,
                                    const std::vector<config::Place>& places, Reading& reading) {
    constexpr std::size_t one_in = 10;
    std::vector<std::size_t> slivers;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        if (has_no_extent(targets[i])) {
            slivers.push_back(i);
        }
    }
    if (slivers.empty() || slivers.size() * one_in > targets.size()) {
        return {};
    }
    reading.warn(places[slivers.front()],
                 joined(counted(slivers.size(), "target"), " without length or area, left out"),
                 "lines or areas that rocks can reach",
                 "look at it on the map: a sliver between two shapes has nothing to protect");
    return slivers;
}

void judge_shapes_of_targets(const std::vector<rockfall::Target>& targets,
                             const std::vector<config::Place>& places, Reading& reading) {
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const rockfall::Target& target = targets[i];
        const std::string name = joined("target ", config::in_quotes(target.id));
        if (has_no_extent(target)) {
            reading.refuse(places[i], joined(name, target.is_area ? " without area" : " without length"),
                           "a line or an area that rocks can reach", "draw it again, or delete the row");
        } else if (target.is_area && std::any_of(target.parts.begin(), target.parts.end(), crosses_itself)) {
            reading.warn(places[i], joined(name, " with an outline that crosses itself"),
                         "an outline that goes round once",
                         "order its corners (QGIS: Fix geometries): what lies between two turns is left out");
        }
    }
    if (!targets.empty()) {
        note_same_shapes(targets, places.front().file, reading);
    }
}

}  // namespace coupling::plausible
