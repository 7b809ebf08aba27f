#include <cmath>
#include <limits>
#include <string>

#include "config/text/joined.hpp"
#include "coupling/assessments/consequences/quantity_columns.hpp"
#include "coupling/assessments/consequences/risk_words.hpp"
#include "coupling/assessments/hazard/risk/risk_results.hpp"
#include "coupling/results/figures/figures.hpp"
#include "coupling/results/tables/figure_columns.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::hazard::risk {
namespace {

using config::joined;
using consequences::amount_of;
using consequences::rate_text;
using consequences::six_digits;
using consequences::slope_in_words;
using report::PageFields;

constexpr const char* how_avoided = "coupling/assessments/hazard/risk/README.md";
constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

double finite_or_none(double value) {
    return std::isfinite(value) ? six_digits(value) : not_known;
}

struct AvoidedRow {
    const RiskResults& results;
    const AvoidedOnSlope& slope;

    [[nodiscard]] std::optional<double> cost() const { return results.avoided->cost_per_year(); }
};

ColumnsOf<AvoidedRow> avoided_estimate(const char* name, const char* unit, const char* meaning,
                                       Estimate AvoidedOnSlope::*of) {
    const auto part = [&](const char* infix, const std::string& says, double Estimate::*which) {
        return ColumnsOf<AvoidedRow>{
            Column{joined(name, infix, "_per_year"), unit, says, how_avoided}, as_given,
            [of, which](const AvoidedRow& row) { return six_digits(row.slope.*of.*which); }};
    };
    return {part("", meaning, &Estimate::value),
            part("_low", "lower end of its 95 % interval by the chance of rocks", &Estimate::low),
            part("_high", "upper end of its 95 % interval by the chance of rocks", &Estimate::high)};
}

/// A figure that risk_total.csv has with its interval: another one beside it would be a second answer.
ColumnsOf<AvoidedRow> avoided_figure(const char* name, const char* unit, const char* meaning,
                                     Estimate AvoidedOnSlope::*of) {
    return {Column{joined(name, "_per_year"), unit, meaning, how_avoided}, as_given,
            [of](const AvoidedRow& row) { return six_digits((row.slope.*of).value); }};
}

/// A ratio to the cost; empty where the cost is not known or 0, and where its value is not bounded.
template <class RatioOf>
ColumnsOf<AvoidedRow> ratio_columns(const char* name, const char* unit, const char* meaning,
                                    RatioOf ratio_of) {
    const auto part = [&](const char* infix, const std::string& says, double Ratio::*which) {
        return ColumnsOf<AvoidedRow>{
            Column{joined(name, infix), unit, says, how_avoided}, as_given,
            [ratio_of, which](const AvoidedRow& row) {
                const auto cost = row.cost();
                return cost && *cost > 0.0 ? finite_or_none(ratio_of(row.slope, *cost).*which) : not_known;
            }};
    };
    return {part("", meaning, &Ratio::value),
            part("_low", "lower end of its 95 % interval by the chance of rocks", &Ratio::low),
            part("_high", "upper end of that interval; empty: open", &Ratio::high)};
}

TableOf<AvoidedRow> avoided_table() {
    constexpr const char* in_money = "as the currency says";
    return {
        "risk_avoided.csv",
        "What nets and works spare at all exposed targets together, a year, and what that costs.",
        "a slope",
        {{cover_column(), [](const auto& row) { return name_of(row.slope.cover); }},
         avoided_figure("money_without", in_money, "expected cost without nets and works",
                        &AvoidedOnSlope::money_without),
         avoided_figure("money_with", in_money, "expected cost with them", &AvoidedOnSlope::money_with),
         avoided_estimate("avoided_money", in_money, "what they spare, of the same rocks",
                          &AvoidedOnSlope::money),
         avoided_figure("deaths_without", "-", "expected deaths without them",
                        &AvoidedOnSlope::deaths_without),
         avoided_figure("deaths_with", "-", "expected deaths with them", &AvoidedOnSlope::deaths_with),
         avoided_estimate("avoided_deaths", "-", "deaths that they prevent, of the same rocks",
                          &AvoidedOnSlope::deaths),
         {Column{"cost_per_year", in_money, "what they cost; empty: not known of each of them", how_avoided},
          as_given,
          [](const AvoidedRow& row) {
              const auto cost = row.cost();
              return cost ? six_digits(*cost) : not_known;
          }},
         ratio_columns(
             "benefit_by_cost", "-", "money that they spare for each unit of cost",
             [](const AvoidedOnSlope& slope, double cost) { return benefit_by_cost(slope.money, cost); }),
         ratio_columns(
             "cost_of_prevented_death", in_money, "cost of each death that they prevent",
             [](const AvoidedOnSlope& slope, double cost) { return cost_of_each(slope.deaths, cost); }),
         {"currency", "of all amounts", "input risk",
          [](const AvoidedRow& row) { return row.results.settings.currency; }}}};
}

struct BarrierRow {
    const RiskResults& results;
    const NewBarrier& barrier;
};

TableOf<BarrierRow> barrier_table() {
    constexpr const char* in_money = "as the currency says";
    constexpr const char* from_lists = "input nets.file or works.file";
    const auto given = [](const std::optional<double>& figure) { return figure.value_or(not_known); };
    return {"risk_barriers.csv",
            "The nets and works that this run has and the one without them has not, and what each costs a "
            "year.",
            "a net or a work",
            {{"name", "of the net or work", from_lists, [](const auto& row) { return row.barrier.name; }},
             {"kind", "net, dam, ditch, wall or gallery", from_lists,
              [](const auto& row) { return row.barrier.kind; }},
             {Column{"investment", in_money, "what it costs to build; empty: not known", from_lists},
              as_given, [given](const auto& row) { return given(row.barrier.cost.investment); }},
             {Column{"life_years", "yr", "how long it stands", from_lists}, as_given,
              [given](const auto& row) { return given(row.barrier.cost.life_years); }},
             {Column{"maintenance_percent", "%", "of the investment a year", from_lists}, as_given,
              [](const auto& row) { return row.barrier.cost.maintenance_percent; }},
             {Column{"interest_percent", "%", "a year", "input risk"}, as_given,
              [](const auto& row) { return row.results.settings.interest_percent; }},
             {Column{"cost_per_year", in_money, "annuity of the investment over its life, and maintenance",
                     how_avoided},
              as_given,
              [](const auto& row) {
                  return row.barrier.cost_per_year ? six_digits(*row.barrier.cost_per_year) : not_known;
              }},
             {"currency", "of all amounts", "input risk",
              [](const auto& row) { return row.results.settings.currency; }}}};
}

Json json_of(const Estimate& estimate) {
    return {{"value", json_number(estimate.value)},
            {"low", json_number(estimate.low)},
            {"high", json_number(estimate.high)}};
}

Json json_of(const Ratio& ratio) {
    const auto number = [](double value) {
        return std::isfinite(value) ? json_number(value) : Json(nullptr);
    };
    return {{"value", number(ratio.value)}, {"low", number(ratio.low)}, {"high", number(ratio.high)}};
}

/// What is said of a slope about the cost of what it spares; nothing where the cost is not known.
std::optional<PageFields> ratios_in_words(const AvoidedOnSlope& slope, std::optional<double> cost,
                                          const RiskSettings& settings) {
    if (!cost || !(*cost > 0.0)) {
        return std::nullopt;
    }
    const Ratio benefit = benefit_by_cost(slope.money, *cost);
    const Ratio death = cost_of_each(slope.deaths, *cost);
    const auto text = [&](double amount) {
        return std::isfinite(amount) ? amount_of(amount, settings) : std::string{};
    };
    return PageFields{{"benefit", report::three_digits(benefit.value)},
                      {"benefit_low", report::three_digits(benefit.low)},
                      {"benefit_high", report::three_digits(benefit.high)},
                      {"death_known", std::isfinite(death.high)},
                      {"death_open", std::isfinite(death.value) && !std::isfinite(death.high)},
                      {"death_not_shown", !std::isfinite(death.value)},
                      {"death", text(death.value)},
                      {"death_low", text(death.low)},
                      {"death_high", text(death.high)}};
}

}  // namespace

