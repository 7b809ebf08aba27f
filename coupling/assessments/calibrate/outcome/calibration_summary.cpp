#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/assessments/calibrate/outcome/calibration.hpp"
#include "coupling/results/figures/json.hpp"

namespace coupling::calibrate {
namespace {

using config::joined;

Json side_of(const Side& side) {
    return {{"count", side.observed},
            {"observed", json_number(side.figure)},
            {"predicted_p05", json_number(side.predicted.front())},
            {"predicted_p50", json_number(side.predicted[2])},
            {"predicted_p95", json_number(side.predicted.back())},
            {"energy_distance", json_number(side.distance)},
            {"as_far", json_number(side.as_far)}};
}

Json side_with_before(const Side& side) {
    Json json = side_of(side);
    json["before_p05"] = json_number(side.before.front());
    json["before_p95"] = json_number(side.before.back());
    return json;
}

const char* name_of(SearchEnd end) {
    switch (end) {
        case SearchEnd::close:
            return "close";
        case SearchEnd::few_kept:
            return "few_kept";
        case SearchEnd::budget:
            return "budget";
        case SearchEnd::few_sets:
            return "few_sets";
    }
    return "";
}

void add_if_far(const Observation& observation, const Side& side, const char* use,
                std::vector<FarAlone>& rows) {
    if (side.as_far < least_as_far) {  // not of NaN
        rows.push_back({observation, use, side.as_far});
    }
}

}  // namespace

std::vector<FarAlone> far_alone(const Calibration& calibration) {
    std::vector<FarAlone> rows;
    for (std::size_t i = 0; i < calibration.observations.size(); ++i) {
        const Judged& judged = calibration.judgement.observations[i];
        add_if_far(calibration.observations[i], judged.fit, "fitted", rows);
        add_if_far(calibration.observations[i], judged.held_out, "held out", rows);
    }
    return rows;
}

std::vector<FarAlone> far_alone(const Calibration& calibration, const Transfer& transfer) {
    std::vector<FarAlone> rows;
    std::size_t number = 0;
    for (const Observation& observation : calibration.observations) {
        if (observation.site == transfer.site) {
            add_if_far(observation, transfer.sides[number++], "", rows);
        }
    }
    return rows;
}

std::string reason_against(const Judgement& judgement, const SearchState& state) {
    if (judgement.is_calibrated) {
        return "";
    }
    if (state.end == SearchEnd::budget) {
        return "The search ended at calibrate.most_sets, before its sets came as near to what was observed "
               "as "
               "the model is to itself.";
    }
    if (state.end == SearchEnd::few_kept) {
        return "Hardly any set comes as near to what was observed as the model is to itself: something in "
               "the "
               "model, the sources, the block sizes or the observations does not fit.";
    }
    if (state.end == SearchEnd::few_sets) {
        return "The search ended before its goal: too few sets are left to draw others from; raise "
               "calibrate.sets.";
    }
    if (judgement.shows_too_few) {
        return "Too few simulated rocks show what was observed, so that distances say little: raise "
               "calibrate.rocks, or check sources and targets.";
    }
    if (!(judgement.fit_as_far >= least_as_far)) {
        return "What was fitted to is further away from the sets than 95 % of samples of the model itself.";
    }
    if (judgement.held_out > 0 && std::isnan(judgement.held_out_as_far)) {
        return "At one of the sites nothing that was held out can be judged, so nothing says whether the "
               "sets hold there beyond what they were fitted to.";
    }
    return judgement.held_out > 0
               ? "What was held out is further away from the sets than 95 % of samples of the model itself: "
                 "they do not hold beyond what they were fitted to."
               : "Nothing was held out, so nothing says whether the sets hold beyond what they were fitted "
                 "to.";
}

void write_summary(std::ostream& out, const Calibration& calibration, const std::vector<WrittenFile>& files) {
    const Judgement& judgement = calibration.judgement;
    const SearchState& state = calibration.state;
    Json summary{{"program", "Bannwald"}, {"version", calibration.version}};
    summary["run"] = {{"scenario", calibration.scenario.file.filename().string()},
                      {"kind", "calibrate"},
                      {"seed", calibration.scenario.run.seed},
                      {"rocks_of_a_set", calibration.plan.rocks}};
    summary["calibrated"] = judgement.is_calibrated;
    summary["reason"] = reason_against(judgement, state);
    summary["search"] = {{"end", name_of(state.end)},
                         {"rounds", state.waves.size()},
                         {"tried", state.tried()},
                         {"kept", state.population.size()},
                         {"effective_sets", json_number(judgement.effective_sets)},
                         {"followed_by_regression", json_number(judgement.followed)},
                         {"goal", json_number(state.scale.at_90)}};
    if (calibration.plan.emulates) {
        Json by_observation = Json::array();
        for (const RuledOut& each : judgement.ruled_out) {
            by_observation.push_back(
                {{"site", calibration.site_of(calibration.observations[each.observation]).name},
                 {"observation", calibration.observations[each.observation].name},
                 {"ruled_out", json_number(each.share)},
                 {"explained", json_number(each.explained)}});
        }
        summary["emulator"] = {{"ruled_out", json_number(1.0 - state.left())},
                               {"not_run", state.ruled.not_run()},
                               {"beyond", state.ruled.beyond},
                               {"beyond_kept", state.ruled.beyond_kept},
                               {"beyond_weight", json_number(state.ruled.beyond_weight)},
                               {"observations", by_observation}};
    }
    // Of several sites no share: the least of them times their number (Bonferroni).
    const std::string of_sites = calibration.has_several_sites() ? "least_of_sites_times_their_number_" : "";
    summary[joined(of_sites, "fit_as_far")] = json_number(judgement.fit_as_far);
    summary["held_out"] = judgement.held_out;
    summary[joined(of_sites, "held_out_as_far")] = json_number(judgement.held_out_as_far);
    Json sites = Json::array();
    for (std::size_t i = 0; i < judgement.sites.size(); ++i) {
        const SiteCase& of_site = *calibration.sites[i];
        Json site{{"site", of_site.name},
                  {"scenario", of_site.scenario.file.filename().string()},
                  {"fit_as_far", json_number(judgement.sites[i].fit_as_far)},
                  {"held_out_as_far", json_number(judgement.sites[i].held_out_as_far)}};
        if (!judgement.transfers.empty()) {
            const Transfer& transfer = judgement.transfers[i];
            Json observed = Json::array();
            for (std::size_t k = 0; k < transfer.sides.size(); ++k) {
                observed.push_back({{"observation", of_site.observations[k].name},
                                    {"predicted", side_of(transfer.sides[k])}});
            }
            site["by_other_sites"] = {{"holds", transfer.verdict() == TransferVerdict::holds},
                                      {"shows_too_few", transfer.shows_too_few},
                                      {"end", name_of(transfer.end)},
                                      {"tried", transfer.tried},
                                      {"as_far", json_number(transfer.as_far)},
                                      {"least_as_far", json_number(transfer.least_as_far())},
                                      {"observations", observed}};
        }
        sites.push_back(std::move(site));
    }
    summary["sites"] = sites;
    Json parameters = Json::array();
    for (const Learned& learned : judgement.parameters) {
        parameters.push_back({{"parameter", learned.component.parameter},
                              {"ground", learned.component.ground},
                              {"site", calibration.users_of(parameters.size())},
                              {"width_before", json_number(learned.component.width)},
                              {"factor_p50", json_number(learned.median)},
                              {"factor_p05", json_number(learned.low)},
                              {"factor_p95", json_number(learned.high)},
                              {"learned", json_number(learned.learned)},
                              {"learned_by_chance", json_number(learned.by_chance)},
                              {"beyond_chance", learned.is_beyond_chance()},
                              {"partner", learned.partner},
                              {"correlation", json_number(learned.correlation)}});
    }
    summary["parameters"] = parameters;
    Json observations = Json::array();
    for (std::size_t i = 0; i < calibration.observations.size(); ++i) {
        const Judged& judged = judgement.observations[i];
        observations.push_back({{"site", calibration.site_of(calibration.observations[i]).name},
                                {"observation", calibration.observations[i].name},
                                {"fit", side_with_before(judged.fit)},
                                {"held_out", side_with_before(judged.held_out)}});
    }
    summary["observations"] = observations;
    summary["warnings"] = calibration.warnings.warnings();
    summary["notes"] = calibration.warnings.notes();
    write_json_summary(out, std::move(summary), calibration.inputs, calibration.scenario, files);
}

}  // namespace coupling::calibrate
