#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "config/text/joined.hpp"
#include "coupling/assessments/hazard/risk/risk_results.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/figures/figures.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::hazard::risk {
namespace {

using config::joined;
using report::page_text;
using report::PageFields;

constexpr std::size_t most_rows = 10;

/// "⁻⁵".
std::string raised(int exponent) {
    constexpr std::array digits{"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
    std::string text;
    for (const char digit : std::to_string(exponent)) {
        text += digit == '-' ? "\u207b" : digits.at(static_cast<std::size_t>(digit - '0'));
    }
    return text;
}

std::string amount_of(double amount, const RiskSettings& settings) {
    return joined(report::three_digits(amount), "\u00a0", settings.currency);
}

std::string targets_in_words(std::size_t targets) {
    return targets == 1 ? page_text("the exposed target")
                        : page_text("the {count} exposed targets", {{"count", report::grouped(targets)}});
}

const std::string& words_of(Cover cover) {
    return page_text(cover == Cover::forest ? "With forest" : "Bare slope");
}

std::vector<PageFields> slopes_of(const RiskResults& results) {
    std::vector<PageFields> slopes;
    for (const Cover cover : results.slopes) {
        const SlopeRisk& slope = results.all.slopes[coupling::index_of(cover)];
        const Estimate& money = slope.at(Quantity::money);
        slopes.push_back({{"slope", words_of(cover)},
                          {"money", amount_of(money.value, results.settings)},
                          {"targets", targets_in_words(results.targets.size())},
                          {"low", report::three_digits(money.low)},
                          {"high", report::three_digits(money.high)},
                          {"deaths", rate_text(slope.at(Quantity::deaths).value)}});
    }
    return slopes;
}

std::optional<PageFields> spared_by_forest(const RiskResults& results) {
    if (!results.with_forest()) {
        return std::nullopt;
    }
    const Estimate& spared = results.all.spared_money;
    const bool is_gain = spared.low > 0.0;
    const double sign = spared.high < 0.0 ? -1.0 : 1.0;
    const auto [low, high] = std::minmax(sign * spared.low, sign * spared.high);
    return PageFields{{"is_clear", is_gain || spared.high < 0.0},
                      {"is_gain", is_gain},
                      {"amount", amount_of(sign * spared.value, results.settings)},
                      {"low", report::three_digits(low)},
                      {"high", amount_of(high, results.settings)}};
}

/// What targets.file says of a target.
std::string exposure_in_words(const TargetExposure& of, const RiskSettings& settings) {
    std::vector<std::string> parts;
    if (of.is_road()) {
        parts.push_back(
            page_text("{vehicles} vehicles a day, {speed} km/h, {persons} persons in each, {length} m",
                      {{"vehicles", report::exact(*of.vehicles_per_day)},
                       {"speed", report::exact(of.speed_kmph.value())},
                       {"persons", report::exact(of.persons_per_vehicle.value())},
                       {"length", report::exact(of.vehicle_length_m.value_or(settings.vehicle_length_m))}}));
    }
    if (of.persons) {
        parts.push_back(page_text(
            "{persons} persons, {hours} h a day",
            {{"persons", report::exact(*of.persons)}, {"hours", report::exact(of.hours_per_day.value())}}));
    }
    if (of.house_value) {
        parts.push_back(page_text("worth {amount}", {{"amount", joined(report::exact(*of.house_value),
                                                                       "\u00a0", settings.currency)}}));
    }
    return report::join_with_commas(parts);
}

PageFields row_of(const RiskResults& results, const TargetRisk& target, const std::string& name) {
    const bool is_road = target.exposure.is_road();
    std::vector<PageFields> answers;
    for (const Cover cover : results.slopes) {
        const SlopeRisk& slope = target.risk.slopes[coupling::index_of(cover)];
        const Estimate& money = slope.at(Quantity::money);
        answers.push_back(
            {{"name", name},
             {"exposure", exposure_in_words(target.exposure, results.settings)},
             {"slope", words_of(cover)},
             {"arrivals", rate_text(slope.at(Quantity::arrivals).value)},
             {"individual", rate_text(slope.at(Quantity::individual_risk).value)},
             {"deaths", rate_text(slope.at(Quantity::deaths).value)},
             {"damage", is_road ? std::string{"–"} : report::three_digits(slope.at(Quantity::damage).value)},
             {"closure",
              is_road ? report::three_digits(slope.at(Quantity::closure).value) : std::string{"–"}},
             {"money", amount_of(money.value, results.settings)},
             {"money_low", report::three_digits(money.low)},
             {"money_high", report::three_digits(money.high)}});
    }
    return {{"answers", answers}};
}

std::vector<PageFields> rows_of_curves(const Curves& curves) {
    std::vector<PageFields> rows;
    for (const CurveClass& each : curves.classes()) {
        rows.push_back({{"from_kj", report::exact(each.energy_from_kj)},
                        {"in_vehicle", report::exact(each.lethality_in_vehicle)},
                        {"in_house", report::exact(each.lethality_in_house)},
                        {"damage_share", report::exact(each.damage_to_house)}});
    }
    return rows;
}

}  // namespace

std::string rate_text(double rate) {
    constexpr double least_plain = 0.001;
    if (rate == 0.0 || rate >= least_plain) {
        return report::three_digits(rate);
    }
    constexpr double ten = 10.0;
    constexpr double rounds_to_ten = 9.95;
    double exponent = std::floor(std::log10(rate));
    if (rate / std::pow(ten, exponent) >= rounds_to_ten) {
        exponent += 1.0;
    }
    return joined(report::fixed(rate / std::pow(ten, exponent), 1), "\u00a0·\u00a010",
                  raised(static_cast<int>(exponent)));
}

PageFields risk_fields(const RiskResults& results, const Site& site, const Scenario& scenario) {
    const RiskSettings& settings = results.settings;
    const std::vector<std::size_t> order = results.ranked();
    std::vector<PageFields> rows;
    for (std::size_t k = 0; k < std::min(most_rows, order.size()); ++k) {
        const TargetRisk& target = results.targets[order[k]];
        rows.push_back(row_of(results, target, site.targets[target.target].name));
    }
    const auto any = [&](bool (TargetExposure::*is)() const) {
        return std::any_of(results.targets.begin(), results.targets.end(),
                           [&](const TargetRisk& target) { return (target.exposure.*is)(); });
    };
    return {{"slopes", slopes_of(results)},
            {"spared", spared_by_forest(results)},
            {"shipped_curves", settings.curves.empty()},
            {"curves_file", scenario.shown(settings.curves)},
            {"more_targets", results.targets.size() > most_rows},
            {"rows_shown", report::grouped(rows.size())},
            {"targets_all", report::grouped(results.targets.size())},
            {"with_forest", results.with_forest()},
            {"rows", rows},
            {"with_roads", any(&TargetExposure::is_road)},
            {"with_houses", any(&TargetExposure::is_house)},
            {"with_closure", settings.closure_days > 0.0},
            {"length", report::exact(settings.vehicle_length_m)},
            {"passages", report::exact(settings.passages_per_day)},
            {"closure_days", report::exact(settings.closure_days)},
            {"closure_cost", amount_of(settings.closure_cost_per_day, settings)},
            {"prevented_death", joined(report::exact(settings.prevented_death), "\u00a0", settings.currency)},
            {"curve_rows", rows_of_curves(results.curves)}};
}

}  // namespace coupling::hazard::risk
