#include "coupling/assessments/consequences/risk_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/scenario_names.hpp"

namespace coupling::consequences {
namespace {

using config::joined;
using report::page_text;
using report::PageFields;

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
    if (!std::isfinite(rate)) {
        return "–";
    }
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

std::string amount_of(double amount, const RiskSettings& settings) {
    return joined(report::three_digits(amount), "\u00a0", settings.currency);
}

std::string targets_in_words(std::size_t targets) {
    return targets == 1 ? page_text("the target with persons, traffic or value")
                        : page_text("the {count} targets with persons, traffic or value",
                                    {{"count", report::grouped(targets)}});
}

const std::string& slope_in_words(Cover cover) {
    return page_text(cover == Cover::forest ? "With forest" : "Bare slope");
}

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
            *of.persons == 1.0 ? "{persons} person, {hours} h a day" : "{persons} persons, {hours} h a day",
            {{"persons", report::exact(*of.persons)}, {"hours", report::exact(of.hours_per_day.value())}}));
    }
    if (of.is_house() && !of.persons) {
        parts.push_back(page_text("no persons given"));
    }
    if (of.house_value) {
        parts.push_back(page_text("worth {amount}", {{"amount", joined(report::exact(*of.house_value),
                                                                       "\u00a0", settings.currency)}}));
    }
    return report::join_with_commas(parts);
}

PageFields assumption_fields(const RiskPlan& plan, const std::string& curves_file) {
    const RiskSettings& settings = plan.settings;
    const auto any = [&](bool (TargetExposure::*is)() const) {
        return std::any_of(plan.targets.begin(), plan.targets.end(),
                           [&](const ExposedTarget& target) { return (target.exposure.*is)(); });
    };
    return {{"shipped_curves", settings.curves.empty()},
            {"curves_file", report::with_scenario_names(curves_file)},
            {"with_roads", any(&TargetExposure::is_road)},
            {"with_houses", any(&TargetExposure::is_house)},
            {"with_closure", settings.closure_days > 0.0},
            {"length", report::exact(settings.vehicle_length_m)},
            {"passages", report::exact(settings.passages_per_day)},
            {"closure_days", report::exact(settings.closure_days)},
            {"closure_cost", amount_of(settings.closure_cost_per_day, settings)},
            {"prevented_death", joined(report::exact(settings.prevented_death), "\u00a0", settings.currency)},
            {"curve_rows", rows_of_curves(plan.curves)}};
}

}  // namespace coupling::consequences
