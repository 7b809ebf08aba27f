#include "coupling/assessments/decades/report/indicator_table.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "config/text/joined.hpp"
#include "coupling/assessments/decades/report/series.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::decades {
namespace {

using config::joined;
using report::fixed;
using report::page_text;

/// A figure of the table.
struct Indicator {
    const char* quantity;
    const char* name;  ///< key of its text
    int decimals;
};

constexpr std::array indicators_of_page{
    Indicator{"protection_percent", "Protection by trees and dead wood, %", 1},
    Indicator{"protection_living_percent", "Protection by living trees alone, %", 1},
    Indicator{"hd_above_90_percent", "Stems from 12 cm with height / diameter above 90, %", 0},
    Indicator{"cover_percent", "Cover of crowns from 12 cm, %", 0},
    Indicator{"regeneration_percent", "Cover of young growth (0.4 m to 12 cm), %", 0},
    Indicator{"lost_in_5_years_m3pha",
              "Wood lost to storm, snow, beetles and other deaths in five years, m³/ha", 1},
    Indicator{"carbon_stand_tpha", "Carbon in living trees above ground, t/ha", 0},
    Indicator{"carbon_dead_wood_tpha", "Carbon in dead wood, t/ha", 1},
    Indicator{"carbon_products_tpha", "Carbon in sawn wood since the start, t/ha", 1}};

std::string indicator_cell(const Series& series, std::size_t course, std::int32_t year, int decimals) {
    const auto value = over_replicates(series, course, year);
    if (!value) {
        return "–";
    }
    const Band& band = value->band;
    return band.has_interval() ? joined(fixed(band.mean, decimals), " <small>(", fixed(band.low, decimals),
                                        " – ", fixed(band.high, decimals), ")</small>")
                               : fixed(band.mean, decimals);
}

}  // namespace

bool has_protection(std::span<const Series> all_series) {
    return std::any_of(all_series.begin(), all_series.end(), [](const Series& series) {
        return series.quantity == "protection_percent" && !years_of(series).empty();
    });
}

std::string indicator_table(const Names& names, const Site& site, std::span<const Series> all_series) {
    const auto stand = std::find_if(all_series.begin(), all_series.end(), [](const Series& series) {
        return series.quantity == "hd_above_90_percent";
    });
    if (stand == all_series.end() || years_of(*stand).empty()) {
        return "";
    }
    // Years with rocks, so that protection stands beside the rest.
    const auto protection = std::find_if(all_series.begin(), all_series.end(), [](const Series& series) {
        return series.quantity == "protection_percent" && !years_of(series).empty();
    });
    const std::vector<std::int32_t> known = years_of(protection == all_series.end() ? *stand : *protection);
    std::vector<std::int32_t> years;
    for (const std::int32_t year : {known.front(), known[known.size() / 2], known.back()}) {
        if (years.empty() || years.back() != year) {
            years.push_back(year);
        }
    }
    std::vector<std::string> head{page_text("Figure")};
    for (const std::int32_t year : years) {
        head.push_back(page_text("year {year}", {{"year", std::to_string(year)}}));
    }
    report::HtmlTable table{page_text(has_protection(all_series)
                                          ? "Mean of the replicates, in brackets its 90 % interval. "
                                            "Protection with and without dead wood is that of the same rocks."
                                          : "Mean of the replicates, in brackets its 90 % interval."),
                            head};
    for (const Indicator& indicator : indicators_of_page) {
        for (const Series& series : all_series) {
            if (series.quantity != indicator.quantity || years_of(series).empty()) {
                continue;
            }
            const bool names_target = !series.target.empty() && site.targets.size() > 1;
            table.group(joined(page_text(indicator.name),
                               names_target ? joined(", ", report::escaped(series.target)) : ""));
            for (std::size_t course = 0; course < names.courses(); ++course) {
                std::vector<std::string> row{report::escaped(look_of(names, course).title())};
                for (const std::int32_t year : years) {
                    row.push_back(indicator_cell(series, course, year, indicator.decimals));
                }
                table.row(row);
            }
        }
    }
    return joined("<section class=\"card\">", table.html(), "</section>\n");
}

}  // namespace coupling::decades
