#include "coupling/assessments/hazard/arrival_sections.hpp"

#include <algorithm>
#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/results/figures/few_rocks.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::hazard {

using config::joined;
using report::escaped;
using report::HtmlTable;
using report::page_text;

const std::string& words_of(Cover cover) {
    return cover == Cover::forest ? page_text("with forest") : page_text("bare slope");
}

std::string years_text(double years) {
    return page_text(years == 1.0 ? "{years} year" : "{years} years", {{"years", report::exact(years)}});
}

std::string arrival_period(double release_years, double arrive_percent) {
    const double years = arrival_return_period_years(release_years, arrive_percent);
    return std::isnan(arrive_percent) ? "–"
           : std::isinf(years)        ? page_text("none arrives")
                                      : page_text("{years} years", {{"years", report::three_digits(years)}});
}

std::string levels_by_arrival(const HazardResults& results, const report::MapSheet& sheet,
                              const report::ColourScale& by_level) {
    std::string html =
        joined("<h3>", page_text("By the return period of the arrival"), "</h3>\n<p>",
               page_text("The return period of the arrival is that of the release divided by the share of "
                         "rocks that reach the cell: a cell that one rock in ten reaches has one arrival in "
                         "ten releases. The maps above use the return period of the release."),
               "</p>\n<div class=\"halves\">");
    for (const SlopeHazard& slope : results.slopes) {
        const std::string& cover = words_of(slope.cover);
        html +=
            sheet.figure({report::join_with_commas({cover, page_text("by arrival")}),
                          page_text("Hazard levels, {words_of_slope}", {{"words_of_slope", cover}}),
                          sheet.picture(slope.map.arrival_level, by_level), by_level.legend("levels"), ""},
                         report::MapSize::half);
    }
    return joined(html, "</div>\n");
}

namespace {

std::string stopped_by_forest(const PeriodArrivals& arrivals) {
    if (std::isnan(arrivals.protection_percent)) {
        return "–";
    }
    if (too_few_for_protection(arrivals.bare_rocks)) {
        return too_few_in_words(arrivals.bare_rocks);
    }
    return joined(
        "<b>", report::fixed(arrivals.protection_percent, 1), "\u00a0%</b> (",
        page_text("{low} to {high}", {{"low", report::fixed(arrivals.protection_low_percent, 1)},
                                      {"high", report::fixed(arrivals.protection_high_percent, 1)}}),
        ")");
}

}  // namespace

std::string arrivals_table(const HazardResults& results) {
    if (results.site.targets.empty()) {
        return "";
    }
    const bool with_forest =
        std::any_of(results.slopes.begin(), results.slopes.end(),
                    [](const SlopeHazard& slope) { return slope.cover == Cover::forest; });
    HtmlTable table =
        with_forest
            ? HtmlTable{page_text("Shares of the rocks of a return period that arrive; in brackets the "
                                  "95 % interval of chance in the simulated rocks."),
                        {page_text("Return period"), page_text("bare slope"), page_text("with forest"),
                         page_text("the forest stops"), page_text("An arrival every, bare slope"),
                         page_text("An arrival every, with forest")}}
            : HtmlTable{page_text("Shares of the rocks of a return period that arrive."),
                        {page_text("Return period"), page_text("bare slope"),
                         page_text("An arrival every, bare slope")}};
    std::size_t shown = results.site.targets.size();
    for (const PeriodArrivals& arrivals : results.arrivals) {
        if (arrivals.target != shown) {
            shown = arrivals.target;
            table.group(escaped(results.site.targets[shown].name));
        }
        const auto share = [](double percent) {
            return std::isnan(percent) ? std::string{"–"} : report::percent(percent / 100.0);
        };
        const std::string years = years_text(arrivals.return_period_years);
        const std::string every = arrival_period(arrivals.return_period_years, arrivals.bare_percent);
        if (!with_forest) {
            table.row({years, share(arrivals.bare_percent), every});
            continue;
        }
        table.row({years, share(arrivals.bare_percent), share(arrivals.forest_percent),
                   stopped_by_forest(arrivals), every,
                   arrival_period(arrivals.return_period_years, arrivals.forest_percent)});
    }
    return joined("<h2>", page_text("Rocks that arrive"),
                  "</h2>\n<section class=\"card\"><div class=\"wide\">", table.html(), "</div></section>\n");
}

}  // namespace coupling::hazard
