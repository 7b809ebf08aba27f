#include "coupling/assessments/today/summary.hpp"

#include "config/units/constants.hpp"
#include "coupling/assessments/today/observed_events.hpp"
#include "coupling/assessments/today/observed_stops.hpp"
#include "coupling/assessments/works/work_tables.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/figures/departures.hpp"
#include "coupling/results/figures/drawn_json.hpp"
#include "coupling/results/figures/few_rocks.hpp"
#include "coupling/results/figures/json.hpp"

namespace coupling {
namespace {

using config::percent;

Json arrivals(const ArrivalFigures& figures) {
    return {{"reached", json_share(figures.share)},
            {"energy_kj", json_distribution(figures.energy_kj, true)},
            {"above_energies", json_above_energies(figures.above)},
            {"speed_mps", json_distribution(figures.speed_mps, true)},
            {"height_m", json_distribution(figures.height_m, true)},
            {"top_height_m", json_distribution(figures.top_height_m, true)}};
}

Json protection(const TargetFigures& target) {
    if (!target.protection) {
        return nullptr;
    }
    const ProtectionEffect& effect = *target.protection;
    Json json{{"effect_percent", json_number(percent * effect.value)},
              {"interval_95_percent", json_interval(effect.interval, percent)},
              {"interval_is_one_sided", effect.one_sided},
              {"too_few_rocks", too_few_for_protection(target.paired)},
              {"reached_both", target.paired.both},
              {"reached_only_bare", target.paired.only_bare},
              {"reached_only_forest", target.paired.only_forest}};
    if (!effect.one_sided) {
        json["rocks_for_half_interval"] = rocks_for_half(target.at(Cover::bare).share.whole);
    }
    if (target.reduction) {
        json["bari_percent"] = json_number(target.reduction->bari_percent);
        json["miri_percent"] = json_number(target.reduction->miri_percent);
        json["orpi_percent"] = json_number(target.reduction->orpi_percent);
    }
    return json;
}

Json targets(const Figures& figures, const std::vector<Cover>& covers) {
    Json list = Json::array();
    for (const TargetFigures& target : figures.targets) {
        Json json{{"id", target.id}, {"name", target.name}, {"kind", target.is_area ? "area" : "line"}};
        for (const Cover cover : covers) {
            json[name_of(cover)] = arrivals(target.at(cover));
        }
        json["protection"] = protection(target);
        list.push_back(std::move(json));
    }
    return list;
}

Json slope(const SlopeFigures& figures, const Departures& departures) {
    Json stops;
    for (std::size_t reason = 0; reason < figures.by_reason.size(); ++reason) {
        stops[name_of(static_cast<rockfall::StopReason>(reason))] = json_share(figures.by_reason[reason]);
    }
    Json json{{"rocks", figures.rocks},
              {"stop_reasons", stops},
              {"stopped", json_share(figures.stopped)},
              {"left_terrain", json_departures(departures)},
              {"run_out_m", json_distribution(figures.run_out_m, false)},
              {"run_out_at_least_m", json_distribution(figures.run_out_at_least_m, false)},
              {"max_speed_mps", json_distribution(figures.max_speed_mps, true)},
              {"max_energy_kj", json_distribution(figures.max_energy_kj, true)},
              {"max_height_m", json_distribution(figures.max_height_m, true)},
              {"mean_speed_mps", json_number(figures.mean_speed_mps)},
              {"jump_height_mean_m", json_number(figures.jump_height_mean_m)},
              {"jumps_per_rock", json_number(figures.jumps_per_rock)},
              {"ground_impacts_per_rock", json_number(figures.ground_impacts_per_rock)},
              {"tree_hits_per_rock", json_number(figures.tree_hits_per_rock)},
              {"trees_broken_per_rock", json_number(figures.trees_broken_per_rock)},
              {"tree_energy_per_rock_kj", json_number(figures.tree_energy_per_rock_kj)},
              {"hit_a_tree", json_share(figures.hit_a_tree)},
              {"log_hits_per_rock", json_number(figures.log_hits_per_rock)},
              {"logs_broken_per_rock", json_number(figures.logs_broken_per_rock)},
              {"log_energy_per_rock_kj", json_number(figures.log_energy_per_rock_kj)}};
    if (figures.dissipated_per_rock_kj > 0.0) {
        json["energy_ledger"] = {{"dissipated_per_rock_kj", json_number(figures.dissipated_per_rock_kj)},
                                 {"residual_share", json_number(figures.ledger_residual)},
                                 {"overlap_work_share", json_number(figures.ledger_corrected)},
                                 {"unsolved_percussions", figures.unsolved_percussions}};
    }
    return json;
}

/// Both intervals of the main figures, and what was drawn.
Json drawn(const DrawnFigures& figures, const RunResults& results, const std::vector<Cover>& covers) {
    const ParameterDraws& draws = *results.draws;
    Json json = json_draws(draws);
    json["targets"] = Json::array();
    for (std::size_t i = 0; i < figures.targets.size(); ++i) {
        Json target{{"id", results.site.targets[i].id}};
        for (const Cover cover : covers) {
            const DrawnArrivals& at = figures.targets[i].by_cover[index_of(cover)];
            target[name_of(cover)] = {{"reached_percent", json_drawn(at.share, draws, percent)},
                                      {"energy_mean_kj", json_drawn(at.energy_mean_kj, draws, 1.0)},
                                      {"energy_95_kj", json_drawn(at.energy_95_kj, draws, 1.0)},
                                      {"height_95_m", json_drawn(at.height_95_m, draws, 1.0)}};
        }
        target["protection_percent"] = json_drawn(figures.targets[i].protection, draws, percent);
        json["targets"].push_back(std::move(target));
    }
    for (const Cover cover : covers) {
        const DrawnRunOut& run_out = figures.run_outs[index_of(cover)];
        json["slopes"][name_of(cover)] = {{"run_out_mean_m", json_drawn(run_out.mean_m, draws, 1.0)},
                                          {"run_out_95_m", json_drawn(run_out.p95_m, draws, 1.0)}};
    }
    return json;
}

Json run(const RunResults& results) {
    const Site& site = results.site;
    return {{"scenario", results.scenario.file.filename().string()},
            {"seed", results.scenario.run.seed},
            {"rocks", results.rocks},
            {"release_sources", site.sources.size()},
            {"trees", site.trees.size()},
            {"logs", site.logs.size()},
            {"nets", site.nets.size()},
            {"works", site.works.size()},
            {"with_forest", results.with_forest},
            {"map", json_map_frame(site.map_frame)},
            {"projection", site.projection.empty() ? Json(nullptr) : Json(site.projection)}};
}

}  // namespace

void write_summary(std::ostream& out, const RunResults& results, const Figures& figures,
                   const std::vector<WrittenFile>& files) {
    Json summary{{"program", "Bannwald"}, {"version", results.version}, {"run", run(results)}};
    const std::vector<Cover> covers = covers_of(results);
    summary["targets"] = targets(figures, covers);
    for (const Cover cover : covers) {
        summary["slopes"][name_of(cover)] = slope(figures.at(cover), departures_of(results, cover));
    }
    if (figures.drawn) {
        summary["with_parameters"] = drawn(*figures.drawn, results, covers);
    }
    if (!results.observed_stops.empty()) {
        summary["observed_stops"] = json_observed_stops(results.observed_stops);
    }
    if (!results.observed_events.empty()) {
        summary["observed_events"] = json_observed_events(results.observed_events);
    }
    if (!results.site.works.empty()) {
        summary["works"] = works_json(results);
    }
    summary["warnings"] = results.warnings.warnings();
    summary["notes"] = results.warnings.notes();
    write_json_summary(out, std::move(summary), results.site.inputs, results.scenario, files);
}

}  // namespace coupling
