#include "config/units/constants.hpp"
#include "coupling/assessments/decades/decade_results.hpp"
#include "coupling/assessments/decades/risk/risk_years_json.hpp"
#include "coupling/assessments/decades/tables/departures_over_years.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/figures/few_rocks.hpp"
#include "coupling/results/figures/json.hpp"

namespace coupling::decades {
namespace {

using config::percent;

Json stand(const StandRow& row) {
    const forest::StandFigures& f = row.figures;
    return {{"stems_pha", json_number(f.stems_pha)},
            {"basal_area_m2pha", json_number(f.basal_area_m2pha)},
            {"volume_m3pha", json_number(f.volume_m3pha)},
            {"dominant_height_m", json_number(f.dominant_height_m)},
            {"leaf_area_index", json_number(f.leaf_area_index)}};
}

/// The whole forest at the start and at the end, and the targets in the first and last year with rocks.
Json member(const DecadeResults& results, const MemberYears& years) {
    Json json{{"regime", results.names.regimes[years.member.regime]},
              {"climate", results.names.climates[years.member.climate]},
              {"replicate", years.member.replicate + 1}};
    const auto last_year = static_cast<std::int32_t>(results.scenario.run.years);
    for (const StandRow& row : years.stands) {
        if (row.unit == all && row.species == all && (row.year == 0 || row.year == last_year)) {
            json[row.year == 0 ? "stand_at_start" : "stand_at_end"] = stand(row);
        }
    }
    json["targets"] = Json::array();
    for (const TargetRow& row : years.targets) {
        if (row.year == years.targets.front().year || row.year == years.targets.back().year) {
            Json target{{"id", results.site.targets[row.target].id},
                        {"year", row.year},
                        {"rocks", row.bare.share.whole},
                        {"reached_bare", row.paired.bare()},
                        {"reached_forest", row.paired.forest()}};
            const auto effect = protection_effect(row.paired);
            target["protection_percent"] = effect ? json_number(percent * effect->value) : Json(nullptr);
            target["too_few_rocks"] = too_few_for_protection(row.paired);
            target["above_energies_bare"] = json_above_energies(row.bare.above);
            target["above_energies_forest"] = json_above_energies(row.forest.above);
            json["targets"].push_back(std::move(target));
        }
    }
    return json;
}

}  // namespace

void write_summary(std::ostream& out, const DecadeResults& results, const std::vector<WrittenFile>& files) {
    Json summary{{"program", "Bannwald"}, {"version", results.version}};
    const forest::PatchGrid& grid = results.site.forest->grid;
    summary["run"] = {{"scenario", results.scenario.file.filename().string()},
                      {"kind", "years"},
                      {"seed", results.scenario.run.seed},
                      {"years", results.scenario.run.years},
                      {"first_calendar_year", results.site.forest->first_year()},
                      {"regimes", results.names.regimes},
                      {"climates", results.names.climates},
                      {"replicates", results.scenario.forest.replicates},
                      {"member_years", results.members.size() * results.scenario.run.years},
                      {"simulated_member_years", results.simulated_years},
                      {"rocks_a_year", results.rocks},
                      {"patches", grid.size()},
                      {"area_ha", json_number(grid.area_ha())},
                      {"map", json_map_frame(results.site.map_frame)},
                      {"patch_map", json_map_frame(grid.frame())}};
    if (results.rocks > 0) {
        for (const Cover cover : all_covers) {
            summary["left_terrain"][name_of(cover)] =
                json_departures(departures_over_years(results.members, cover, results.site.slope.terrain));
        }
    }
    summary["verdict"] = verdict_of(results);
    if (results.risk != nullptr) {
        summary["risk"] =
            risk_years_json(results.names, *results.risk, results.scenario.forest.decision.discount_percent);
    }
    summary["members"] = Json::array();
    for (const MemberYears& years : results.members) {
        summary["members"].push_back(member(results, years));
    }
    summary["warnings"] = results.warnings.warnings();
    summary["notes"] = results.warnings.notes();
    write_json_summary(out, std::move(summary), results.site.inputs, results.scenario, files);
}

}  // namespace coupling::decades
