#include "coupling/assessments/decades/risk/risk_years_page.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "coupling/assessments/consequences/risk_words.hpp"
#include "coupling/assessments/decades/report/figure_cells.hpp"
#include "coupling/assessments/decades/report/regime_chart.hpp"
#include "coupling/assessments/decades/report/series.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::decades {
namespace {

using consequences::Quantity;
using report::page_text;
using report::PageFields;

constexpr std::size_t most_places = 10;

/// A place and what is there.
struct PlaceOfPage {
    const RiskAtPlace& place;
    std::string name;
    const TargetExposure* exposure = nullptr;  ///< of all targets: none

    [[nodiscard]] bool may_have(bool (TargetExposure::*is)() const) const {
        return exposure == nullptr || (exposure->*is)();
    }
};

/// Pairs of replicates of the money after the start.
std::optional<PairedDifference> money_difference(const RiskAtPlace& place, std::size_t course,
                                                 std::size_t reference) {
    std::vector<double> differences;
    const auto& here = place.at(Cover::forest, course);
    const auto& there = place.at(Cover::forest, reference);
    for (std::size_t r = 0; r < std::min(here.size(), there.size()); ++r) {
        const auto a = mean_after_start(here[r]);
        const auto b = mean_after_start(there[r]);
        if (a && b) {
            differences.push_back((*a)[consequences::index_of(Quantity::money)] -
                                  (*b)[consequences::index_of(Quantity::money)]);
        }
    }
    return differences.empty() ? std::nullopt : std::optional{difference_of(differences)};
}

PageFields slope_row(const Names& names, const PlaceOfPage& of, Cover cover, std::size_t course) {
    const auto mean = mean_risk(of.place, cover, course);
    const auto rate = [&](Quantity quantity) {
        return mean ? consequences::rate_text(mean->at(quantity).mean) : "–";
    };
    const auto amount = [&](Quantity quantity, bool has) {
        return mean && has ? report::three_digits(mean->at(quantity).mean) : "–";
    };
    std::vector<PageFields> difference;
    if (names.regimes.size() > 1) {
        const bool compares = cover == Cover::forest && names.regime_of(course) > 0;
        difference.push_back(
            {{"other", compares ? std::optional{difference_cell(money_difference(
                                      of.place, course, names.course(0, names.climate_of(course))))}
                                : std::nullopt}});
    }
    return {{"name", cover == Cover::bare ? consequences::slope_in_words(cover)
                                          : look_of(names, course).title_in_chart()},
            {"arrivals", rate(Quantity::arrivals)},
            {"individual", of.exposure != nullptr ? rate(Quantity::individual_risk) : "–"},
            {"deaths", rate(Quantity::deaths)},
            {"damage", amount(Quantity::damage, of.may_have(&TargetExposure::is_house))},
            {"closure", amount(Quantity::closure, of.may_have(&TargetExposure::is_road))},
            {"money", mean ? amount_cell(mean->at(Quantity::money)) : "–"},
            {"difference", difference}};
}

double mean_money(const RiskAtPlace& place, Cover cover, std::size_t course) {
    const auto mean = mean_risk(place, cover, course);
    return mean ? mean->at(Quantity::money).mean : 0.0;
}

/// All together where they are several, then those with most money over the bare slope first.
std::vector<PlaceOfPage> places_of_page(const Site& site, const RiskOverYears& risk) {
    std::vector<PlaceOfPage> places;
    if (risk.targets.size() > 1) {
        places.push_back({risk.all, page_text("All exposed targets")});
    }
    std::vector<std::size_t> order(risk.targets.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return mean_money(risk.targets[a], Cover::bare, 0) > mean_money(risk.targets[b], Cover::bare, 0);
    });
    order.resize(std::min(order.size(), most_places));
    for (const std::size_t i : order) {
        const ExposedTarget& target = risk.plan.targets[i];
        places.push_back({risk.targets[i],
                          site.targets[consequences::place_among(target.id, site.targets)].name,
                          &target.exposure});
    }
    return places;
}

