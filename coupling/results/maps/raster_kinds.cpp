#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "coupling/results/maps/rasters.hpp"
#include "rockfall/tally/cell_quantile.hpp"
#include "rockfall/tally/cell_releases.hpp"

namespace coupling {
namespace {

using rockfall::CellHistograms;
using rockfall::CellSums;

constexpr float not_there = std::numeric_limits<float>::quiet_NaN();
constexpr double kilo_per_one = 1e-3;

float mean_of(std::uint64_t sum, std::uint32_t count) {
    return static_cast<float>(static_cast<double>(sum) / count * kilo_per_one);
}

/// Percentiles never exceed the exact maximum that is kept beside the bins.
template <int percent>
float energy_percentile_kj(const CellSums& sums, const CellHistograms* histograms, std::size_t cell) {
    const double found_j = rockfall::cell_quantile(rockfall::energy_bins, histograms->energy(cell),
                                                   sums.passages, sums.energy_max_j, percent / 100.0);
    return static_cast<float>(std::min(found_j, static_cast<double>(sums.energy_max_j)) * kilo_per_one);
}

template <int percent>
float speed_percentile_mps(const CellSums& sums, const CellHistograms* histograms, std::size_t cell) {
    const double found_mps = rockfall::cell_quantile(rockfall::speed_bins, histograms->speed(cell),
                                                     sums.passages, sums.speed_max_mps, percent / 100.0);
    return std::min(static_cast<float>(found_mps), sums.speed_max_mps);
}

template <int percent>
float height_percentile_m(const CellSums& sums, const CellHistograms* histograms, std::size_t cell) {
    const double found_m = rockfall::cell_quantile(rockfall::height_bins, histograms->height(cell),
                                                   sums.passages, sums.height_max_m, percent / 100.0);
    return std::min(static_cast<float>(found_m), sums.height_max_m);
}

float reach_percent(const CellSums& sums, const CellHistograms*, std::size_t) {
    if (sums.fed_rocks == 0) {
        return not_there;
    }
    return static_cast<float>(std::min(100.0, 100.0 * sums.passages / static_cast<double>(sums.fed_rocks)));
}

float energy_line_angle_deg(const CellSums& sums, const CellHistograms*, std::size_t) {
    if (sums.passages == 0 || !std::isfinite(sums.energy_line_slope_min)) {
        return not_there;
    }
    return static_cast<float>(std::atan(static_cast<double>(sums.energy_line_slope_min)) * 180.0 /
                              std::numbers::pi);
}

void add_energy(std::vector<RasterKind>& kinds) {
    const auto add = [&](std::string_view stem, std::string_view meaning, bool percentile, bool compared,
                         auto value) {
        kinds.push_back({stem, "kJ", meaning, RasterStyle::energy_classes, Palette::deposits, percentile,
                         compared, value});
    };
    add("E_mean", "mean of the largest kinetic energy of each rock in the cell", false, true,
        [](const CellSums& s, const CellHistograms*, std::size_t) {
            return mean_of(s.energy_sum_j, s.passages);
        });
    add("E_50", "median of the largest energy of each rock in the cell", true, false,
        energy_percentile_kj<50>);
    add("E_90", "90th percentile of the largest energy of each rock in the cell", true, false,
        energy_percentile_kj<90>);
    add("E_95", "95th percentile of the largest energy of each rock in the cell", true, true,
        energy_percentile_kj<95>);
    add("E_98", "98th percentile of the largest energy of each rock in the cell", true, false,
        energy_percentile_kj<98>);
    add("E_99", "99th percentile of the largest energy of each rock in the cell", true, false,
        energy_percentile_kj<99>);
    add("E_max", "largest energy of all rocks in the cell", false, true,
        [](const CellSums& s, const CellHistograms*, std::size_t) { return s.energy_max_j * 1e-3F; });
}

void add_speed(std::vector<RasterKind>& kinds) {
    const auto add = [&](std::string_view stem, std::string_view meaning, bool percentile, bool compared,
                         auto value) {
        kinds.push_back(
            {stem, "m/s", meaning, RasterStyle::linear, Palette::passages, percentile, compared, value});
    };
    add("V_mean", "mean of the highest speed of each rock in the cell", false, false,
        [](const CellSums& s, const CellHistograms*, std::size_t) {
            return mean_of(s.speed_sum_mmps, s.passages);
        });
    add("V_50", "median of the highest speed of each rock in the cell", true, false,
        speed_percentile_mps<50>);
    add("V_90", "90th percentile of the highest speed of each rock in the cell", true, false,
        speed_percentile_mps<90>);
    add("V_95", "95th percentile of the highest speed of each rock in the cell", true, false,
        speed_percentile_mps<95>);
    add("V_98", "98th percentile of the highest speed of each rock in the cell", true, false,
        speed_percentile_mps<98>);
    add("V_99", "99th percentile of the highest speed of each rock in the cell", true, false,
        speed_percentile_mps<99>);
    add("V_max", "highest speed of all rocks in the cell", false, true,
        [](const CellSums& s, const CellHistograms*, std::size_t) { return s.speed_max_mps; });
}

void add_height(std::vector<RasterKind>& kinds) {
    const auto add = [&](std::string_view stem, std::string_view meaning, bool percentile, bool compared,
                         auto value) {
        kinds.push_back(
            {stem, "m", meaning, RasterStyle::linear, Palette::height, percentile, compared, value});
    };
    add("Ph_mean", "mean of the largest passing height of each rock, normal to the slope", false, false,
        [](const CellSums& s, const CellHistograms*, std::size_t) {
            return mean_of(s.height_sum_mm, s.passages);
        });
    add("Ph_50", "median of the passing heights, normal to the slope", true, false, height_percentile_m<50>);
    add("Ph_90", "90th percentile of the passing heights, normal to the slope", true, false,
        height_percentile_m<90>);
    add("Ph_95", "95th percentile of the passing heights, normal to the slope", true, true,
        height_percentile_m<95>);
    add("Ph_98", "98th percentile of the passing heights, normal to the slope", true, false,
        height_percentile_m<98>);
    add("Ph_99", "99th percentile of the passing heights, normal to the slope", true, false,
        height_percentile_m<99>);
    add("Ph_max", "largest passing height of all rocks, normal to the slope", false, false,
        [](const CellSums& s, const CellHistograms*, std::size_t) { return s.height_max_m; });
}

void add_counts(std::vector<RasterKind>& kinds) {
    kinds.push_back({"Nr_passages", "rocks", "rocks that passed the cell, each counted once",
                     RasterStyle::logarithmic, Palette::passages, false, true,
                     [](const CellSums& s, const CellHistograms*, std::size_t) {
                         return static_cast<float>(s.passages);
                     }});
    kinds.push_back({"Nr_deposited", "rocks", "rocks that came to rest in the cell", RasterStyle::logarithmic,
                     Palette::deposits, false, false,
                     [](const CellSums& s, const CellHistograms*, std::size_t) {
                         return static_cast<float>(s.deposited);
                     }});
    kinds.push_back({"Nr_tree_impacts", "hits", "hits on trees in the cell", RasterStyle::logarithmic,
                     Palette::impacts, false, false,
                     [](const CellSums& s, const CellHistograms*, std::size_t) {
                         return static_cast<float>(s.tree_impacts);
                     }});
    kinds.push_back({"Reach_probability", "%",
                     "rocks that passed the cell in percent of all rocks from the sources that feed it",
                     RasterStyle::linear, Palette::reach, false, true, reach_percent});
    kinds.push_back(
        {"Density", "%", "rocks that passed the cell in percent of all rocks that fell", RasterStyle::linear,
         Palette::passages, false, true,
         [](const CellSums& s, const CellHistograms*, std::size_t) { return static_cast<float>(s.passages); },
         true});
    kinds.push_back({"EL_angles", "deg", "smallest energy-line angle from a release point down to the cell",
                     RasterStyle::linear, Palette::height, false, false, energy_line_angle_deg});
}

float not_of_sums(const CellSums&, const CellHistograms*, std::size_t) {
    return not_there;
}

}  // namespace

const std::vector<RasterKind>& spread_kinds() {
    static const std::vector<RasterKind> kinds{
        {"Reach_spread", "%",
         "standard deviation of the reach probability over the draws of what is not known, without the "
         "chance of the rocks",
         RasterStyle::linear, Palette::reach, false, false, not_of_sums},
        {"E_mean_spread", "kJ",
         "standard deviation of the mean of the largest kinetic energies over the draws of what is not "
         "known, without the chance of the rocks",
         RasterStyle::linear, Palette::height, false, false, not_of_sums}};
    return kinds;
}

const RasterKind& repeats_kind() {
    static const RasterKind kind{"Reached_in_repeats",
                                 "%",
                                 "share of the repeats in which at least one rock passed the cell",
                                 RasterStyle::linear,
                                 Palette::reach,
                                 false,
                                 false,
                                 not_of_sums};
    return kind;
}

const std::vector<RasterKind>& release_kinds() {
    const auto kind = [](std::string_view stem, std::string_view meaning) {
        return RasterKind{stem,           "rocks", meaning, RasterStyle::linear,
                          Palette::reach, false,   false,   not_of_sums};
    };
    static const std::vector<RasterKind> kinds{
        kind("Per_release",
             "rocks that pass the cell, or the square of hazard.reference_width_m around it, each time that "
             "every row of hazard.blocks releases one"),
        kind("Per_release_30_kJ",
             "rocks that pass the cell, or the square of hazard.reference_width_m around it, with at least "
             "30 kJ each time that every row of hazard.blocks releases one"),
        kind("Per_release_100_kJ",
             "rocks that pass the cell, or the square of hazard.reference_width_m around it, with at least "
             "100 kJ each time that every row of hazard.blocks releases one"),
        kind("Per_release_300_kJ",
             "rocks that pass the cell, or the square of hazard.reference_width_m around it, with at least "
             "300 kJ each time that every row of hazard.blocks releases one"),
        kind("Per_release_1000_kJ",
             "rocks that pass the cell, or the square of hazard.reference_width_m around it, with at least "
             "1000 kJ each time that every row of hazard.blocks releases one")};
    static_assert(rockfall::CellReleases::from_j == std::array{0.0F, 30e3F, 100e3F, 300e3F, 1000e3F});
    return kinds;
}

const std::vector<RasterKind>& raster_kinds() {
    static const std::vector<RasterKind> kinds = [] {
        std::vector<RasterKind> list;
        add_energy(list);
        add_speed(list);
        add_height(list);
        add_counts(list);
        return list;
    }();
    return kinds;
}

const RasterKind& raster_kind(std::string_view stem) {
    const auto found = std::find_if(raster_kinds().begin(), raster_kinds().end(),
                                    [&](const RasterKind& kind) { return kind.stem == stem; });
    assert(found != raster_kinds().end());
    return *found;
}

}  // namespace coupling
