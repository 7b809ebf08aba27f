#include "coupling/assessments/hazard/hazard_results.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/units/constants.hpp"
#include "coupling/assessments/hazard/hazard_zones.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/maps/rasters.hpp"
#include "coupling/results/maps/read_raster.hpp"

namespace coupling::hazard {
namespace {

using config::joined;

namespace fs = std::filesystem;

constexpr double m2_per_ha = 1e4;

config::Raster<float> raster_of(const FinishedPeriod& period, Cover cover, const std::string& stem,
                                const config::GridFrame& frame) {
    const fs::path file = period.folder / "rasters" / name_of(cover) / joined(stem, ".asc");
    config::Raster<float> raster = read_raster(file);
    if (!config::same_place(raster.frame, frame)) {
        config::fail(config::ExitCode::data, {file.string()}, "a raster on another frame",
                     "that of this scenario: --overwrite simulates all of them again");
    }
    raster.frame = frame;  // as exact as the site has it
    return raster;
}

}  // namespace

std::string stem_of(HazardEnergy energy) {
    switch (energy) {
        case HazardEnergy::mean:
            return "E_mean";
        case HazardEnergy::p50:
            return "E_50";
        case HazardEnergy::p90:
            return "E_90";
        case HazardEnergy::p95:
            return "E_95";
        case HazardEnergy::p98:
            return "E_98";
        case HazardEnergy::p99:
            return "E_99";
        case HazardEnergy::max:
            break;
    }
    return "E_max";
}

const FinishedPeriod& leaves_most(const std::vector<FinishedPeriod>& periods, Cover cover) {
    return *std::max_element(
        periods.begin(), periods.end(), [&](const FinishedPeriod& a, const FinishedPeriod& b) {
            return a.departures[index_of(cover)].share() < b.departures[index_of(cover)].share();
        });
}

double level_area_ha(const config::Raster<float>& map, const Site& site, Level level) {
    std::size_t cells = 0;
    for (std::size_t i = 0; i < map.values.size(); ++i) {
        const bool untouched = std::isnan(map.values[i]);
        const bool is_ground = !std::isnan(site.heights.values[i]);
        cells += untouched ? (level == Level::none && is_ground ? 1U : 0U)
                           : (map.values[i] == static_cast<float>(level) ? 1U : 0U);
    }
    return static_cast<double>(cells) * map.frame.cell_area_m2() / m2_per_ha;
}

std::vector<Level> levels_of_targets(const SlopeHazard& slope, RuledLevel TargetHazard::*by) {
    std::vector<Level> found;
    for (const TargetHazard& target : slope.targets) {
        found.push_back((target.*by).level);
    }
    return found;
}

std::optional<ForestChanges> changes_by_forest(const HazardResults& results) {
    if (results.slopes.size() < 2) {
        return std::nullopt;
    }
    const SlopeHazard& forest = results.slopes.front();
    const SlopeHazard& bare = results.slopes.back();
    const auto ruled = [](const SlopeHazard& slope) {
        std::vector<RuledLevel> found;
        for (const TargetHazard& target : slope.targets) {
            found.push_back(target.ruled);
        }
        return found;
    };
    return changes_between(ruled(forest), ruled(bare), forest.map, bare.map);
}

std::string compared_stem(const HazardResults& results) {
    return joined("Hazard_level_", rule_name(results.slopes.front().compared.rule));
}

namespace {

PeriodFalls falls_of(const FinishedPeriod& period, Cover cover, const Scenario& scenario,
                     const config::GridFrame& frame) {
    const auto raster = [&](const std::string& stem) { return raster_of(period, cover, stem, frame); };
    PeriodFalls falls{.return_period_years = period.return_period_years,
                      .passages = raster("Nr_passages"),
                      .reach_percent = raster("Reach_probability"),
                      .energy_kj = raster(stem_of(scenario.hazard.energy)),
                      .largest_kj = raster("E_max"),
                      .per_release = {}};
    for (const RasterKind& kind : release_kinds()) {
        falls.per_release.push_back(raster(std::string{kind.stem}));
    }
    return falls;
}

/// Of how many rocks of the same weight the frequency of a class of energy is, over all return periods.
FewRocks rocks_of_class(std::span<const FinishedPeriod> periods, std::size_t target, Cover cover,
                        HitsOfTargets FinishedPeriod::*hits_of_period, const RuledLevel& ruled) {
    double per_year = 0.0;
    double squares = 0.0;
    std::uint64_t rocks = 0;
    for (const FinishedPeriod& period : periods) {
        const TargetHits& hits = (period.*hits_of_period)[target][index_of(cover)];
        if (hits.rocks == 0 || hits.even_rocks_above[ruled.intensity] == 0) {
            continue;
        }
        const double here = hits.at_place.per_release_above[ruled.intensity] / period.return_period_years;
        per_year += here;
        rocks += hits.rocks_above[ruled.intensity];
        squares += here * here / static_cast<double>(hits.even_rocks_above[ruled.intensity]);
    }
    return {ruled.release_years, rocks, even_rocks(per_year, squares)};
}

TargetHazard target_hazard(std::size_t target, Cover cover, const std::vector<FinishedPeriod>& periods,
                           HitsOfTargets FinishedPeriod::*hits_of_period, const Matrix& matrix,
                           HazardRule rule, HazardRule compared) {
    TargetHazard hazard;
    std::vector<PeriodAtPlace> of_periods;
    for (const FinishedPeriod& period : periods) {
        const TargetHits& hits = (period.*hits_of_period)[target][index_of(cover)];
        if (hits.rocks == 0) {
            continue;
        }
        const double years = period.return_period_years;
        of_periods.push_back({years, hits.at_place});
        const EnergyOfRocks& energy = hits.at_place.energy;
        if (hazard.highest.rocks == 0 || energy.kj > hazard.highest.kj) {
            hazard.highest = energy;
        }
        if (rule != HazardRule::cadanav && energy.is_largest) {
            hazard.few_rocks.push_back({years, energy.rocks, energy.rocks});
        }
        hazard.rocks += hits.rocks;
        hazard.hits_per_year += hits.at_place.per_release / years;
    }
    hazard.ruled = level_of(rule, matrix, of_periods);
    hazard.compared = level_of(compared, matrix, of_periods);
    if (rule == HazardRule::cadanav && !hazard.ruled.is_free()) {
        const FewRocks of_class = rocks_of_class(periods, target, cover, hits_of_period, hazard.ruled);
        if (of_class.even_rocks < least_rocks_of_class) {
            hazard.few_rocks.push_back(of_class);
        }
    }
    return hazard;
}

}  // namespace

SlopeHazard slope_hazard(Cover cover, const std::vector<FinishedPeriod>& periods, const Scenario& scenario,
                         const Site& site, const Matrix& matrix) {
    std::vector<PeriodFalls> falls;
    for (const FinishedPeriod& period : periods) {
        falls.push_back(falls_of(period, cover, scenario, site.map_frame));
    }
    const HazardSettings& hazard = scenario.hazard;
    const HazardRule compared = compared_with(hazard.rule);
    SlopeHazard slope{cover,
                      hazard_map(hazard.rule, falls, matrix, hazard.least_reach_percent),
                      hazard_map(compared, falls, matrix, hazard.least_reach_percent),
                      {},
                      {}};
    slope.zones_ha = zone_areas_ha(slope.map, hazard.smallest_zone_m2);
    for (std::size_t target = 0; target < site.targets.size(); ++target) {
        const auto by = [&](HitsOfTargets FinishedPeriod::*hits) {
            return target_hazard(target, cover, periods, hits, matrix, hazard.rule, compared);
        };
        slope.targets.push_back(by(&FinishedPeriod::hits));
        if (!periods.front().hits_without.empty()) {
            slope.without.push_back(by(&FinishedPeriod::hits_without).ruled.level);
        }
    }
    return slope;
}

namespace {

std::uint64_t percentile_of(HazardEnergy energy) {
    switch (energy) {
        case HazardEnergy::p50:
            return 50;
        case HazardEnergy::p90:
            return 90;
        case HazardEnergy::p95:
            return 95;
        case HazardEnergy::p98:
            return 98;
        case HazardEnergy::p99:
            return 99;
        case HazardEnergy::mean:
        case HazardEnergy::max:
            break;
    }
    return 0;
}

}  // namespace

std::uint64_t least_rocks(HazardEnergy energy) {
    std::uint64_t rocks = 1;
    while (!percentile_is_known(rocks, percentile_of(energy))) {
        ++rocks;
    }
    return rocks;
}

}  // namespace coupling::hazard
