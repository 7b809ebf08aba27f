#include "config/units/constants.hpp"
#include "coupling/assessments/profile/falls/profile_departures.hpp"
#include "coupling/assessments/profile/profile_results.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/figures/drawn_json.hpp"
#include "coupling/results/figures/json.hpp"

namespace coupling::profile {
namespace {

using config::j_per_kj;

Json moments(const Moments& m, double unit) {
    return {{"mean", json_number(m.mean() / unit)},
            {"sd", json_number(m.deviation() / unit)},
            {"min", json_number(m.least() / unit)},
            {"max", json_number(m.most() / unit)}};
}

Json spread(const Spread& s, const rockfall::LogBins& bins, double unit) {
    Json json = moments(s.moments, unit);
    json["p50"] = json_number(s.quantile(bins, 0.50) / unit);
    json["p90"] = json_number(s.quantile(bins, 0.90) / unit);
    json["p95"] = json_number(s.quantile(bins, 0.95) / unit);
    json["p99"] = json_number(s.quantile(bins, 0.99) / unit);
    return json;
}

Json along_profile(const ProfileTally& tally) {
    using namespace rockfall;
    Json stops;
    for (std::size_t reason = 0; reason < tally.by_reason.size(); ++reason) {
        stops[name_of(static_cast<StopReason>(reason))] =
            json_share(share_of(tally.by_reason[reason], tally.rocks));
    }
    return {{"stop_reasons", stops},
            {"stopped", json_share(share_of(tally.run_out_m.count(), tally.rocks))},
            {"left_terrain", json_departures(tally)},
            {"run_out_m", moments(tally.run_out_m, 1.0)},
            {"run_out_at_least_m", moments(tally.run_out_at_least_m, 1.0)},
            {"max_speed_mps", spread(tally.max_speed_mps, fine_speed_bins, 1.0)},
            {"max_energy_kj", spread(tally.max_energy_j, fine_energy_bins, j_per_kj)},
            {"max_height_m", spread(tally.max_height_m, fine_height_bins, 1.0)},
            {"mean_speed_mps", moments(tally.mean_speed_mps, 1.0)},
            {"ground_impacts_per_rock", moments(tally.ground_impacts, 1.0)},
            {"jump_length_m", moments(tally.jump_length_m, 1.0)}};
}

Json stations_json(const ProfileResults& results) {
    using namespace rockfall;
    Json list = Json::array();
    for (std::size_t i = 0; i < results.site.stations.size(); ++i) {
        const StationTally& tally = results.tally.stations[i];
        list.push_back(
            {{"name", results.site.stations[i].name},
             {"distance_m", json_number(results.site.stations[i].distance_m)},
             {"reached", json_share(share_of(tally.energy_j.moments.count(), results.tally.rocks))},
             {"energy_kj", spread(tally.energy_j, fine_energy_bins, j_per_kj)},
             {"above_energies", json_above_energies(rates_of(tally, results.tally.rocks))},
             {"translational_kj", moments(tally.translational_j, j_per_kj)},
             {"speed_mps", spread(tally.speed_mps, fine_speed_bins, 1.0)},
             {"height_m", spread(tally.height_m, fine_height_bins, 1.0)}});
    }
    return list;
}

/// Both intervals of the main figures, and what was drawn.
Json with_parameters(const ProfileIntervals& intervals, const ProfileResults& results) {
    const ParameterDraws& draws = results.draws;
    Json json = json_draws(draws);
    json["run_out_mean_m"] = json_drawn(intervals.run_out_mean_m, draws, 1.0);
    json["stations"] = Json::array();
    for (std::size_t i = 0; i < intervals.stations.size(); ++i) {
        const ProfileIntervals::AtStation& at = intervals.stations[i];
        json["stations"].push_back({{"name", results.site.stations[i].name},
                                    {"reached_percent", json_drawn(at.share, draws, config::percent)},
                                    {"energy_mean_kj", json_drawn(at.energy_mean_kj, draws, 1.0)},
                                    {"energy_95_kj", json_drawn(at.energy_95_kj, draws, 1.0)},
                                    {"speed_mean_mps", json_drawn(at.speed_mean_mps, draws, 1.0)},
                                    {"height_95_m", json_drawn(at.height_95_m, draws, 1.0)}});
    }
    return json;
}

}  // namespace

void write_summary(std::ostream& out, const ProfileResults& results, const std::vector<WrittenFile>& files) {
    const ProfileTally& tally = results.tally;
    Json summary{{"program", "Bannwald"}, {"version", results.version}};
    summary["run"] = {{"scenario", results.scenario.file.filename().string()},
                      {"kind", "profile"},
                      {"seed", results.scenario.run.seed},
                      {"rocks", tally.rocks},
                      {"from_m", json_number(results.site.first_m())},
                      {"to_m", json_number(results.site.last_m())},
                      {"start_m", json_number(results.site.start_m)}};
    summary["slope"] = along_profile(tally);
    summary["stations"] = stations_json(results);
    if (results.intervals) {
        summary["with_parameters"] = with_parameters(*results.intervals, results);
    }
    summary["warnings"] = results.warnings.warnings();
    summary["notes"] = results.warnings.notes();
    write_json_summary(out, std::move(summary), results.site.inputs, results.scenario, files);
}

}  // namespace coupling::profile
