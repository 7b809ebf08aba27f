#include "coupling/assessments/decades/decision/decision_risk.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <utility>

#include "config/text/joined.hpp"
#include "coupling/assessments/consequences/quantity_columns.hpp"
#include "coupling/assessments/decades/report/figure_cells.hpp"
#include "coupling/assessments/decades/report/series.hpp"
#include "coupling/assessments/decades/risk/read_risk.hpp"
#include "coupling/results/text/markup.hpp"

namespace coupling::decades {
namespace {

using consequences::Quantity;
using report::PageFields;

/// Present values of a course's risk per hectare, by replicate.
std::vector<double> risk_values_pha(const RiskOverYears& risk, std::size_t course, double discount_percent,
                                    double area_ha) {
    std::vector<double> values;
    for (const RiskByYear& replicate : risk.all.at(Cover::forest, course)) {
        values.push_back(present_value_of_risk(replicate, discount_percent) / area_ha);
    }
    return values;
}

/// a - b, replicate by replicate.
std::vector<double> minus_by_replicate(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> less;
    const auto pairs = static_cast<std::ptrdiff_t>(std::min(a.size(), b.size()));
    std::transform(a.begin(), a.begin() + pairs, b.begin(), std::back_inserter(less), std::minus<>{});
    return less;
}

std::optional<PairedDifference> paired_difference(const std::vector<double>& a,
                                                  const std::vector<double>& b) {
    const std::vector<double> differences = minus_by_replicate(a, b);
    return differences.empty() ? std::nullopt : std::optional{difference_of(differences)};
}

constexpr const char* risk_of_replicates = "over the replicates, coupling/assessments/decades/README.md";

ColumnsOf<Band> risk_band_columns(const std::string& name, const char* unit, const char* meaning) {
    const auto part = [&](const char* ending, const char* says, double Band::*of) {
        return ColumnsOf<Band>{Column{name + ending, unit, says, risk_of_replicates}, as_given,
                               [of](const Band& band) { return consequences::six_digits(band.*of); }};
    };
    return {part("", meaning, &Band::mean), part("_low_90", "lower end of its 90 % interval", &Band::low),
            part("_high_90", "upper end of its 90 % interval", &Band::high)};
}

ColumnsOf<PairedDifference> risk_difference_columns(const std::string& name, const char* unit,
                                                    const char* meaning, const char* needed) {
    constexpr const char* of_pairs = "pairs of replicates, Student's t, 95 %";
    const auto part = [&](const char* ending, const char* says, double PairedDifference::*of) {
        return ColumnsOf<PairedDifference>{
            Column{name + ending, unit, says, of_pairs}, as_given,
            [of](const PairedDifference& found) { return consequences::six_digits(found.*of); }};
    };
    return {part("", meaning, &PairedDifference::mean),
            part("_low_95", "lower end of its 95 % interval", &PairedDifference::low),
            part("_high_95", "upper end of its 95 % interval", &PairedDifference::high),
            {needed, "replicates to tell the two apart; empty: not known", of_pairs,
             [](const PairedDifference& d) { return replicates_needed(d.mean, d.deviation); }}};
}

PageFields risk_row_of(const Names& names, const CourseRisk& risk, double value_eur_pha) {
    const bool is_first = names.regime_of(risk.course) == 0;
    const auto minus_first = [&](const std::optional<PairedDifference>& difference) {
        std::vector<PageFields> cells;
        if (names.regimes.size() > 1) {
            cells.push_back(
                {{"other", is_first ? std::nullopt : std::optional{difference_cell(difference)}}});
        }
        return cells;
    };
    return {{"regime", breakable(look_of(names, risk.course).title_in_chart())},
            {"money", amount_cell(risk.money_a_year)},
            {"present_value", amount_cell(risk.present_value_pha)},
            {"difference", minus_first(risk.difference_pha)},
            {"work_and_stock", report::fixed(value_eur_pha, 0)},
            {"less_risk", risk.value_less_risk_eur_pha ? band_cell(*risk.value_less_risk_eur_pha, 0) : "–"},
            {"less_risk_difference", minus_first(risk.value_less_risk_difference_eur_pha)}};
}

}  // namespace

std::vector<CourseRisk> risks_of_courses(const Names& names, const Decision& decision,
                                         const RiskOverYears& risk, double area_ha) {
    const std::string& currency = risk.plan.settings.currency;
    const auto values_of_course = [&](std::size_t course) {
        return risk_values_pha(risk, course, decision.settings.discount_percent, area_ha);
    };
    std::vector<CourseRisk> risks;
    for (std::size_t course = 0; course < names.courses(); ++course) {
        const auto mean = mean_risk(risk.all, Cover::forest, course);
        const std::vector<double> values = values_of_course(course);
        const std::vector<double> less =
            minus_by_replicate(decision.money[course].present_values_eur_pha, values);
        CourseRisk found{.course = course, .currency = currency};
        found.money_a_year = mean ? mean->at(Quantity::money) : Band{NAN, NAN, NAN, NAN, NAN, NAN, NAN};
        found.present_value_pha = band_of(values, not_negative);
        const bool joins = currency == currency_of_timber && !less.empty();
        if (joins) {
            found.value_less_risk_eur_pha = band_of(less);
        }
        if (names.regime_of(course) > 0) {
            const std::size_t reference = names.course(0, names.climate_of(course));
            const std::vector<double> others = values_of_course(reference);
            found.difference_pha = paired_difference(values, others);
            if (joins) {
                found.value_less_risk_difference_eur_pha = paired_difference(
                    less, minus_by_replicate(decision.money[reference].present_values_eur_pha, others));
            }
        }
        risks.push_back(std::move(found));
    }
    return risks;
}

ColumnsOf<CourseRisk> course_risk_columns() {
    constexpr const char* as_said = "as the currency says";
    return {
        {"risk_currency", "of the risk; empty, as all that follows: no risk.assess", "input risk.currency",
         &CourseRisk::currency},
        {risk_band_columns("risk_money_per_year", as_said,
                           "money at risk a year at all exposed targets, mean of the years after the "
                           "start, of the whole slope"),
         &CourseRisk::money_a_year},
        {risk_band_columns("risk_present_value_per_hectare", as_said,
                           "the same of the years after the start, discounted to it by "
                           "decision.discount_percent, per hectare of forest"),
         &CourseRisk::present_value_pha},
        {risk_difference_columns(
             "risk_difference_per_hectare", as_said,
             "present value of the risk per hectare of forest minus that of the reference; below 0: spared",
             "risk_replicates_needed"),
         &CourseRisk::difference_pha},
        {risk_band_columns("value_less_risk_eur_pha", "EUR/ha",
                           "present value of work and stock less that of the risk; empty: risk.currency "
                           "is not EUR"),
         &CourseRisk::value_less_risk_eur_pha},
        {risk_difference_columns("value_less_risk_difference_eur_pha", "EUR/ha",
                                 "the same minus that of the reference", "value_less_risk_replicates_needed"),
         &CourseRisk::value_less_risk_difference_eur_pha}};
}

PageFields course_risk_fields(const Names& names, const Decision& decision,
                              std::span<const CourseRisk> risks) {
    const bool compares = names.regimes.size() > 1;
    std::vector<PageFields> groups;
    for (std::size_t climate = 0; climate < names.climates.size(); ++climate) {
        std::vector<PageFields> rows;
        for (std::size_t regime = 0; regime < names.regimes.size(); ++regime) {
            const std::size_t course = names.course(regime, climate);
            rows.push_back(
                risk_row_of(names, risks[course], decision.money[course].present_value_eur_pha.mean));
        }
        groups.push_back(
            {{"grouped", names.climates.size() > 1}, {"group", names.climates[climate]}, {"rows", rows}});
    }
    const std::string& currency = risks.front().currency;
    return {{"discount", report::fixed(decision.settings.discount_percent, 1)},
            {"other_currency", currency != currency_of_timber},
            {"compares", compares},
            {"currency", currency},
            {"columns", compares ? "7" : "5"},
            {"groups", groups}};
}

}  // namespace coupling::decades
