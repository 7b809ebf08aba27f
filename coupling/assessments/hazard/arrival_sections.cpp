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
           : std::isinf(years)        ? page_text("hazard_page.none_arrives")
                               : page_text("hazard_page.years_3", {{"years", report::three_digits(years)}});
}

std::string levels_by_arrival(const HazardResults& results, const report::MapSheet& sheet,
                              const report::ColourScale& by_level) {
    std::string html = joined("<h3>", page_text("hazard_page.levels_by_arrival"), "</h3>\n<p>",
                              page_text("hazard_page.about_the_arrival"), "</p>\n<div class=\"halves\">");
    for (const SlopeHazard& slope : results.slopes) {
        const std::string& cover =
            slope.cover == Cover::forest ? page_text("common.with_forest") : page_text("common.bare_slope");
        html +=
            sheet.figure({joined(cover, page_text("hazard_page.comma_by_arrival")),
                          page_text("hazard_page.hazard_levels", {{"words_of_slope", cover}}),
                          sheet.picture(slope.map.arrival_level, by_level), by_level.legend("levels"), ""},
                         report::MapSize::half);
    }
    return joined(html, "</div>\n");
}

}  // namespace coupling::hazard
