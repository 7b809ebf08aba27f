#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "coupling/assessments/consequences/risk_words.hpp"
#include "coupling/assessments/hazard/risk/risk_results.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/figures/figures.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"

namespace coupling::hazard::risk {
namespace {

using consequences::amount_of;
using consequences::exposure_in_words;
using consequences::rate_text;
using consequences::slope_in_words;
using consequences::targets_in_words;
using report::PageFields;

constexpr std::size_t most_rows = 10;

/// Damage and closure, without what deaths are worth, and which of them is counted; nothing where neither is.
std::optional<PageFields> property_of(const SlopeRisk& slope, const RiskSettings& settings) {
    const double damage = slope.at(Quantity::damage).value;
    const double closure = slope.at(Quantity::closure).value;
    const bool has_damage = !std::isnan(damage);
    const bool has_closure = !std::isnan(closure);
    if (!has_damage && !has_closure) {
        return std::nullopt;
    }
    return PageFields{
        {"property_amount", amount_of((has_damage ? damage : 0.0) + (has_closure ? closure : 0.0), settings)},
        {"both", has_damage && has_closure},
        {"damage_alone", !has_closure},
        {"closure_alone", !has_damage}};
}

/// How many of the targets have what a quantity counts.
std::size_t targets_with(Quantity quantity, const RiskResults& results) {
    return static_cast<std::size_t>(
        std::count_if(results.targets.begin(), results.targets.end(), [&](const TargetRisk& target) {
            return consequences::has_what_counts(target.exposure, quantity, results.settings);
        }));
}

std::vector<PageFields> slopes_of(const RiskResults& results) {
    std::vector<PageFields> slopes;
    for (const Cover cover : results.slopes) {
        const SlopeRisk& slope = results.all.slopes[coupling::index_of(cover)];
        const Estimate& money = slope.at(Quantity::money);
        const Estimate& deaths = slope.at(Quantity::deaths);
        const bool has_persons = !std::isnan(deaths.value);
        const std::size_t with_persons = targets_with(Quantity::deaths, results);
        slopes.push_back(
            {{"slope", slope_in_words(cover)},
             {"targets", targets_in_words(results.targets.size())},
             {"with_persons", report::grouped(with_persons)},
             {"all_have_persons", with_persons == results.targets.size()},
             {"money", amount_of(money.value, results.settings)},
             {"low", report::three_digits(money.low)},
             {"high", report::three_digits(money.high)},
             {"persons", has_persons ? std::optional{PageFields{{"deaths", rate_text(deaths.value)},
                                                                {"deaths_low", rate_text(deaths.low)},
                                                                {"deaths_high", rate_text(deaths.high)}}}
                                     : std::nullopt},
             {"property", property_of(slope, results.settings)},
             {"with_all",
              slope.all_money ? std::optional{PageFields{
                                    {"all_low", report::three_digits(slope.all_money->low)},
                                    {"all_high", amount_of(slope.all_money->high, results.settings)}}}
                              : std::nullopt}});
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
    const auto [low, high] = std::minmax({sign * spared.low, sign * spared.high});
    return PageFields{{"is_clear", is_gain || spared.high < 0.0},
                      {"is_gain", is_gain},
                      {"amount", amount_of(sign * spared.value, results.settings)},
                      {"low", report::three_digits(low)},
                      {"high", amount_of(high, results.settings)}};
}

PageFields row_of(const RiskResults& results, const TargetRisk& target, const std::string& name) {
    std::vector<PageFields> answers;
    for (const Cover cover : results.slopes) {
        const SlopeRisk& slope = target.risk.slopes[coupling::index_of(cover)];
        const Estimate& money = slope.at(Quantity::money);
        answers.push_back({{"is_first", cover == results.slopes.front()},
                           {"name", name},
                           {"exposure", exposure_in_words(target.exposure, results.settings)},
                           {"slope", slope_in_words(cover)},
                           {"arrivals", rate_text(slope.at(Quantity::arrivals).value)},
                           {"individual", rate_text(slope.at(Quantity::individual_risk).value)},
                           {"deaths", rate_text(slope.at(Quantity::deaths).value)},
                           {"damage", report::three_digits(slope.at(Quantity::damage).value)},
                           {"closure", report::three_digits(slope.at(Quantity::closure).value)},
                           {"money", amount_of(money.value, results.settings)},
                           {"money_low", report::three_digits(money.low)},
                           {"money_high", report::three_digits(money.high)}});
    }
    return {{"answers", answers}};
}

/// Where the individual risk, on the slope as it is, is above the protection goal; nothing without persons.
std::optional<PageFields> against_goal(const RiskResults& results, const Site& site) {
    constexpr std::size_t most_named = 5;
    std::size_t with_persons = 0;
    std::size_t above = 0;
    std::vector<std::string> names;
    for (const std::size_t i : results.ranked()) {
        const TargetRisk& target = results.targets[i];
        const double risk = target.risk.slopes[coupling::index_of(results.slopes.front())]
                                .at(Quantity::individual_risk)
                                .value;
        with_persons += std::isnan(risk) ? 0 : 1;
        if (risk > results.settings.individual_goal && ++above <= most_named + 1) {
            names.push_back(above <= most_named ? site.targets[target.target].name : "…");
        }
    }
    return with_persons > 0 ? std::optional{PageFields{{"is_exceeded", above > 0},
                                                       {"goal", rate_text(results.settings.individual_goal)},
                                                       {"above", report::grouped(above)},
                                                       {"exposed", report::grouped(with_persons)},
                                                       {"names", report::join_with_commas(names)}}}
                            : std::nullopt;
}

}  // namespace

PageFields risk_fields(const RiskResults& results, const Site& site, const Scenario& scenario) {
    const RiskSettings& settings = results.settings;
    std::vector<std::size_t> order = results.ranked();
    const auto is_hit = [&](std::size_t number) {
        return std::any_of(results.slopes.begin(), results.slopes.end(), [&](Cover cover) {
            const SlopeRisk& slope = results.targets[number].risk.slopes[coupling::index_of(cover)];
            return slope.at(Quantity::arrivals).value > 0.0;
        });
    };
    // Rows of nothing but 0 would be alike.
    const std::size_t exposed = order.size();
    order.erase(std::stable_partition(order.begin(), order.end(), is_hit), order.end());
    const std::size_t hit = order.size();
    std::vector<PageFields> rows;
    for (std::size_t k = 0; k < std::min(most_rows, order.size()); ++k) {
        const TargetRisk& target = results.targets[order[k]];
        rows.push_back(row_of(results, target, site.targets[target.target].name));
    }
    RiskPlan plan{{}, results.curves, settings};
    for (const TargetRisk& target : results.targets) {
        plan.targets.push_back({site.targets[target.target].id, target.exposure});
    }
    PageFields fields = consequences::assumption_fields(plan, scenario.shown(settings.curves));
    fields.insert(
        fields.end(),
        {{"slopes", slopes_of(results)},
         {"with_persons", against_goal(results, site)},
         {"spared", spared_by_forest(results)},
         {"has_rows", !rows.empty()},
         {"more_targets", hit > most_rows},
         {"targets_hit", report::grouped(hit)},
         {"unhit", exposed > hit
                       ? std::optional{PageFields{{"unhit_targets", report::grouped(exposed - hit)}}}
                       : std::nullopt},
         {"rows_shown", report::grouped(rows.size())},
         {"targets_all", report::grouped(results.targets.size())},
         {"with_forest", results.with_forest()},
         {"with_barriers", !site.nets.empty() || !site.works.empty()},
         {"avoided", results.avoided ? std::optional{avoided_fields(results)} : std::nullopt},
         {"rows", rows}});
    return fields;
}

}  // namespace coupling::hazard::risk
