#include "config/units/constants.hpp"
#include "coupling/assessments/hazard/hazard_results.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/figures/json.hpp"

namespace coupling::hazard {
namespace {

using config::percent;

Json target_hazard(const TargetHazard& target) {
    Json shares;
    for (std::size_t level = 0; level < levels; ++level) {
        shares[level_names[level]] = json_number(percent * target.levels[level]);
    }
    Json arrival_shares;
    for (std::size_t level = 0; level < levels; ++level) {
        arrival_shares[level_names[level]] = json_number(percent * target.arrival_levels[level]);
    }
    return {{"highest_level", level_name(target.highest())},
            {"share_percent", shares},
            {"arrival_share_percent", arrival_shares}};
}

}  // namespace

void write_summary(std::ostream& out, const HazardResults& results, const std::vector<WrittenFile>& files) {
    Json summary{{"program", "Bannwald"}, {"version", results.version}};
    std::uint64_t rocks = 0;
    Json periods = Json::array();
    for (const FinishedPeriod& period : results.periods) {
        rocks += period.rocks;
        Json left;
        for (const SlopeHazard& slope : results.slopes) {
            left[name_of(slope.cover)] = json_departures(period.departures[index_of(slope.cover)]);
        }
        periods.push_back({{"return_period_years", period.return_period_years},
                           {"folder", "../" + period.folder.filename().string()},
                           {"rocks", period.rocks},
                           {"smallest_diameter_m", json_number(period.diameters.smallest_m)},
                           {"largest_diameter_m", json_number(period.diameters.largest_m)},
                           {"left_terrain", std::move(left)}});
    }
    summary["run"] = {{"scenario", results.scenario.file.filename().string()},
                      {"kind", "hazard"},
                      {"smallest_zone_m2", json_number(results.scenario.hazard.smallest_zone_m2)},
                      {"seed", results.scenario.run.seed},
                      {"rocks", rocks},
                      {"map", json_map_frame(results.site.map_frame)}};
    summary["return_periods"] = std::move(periods);
    summary["targets"] = Json::array();
    for (std::size_t i = 0; i < results.site.targets.size(); ++i) {
        Json target{{"id", results.site.targets[i].id}, {"name", results.site.targets[i].name}};
        for (const SlopeHazard& slope : results.slopes) {
            target[name_of(slope.cover)] = target_hazard(slope.targets[i]);
        }
        summary["targets"].push_back(std::move(target));
    }
    summary["warnings"] = results.warnings.warnings();
    summary["notes"] = results.warnings.notes();
    write_json_summary(out, std::move(summary), results.inputs, results.scenario, files);
}

}  // namespace coupling::hazard