std::vector<TableLayout> avoided_layouts() {
    return {avoided_table(), barrier_table()};
}

std::vector<WrittenFile> write_avoided(const RiskResults& results, const std::filesystem::path& folder) {
    return {avoided_table().write(folder,
                                  [&](auto& rows) {
                                      for (const AvoidedOnSlope& slope : results.avoided->slopes) {
                                          rows.add({results, slope});
                                      }
                                  }),
            barrier_table().write(folder, [&](auto& rows) {
                for (const NewBarrier& barrier : results.avoided->barriers) {
                    rows.add({results, barrier});
                }
            })};
}

Json avoided_json(const RiskResults& results) {
    const AvoidedRisk& avoided = *results.avoided;
    const std::optional<double> cost = avoided.cost_per_year();
    Json json{{"cost_per_year", cost ? json_number(*cost) : Json(nullptr)},
              {"interest_percent", json_number(results.settings.interest_percent)}};
    for (const AvoidedOnSlope& slope : avoided.slopes) {
        Json one{{"money_without_per_year", json_number(slope.money_without.value)},
                 {"money_with_per_year", json_number(slope.money_with.value)},
                 {"avoided_money_per_year", json_of(slope.money)},
                 {"avoided_deaths_per_year", json_of(slope.deaths)}};
        if (cost && *cost > 0.0) {
            one["benefit_by_cost"] = json_of(benefit_by_cost(slope.money, *cost));
            one["cost_of_prevented_death"] = json_of(cost_of_each(slope.deaths, *cost));
        }
        json[name_of(slope.cover)] = std::move(one);
    }
    return json;
}

