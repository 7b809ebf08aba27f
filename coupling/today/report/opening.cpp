#include <algorithm>
#include <vector>

#include "config/text/joined.hpp"
#include "coupling/results/report/deciding.hpp"
#include "coupling/results/report/listings.hpp"
#include "coupling/results/report/markup.hpp"
#include "coupling/results/report/page_head.hpp"
#include "coupling/results/report/page_text.hpp"
#include "coupling/today/report/sections.hpp"

namespace coupling::report {
namespace {

using config::joined;

std::size_t zones_of(const Site& site) {
    std::vector<std::uint32_t> zones;
    for (const rockfall::ReleaseSource& source : site.sources) {
        zones.push_back(source.zone);
    }
    std::sort(zones.begin(), zones.end());
    return static_cast<std::size_t>(std::unique(zones.begin(), zones.end()) - zones.begin());
}

}  // namespace

std::string why_no_obstacles(const RunResults& results) {
    const Scenario& scenario = results.scenario;
    if (scenario.trees.empty() && scenario.logs.empty()) {
        return page_text("today.opening.neither_trees_nor_logs_were");
    }
    const std::string files =
        joined(scenario.trees, scenario.trees.empty() || scenario.logs.empty() ? "" : page_text("common.and"),
               scenario.logs);
    return page_text("today.opening.no_trees_or_logs_are_left_list", {{"files", escaped(files)}});
}

std::string opening(const RunResults& results, const Figures&) {
    const Scenario& scenario = results.scenario;
    const Site& site = results.site;
    const config::GridFrame& frame = site.map_frame;
    std::string html = joined(
        page_head(scenario.report, results.with_forest
                                       ? page_text("today.opening.rockfall_with_and_without")
                                       : page_text("today.opening.rockfall_over_the_bare_slope")),
        "<p class=\"lead\">",
        page_text(
            "today.opening.scenario_rocks_were_released",
            {{"file", escaped(scenario.file.filename().string())},
             {"rocks", grouped(results.rocks)},
             {"sources", grouped(site.sources.size())},
             {"part",
              (results.with_forest
                   ? page_text("today.opening.each_falling_twice_with_the",
                               {{"logs", site.logs.empty() ? "" : page_text("today.opening.and_its_logs")}})
                   : page_text("today.opening.and_fell_over_the_bare_slope",
                               {{"why_no_obstacles", why_no_obstacles(results)}}))}}),
        "</p>\n<dl class=\"facts\">");
    html += fact(page_text("today.opening.terrain"),
                 page_text("today.opening.m_cells_of_m",
                           {{"frame_x_west_m", three_digits(frame.x_east_m() - frame.x_west_m)},
                            {"frame_y_south_m", three_digits(frame.y_north_m() - frame.y_south_m)},
                            {"frame_cell_width_m", three_digits(frame.cell_width_m)}}));
    html += fact(page_text("common.release"),
                 page_text("today.opening.sources_in",
                           {{"sources", grouped(site.sources.size())},
                            {"zones_of", grouped(zones_of(site))},
                            {"part", (zones_of(site) == 1 ? page_text("today.opening.zone")
                                                          : page_text("today.opening.zones"))}}));
    html += fact(page_text("today.opening.trees"), grouped(site.trees.size()));
    if (!site.logs.empty()) {
        html += fact(page_text("today.opening.lying_logs"), grouped(site.logs.size()));
    }
    html += deciding_facts(scenario, site.sources, grouped(results.rocks));
    return joined(html,
                  fact(page_text("common.program"),
                       page_text("common.bannwald", {{"version", escaped(results.version)}})),
                  "</dl>\n");
}

}  // namespace coupling::report
