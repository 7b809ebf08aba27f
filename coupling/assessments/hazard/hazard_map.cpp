#include "coupling/assessments/hazard/hazard_map.hpp"

#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "config/units/constants.hpp"
#include "rockfall/tally/cell_releases.hpp"

namespace coupling::hazard {
namespace {

constexpr float no_value = std::numeric_limits<float>::quiet_NaN();

/// The rocks of a return period in a cell, as its rasters have them; nothing where none counts.
std::optional<PeriodAtPlace> rocks_in(const PeriodFalls& falls, const Matrix& matrix,
                                      double least_reach_percent, std::size_t cell) {
    const auto reach_percent = static_cast<double>(falls.reach_percent.values[cell]);
    if (!(reach_percent > 0.0) || reach_percent < least_reach_percent ||
        std::isnan(falls.energy_kj.values[cell])) {
        return std::nullopt;
    }
    std::array<double, rockfall::CellReleases::from_j.size()> passing{};
    for (std::size_t i = 0; i < passing.size(); ++i) {
        passing[i] = static_cast<double>(falls.per_release[i].values[cell]);
    }
    PeriodAtPlace here{falls.return_period_years,
                       {.per_release = passing.front(),
                        .per_release_above = {},
                        .energy = {.kj = static_cast<double>(falls.energy_kj.values[cell])}}};
    const auto largest_kj = static_cast<double>(falls.largest_kj.values[cell]);
    for (const double from_kj : matrix.energy_from_kj()) {
        here.rocks.per_release_above.push_back(per_release_from(from_kj, passing, largest_kj));
    }
    const auto rocks = static_cast<double>(falls.passages.values[cell]);
    for (const double above : here.rocks.per_release_above) {
        here.rocks.rocks_above.push_back(passing.front() > 0.0 ? rocks * above / passing.front() : 0.0);
    }
    return here;
}

}  // namespace

double per_release_from(double energy_kj, std::span<const double> per_release, double largest_kj) {
    const auto& from_j = rockfall::CellReleases::from_j;
    assert(per_release.size() == from_j.size());
    std::size_t below = 0;
    while (below + 1 < from_j.size() &&
           static_cast<double>(from_j[below + 1]) / config::j_per_kj <= energy_kj) {
        ++below;
    }
    const double low_kj = static_cast<double>(from_j[below]) / config::j_per_kj;
    if (energy_kj == low_kj) {
        return per_release[below];
    }
    if (energy_kj > largest_kj) {
        return 0.0;
    }
    const bool is_last = below + 1 == from_j.size();
    const double high_kj = is_last ? largest_kj : static_cast<double>(from_j[below + 1]) / config::j_per_kj;
    const double above = is_last ? 0.0 : per_release[below + 1];
    return per_release[below] + (energy_kj - low_kj) / (high_kj - low_kj) * (above - per_release[below]);
}

HazardMap hazard_map(HazardRule rule, std::span<const PeriodFalls> periods, const Matrix& matrix,
                     double least_reach_percent) {
    assert(!periods.empty());
    const config::GridFrame& frame = periods.front().reach_percent.frame;
    const config::Raster<float> empty{frame, no_value};
    HazardMap map{rule, empty, empty, empty, {}, {}};
    map.intensity.assign(periods.size(), empty);
    map.arrival_years = map.intensity;
    std::vector<PeriodAtPlace> here;
    for (std::size_t cell = 0; cell < frame.size(); ++cell) {
        here.clear();
        for (std::size_t k = 0; k < periods.size(); ++k) {
            assert(periods[k].reach_percent.frame == frame);
            if (auto rocks = rocks_in(periods[k], matrix, least_reach_percent, cell)) {
                const RuledLevel alone = level_of(rule, matrix, std::span{&*rocks, 1});
                map.intensity[k].values[cell] = static_cast<float>(alone.intensity + 1);
                map.arrival_years[k].values[cell] = static_cast<float>(
                    arrival_return_period_years(rocks->release_years, rocks->rocks.per_release));
                here.push_back(std::move(*rocks));
            }
        }
        if (!here.empty()) {
            const RuledLevel ruled = level_of(rule, matrix, here);
            map.level.values[cell] = static_cast<float>(ruled.level);
            map.ruling_years.values[cell] = static_cast<float>(ruled.release_years);
            map.rocks.values[cell] = static_cast<float>(ruled.rocks);
        }
    }
    return map;
}

}  // namespace coupling::hazard
