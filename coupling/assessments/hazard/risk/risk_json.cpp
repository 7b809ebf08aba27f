#include "config/text/joined.hpp"
#include "coupling/assessments/hazard/risk/risk_results.hpp"
#include "coupling/results/figures/figures.hpp"

namespace coupling::hazard::risk {
namespace {

Json json_estimate(const Estimate& estimate) {
    return {{"value", json_number(estimate.value)},
            {"low", json_number(estimate.low)},
            {"high", json_number(estimate.high)}};
}

Json json_slope(const SlopeRisk& slope, bool of_one_place) {
    Json json{{"arrivals_per_year", json_estimate(slope.at(Quantity::arrivals))},
              {"vehicles_hit_per_year", json_estimate(slope.at(Quantity::vehicles_hit))},
              {"deaths_per_year", json_estimate(slope.at(Quantity::deaths))},
              {"damage_per_year", json_estimate(slope.at(Quantity::damage))},
              {"closure_days_per_year", json_estimate(slope.at(Quantity::closure_days))},
              {"closure_cost_per_year", json_estimate(slope.at(Quantity::closure))},
              {"money_per_year", json_estimate(slope.at(Quantity::money))}};
    if (slope.all_money) {
        json["money_per_year"]["all_low"] = json_number(slope.all_money->low);
        json["money_per_year"]["all_high"] = json_number(slope.all_money->high);
    }
    if (of_one_place) {
        json["individual_risk_per_year"] = json_estimate(slope.at(Quantity::individual_risk));
    }
    return json;
}

Json json_place(const RiskResults& results, const PlaceRisk& risk, bool of_one_place) {
    Json json = Json::object();
    for (const Cover cover : results.slopes) {
        json[name_of(cover)] = json_slope(risk.slopes[coupling::index_of(cover)], of_one_place);
    }
    if (results.with_forest()) {
        json["spared_money_per_year"] = json_estimate(risk.spared_money);
        json["spared_deaths_per_year"] = json_estimate(risk.spared_deaths);
    }
    return json;
}

}  // namespace

Json risk_json(const RiskResults& results, const Site& site) {
    const RiskSettings& settings = results.settings;
    Json json{{"currency", settings.currency},
              {"prevented_death", json_number(settings.prevented_death)},
              {"own_curves", !settings.curves.empty()},
              {"interval", "95 %, chance of the simulated rocks"},
              {"all_targets", json_place(results, results.all, false)},
              {"targets", Json::array()}};
    for (const TargetRisk& target : results.targets) {
        Json one = json_place(results, target.risk, true);
        one["id"] = site.targets[target.target].id;
        one["use"] = target.exposure.is_road() ? "road" : "house";
        json["targets"].push_back(std::move(one));
    }
    if (results.avoided) {
        json["nets_and_works"] = avoided_json(results);
    }
    return json;
}

}  // namespace coupling::hazard::risk
