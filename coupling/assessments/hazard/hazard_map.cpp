#include "coupling/assessments/hazard/hazard_map.hpp"

#include <cassert>
#include <cmath>
#include <limits>
#include <optional>

#include "config/units/constants.hpp"

namespace coupling::hazard {
namespace {

constexpr float no_value = std::numeric_limits<float>::quiet_NaN();

/// The rocks of a return period in a cell, as its rasters have them; nothing where none counts.
std::optional<RocksAtPlace> rocks_in(HazardRule rule, const PeriodFalls& falls, const Matrix& matrix,
                                     double least_reach_percent, std::size_t cell) {
    const auto reach_percent = static_cast<double>(falls.reach_percent.values[cell]);
    if (!(reach_percent > 0.0) || reach_percent < least_reach_percent) {
        return std::nullopt;
    }
    RocksAtPlace rocks{.per_release = reach_percent / config::percent, .per_release_above = {}};
    if (rule != HazardRule::cadanav) {
        rocks.energy.kj = static_cast<double>(falls.energy_kj.values[cell]);
        return std::isnan(rocks.energy.kj) ? std::nullopt : std::optional{std::move(rocks)};
    }
    std::array<EnergyQuantile, quantile_rasters.size()> quantiles;
    for (std::size_t i = 0; i < quantiles.size(); ++i) {
        quantiles[i] = {quantile_rasters[i].share_below,
                        static_cast<double>(falls.quantiles_kj[i].values[cell])};
        if (std::isnan(quantiles[i].energy_kj)) {
            return std::nullopt;
        }
    }
    for (const double from_kj : matrix.energy_from_kj()) {
        rocks.per_release_above.push_back(rocks.per_release * share_above(from_kj, quantiles));
    }
    return rocks;
}

}  // namespace

HazardMap hazard_map(HazardRule rule, std::span<const PeriodFalls> periods, const Matrix& matrix,
                     double least_reach_percent) {
    assert(!periods.empty());
    const config::GridFrame& frame = periods.front().reach_percent.frame;
    HazardMap map{
        rule, config::Raster<float>{frame, no_value}, config::Raster<float>{frame, no_value}, {}, {}};
    std::vector<RuledLevel> highest(frame.size());
    for (const PeriodFalls& falls : periods) {
        assert(falls.reach_percent.frame == frame);
        config::Raster<float>& intensities = map.intensity.emplace_back(frame, no_value);
        config::Raster<float>& arrivals = map.arrival_years.emplace_back(frame, no_value);
        for (std::size_t cell = 0; cell < frame.size(); ++cell) {
            const std::optional<RocksAtPlace> rocks =
                rocks_in(rule, falls, matrix, least_reach_percent, cell);
            if (!rocks) {
                continue;
            }
            const RuledLevel found = level_of(rule, matrix, falls.return_period_years, *rocks);
            intensities.values[cell] = static_cast<float>(found.intensity + 1);
            arrivals.values[cell] = static_cast<float>(
                arrival_return_period_years(falls.return_period_years, rocks->per_release));
            highest[cell] = higher(rule, highest[cell], found);
            map.level.values[cell] = static_cast<float>(highest[cell].level);
            map.ruling_years.values[cell] = static_cast<float>(highest[cell].release_years);
        }
    }
    return map;
}

}  // namespace coupling::hazard
