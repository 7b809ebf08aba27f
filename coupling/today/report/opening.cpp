#include <algorithm>
#include <vector>

#include "config/text/joined.hpp"
#include "coupling/results/report/deciding.hpp"
#include "coupling/results/report/listings.hpp"
#include "coupling/results/report/markup.hpp"
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
        return "neither trees nor logs were given";
    }
    const std::string files =
        joined(scenario.trees, scenario.trees.empty() || scenario.logs.empty() ? "" : " and ", scenario.logs);
    return joined("no trees or logs are left: ", escaped(files), " list none on the terrain");
}

std::string opening(const RunResults& results, const Figures&) {
    const Scenario& scenario = results.scenario;
    const Site& site = results.site;
    const config::GridFrame& frame = site.map_frame;
    std::string html = joined(
        "<h1>", results.with_forest ? "Rockfall with and without forest" : "Rockfall over the bare slope",
        "</h1>\n<p class=\"lead\">Scenario <b>", escaped(scenario.file.filename().string()),
        "</b>: ", grouped(results.rocks), " rocks were released from ", grouped(site.sources.size()),
        " places",
        (results.with_forest
             ? std::string{", each falling twice with the same random numbers: through the forest as it "
                           "stands, lying logs included, and over the bare slope without either."}
             : joined(" and fell over the bare slope: ", why_no_obstacles(results), ".")),
        "</p>\n<dl class=\"facts\">");
    html += fact("Terrain", joined(three_digits(frame.x_east_m() - frame.x_west_m), " × ",
                                   three_digits(frame.y_north_m() - frame.y_south_m), " m, cells of ",
                                   three_digits(frame.cell_width_m), " m"));
    html += fact("Release", joined(grouped(site.sources.size()), " sources in ", grouped(zones_of(site)),
                                   (zones_of(site) == 1 ? " zone" : " zones")));
    html += fact("Trees", grouped(site.trees.size()));
    if (!site.logs.empty()) {
        html += fact("Lying logs", grouped(site.logs.size()));
    }
    html += deciding_facts(scenario, site.sources, grouped(results.rocks));
    return joined(html, fact("Program", joined("Bannwald ", escaped(results.version))), "</dl>\n");
}

}  // namespace coupling::report
