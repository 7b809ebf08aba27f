#include "coupling/assessments/decades/decision/decision_page.hpp"

#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/assessments/decades/decision/decision_tables.hpp"
#include "coupling/assessments/decades/decision/verdict.hpp"
#include "coupling/assessments/decades/report/series.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::decades {
namespace {

using config::joined;
using report::escaped;
using report::fixed;
using report::page_text;

std::string cell(const Band& band, int decimals) {
    if (std::isnan(band.mean)) {
        return "–";
    }
    return band.has_interval() ? joined(fixed(band.mean, decimals), " <small>(", fixed(band.low, decimals),
                                        " – ", fixed(band.high, decimals), ")</small>")
                               : fixed(band.mean, decimals);
}

/// A difference, and how many replicates would tell it from 0 where these do not.
std::string cell(const std::optional<PairedDifference>& difference, int decimals) {
    if (!difference) {
        return "–";
    }
    if (std::isnan(difference->low)) {
        return fixed(difference->mean, decimals);
    }
    const bool is_known = difference->low > 0.0 || difference->high < 0.0;
    const auto needed = replicates_needed(difference->mean, difference->deviation);
    return joined(fixed(difference->mean, decimals), " <small>(", fixed(difference->low, decimals), " – ",
                  fixed(difference->high, decimals), ")</small>",
                  is_known  ? ""
                  : !needed ? joined("<br/><small>", page_text("no number of replicates known"), "</small>")
                            : joined("<br/><small>",
                                     page_text("{replicates} replicates needed",
                                               {{"replicates", std::to_string(*needed)}}),
                                     "</small>"));
}

std::string share_cell(const KeptShare& share) {
    return share.replicates == 0
               ? "–"
               : joined(fixed(100.0 * share.value(), 0), " % <small>(", fixed(100.0 * share.low, 0), " – ",
                        fixed(100.0 * share.high, 0), ")</small>");
}

std::string keeps_cell(Keeps keeps) {
    const char* key = keeps == Keeps::yes ? "yes" : keeps == Keeps::no ? "no" : "undecided";
    return joined("<b>", page_text(key), "</b>");
}

std::string lowest_cell(const std::optional<Extreme>& lowest) {
    return lowest
               ? joined(cell(lowest->value.band, 1), " ",
                        page_text("<small>in year {year}</small>", {{"year", std::to_string(lowest->year)}}))
               : "–";
}

std::string table_of(const Names& names, const Decision& decision) {
    const bool compares = names.regimes.size() > 1;
    std::vector<std::string> head{page_text("Regime"),
                                  page_text("Keeps"),
                                  page_text("Probability"),
                                  page_text("Years below"),
                                  page_text("Lowest year, %"),
                                  page_text("Removed, m³/ha a year"),
                                  page_text("Net, EUR/ha a year"),
                                  page_text("Present value, EUR/ha")};
    if (compares) {
        head.push_back(page_text("Present value, minus A"));
        head.push_back(page_text("Percent-years lost, minus A"));
    }
    report::HtmlTable table{
        page_text(
            "Keeps: whether protection is at least {percent} % in all years with rocks after the start, with "
            "the probability asked for; the verdicts on all regimes hold together with 95 %, so that a yes "
            "takes at least {least} replicates. In brackets 90 % intervals: of the probability by Clopper "
            "and Pearson, of means over replicates by Student’s t, skewness by Hall 1992. Money is the "
            "contribution margin; the present value discounts it by {discount} % a year to the start. "
            "{differences}",
            {{"percent", fixed(decision.settings.protection_at_least_percent, 0)},
             {"least", std::to_string(least_for_yes(decision.settings.probability, decision.chances))},
             {"discount", fixed(decision.settings.discount_percent, 1)},
             {"differences",
              compares
                  ? page_text(
                        "Differences from the first regime are paired by replicate, with their 95 % interval "
                        "and, where that holds 0, the replicates that would tell the two apart.")
                  : ""}}),
        head};
    const std::size_t targets = decision.at_targets.size() / decision.money.size();
    for (std::size_t climate = 0; climate < names.climates.size(); ++climate) {
        for (std::size_t target = 0; target < targets; ++target) {
            if (names.climates.size() > 1 || targets > 1) {
                const std::string& id = decision.at_targets[target].target;
                table.group(joined(names.climates.size() > 1 ? escaped(names.climates[climate]) : "",
                                   names.climates.size() > 1 && targets > 1 ? ", " : "",
                                   targets > 1 ? escaped(id) : ""));
            }
            for (std::size_t regime = 0; regime < names.regimes.size(); ++regime) {
                const std::size_t course = names.course(regime, climate);
                const std::size_t first = names.course(0, climate);
                const CourseAtTarget& at = decision.at_targets[course * targets + target];
                const CourseMoney& money = decision.money[course];
                std::vector<std::string> cells{escaped(look_of(names, course).title_in_chart()),
                                               keeps_cell(judge(at.kept, decision.settings.probability)),
                                               share_cell(at.kept),
                                               cell(at.years_below, 1),
                                               lowest_cell(at.lowest),
                                               cell(money.removed_m3pha_a_year, 1),
                                               cell(money.net_eur_pha_a_year, 0),
                                               cell(money.present_value_eur_pha, 0)};
                if (compares) {
                    const bool is_first = regime == 0;
                    cells.push_back(is_first ? ""
                                             : cell(difference_in_value(money, decision.money[first]), 0));
                    cells.push_back(is_first ? ""
                                             : cell(difference_in_percent_years(
                                                        at, decision.at_targets[first * targets + target]),
                                                    1));
                }
                table.row(cells);
            }
        }
    }
    table.text_columns({1});
    return table.html();
}

}  // namespace

std::string decision_html(const Names& names, const Decision& decision) {
    std::string html = "<section class=\"card\">";
    bool is_first = true;
    for (const std::string& sentence : verdict(names, decision)) {
        html += joined("<p class=\"answer\">", is_first ? "<b>" : "", escaped(sentence),
                       is_first ? "</b>" : "", "</p>");
        is_first = false;
    }
    return joined(html, table_of(names, decision), "</section>\n");
}

}  // namespace coupling::decades
