#include "coupling/assessments/hazard/arrival_sections.hpp"

#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::hazard {

using config::joined;
using report::page_text;

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
        const std::string& cover =
            slope.cover == Cover::forest ? page_text("with forest") : page_text("bare slope");
        html +=
            sheet.figure({joined(cover, ", ", page_text("by arrival")),
                          page_text("Hazard levels, {words_of_slope}", {{"words_of_slope", cover}}),
                          sheet.picture(slope.map.arrival_level, by_level), by_level.legend("levels"), ""},
                         report::MapSize::half);
    }
    return joined(html, "</div>\n");
}

}  // namespace coupling::hazard
