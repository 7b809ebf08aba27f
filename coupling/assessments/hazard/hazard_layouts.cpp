#include <string>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/assessments/hazard/hazard_results.hpp"
#include "coupling/results/tables/figure_columns.hpp"

namespace coupling::hazard {
namespace {

using config::joined;

constexpr const char* from_map = "cells of the map";
constexpr const char* from_matrix = "hazard_matrix.csv or hazard.matrix";
constexpr const char* how_arrivals = "coupling/assessments/hazard/README.md";
constexpr const char* from_blocks = "input hazard.blocks";

std::vector<Column> class_columns() {
    return {{"energy_from_kj", "kJ", "lower end of the class of energy, which ends with the next one",
             from_matrix},
            {"intensity", "-", "number of the class, from 1", from_matrix}};
}

Column period_column() {
    return {"return_period_years", "years", "return period of the rocks", from_blocks};
}

Column level_column() {
    return {"level", "text", "none, residual, low, moderate or high", from_matrix};
}

}  // namespace

const std::vector<TableLayout>& hazard_layouts() {
    static const std::vector<TableLayout> layouts{
        {"hazard_blocks.csv",
         "the rocks of a release zone with a return period",
         {{"zone", "text", "release zone; others: those without a row of their own; all: no zone has one",
           from_blocks},
          period_column(),
          {"diameter_m", "m", "diameter of the rocks", from_blocks},
          {"mass_kg", "kg", "mass of the rocks", from_blocks},
          {"rocks", "-", "how many are released", "input release"}}},
        {"hazard_levels.csv",
         "a hazard level on a slope",
         {cover_column(),
          level_column(),
          {"area_ha", "ha", "plan area with this level", from_map},
          {"arrival_area_ha", "ha", "the same by the return period of the arrival", from_map}}},
        {"hazard_intensities.csv", "a class of energy with a return period on a slope",
         together(
             std::vector{cover_column(), period_column()}, class_columns(),
             std::vector<Column>{{"area_ha", "ha", "plan area with this intensity", from_map},
                                 {"level", "text", "hazard level that the two have together", from_matrix}})},
        {"hazard_arrivals.csv", "the rocks of a return period at a target",
         together(target_columns(), std::vector{period_column()},
                  std::vector<Column>{
                      {"reached_bare_percent", "%", "share of the rocks that arrive over the bare slope",
                       "targets.csv of the return period"},
                      {"reached_percent", "%", "share that arrives with forest",
                       "targets.csv of the return period"},
                      {"protection_percent", "%", "share of the arriving rocks that the forest stops",
                       "protection.csv of the return period"},
                      {"protection_low_percent", "%", "lower end of its 95 % interval",
                       "protection.csv of the return period"},
                      {"protection_high_percent", "%", "upper end of its 95 % interval",
                       "protection.csv of the return period"},
                      {"arrival_period_bare_years", "years",
                       "mean time between two arrivals over the bare slope: return period of the release by "
                       "the share that arrives; empty: none arrives",
                       how_arrivals},
                      {"arrival_period_years", "years", "the same with forest", how_arrivals}})},
        {"hazard_targets.csv", "a hazard level of a target on a slope",
         together(
             target_columns(), std::vector{cover_column(), level_column()},
             std::vector<Column>{
                 {"share_percent", "%", "share of the target's length or area with this level", from_map},
                 {"arrival_share_percent", "%", "the same by the return period of the arrival", from_map}})},
        {"hazard_target_intensities.csv", "a class of energy at a target with a return period on a slope",
         together(
             target_columns(), std::vector{cover_column(), period_column()}, class_columns(),
             std::vector<Column>{{"share_percent", "%",
                                  "share of the target's length or area with this intensity", from_map}})}};
    return layouts;
}

std::vector<Column> hazard_raster_columns(const std::vector<FinishedPeriod>& periods) {
    std::vector<Column> columns{
        {"Hazard_level", "-",
         "highest hazard level of all return periods: 0 none, 1 residual, 2 low, 3 moderate, 4 high",
         from_matrix},
        {"Hazard_level_arrival", "-", "the same by the return period of the arrival in the cell",
         from_matrix},
        {"Hazard_return_period", "years", "shortest return period that gives this level", from_blocks},
    };
    for (const FinishedPeriod& period : periods) {
        columns.push_back({joined("Intensity_", config::to_text(period.return_period_years)), "-",
                           "class of energy of the rocks of this return period, from 1; the classes stand in "
                           "hazard_intensities.csv",
                           from_matrix});
        columns.push_back({joined("Arrival_return_period_", config::to_text(period.return_period_years)),
                           "years", "mean time between two arrivals of such rocks in the cell",
                           how_arrivals});
    }
    return columns;
}

}  // namespace coupling::hazard
