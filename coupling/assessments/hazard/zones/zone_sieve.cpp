#include "coupling/assessments/hazard/zones/zone_sieve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <vector>

namespace coupling::hazard::zones {
namespace {

using SievedLevels = config::Raster<std::uint8_t>;

constexpr std::uint32_t unknown = std::numeric_limits<std::uint32_t>::max();

/// Calls visit(neighbour, length of the shared side) for the cells beside a cell.
template <class Visit>
void each_neighbour(const config::GridFrame& frame, std::size_t cell, const Visit& visit) {
    const config::Cell here = frame.cell_of(cell);
    const std::array<std::pair<config::Cell, double>, 4> sides{
        {{{here.column, here.row - 1}, frame.cell_width_m},
         {{here.column, here.row + 1}, frame.cell_width_m},
         {{here.column - 1, here.row}, frame.cell_height_m},
         {{here.column + 1, here.row}, frame.cell_height_m}}};
    for (const auto& [neighbour, length_m] : sides) {
        if (frame.contains(neighbour)) {
            visit(frame.index(neighbour), length_m);
        }
    }
}

/// The cells of each zone, zone by zone in the order of their first cells.
std::vector<std::vector<std::size_t>> zones_in(const SievedLevels& levels,
                                               std::vector<std::uint32_t>& zone_of) {
    std::vector<std::vector<std::size_t>> zones;
    zone_of.assign(levels.values.size(), unknown);
    std::vector<std::size_t> open;
    for (std::size_t first = 0; first < levels.values.size(); ++first) {
        if (zone_of[first] != unknown) {
            continue;
        }
        const auto number = static_cast<std::uint32_t>(zones.size());
        std::vector<std::size_t>& cells = zones.emplace_back();
        zone_of[first] = number;
        open.assign(1, first);
        while (!open.empty()) {
            const std::size_t cell = open.back();
            open.pop_back();
            cells.push_back(cell);
            each_neighbour(levels.frame, cell, [&](std::size_t next, double) {
                if (zone_of[next] == unknown && levels.values[next] == levels.values[first]) {
                    zone_of[next] = number;
                    open.push_back(next);
                }
            });
        }
    }
    return zones;
}

/// Merges small zones as far as their neighbours have not changed in this pass. Whether any was.
bool merge_small_zones(SievedLevels& levels, double smallest_m2) {
    std::vector<std::uint32_t> zone_of;
    const std::vector<std::vector<std::size_t>> zones = zones_in(levels, zone_of);
    std::vector<std::size_t> order(zones.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return zones[a].size() < zones[b].size(); });
    std::vector<bool> fixed(zones.size(), false);  // changed, or beside one that was
    bool merged = false;
    constexpr double hair = 1.0 - 1e-9;
    for (const std::size_t zone : order) {
        const double area_m2 = static_cast<double>(zones[zone].size()) * levels.frame.cell_area_m2();
        if (fixed[zone] || area_m2 >= smallest_m2 * hair) {
            continue;
        }
        std::map<std::uint8_t, double> border_m;  // by level
        std::vector<std::uint32_t> beside;
        for (const std::size_t cell : zones[zone]) {
            each_neighbour(levels.frame, cell, [&](std::size_t next, double length_m) {
                if (zone_of[next] != zone) {
                    border_m[levels.values[next]] += length_m;
                    beside.push_back(zone_of[next]);
                }
            });
        }
        if (border_m.empty()) {
            continue;
        }
        const auto longest =
            std::max_element(border_m.begin(), border_m.end(), [](const auto& a, const auto& b) {
                return a.second < b.second || (a.second == b.second && a.first < b.first);
            });
        if (longest->first < levels.values[zones[zone].front()]) {
            continue;  // what is high stays, however small
        }
        for (const std::size_t cell : zones[zone]) {
            levels.values[cell] = longest->first;
        }
        merged = true;
        fixed[zone] = true;
        for (const std::uint32_t other : beside) {
            fixed[other] = true;
        }
    }
    return merged;
}

}  // namespace

SievedLevels without_small_zones(const config::Raster<float>& cells, double smallest_m2) {
    SievedLevels found{cells.frame, 0};
    for (std::size_t cell = 0; cell < found.values.size(); ++cell) {
        const float level = cells.values[cell];
        found.values[cell] = std::isnan(level) ? std::uint8_t{0} : static_cast<std::uint8_t>(level);
    }
    while (merge_small_zones(found, smallest_m2)) {
    }
    return found;
}

}  // namespace coupling::hazard::zones
