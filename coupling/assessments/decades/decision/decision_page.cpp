#include "coupling/assessments/decades/decision/decision_page.hpp"

#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/assessments/decades/decision/decision_tables.hpp"
#include "coupling/assessments/decades/decision/verdict.hpp"
#include "coupling/assessments/decades/report/figure_cells.hpp"
#include "coupling/assessments/decades/report/series.hpp"
#include "coupling/results/figures/few_rocks.hpp"
#include "coupling/results/templates/page_template.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::decades {
namespace {

using config::joined;
using report::fixed;
using report::page_text;
using report::PageFields;

/// A mean with its interval; a dash where no replicate has the figure.
std::string mean_cell(const Band& band, int decimals) {
    return std::isnan(band.mean) ? "–" : band_cell(band, decimals);
}

std::string share_cell(const KeptShare& share) {
    return share.replicates == 0 ? "–"
                                 : interval_cell(joined(fixed(100.0 * share.value(), 0), " %"),
                                                 fixed(100.0 * share.low, 0), fixed(100.0 * share.high, 0));
}

std::string worst_cell(const WorstYear& worst) {
    const auto in_percent = [&](double share) { return fixed(100.0 * worst.at(share), 0); };
    return interval_cell(joined(in_percent(0.5), " %"), in_percent(0.05), in_percent(0.95));
}

std::string keeps_in_words(Keeps keeps) {
    return page_text(keeps == Keeps::yes ? "yes" : keeps == Keeps::no ? "no" : "undecided");
}

/// Of percent-years lost; nothing where its interval says nothing of the percent of an average year.
std::optional<PairedDifference> known_loss(const CourseAtTarget& at, const CourseAtTarget& reference,
                                           std::int32_t years) {
    const auto difference = difference_in_percent_years(at, reference);
    const auto a_year = [&](double percent_years) { return percent_years / static_cast<double>(years); };
    return difference && !std::isnan(difference->low) &&
                   says_nothing(a_year(difference->low), a_year(difference->high))
               ? std::nullopt
               : difference;
}

/// A regime at a target.
PageFields row_of(const Names& names, const Decision& decision, std::size_t course, std::size_t target) {
    const std::size_t targets = decision.at_targets.size() / decision.money.size();
    const CourseAtTarget& at = decision.at_targets[course * targets + target];
    const CourseMoney& money = decision.money[course];
    const std::size_t first = names.course(0, names.climate_of(course));
    std::vector<PageFields> differences;
    if (names.regimes.size() > 1) {
        const bool is_first = course == first;
        const auto cell = [&](const std::optional<PairedDifference>& difference, int decimals) {
            return is_first ? std::nullopt : std::optional{difference_cell(difference, decimals)};
        };
        differences = {
            {{"other", cell(difference_in_value(money, decision.money[first]), 0)}},
            {{"other",
              cell(known_loss(at, decision.at_targets[first * targets + target], decision.last_year), 1)}}};
    }
    return {{"regime", breakable(look_of(names, course).title_in_chart())},
            {"keeps", keeps_in_words(decision.at_target(names, at))},
            {"probability", at.worst() != nullptr ? worst_cell(*at.worst()) : share_cell(at.kept)},
            {"years_below", mean_cell(at.forest.years_below, 1)},
            {"lowest", at.forest.lowest ? std::optional{PageFields{
                                              {"percent_in_year", protection_cell(at.forest.lowest->value)},
                                              {"year", std::to_string(at.forest.lowest->year)}}}
                                        : std::nullopt},
            {"removed", mean_cell(money.removed_m3pha_a_year, 1)},
            {"net", mean_cell(money.net_eur_pha_a_year, 0)},
            {"present_value", mean_cell(money.present_value_eur_pha, 0)},
            {"stock",
             std::isnan(money.stock_value_eur_pha.mean) ? "–" : fixed(money.stock_value_eur_pha.mean, 0)},
            {"differences", differences}};
}

/// The regimes of each climate at each target.
std::vector<PageFields> groups_of(const Names& names, const Decision& decision) {
    const std::size_t targets = decision.at_targets.size() / decision.money.size();
    std::vector<PageFields> groups;
    for (std::size_t climate = 0; climate < names.climates.size(); ++climate) {
        for (std::size_t target = 0; target < targets; ++target) {
            std::vector<PageFields> rows;
            for (std::size_t regime = 0; regime < names.regimes.size(); ++regime) {
                rows.push_back(row_of(names, decision, names.course(regime, climate), target));
            }
            const std::string name =
                report::join_with_commas({names.climates.size() > 1 ? names.climates[climate] : "",
                                          targets > 1 ? decision.at_targets[target].target : ""});
            groups.push_back({{"grouped", !name.empty()}, {"group", name}, {"rows", rows}});
        }
    }
    return groups;
}

}  // namespace

std::string decision_html(const Names& names, const Decision& decision, const std::string& charts,
                          std::span<const CourseRisk> risks) {
    const std::vector<std::string> sentences = verdict(names, decision);
    std::vector<PageFields> more;
    for (std::size_t i = 1; i < sentences.size(); ++i) {
        more.push_back({{"sentence", sentences[i]}});
    }
    const bool compares = names.regimes.size() > 1;
    return report::filled_template(
        "decision.html",
        {{"answer", sentences.empty() ? "" : sentences.front()},
         {"more", more},
         {"charts", charts},
         {"percent", fixed(decision.settings.protection_at_least_percent, 0)},
         {"least", std::to_string(least_for_yes(decision.settings.probability, decision.chances))},
         {"discount", fixed(decision.settings.discount_percent, 1)},
         {"compares", compares},
         {"columns", compares ? "10" : "8"},
         {"groups", groups_of(names, decision)},
         {"risk", risks.empty() ? std::nullopt : std::optional{course_risk_fields(names, decision, risks)}}});
}

}  // namespace coupling::decades
