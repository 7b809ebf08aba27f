#include "coupling/assessments/hazard/hazard_results.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/text/language.hpp"
#include "config/text/numbers.hpp"
#include "config/units/constants.hpp"
#include "coupling/assessments/hazard/hazard_colours.hpp"
#include "coupling/assessments/hazard/hazard_zones.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/finish.hpp"
#include "coupling/results/maps/rasters.hpp"
#include "coupling/results/maps/read_raster.hpp"
#include "coupling/results/tables/data_dictionary.hpp"

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

/// The classes of return periods of the matrix, the most frequent one darkest.
std::vector<ClassColour> period_colours(const Matrix& matrix) {
    constexpr double longest_years = 1e9;
    std::vector<ClassColour> classes;
    for (std::size_t i = 0; i < matrix.frequencies(); ++i) {
        classes.push_back({std::min(longest_years, matrix.return_period_to_years()[i]),
                           matrix.frequency_name(i),
                           colour_at(Palette::reach, 1.0 - static_cast<double>(i) /
                                                               static_cast<double>(matrix.frequencies()))});
    }
    return classes;
}

std::vector<WrittenFile> write_slope(const SlopeHazard& slope, const HazardResults& results,
                                     const fs::path& folder) {
    const std::string place = joined("rasters/", name_of(slope.cover), "/");
    const std::string where = slope.cover == Cover::forest ? " with forest." : " on the bare slope.";
    make_folder(folder / place);
    const std::string& projection = results.site.projection;
    std::vector<WrittenFile> files{
        write_raster(folder,
                     {joined(place, "Hazard_level"),
                      joined("Highest hazard level of all return periods,", where), slope.map.level},
                     projection, level_colours()),
        write_raster(
            folder,
            {joined(place, compared_stem(results)),
             joined("Highest hazard level by the rule for comparison,", where), slope.compared.level},
            projection, level_colours())};
    std::vector<ClassColour> periods;
    for (const FinishedPeriod& period : results.periods) {
        // Rasters hold the years in 32 bits: a class takes all up to a little above.
        periods.push_back({1.000001 * period.return_period_years,
                           joined(config::to_text(period.return_period_years), " years"),
                           colour_at(Palette::reach, 1.0 - static_cast<double>(periods.size()) /
                                                               static_cast<double>(results.periods.size()))});
    }
    files.push_back(write_raster(
        folder,
        {joined(place, "Hazard_return_period"),
         joined("Return period [years] of the rocks that give this level,", where), slope.map.ruling_years},
        projection, periods));
    for (std::size_t i = 0; i < results.periods.size(); ++i) {
        const std::string years = config::to_text(results.periods[i].return_period_years);
        files.push_back(write_raster(
            folder,
            {joined(place, "Intensity_", years),
             joined("Class of energy of the rocks with a return period of ", years, " years,", where),
             slope.map.intensity[i]},
            projection, intensity_colours(results.matrix)));
        files.push_back(write_raster(folder,
                                     {joined(place, "Arrival_return_period_", years),
                                      joined("Mean time [years] between two arrivals in the cell of rocks "
                                             "whose return period of release is ",
                                             years, " years,", where),
                                      slope.map.arrival_years[i]},
                                     projection, period_colours(results.matrix)));
    }
    return files;
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

/// "Road – 3 (100), 12 (300)": rocks that are too few for the level of a target, in brackets the return
/// period.
std::string few_in_words(const std::string& name, const std::vector<FewRocks>& few) {
    std::string words;
    for (const FewRocks& of_period : few) {
        words += joined(words.empty() ? joined(name, " – ") : ", ", std::to_string(of_period.rocks), " (",
                        config::to_text(of_period.return_period_years), ")");
    }
    return words;
}

}  // namespace

std::uint64_t least_rocks(HazardEnergy energy) {
    std::uint64_t rocks = 1;
    while (!percentile_is_known(rocks, percentile_of(energy))) {
        ++rocks;
    }
    return rocks;
}

void warn_of_few_rocks(const HazardResults& results, config::Warnings& warnings) {
    constexpr std::size_t most_named = 5;
    for (const SlopeHazard& slope : results.slopes) {
        std::size_t found = 0;
        std::string names;
        for (const std::size_t target : ranked_targets(results)) {
            const std::vector<FewRocks>& few = slope.targets[target].few_rocks;
            if (!few.empty() && ++found <= most_named) {
                names +=
                    joined(names.empty() ? "" : " / ", few_in_words(results.site.targets[target].name, few));
            }
        }
        if (found == 0) {
            continue;
        }
        const HazardEnergy energy = results.scenario.hazard.energy;
        const bool by_class = slope.map.rule == HazardRule::cadanav;
        const std::string needed =
            by_class
                ? joined("how often they hit is known from about ", std::to_string(least_rocks_of_class),
                         " rocks of the same weight on")
                : joined("the ", std::to_string(percentile_of(energy)), "th percentile needs at least ",
                         std::to_string(least_rocks(energy)), "; of fewer the largest energy stands for it");
        warnings.add(
            joined(slope.cover == Cover::forest ? "levels with forest" : "levels on the bare slope",
                   " may be too low or too high, at ", std::to_string(found), " of ",
                   std::to_string(slope.targets.size()), " targets (",
                   by_class ? "rocks of the class of energy that gives the level, in brackets the return "
                              "period in years that brings most of them: "
                            : "rocks that hit, in brackets their return period in years: ",
                   names, found > most_named ? " / …" : "", "): ", needed, "; raise release.rocks for more"));
    }
}

std::vector<WrittenFile> write_results(const HazardResults& results, const fs::path& folder,
                                       const WriteWatch& watch) {
    std::vector<WrittenFile> files{
        {"report.html",
         "The hazard map as a page: levels, targets, intensities. Opens offline in any browser."},
        {"summary.json", "Levels at the targets, settings, input hashes and warnings for scripts."}};
    const auto add = [&](const std::vector<WrittenFile>& more) {
        files.insert(files.end(), more.begin(), more.end());
    };
    add(write_tables(results, folder));
    std::vector<TableLayout> layouts = hazard_layouts();
    if (results.risk) {
        add(risk::write_tables(*results.risk, results.site, folder));
        layouts = together(layouts, risk::risk_layouts());
        if (results.risk->avoided) {
            add(risk::write_avoided(*results.risk, folder));
            layouts = together(layouts, risk::avoided_layouts());
        }
    }
    for (const SlopeHazard& slope : results.slopes) {
        watch("rasters");
        add(write_slope(slope, results, folder));
    }
    watch("hazard zones");
    std::vector<geopackage::AreaLayer> layers = zone_layers(results);
    if (!results.site.targets.empty()) {
        layers.push_back(target_layer(results));
    }
    finish_results(
        folder,
        {.scenario = results.scenario,
         .dictionary = {layouts, hazard_raster_columns(results)},
         .summary = [&](std::ostream& out, const auto& written) { write_summary(out, results, written); },
         .page = [&](std::ostream& out, const auto& written) { write_page(out, results, written); },
         .drawn = &results.site,
         .areas = layers},
        files, watch);
    return files;
}

}  // namespace coupling::hazard
