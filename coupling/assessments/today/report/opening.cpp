#include <algorithm>
#include <optional>
#include <vector>

#include "config/text/joined.hpp"
#include "coupling/assessments/today/report/sections.hpp"
#include "coupling/inputs/forest/listed_density.hpp"
#include "coupling/inputs/reading/stands_of_today.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/report/deciding.hpp"
#include "coupling/results/report/departures_line.hpp"
#include "coupling/results/report/first_warnings.hpp"
#include "coupling/results/report/page_head.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/scenario_names.hpp"

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

std::string sizes_in_words(const RunResults& results) {
    const rockfall::DiameterRange range =
        rockfall::diameter_range(start_law(results.scenario.release), results.site.sources);
    const std::string low = fixed(range.smallest_m, 2);
    const std::string high = fixed(range.largest_m, 2);
    return low == high ? joined(low, " m")
                       : page_text("{diameter_low_m} to {diameter_high_m} m",
                                   {{"diameter_low_m", low}, {"diameter_high_m", high}});
}

/// "Road", "Road and House", "12 targets".
std::string targets_in_words(const Site& site) {
    constexpr std::size_t most_names = 3;
    if (site.targets.size() > most_names) {
        return page_text("{targets} targets", {{"targets", grouped(site.targets.size())}});
    }
    std::vector<std::string> names;
    for (const rockfall::Target& target : site.targets) {
        names.push_back(target.name.empty() ? target.id : target.name);
    }
    return join_with_and(names);
}

/// Half a list of trees shows in its stems per hectare; `bannwald check` says the same.
std::string trees_in_words(const RunResults& results) {
    const std::string count = grouped(results.site.trees.size());
    if (results.site.trees.empty()) {
        return count;
    }
    const ListedDensity density = listed_density(results.site.trees);
    return page_text("{trees}; {per_ha} on the {area_ha} ha of cells of 20 m with a tree",
                     {{"trees", count},
                      {"per_ha", page_text("{stems_pha} stems/ha, {basal_area_m2pha} m²/ha basal area",
                                           {{"stems_pha", fixed(density.stems_pha, 0)},
                                            {"basal_area_m2pha", fixed(density.basal_area_m2pha, 1)}})},
                      {"area_ha", hectares(density.wooded_ha)}});
}

std::string leaving(const RunResults& results) {
    std::vector<DeparturesOfSlope> slopes{
        {page_text("over the bare slope"), departures_of(results, Cover::bare)}};
    if (results.with_forest) {
        slopes.push_back({page_text("with forest"), departures_of(results, Cover::forest)});
    }
    return departures_line(slopes);
}

/// How many sources and rocks, and on what ground.
PageFields extent_of(const RunResults& results) {
    const Site& site = results.site;
    const config::GridFrame& frame = site.map_frame;
    const std::size_t zones = zones_of(site);
    return {{"rocks", grouped(results.rocks)},
            {"sources", grouped(site.sources.size())},
            {"one_source", site.sources.size() == 1},
            {"zones", grouped(zones)},
            {"one_zone", zones == 1},
            {"frame_x_west_m", three_digits(frame.x_east_m() - frame.x_west_m)},
            {"frame_y_south_m", three_digits(frame.y_north_m() - frame.y_south_m)},
            {"frame_cell_width_m", three_digits(frame.cell_width_m)}};
}

}  // namespace

std::string why_no_obstacles(const RunResults& results) {
    const Scenario& scenario = results.scenario;
    std::vector<std::string> given{scenario.trees.source(), scenario.trees.logs};
    if (has_stands_of_today(scenario.run, scenario.trees, scenario.forest)) {
        given.insert(given.end(), {scenario.forest.stand_records, scenario.forest.dbh_classes});
    }
    std::vector<std::string> files;
    for (const std::string& file : given) {
        if (!file.empty()) {
            files.push_back(with_scenario_names(scenario.shown(file)));
        }
    }
    if (files.empty()) {
        return page_text("neither trees nor logs were given");
    }
    return page_text("no trees or logs are left: {files} list none on the terrain",
                     {{"files", join_with_and(files)}});
}

std::string with_return_period(const std::string& title, const Scenario& scenario) {
    const double years = scenario.hazard.return_period_years;
    return years > 0.0 ? page_text("{title} (return period of {years} years)",
                                   {{"title", title}, {"years", exact(years)}})
                       : title;
}

PageFields opening(const RunResults& results) {
    const Scenario& scenario = results.scenario;
    const Site& site = results.site;
    PageFields fields = extent_of(results);
    fields.insert(fields.end(),
                  {{"head", page_head(scenario.report,
                                      with_return_period(results.with_forest
                                                             ? page_text("Rockfall with and without forest")
                                                             : page_text("Rockfall over the bare slope"),
                                                         scenario))},
                   {"sizes", sizes_in_words(results)},
                   {"to_targets", site.targets.empty()
                                      ? std::nullopt
                                      : std::optional{PageFields{{"targets", targets_in_words(site)}}}},
                   {"warnings_link", link_to_first_warnings(results.warnings)},
                   {"first_warnings", first_warnings(results.warnings)},
                   {"leaving", leaving(results)},
                   {"with_logs", !site.logs.empty()},
                   {"logs", grouped(site.logs.size())},
                   {"why_no_obstacles", results.with_forest ? "" : why_no_obstacles(results)},
                   {"file", scenario.file.filename().string()},
                   {"deciding", deciding_facts(scenario, site.sources, grouped(results.rocks), "")},
                   {"trees_in_words", trees_in_words(results)},
                   {"version", results.version}});
    return fields;
}

}  // namespace coupling::report