PageFields avoided_fields(const RiskResults& results) {
    const AvoidedRisk& avoided = *results.avoided;
    const RiskSettings& settings = results.settings;
    const std::optional<double> cost = avoided.cost_per_year();
    std::vector<PageFields> slopes;
    for (const AvoidedOnSlope& slope : avoided.slopes) {
        slopes.push_back({{"slope", slope_in_words(slope.cover)},
                          {"without", amount_of(slope.money_without.value, settings)},
                          {"with", amount_of(slope.money_with.value, settings)},
                          {"spared", amount_of(slope.money.value, settings)},
                          {"is_clear", !(slope.money.low <= 0.0 && slope.money.high >= 0.0)},
                          {"low", report::three_digits(slope.money.low)},
                          {"high", report::three_digits(slope.money.high)},
                          {"with_persons", !std::isnan(slope.deaths_with.value)},
                          {"deaths_without", rate_text(slope.deaths_without.value)},
                          {"deaths_with", rate_text(slope.deaths_with.value)},
                          {"ratios", ratios_in_words(slope, cost, settings)}});
    }
    std::vector<PageFields> barriers;
    for (const NewBarrier& barrier : avoided.barriers) {
        const auto text_of = [&](const std::optional<double>& of) {
            return of ? amount_of(*of, settings) : std::string{"–"};
        };
        barriers.push_back(
            {{"name", barrier.name},
             {"kind", report::page_text(barrier.kind)},
             {"investment", text_of(barrier.cost.investment)},
             {"life", barrier.cost.life_years ? report::exact(*barrier.cost.life_years) : std::string{"–"}},
             {"maintenance", report::exact(barrier.cost.maintenance_percent)},
             {"cost", text_of(barrier.cost_per_year)}});
    }
    return {{"slopes", slopes},
            {"barriers", barriers},
            {"no_barriers", avoided.barriers.empty()},
            {"cost", cost ? std::optional{PageFields{{"amount", amount_of(*cost, settings)}}} : std::nullopt},
            {"cost_unknown", !cost && !avoided.barriers.empty()},
            {"interest", report::exact(settings.interest_percent)}};
}

}  // namespace coupling::hazard::risk
