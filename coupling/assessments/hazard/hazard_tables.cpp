#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/units/constants.hpp"
#include "coupling/assessments/hazard/hazard_results.hpp"
#include "coupling/results/tables/figure_columns.hpp"

namespace coupling::hazard {
namespace {

using config::joined;
using config::percent;

constexpr const char* from_map = "cells of the map";
constexpr const char* from_hits = "arrivals.csv of the return period";
constexpr const char* from_matrix = "hazard_matrix.csv or hazard.matrix";
constexpr const char* how_arrivals = "coupling/assessments/hazard/README.md";
constexpr const char* from_blocks = "input hazard.blocks";

/// A class of energy with a return period, on a slope or at a target on it.
struct ClassRow {
    const HazardResults& results;
    const SlopeHazard& slope;
    std::size_t period;
    std::size_t intensity;   ///< from 0
    std::size_t target = 0;  ///< as in the site

    [[nodiscard]] double years() const { return results.periods[period].return_period_years; }
};

/// A hazard level on a slope.
struct LevelRow {
    const HazardResults& results;
    const SlopeHazard& slope;
    std::size_t level;
    const std::optional<ForestChanges>& changes;
};

/// A target on a slope.
struct TargetRow {
    const HazardResults& results;
    const SlopeHazard& slope;
    std::size_t target;  ///< as in the site

