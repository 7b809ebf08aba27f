#include "coupling/assessments/hazard/hazard_map.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <map>

namespace coupling::hazard {
namespace {

constexpr float no_value = std::numeric_limits<float>::quiet_NaN();
constexpr double steps_a_cell = 20.0;
constexpr double places_a_side = 8.0;
constexpr double coarsest_m = 0.5;  // else slivers of a house are lost in large cells

using Extents = std::map<std::size_t, double>;

void add(const Eigen::Vector2d& point_m, double extent, const config::GridFrame& frame, Extents& extents) {
    const config::Cell cell = frame.cell_at(point_m.x(), point_m.y());
    if (frame.contains(cell)) {
        extents[frame.index(cell)] += extent;
    }
}

void add_lines(const rockfall::Target& target, const config::GridFrame& frame, Extents& extents) {
    const double step_m = std::min(frame.cell_width_m, frame.cell_height_m) / steps_a_cell;
    for (const auto& part : target.parts) {
        for (std::size_t i = 0; i + 1 < part.size(); ++i) {
            const Eigen::Vector2d way_m = part[i + 1] - part[i];
            const double length_m = way_m.norm();
            const int steps = std::max(1, static_cast<int>(std::ceil(length_m / step_m)));
            for (int k = 0; k < steps; ++k) {
                add(part[i] + (k + 0.5) / steps * way_m, length_m / steps, frame, extents);
            }
        }
    }
}

void add_area(const rockfall::Target& target, const config::GridFrame& frame, Extents& extents) {
    const auto step_of = [](double cell_m) {
        return cell_m / std::ceil(cell_m / std::min(coarsest_m, cell_m / places_a_side));
    };
    const Eigen::Vector2d step_m{step_of(frame.cell_width_m), step_of(frame.cell_height_m)};
    const auto first = [](double low, double origin, double step) {
        return origin + (std::floor((low - origin) / step) + 0.5) * step;
    };
    for (double y_m = first(target.low_m.y(), frame.y_south_m, step_m.y()); y_m <= target.high_m.y();
         y_m += step_m.y()) {
        for (double x_m = first(target.low_m.x(), frame.x_west_m, step_m.x()); x_m <= target.high_m.x();
             x_m += step_m.x()) {
            const Eigen::Vector2d place_m{x_m, y_m};
            if (rockfall::is_inside(target, place_m)) {
                add(place_m, step_m.x() * step_m.y(), frame, extents);
            }
        }
    }
    if (extents.empty()) {  // smaller than the places are apart
        add(0.5 * (target.low_m + target.high_m), step_m.x() * step_m.y(), frame, extents);
    }
}

}  // namespace

double arrival_return_period_years(double release_years, double reach_percent) {
    constexpr double whole_percent = 100.0;
    return reach_percent > 0.0 ? release_years * whole_percent / std::min(whole_percent, reach_percent)
                               : std::numeric_limits<double>::infinity();
}

HazardMap hazard_map(std::span<const PeriodFalls> periods, const Matrix& matrix, double least_reach_percent) {
    assert(!periods.empty());
    const config::GridFrame& frame = periods.front().energy_kj.frame;
    HazardMap map{config::Raster<float>{frame, no_value},
                  config::Raster<float>{frame, no_value},
                  {},
                  config::Raster<float>{frame, no_value},
                  {}};
    for (const PeriodFalls& falls : periods) {
        assert(falls.energy_kj.frame == frame && falls.reach_percent.frame == frame);
        const std::size_t frequency = matrix.frequency_of(falls.return_period_years);
        config::Raster<float>& intensities = map.intensity.emplace_back(frame, no_value);
        config::Raster<float>& arrivals = map.arrival_years.emplace_back(frame, no_value);
        for (std::size_t cell = 0; cell < frame.size(); ++cell) {
            const auto energy_kj = static_cast<double>(falls.energy_kj.values[cell]);
            const auto reach = static_cast<double>(falls.reach_percent.values[cell]);
            if (std::isnan(energy_kj) || !(reach >= least_reach_percent)) {
                continue;
            }
            const std::size_t intensity = matrix.intensity_of(energy_kj);
            intensities.values[cell] = static_cast<float>(intensity + 1);
            const auto level = static_cast<float>(matrix.at(intensity, frequency));
            float& highest = map.level.values[cell];
            float& ruling_years = map.ruling_years.values[cell];
            const auto years = static_cast<float>(falls.return_period_years);
            if (std::isnan(highest) || level > highest || (level == highest && years < ruling_years)) {
                highest = level;
                ruling_years = years;
            }
            const double arrival_years = arrival_return_period_years(falls.return_period_years, reach);
            arrivals.values[cell] = static_cast<float>(arrival_years);
            const auto by_arrival =
                static_cast<float>(matrix.at(intensity, matrix.frequency_of(arrival_years)));
            float& highest_by_arrival = map.arrival_level.values[cell];
            if (std::isnan(highest_by_arrival) || by_arrival > highest_by_arrival) {
                highest_by_arrival = by_arrival;
            }
        }
    }
    return map;
}

std::vector<TargetPart> parts_of(const rockfall::Target& target, const config::GridFrame& frame) {
    Extents extents;
    if (target.is_area) {
        add_area(target, frame, extents);
    } else {
        add_lines(target, frame, extents);
    }
    std::vector<TargetPart> parts;
    for (const auto& [cell, extent] : extents) {
        parts.push_back({cell, extent});
    }
    return parts;
}

std::vector<double> shares_of(std::span<const TargetPart> parts, const config::Raster<float>& raster,
                              std::size_t count) {
    std::vector<double> shares(count);
    double whole = 0.0;
    for (const TargetPart& part : parts) {
        const float value = raster.values[part.cell];
        shares[std::isnan(value) ? 0 : static_cast<std::size_t>(value)] += part.extent;
        whole += part.extent;
    }
    for (double& share : shares) {
        share = whole > 0.0 ? share / whole : 0.0;
    }
    return shares;
}

}  // namespace coupling::hazard
