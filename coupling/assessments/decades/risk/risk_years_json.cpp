#include "coupling/assessments/decades/risk/risk_years_json.hpp"

#include <utility>

#include "coupling/results/figures/figures.hpp"

namespace coupling::decades {
namespace {

using consequences::Quantity;

Json json_risk_band(const Band& band) {
    return {
        {"value", json_number(band.mean)}, {"low", json_number(band.low)}, {"high", json_number(band.high)}};
}

Json json_risk_at_place(const RiskAtPlace& place, Cover cover, std::size_t course, double discount_percent) {
    const auto mean = mean_risk(place, cover, course);
    if (!mean) {
        return nullptr;
    }
    Json json{{"arrivals_per_year", json_risk_band(mean->at(Quantity::arrivals))},
              {"vehicles_hit_per_year", json_risk_band(mean->at(Quantity::vehicles_hit))},
              {"deaths_per_year", json_risk_band(mean->at(Quantity::deaths))},
              {"damage_per_year", json_risk_band(mean->at(Quantity::damage))},
              {"closure_days_per_year", json_risk_band(mean->at(Quantity::closure_days))},
              {"closure_cost_per_year", json_risk_band(mean->at(Quantity::closure))},
              {"money_per_year", json_risk_band(mean->at(Quantity::money))},
              {"present_value", json_risk_band(present_value_band(place, cover, course, discount_percent))}};
    if (place.id != all_targets) {
        json["individual_risk_per_year"] = json_risk_band(mean->at(Quantity::individual_risk));
    }
    return json;
}

Json json_risk_of_course(const RiskOverYears& risk, Cover cover, std::size_t course,
                         double discount_percent) {
    Json json{{"all_targets", json_risk_at_place(risk.all, cover, course, discount_percent)},
              {"targets", Json::array()}};
    for (const RiskAtPlace& place : risk.targets) {
        Json one{{"id", place.id}};
        one["figures"] = json_risk_at_place(place, cover, course, discount_percent);
        json["targets"].push_back(std::move(one));
    }
    return json;
}

}  // namespace

Band present_value_band(const RiskAtPlace& place, Cover cover, std::size_t course, double discount_percent) {
    std::vector<double> values;
    for (const RiskByYear& replicate : place.at(cover, course)) {
        values.push_back(present_value_of_risk(replicate, discount_percent));
    }
    return band_of(std::move(values), not_negative);
}

Json risk_years_json(const Names& names, const RiskOverYears& risk, double discount_percent) {
    Json json{{"currency", risk.plan.settings.currency},
              {"rocks_per_year", json_number(risk.rocks_per_year)},
              {"prevented_death", json_number(risk.plan.settings.prevented_death)},
              {"own_curves", !risk.plan.settings.curves.empty()},
              {"discount_percent", json_number(discount_percent)},
              {"interval", "90 %, mean of the replicates"},
              {"years", "mean of those after the start"},
              {"bare", json_risk_of_course(risk, Cover::bare, 0, discount_percent)},
              {"regimes", Json::array()}};
    for (std::size_t course = 0; course < names.courses(); ++course) {
        Json one{{"regime", names.regimes[names.regime_of(course)]},
                 {"climate", names.climates[names.climate_of(course)]}};
        one.update(json_risk_of_course(risk, Cover::forest, course, discount_percent));
        json["regimes"].push_back(std::move(one));
    }
    return json;
}

}  // namespace coupling::decades
