#include "coupling/inputs/plausible/overlapping_areas.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "coupling/inputs/systems/extent.hpp"

namespace coupling::plausible {
namespace {

double ring_area_m2(const std::vector<config::Point2>& ring) {
    double twice_m2 = 0.0;
    for (std::size_t i = 1; i < ring.size(); ++i) {
        twice_m2 += (ring[i - 1].x_m - ring.front().x_m) * (ring[i].y_m - ring.front().y_m) -
                    (ring[i].x_m - ring.front().x_m) * (ring[i - 1].y_m - ring.front().y_m);
    }
    return 0.5 * std::abs(twice_m2);
}

/// Share of an area that lies in another one, at the middles of a grid over its box.
double share_inside(const config::Shape& of, const Extent& box, const config::Shape& in) {
    constexpr int side = 40;
    int all = 0;
    int shared = 0;
    for (int i = 0; i < side; ++i) {
        for (int k = 0; k < side; ++k) {
            const config::Point2 place{box.west_m + (i + 0.5) / side * (box.east_m - box.west_m),
                                       box.south_m + (k + 0.5) / side * (box.north_m - box.south_m)};
            if (point_in_polygon(of, place)) {
                ++all;
                shared += point_in_polygon(in, place) ? 1 : 0;
            }
        }
    }
    return all > 0 ? static_cast<double>(shared) / all : 0.0;
}

}  // namespace

double area_m2(const config::Shape& polygon) {
    double sum_m2 = 0.0;
    for (std::size_t i = 0; i < polygon.parts.size(); ++i) {
        // A ring inside of an odd number of others is a hole.
        std::size_t around = 0;
        for (std::size_t k = 0; k < polygon.parts.size(); ++k) {
            const config::Shape other{config::Shape::Kind::polygon, {polygon.parts[k]}};
            around += k != i && point_in_polygon(other, polygon.parts[i].front()) ? 1U : 0U;
        }
        sum_m2 += (around % 2 == 0 ? 1.0 : -1.0) * ring_area_m2(polygon.parts[i]);
    }
    return sum_m2;
}

std::vector<Overlap> overlapping(const std::vector<const config::Shape*>& areas, double least_share) {
    std::vector<Extent> boxes;
    for (const config::Shape* area : areas) {
        std::vector<config::Point2> corners;
        for (const auto& ring : area->parts) {
            corners.insert(corners.end(), ring.begin(), ring.end());
        }
        boxes.push_back(extent_of(corners));
    }
    // By their western sides, so that only those are compared that overlap from west to east.
    std::vector<std::size_t> order(areas.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return boxes[a].west_m < boxes[b].west_m; });
    std::vector<Overlap> found;
    for (std::size_t i = 0; i < order.size(); ++i) {
        for (std::size_t k = i + 1; k < order.size() && boxes[order[k]].west_m < boxes[order[i]].east_m;
             ++k) {
            const std::size_t first = std::min(order[i], order[k]);
            const std::size_t second = std::max(order[i], order[k]);
            if (boxes[first].south_m >= boxes[second].north_m ||
                boxes[second].south_m >= boxes[first].north_m) {
                continue;
            }
            const bool first_is_smaller = area_m2(*areas[first]) <= area_m2(*areas[second]);
            const std::size_t smaller = first_is_smaller ? first : second;
            const std::size_t larger = first_is_smaller ? second : first;
            const double share = share_inside(*areas[smaller], boxes[smaller], *areas[larger]);
            if (share > least_share) {
                found.push_back({first, second, share});
            }
        }
    }
    std::sort(found.begin(), found.end(), [](const Overlap& a, const Overlap& b) {
        return std::pair{a.first, a.second} < std::pair{b.first, b.second};
    });
    return found;
}

}  // namespace coupling::plausible