std::vector<PageFields> place_groups(const Names& names, const Site& site, const RiskOverYears& risk) {
    std::vector<PageFields> groups;
    for (const PlaceOfPage& of : places_of_page(site, risk)) {
        for (std::size_t climate = 0; climate < names.climates.size(); ++climate) {
            std::vector<PageFields> rows;
            for (std::size_t regime = 0; regime < names.regimes.size(); ++regime) {
                rows.push_back(slope_row(names, of, Cover::forest, names.course(regime, climate)));
            }
            rows.push_back(slope_row(names, of, Cover::bare, names.course(0, climate)));
            std::optional<PageFields> exposure;
            if (of.exposure != nullptr) {
                exposure = PageFields{
                    {"in_words", consequences::exposure_in_words(*of.exposure, risk.plan.settings)}};
            }
            groups.push_back(
                {{"place", report::join_with_commas(
                               {of.name, names.climates.size() > 1 ? names.climates[climate] : ""})},
                 {"exposure", exposure},
                 {"columns", names.regimes.size() > 1 ? "8" : "7"},
                 {"rows", rows}});
        }
    }
    return groups;
}

/// The money at all targets through the forest.
Series money_series(const RiskOverYears& risk) {
    Series series{"risk_money_per_year", "", false, false, {}};
    for (const auto& replicates : risk.all.values[static_cast<std::size_t>(Cover::forest)]) {
        auto& of_course = series.values.emplace_back();
        for (const RiskByYear& replicate : replicates) {
            auto& values = of_course.emplace_back();
            for (const auto& [year, figures] : replicate) {
                values[year] = figures[consequences::index_of(Quantity::money)];
            }
        }
    }
    return series;
}

/// The regimes with the least and the most risk, over all climates.
PageFields extremes_of(const Names& names, const RiskOverYears& risk) {
    std::vector<std::size_t> courses(names.courses());
    std::iota(courses.begin(), courses.end(), std::size_t{0});
    const auto money = [&](std::size_t course) { return mean_money(risk.all, Cover::forest, course); };
    const auto [least, most] = std::minmax_element(
        courses.begin(), courses.end(), [&](std::size_t a, std::size_t b) { return money(a) < money(b); });
    const auto amount = [&](double value) { return consequences::amount_of(value, risk.plan.settings); };
    return {{"several", money(*least) < money(*most)},
            {"least", look_of(names, *least).title()},
            {"least_money", amount(money(*least))},
            {"most", look_of(names, *most).title()},
            {"most_money", amount(money(*most))},
            {"bare_money", amount(mean_money(risk.all, Cover::bare, *least))},
            {"targets", consequences::targets_in_words(risk.targets.size())}};
}

}  // namespace

std::string risk_over_years_html(const Names& names, const Site& site, const RiskOverYears& risk,
                                 const std::string& curves_file) {
    const std::vector<std::int32_t> years = years_of(risk.all);
    if (years.empty() || years.back() <= 0) {
        return "";
    }
    const std::string& currency = risk.plan.settings.currency;
    PageFields fields = consequences::assumption_fields(risk.plan, curves_file);
    const PageFields extremes = extremes_of(names, risk);
    fields.insert(fields.end(), extremes.begin(), extremes.end());
    fields.insert(fields.end(),
                  {{"more_targets", risk.targets.size() > most_places},
                   {"rows_shown", report::grouped(most_places)},
                   {"targets_all", report::grouped(risk.targets.size())},
                   {"compares", names.regimes.size() > 1},
                   {"currency", currency},
                   {"groups", place_groups(names, site, risk)},
                   {"charts", series_charts(names, money_series(risk),
                                            {.title = page_text("Risk over the years"),
                                             .y_title = page_text("{currency} a year",
                                                                  {{"currency", report::escaped(currency)}})},
                                            page_text("Expected cost at all exposed targets."))},
                   {"rocks", report::exact(risk.rocks_per_year)}});
    return report::filled_template("risk_years.html", fields);
}

}  // namespace coupling::decades
