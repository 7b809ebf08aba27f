#include <algorithm>

#include "coupling/assessments/collapse/building_damage.hpp"
#include "coupling/assessments/collapse/collapse_results.hpp"
#include "coupling/assessments/collapse/handed_departures.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/figures/json.hpp"

namespace coupling::collapse {
namespace {

/// What single blocks took out of the mass, and where it went: up to the end of each, which may lie behind
/// that of the run.
Json json_hand_over(const CollapseResults& results) {
    double volume_m3 = 0.0, given_j = 0.0, dissipated_j = 0.0, corrected_j = 0.0, residual_j = 0.0;
    double motion_end_j = 0.0, motion_at_return_j = 0.0, lift_j = 0.0, largest_lift_m = 0.0;
    std::uint64_t percussions = 0, unsolved = 0, started_again = 0;
    const HandOver& hand_over = results.hand_over;
    for (std::size_t i = 0; i < results.site.count.free; ++i) {
        volume_m3 += hand_over.was_ever_single(i) ? results.mass.blocks()[i].volume_m3 : 0.0;
    }
    for (std::size_t f = 0; f < hand_over.falls().size(); ++f) {
        const HandedFall& fall = hand_over.falls()[f];
        if (const auto& back = hand_over.return_of(f)) {
            started_again += fall.has_ended ? 1 : 0;
            motion_at_return_j += fall.motion_end_j;
            lift_j += hand_over.lift_given_j(f, results.mass);
            largest_lift_m = std::max(largest_lift_m, back->taken.lift_m);
        }
        given_j += fall.start_j;
        motion_end_j += fall.motion_end_j;
        dissipated_j += fall.end.dissipated_j;
        corrected_j += fall.end.corrected_j;
        residual_j += fall.end.residual_j;
        percussions += fall.end.percussions;
        unsolved += fall.end.unsolved;
    }
    const auto& ledger = results.record.rows.back().ledger;
    return {{"blocks", hand_over.blocks()},
            {"falls", hand_over.falls().size()},
            {"returns", hand_over.returns()},
            {"returns_from_rest", started_again},
            {"left_terrain", json_departures(departures_of_single_blocks(results.hand_over, results.site))},
            {"volume_m3", json_number(volume_m3)},
            {"motion_mj", json_number(ledger.handed_motion_j / 1e6)},
            {"gravity_mj", json_number(ledger.handed_gravity_j / 1e6)},
            {"strain_lost_mj", json_number(ledger.handed_strain_j / 1e6)},
            {"motion_back_mj", json_number(ledger.back_motion_j / 1e6)},
            {"gravity_back_mj", json_number(ledger.back_gravity_j / 1e6)},
            {"strain_back_mj", json_number(ledger.back_strain_j / 1e6)},
            {"motion_at_return_mj", json_number(motion_at_return_j / 1e6)},
            {"lift_given_mj", json_number(lift_j / 1e6)},
            {"largest_lift_m", json_number(largest_lift_m)},
            {"given_mj", json_number(given_j / 1e6)},
            {"dissipated_mj", json_number(dissipated_j / 1e6)},
            {"corrected_mj", json_number(corrected_j / 1e6)},
            {"motion_at_end_mj", json_number(motion_end_j / 1e6)},
            {"residual_mj", json_number(residual_j / 1e6)},
            {"percussions", percussions},
            {"unsolved", unsolved}};
}

}  // namespace

void write_summary(std::ostream& out, const CollapseResults& results, const std::vector<WrittenFile>& files) {
    const KeyFigures figures = key_figures(results);
    const BlockCount& count = results.site.count;
    const Scenario& scenario = results.scenario.scenario;
    Json summary{{"program", "Bannwald"}, {"version", results.version}};
    summary["run"] = {
        {"scenario", scenario.file.filename().string()}, {"kind", "collapse"}, {"seed", scenario.run.seed}};
    summary["mass"] = {{"blocks", count.free},
                       {"fixed_blocks", count.fixed},
                       {"bonds", count.bonds},
                       {"open_faces", count.open_faces},
                       {"volume_m3", json_number(count.body_m3)},
                       {"blocks_m3", json_number(count.blocks_m3)},
                       {"left_out_m3", json_number(count.left_out_m3)},
                       {"slivers_merged", count.merged},
                       {"step_s", json_number(results.mass.step_s())}};
    if (const auto scaled = results.mass.scaled_mass(); scaled.blocks > 0) {
        summary["mass_added"] = {{"blocks", scaled.blocks},
                                 {"largest_factor", json_number(scaled.largest_factor)},
                                 {"percent_of_the_mass", json_number(100.0 * scaled.added_share)}};
    }
    summary["collapse"] = {{"duration_s", figures.duration_s ? json_number(*figures.duration_s) : Json{}},
                           {"simulated_s", json_number(results.record.rows.back().time_s)},
                           {"peak_mean_speed_mps", json_number(figures.peak_mean_speed_mps)},
                           {"peak_time_s", json_number(figures.peak_time_s)},
                           {"largest_speed_mps", json_number(figures.largest_speed_mps)},
                           {"front_m", json_number(figures.front_m)},
                           {"area_m2", json_number(figures.area_m2)},
                           {"blocks_left_terrain", figures.left},
                           {"volume_left_terrain_percent", json_number(100.0 * figures.left_share)},
                           {"bonds_intact", results.mass.bonds_intact()},
                           {"moving_percent_at_end", json_number(100.0 * figures.moving_share)},
                           {"residual_percent", json_number(100.0 * figures.largest_residual)}};
    if (results.hands_over()) {
        summary["hand_over"] = json_hand_over(results);
    }
    Json targets = Json::array();
    for (std::size_t t = 0; t < results.site.targets.size(); ++t) {
        std::size_t blocks = 0;
        double largest_j = 0.0;
        for (const TargetHit& hit : results.record.hits) {
            if (hit.target == static_cast<double>(t)) {
                ++blocks;
                largest_j = std::max(largest_j, hit.energy_j);
            }
        }
        targets.push_back({{"target_id", results.site.targets[t].id},
                           {"blocks", blocks},
                           {"largest_energy_kj", json_number(largest_j / 1e3)}});
    }
    summary["targets"] = targets;
    Json buildings = Json::array();
    for (const BuildingDamage& damage : building_damage(results)) {
        buildings.push_back({{"target_id", results.site.targets[damage.target].id},
                             {"floor_m2", json_number(damage.floor_m2)},
                             {"reached_m2", json_number(damage.reached_m2)},
                             {"reached_30_kj_m2", json_number(damage.reached_low_m2)},
                             {"reached_300_kj_m2", json_number(damage.reached_high_m2)},
                             {"largest_energy_kj", json_number(damage.largest_on_wall_j() / 1e3)},
                             {"energy_sum_mj", json_number(damage.energy_on_walls_j() / 1e6)}});
    }
    summary["buildings"] = buildings;
    summary["map"] = json_map_frame(results.site.map_frame);
    summary["warnings"] = results.warnings.warnings();
    summary["notes"] = results.warnings.notes();
    write_json_summary(out, std::move(summary), results.site.inputs, scenario, files);
}

}  // namespace coupling::collapse
