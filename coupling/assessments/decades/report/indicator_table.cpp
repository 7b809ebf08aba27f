#include "coupling/assessments/decades/report/indicator_table.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "coupling/assessments/decades/report/figure_cells.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::decades {
namespace {

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
    const std::vector<std::int32_t> years = three_of(known);
    std::vector<report::PageFields> figures;
    for (const Indicator& indicator : indicators_of_page) {
        for (const Series& series : all_series) {
            if (series.quantity != indicator.quantity || years_of(series).empty()) {
                continue;
            }
            const bool names_target = !series.target.empty() && site.targets.size() > 1;
            const std::string name =
                report::join_with_commas({page_text(indicator.name), names_target ? series.target : ""});
            figures.push_back(figure_over_years(names, series, name, years, indicator.decimals));
        }
    }
    return report::filled_template("indicator_table.html", {{"protects", has_protection(all_series)},
                                                            {"years", heads_of(years)},
                                                            {"grouped", true},
                                                            {"columns", std::to_string(years.size() + 1)},
                                                            {"figures", figures}});
}

}  // namespace coupling::decades