    [[nodiscard]] const TargetHazard& hazard() const { return slope.targets[target]; }
};

constexpr auto cover_of_slope = [](const auto& row) { return name_of(row.slope.cover); };

template <class Row>
ColumnsOf<Row> target_name_columns() {
    return {target_columns(), [](const Row& row) {
                const auto& target = row.results.site.targets[row.target];
                return TargetName{target.id, target.name};
            }};
}

Column period_column() {
    return {"return_period_years", "years", "return period of the rocks", from_blocks};
}

Column level_column() {
    return {"level", "text", "none, residual, low, moderate or high", from_matrix};
}

ColumnsOf<ClassRow> class_columns() {
    return {{cover_column(), cover_of_slope},
            {period_column(), as_given, &ClassRow::years},
            {"energy_from_kj", as_given, "lower end of the class of energy, which ends with the next one",
             from_matrix, [](const auto& row) { return row.results.matrix.energy_from_kj()[row.intensity]; }},
            {"intensity", "number of the class, from 1", from_matrix,
             [](const auto& row) { return row.intensity + 1; }}};
}

/// Plan area of the cells that hold a class of intensity.
double area_ha(const config::Raster<float>& raster, std::size_t number) {
    const auto cells = std::count(raster.values.begin(), raster.values.end(), static_cast<float>(number));
    return static_cast<double>(cells) * raster.frame.cell_area_m2() / 1e4;
}

TableOf<ZoneRocks> block_table() {
    return {"hazard_blocks.csv",
            "The rocks of each release zone and return period.",
            "the rocks of a release zone with a return period",
            {{"zone", "release zone; others: those without a row of their own; all: no zone has one",
              from_blocks, &ZoneRocks::zone},
             {period_column(), as_given, &ZoneRocks::return_period_years},
             {"diameter_m", 3, "diameter of the rocks", from_blocks, &ZoneRocks::diameter_m},
             {"mass_kg", 1, "mass of the rocks", from_blocks, &ZoneRocks::mass_kg},
             {"rocks", "how many are released", "input release", &ZoneRocks::rocks}}};
}

/// Too few to give a level but by chance.
std::string few_rocks() {
    return joined("fewer than ", config::to_text(least_rocks_of_level), " rocks");
}

double changed_ha(const LevelRow& row, const std::array<double, levels> ForestChanges::*area) {
    return row.changes && row.slope.cover == Cover::forest ? ((*row.changes).*area)[row.level]
                                                           : std::numeric_limits<double>::quiet_NaN();
}

TableOf<LevelRow> level_table() {
    const auto area = [](const HazardMap SlopeHazard::*map) {
        return [map](const LevelRow& row) {
            return level_area_ha((row.slope.*map).level, row.results.site, static_cast<Level>(row.level));
        };
    };
    return {
        "hazard_levels.csv",
        "How much of each slope has which hazard level.",
        "a hazard level on a slope",
        {{cover_column(), cover_of_slope},
         {level_column(), [](const auto& row) { return level_names[row.level]; }},
         {"area_ha", 4, "plan area with this level by hazard.rule", from_map, area(&SlopeHazard::map)},
         {"zones_area_ha", 4, "area with this level in the layer hazard_zones; empty for none",
          "hazard_zones",
          [](const auto& row) {
              return row.level == 0 ? std::numeric_limits<double>::quiet_NaN()
                                    : row.slope.zones_ha[row.level];
          }},
         {"lowered_area_ha", 4,
          "of this area, where the level is higher on the bare slope; empty on the bare slope", from_map,
          [](const auto& row) { return changed_ha(row, &ForestChanges::lowered_ha); }},
         {"raised_area_ha", 4,
          "of this area, where the level is lower on the bare slope; empty on the bare slope", from_map,
          [](const auto& row) { return changed_ha(row, &ForestChanges::raised_ha); }},
         {"unclear_area_ha", 4,
          joined("of this area, where the level is another one on the bare slope, but ", few_rocks(),
                 " give the higher one; empty on the bare slope"),
          from_map, [](const auto& row) { return changed_ha(row, &ForestChanges::unclear_ha); }},
         {"few_rocks_area_ha", 4, joined("of this area, where ", few_rocks(), " give the level"), from_map,
          [](const auto& row) { return chance_area_ha(row.slope.map, static_cast<Level>(row.level)); }},
         {"compared_rule", "rule that it is compared with", "input hazard.rule",
          [](const auto& row) { return rule_name(row.slope.compared.rule); }},
         {"compared_area_ha", 4, "plan area with this level by that rule", from_map,
          area(&SlopeHazard::compared)}}};
}

TableOf<ClassRow> intensity_table() {
    return {
        "hazard_intensities.csv",
        "How much of each slope has which intensity, by return period.",
        "a class of energy with a return period on a slope",
        {class_columns(),
         {"area_ha", 4, "plan area with this intensity", from_map,
          [](const auto& row) { return area_ha(row.slope.map.intensity[row.period], row.intensity + 1); }},
         {"level", "hazard level that the two have together", from_matrix, [](const auto& row) {
              const Matrix& matrix = row.results.matrix;
              return level_name(matrix.at(row.intensity, matrix.frequency_of(row.years())));
          }}}};
}

struct TargetArrivals : PeriodArrivals {
    const HazardResults& results;
};

/// Infinite, an empty field, where none arrives.
double arrival_years(const PeriodArrivals& arrivals, Cover cover) {
    return arrival_return_period_years(arrivals.return_period_years,
                                       arrivals.hits[index_of(cover)].at_place.per_release);
}

TableOf<TargetArrivals> target_arrivals_table() {
    constexpr const char* from_targets = "targets.csv of the return period";
    constexpr const char* from_protection = "protection.csv of the return period";
    return {
        "hazard_arrivals.csv",
        "How many rocks arrive at each target, and what the forest stops, by return period.",
        "the rocks of a return period at a target",
        {target_name_columns<TargetArrivals>(),

         {period_column(), as_given, &PeriodArrivals::return_period_years},
         {"reached_bare_percent", 4, "share of the rocks that arrive over the bare slope", from_targets,
          &PeriodArrivals::bare_percent},
         {"reached_percent", 4, "share that arrives with forest", from_targets,
          &PeriodArrivals::forest_percent},
         {"protection_percent", 3, "share of the arriving rocks that the forest stops", from_protection,
          &PeriodArrivals::protection_percent},
         {"protection_low_percent", 3, "lower end of its 95 % interval", from_protection,
          &PeriodArrivals::protection_low_percent},
         {"protection_high_percent", 3, "upper end of its 95 % interval", from_protection,
          &PeriodArrivals::protection_high_percent},
         {"arrival_period_bare_years", 2,
          "mean time between two arrivals over the bare slope where each row of hazard.blocks releases one "
          "rock in its return period; empty: none arrives",
          how_arrivals, [](const auto& a) { return arrival_years(a, Cover::bare); }},
         {"arrival_period_years", 2, "the same with forest", how_arrivals,
          [](const auto& a) { return arrival_years(a, Cover::forest); }}}};
}

TableOf<TargetRow> target_table() {
    const auto ruled_figure = [](const RuledLevel TargetHazard::*ruled, double RuledLevel::*of) {
        return [ruled, of](const TargetRow& row) { return (row.hazard().*ruled).*of; };
    };
    return {
        "hazard_targets.csv",
        "The hazard level of each target, from the rocks that hit it.",
        "a target on a slope",
        {target_name_columns<TargetRow>(),
         {cover_column(), cover_of_slope},
         {level_column(), [](const auto& row) { return level_name(row.hazard().ruled.level); }},
         {"forest_changes_level",
          joined(
              "the level with forest beside that of the bare slope: lower, same, higher, or unclear where ",
              few_rocks(), " give the higher one; empty on the bare slope"),
          from_matrix,
          [](const auto& row) {
              return row.slope.cover == Cover::bare
                         ? ""
                         : change_name(change_between(row.hazard().ruled,
                                                      row.results.slopes.back().targets[row.target].ruled));
          }},
         {"level_rocks", 0, "simulated rocks that give the level, of all return periods", from_hits,
          ruled_figure(&TargetHazard::ruled, &RuledLevel::rocks)},
         {"rule", "hazard.rule", "input hazard.rule",
          [](const auto& row) { return rule_name(row.slope.map.rule); }},
         {"release_return_period_years", as_given, "of the rocks that give the level; empty: none hits",
          from_blocks, ruled_figure(&TargetHazard::ruled, &RuledLevel::release_years)},
         {"return_period_years", 2, "return period that the matrix was asked; empty: none hits", how_arrivals,
          ruled_figure(&TargetHazard::ruled, &RuledLevel::years)},
         {"intensity", "number of the class of energy that gives the level, from 1; 0: none hits",
          from_matrix,
          [](const auto& row) {
              const RuledLevel& ruled = row.hazard().ruled;
              return ruled.is_free() ? std::size_t{0} : ruled.intensity + 1;
          }},
         {"rocks", "simulated rocks of all return periods that hit it", from_hits,
          [](const auto& row) { return row.hazard().rocks; }},
         {"hit_every_years", 2, "mean time between two hits by rocks of all return periods; empty: none hits",
          how_arrivals, [](const auto& row) { return 1.0 / row.hazard().hits_per_year; }},
         {"energy_kj", 3,
          "hazard.energy of the rocks that give the level; their largest energy where they are too few "
          "for it (energy_is); empty: none hits",
          from_hits, [](const auto& row) { return row.hazard().ruled.energy.kj; }},
         {"energy_rocks", "simulated rocks that energy_kj is of", from_hits,
          [](const auto& row) { return row.hazard().ruled.energy.rocks; }},
         {"energy_is",
          "what energy_kj is: hazard.energy, or largest where fewer rocks hit than a percentile needs; "
          "empty: none hits",
          from_hits, [](const auto& row) { return statistic_name(row.hazard().ruled.energy); }},
         {"highest_energy_kj", 3,
          "the highest of the energies of single return periods, each as energy_kj; empty: none hits",
          from_hits, [](const auto& row) { return row.hazard().highest.kj; }},
         {"highest_energy_rocks", "simulated rocks that highest_energy_kj is of", from_hits,
          [](const auto& row) { return row.hazard().highest.rocks; }},
         {"highest_energy_is", "what highest_energy_kj is, as energy_is", from_hits,
          [](const auto& row) { return statistic_name(row.hazard().highest); }},
         {"compared_rule", "rule that it is compared with", "input hazard.rule",
          [](const auto& row) { return rule_name(row.slope.compared.rule); }},
         {"compared_level", "level by that rule", from_matrix,
          [](const auto& row) { return level_name(row.hazard().compared.level); }},
         {"level_without_barriers",
          "level of the same rocks without the nets and works that the run of risk.without lacks, by "
          "hazard.rule; "
          "empty: no risk.without",
          "run of risk.without",
          [](const auto& row) {
              return row.slope.without.empty() ? "" : level_name(row.slope.without[row.target]);
          }},
         {"compared_steps", "steps from level up to compared_level; below 0: that rule gives a lower one",
          from_matrix, [](const auto& row) {
              return steps_between(row.hazard().ruled.level, row.hazard().compared.level);
          }}}};
}

const TargetHits& hits_in(const ClassRow& row) {
    return row.results.periods[row.period].hits[row.target][index_of(row.slope.cover)];
}

double class_years(const ClassRow& row) {
    return arrival_return_period_years(row.years(), hits_in(row).at_place.per_release_above[row.intensity]);
}

TableOf<ClassRow> target_intensity_table() {
    return {"hazard_target_intensities.csv",
            "How often rocks of each class of energy and above hit each target, by return period.",
            "a class of energy at a target with a return period on a slope",
            {target_name_columns<ClassRow>(),
             class_columns(),
             {"rocks", "simulated rocks with at least this energy that hit the target", from_hits,
              [](const auto& row) { return hits_in(row).rocks_above[row.intensity]; }},
             {"per_release", 6, "the same for each release of each row of hazard.blocks", how_arrivals,
              [](const auto& row) { return hits_in(row).at_place.per_release_above[row.intensity]; }},
             {"target_return_period_years", 2, "mean time between two such hits; empty: none", how_arrivals,
              &class_years},
             {"level", "hazard level that energy and this return period have together (hazard.rule cadanav)",
              from_matrix, [](const auto& row) {
                  const double years = class_years(row);
                  const Matrix& matrix = row.results.matrix;
                  return level_name(std::isinf(years) ? Level::none
                                                      : matrix.at(row.intensity, matrix.frequency_of(years)));
              }}}};
}

void add_levels(auto& rows, const HazardResults& results) {
    const std::optional<ForestChanges> changes = changes_by_forest(results);
    for (const SlopeHazard& slope : results.slopes) {
        for (std::size_t level = 0; level < levels; ++level) {
            rows.add({results, slope, level, changes});
        }
    }
}

void add_classes(auto& rows, const HazardResults& results, std::size_t target) {
    for (const SlopeHazard& slope : results.slopes) {
        for (std::size_t period = 0; period < results.periods.size(); ++period) {
            for (std::size_t i = 0; i < results.matrix.intensities(); ++i) {
                rows.add({results, slope, period, i, target});
            }
        }
    }
}

}  // namespace

const std::vector<TableLayout>& hazard_layouts() {
    static const std::vector<TableLayout> layouts{block_table(),     level_table(),
                                                  intensity_table(), target_arrivals_table(),
                                                  target_table(),    target_intensity_table()};
    return layouts;
}

std::vector<WrittenFile> write_tables(const HazardResults& results, const std::filesystem::path& folder) {
    std::vector<WrittenFile> files{
        block_table().write(folder, [&](auto& rows) { rows.add_all(results.rocks); }),
        level_table().write(folder, [&](auto& rows) { add_levels(rows, results); }),
        intensity_table().write(folder, [&](auto& rows) { add_classes(rows, results, 0); })};
    const std::size_t targets = results.site.targets.size();
    if (targets > 0) {
        files.push_back(target_arrivals_table().write(folder, [&](auto& rows) {
            for (const PeriodArrivals& arrivals : results.arrivals) {
                rows.add({arrivals, results});
            }
        }));
        files.push_back(target_table().write(folder, [&](auto& rows) {
            for (std::size_t target = 0; target < targets; ++target) {
                for (const SlopeHazard& slope : results.slopes) {
                    rows.add({results, slope, target});
                }
            }
        }));
        files.push_back(target_intensity_table().write(folder, [&](auto& rows) {
            for (std::size_t target = 0; target < targets; ++target) {
                add_classes(rows, results, target);
            }
        }));
    }
    return files;
}

std::vector<Column> hazard_raster_columns(const HazardResults& results) {
    std::vector<Column> columns{
        {"Hazard_level", "-",
         "highest hazard level of all return periods by hazard.rule: "
         "0 none, 1 residual, 2 low, 3 moderate, 4 high",
         from_matrix},
        {compared_stem(results), "-", "the same by the rule that it is compared with", from_matrix},
        {"Hazard_return_period", "years",
         "return period of the release of the rocks that give this level; by release the shortest of equal "
         "levels, else that of most of the rocks",
         from_blocks},
    };
    for (const FinishedPeriod& period : results.periods) {
        columns.push_back(
            {joined("Intensity_", config::to_text(period.return_period_years)), "-",
             "class of energy that gives the level of this return period, from 1; the classes stand in "
             "hazard_intensities.csv",
             from_matrix});
        columns.push_back(
            {joined("Arrival_return_period_", config::to_text(period.return_period_years)), "years",
             "mean time between two arrivals in the cell of such rocks of all zones: return period of the "
             "release divided by Per_release of its run",
             how_arrivals});
    }
    return columns;
}

}  // namespace coupling::hazard
