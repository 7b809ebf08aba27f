#include "coupling/assessments/hazard/hazard_results.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/figures/json.hpp"

namespace coupling::hazard {
namespace {

Json ruled_level(const RuledLevel& ruled, HazardRule rule) {
    Json json{{"rule", rule_name(rule)}, {"level", level_name(ruled.level)}};
    if (!ruled.is_free()) {
        json["release_return_period_years"] = json_number(ruled.release_years);
        json["return_period_years"] = json_number(ruled.years);
        json["intensity"] = ruled.intensity + 1;
    }
    return json;
}

/// What an energy is, of how many rocks, and whether too few for a percentile; null where none hits.
void add_energy(Json& json, const std::string& name, const EnergyOfRocks& energy) {
    const bool is_there = energy.rocks > 0;
    json[name + "_kj"] = is_there ? json_number(energy.kj) : Json{};
    json[name + "_rocks"] = energy.rocks;
    json[name + "_is"] = is_there ? Json(statistic_name(energy)) : Json{};
}

Json target_json(const TargetHazard& target, const SlopeHazard& slope) {
    Json json = ruled_level(target.ruled, slope.map.rule);
    json["rocks"] = target.rocks;
    json["hit_every_years"] = target.rocks > 0 ? json_number(1.0 / target.hits_per_year) : Json{};
    add_energy(json, "energy", target.ruled.energy);
    add_energy(json, "highest_energy", target.highest);
    json["rests_on_few_rocks"] = target.rests_on_few_rocks(slope.map.rule);
    json["compared"] = ruled_level(target.compared, slope.compared.rule);
    return json;
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
                      {"rule", rule_name(results.scenario.hazard.rule)},
                      {"smallest_zone_m2", json_number(results.scenario.hazard.smallest_zone_m2)},
                      {"seed", results.scenario.run.seed},
                      {"rocks", rocks},
                      {"map", json_map_frame(results.site.map_frame)}};
    summary["return_periods"] = std::move(periods);
    summary["targets"] = Json::array();
    for (std::size_t i = 0; i < results.site.targets.size(); ++i) {
        Json target{{"id", results.site.targets[i].id}, {"name", results.site.targets[i].name}};
        for (const SlopeHazard& slope : results.slopes) {
            target[name_of(slope.cover)] = target_json(slope.targets[i], slope);
        }
        summary["targets"].push_back(std::move(target));
    }
    if (results.risk) {
        summary["risk"] = risk::risk_json(*results.risk, results.site);
    }
    summary["warnings"] = results.warnings.warnings();
    summary["notes"] = results.warnings.notes();
    write_json_summary(out, std::move(summary), results.inputs, results.scenario, files);
}

}  // namespace coupling::hazard
