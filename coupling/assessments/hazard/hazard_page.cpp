#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "config/text/joined.hpp"
#include "coupling/assessments/hazard/few_rocks_page.hpp"
#include "coupling/assessments/hazard/hazard_answers.hpp"
#include "coupling/assessments/hazard/hazard_colours.hpp"
#include "coupling/assessments/hazard/hazard_results.hpp"
#include "coupling/assessments/hazard/matrix_drawing.hpp"
#include "coupling/assessments/hazard/target_ranks.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/report/deciding.hpp"
#include "coupling/results/report/departures_line.hpp"
#include "coupling/results/report/first_warnings.hpp"
#include "coupling/results/report/listings.hpp"
#include "coupling/results/report/map/map_key.hpp"
#include "coupling/results/report/map/map_sheet.hpp"
#include "coupling/results/report/page_frame.hpp"
#include "coupling/results/report/page_head.hpp"
#include "coupling/results/templates/page_files.hpp"
#include "coupling/results/templates/page_template.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/messages.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/scenario_names.hpp"
#include "coupling/results/text/writing_language.hpp"
#include "coupling/results/text/years.hpp"
#include "rockfall/tally/release_window.hpp"

namespace coupling::hazard {
namespace {

using config::joined;
using report::ColourScale;
using report::message_text;
using report::page_text;
using report::PageFields;

/// What the page is about.
std::string about() {
    return page_text("Rockfall hazard map");
}

/// Names of classes as the page says them.
std::vector<ClassColour> named(std::vector<ClassColour> classes) {
    for (ClassColour& one : classes) {
        one.label = message_text(one.label);
    }
    return classes;
}

/// What hazard.rule says, in a few words.
std::string rule_in_words(HazardRule rule, const std::string& own_matrix) {
    switch (rule) {
        case HazardRule::cadanav:
            if (!own_matrix.empty()) {
                return page_text("how often rocks of each class of energy hit the place (matrix: {matrix})",
                                 {{"matrix", own_matrix}});
            }
            return page_text("how often rocks of each class of energy hit the place (Swiss matrix)");
        case HazardRule::arrival:
            return page_text("energy of the rocks that hit the place, return period of their arrival");
        case HazardRule::release:
            break;
    }
    return page_text("energy of the rocks that hit the place, return period of their release");
}

/// Smallest and largest rock of all return periods.
std::string sizes_of_rocks(const HazardResults& results) {
    double low_m = std::numeric_limits<double>::infinity();
    double high_m = 0.0;
    for (const FinishedPeriod& period : results.periods) {
        low_m = std::min(low_m, period.diameters.smallest_m);
        high_m = std::max(high_m, period.diameters.largest_m);
    }
    return report::marked(
        results.scenario,
        page_text("{low_m} to {high_m} m by return period and zone, spheres",
                  {{"low_m", report::fixed(low_m, 2)}, {"high_m", report::fixed(high_m, 2)}}),
        {"hazard.blocks"});
}

/// Of each slope the return period whose rocks leave most.
std::string leaving(const HazardResults& results) {
    std::vector<report::DeparturesOfSlope> slopes;
    for (const SlopeHazard& slope : results.slopes) {
        const FinishedPeriod& most = leaves_most(results.periods, slope.cover);
        const std::string name =
            joined(page_text(slope.cover == Cover::bare ? "over the bare slope" : "with forest"), " (",
                   report::years_in_words(most.return_period_years), ")");
        slopes.insert(slope.cover == Cover::bare ? slopes.begin() : slopes.end(),
                      {name, most.departures[index_of(slope.cover)]});
    }
    return report::departures_line(slopes);
}

PageFields opening(const HazardResults& results) {
    const Scenario& scenario = results.scenario;
    const HazardSettings& hazard = scenario.hazard;
    std::vector<std::string> periods;
    std::uint64_t rocks = 0;
    for (const FinishedPeriod& period : results.periods) {
        periods.push_back(report::exact(period.return_period_years));
        rocks += period.rocks;
    }
    return {
        {"head", report::page_head(scenario.report, about())},
        {"warnings_link", report::link_to_first_warnings(results.warnings)},
        {"first_warnings", report::first_warnings(results.warnings)},
        {"leaving", leaving(results)},
        {"periods", report::join_with_commas(periods)},
        {"rule", report::marked(scenario, rule_in_words(hazard.rule, hazard.matrix), {"hazard.rule"})},
        {"compared_rule", rule_in_words(results.slopes.front().compared.rule, hazard.matrix)},
        {"smallest_zone", report::marked(scenario, joined(report::exact(hazard.smallest_zone_m2), " m²"),
                                         {"hazard.smallest_zone_m2"})},
        {"intensity", report::marked(scenario, energy_in_words(hazard.energy), {"hazard.energy"})},
        {"least_reach", report::marked(scenario, joined(report::exact(hazard.least_reach_percent), "\u00a0%"),
                                       {"hazard.least_reach_percent"})},
        {"deciding", report::deciding_facts(scenario, results.site.sources, report::grouped(rocks),
                                            sizes_of_rocks(results))},
        {"with_nets", !results.site.nets.empty()},
        {"with_works", !results.site.works.empty()},
        {"barriers_may_raise", (!results.site.nets.empty() || !results.site.works.empty()) &&
                                   results.scenario.hazard.rule != HazardRule::cadanav},
        {"map_key", report::map_key(report::drawn_of(results.site))},
        {"lines", report::lines_in_words(report::drawn_of(results.site), {.of_longest_period = true})},
        {"nets", report::grouped(results.site.nets.size())},
        {"works", report::grouped(results.site.works.size())}};
}

PageFields areas_of_levels(const HazardResults& results) {
    std::vector<PageFields> names;
    for (std::size_t level = levels; level-- > 0;) {
        names.push_back({{"level", message_text(level_names[level])}});
    }
    std::vector<PageFields> slopes;
    for (const SlopeHazard& slope : results.slopes) {
        std::vector<PageFields> areas;
        std::vector<PageFields> zones;
        for (std::size_t level = levels; level-- > 0;) {
            zones.push_back({{"area", level > 0 ? joined(report::hectares(slope.zones_ha[level]), " ha")
                                                : std::string{"–"}}});
            const double area_ha = level_area_ha(slope.map.level, results.site, static_cast<Level>(level));
            areas.push_back({{"area", report::hectares(area_ha)}});
        }
        slopes.push_back({{"cover", slope_words(slope.cover)}, {"areas", areas}, {"zone_areas", zones}});
    }
    return {
        {"level_names", names}, {"level_columns", std::to_string(levels + 1)}, {"areas_by_slope", slopes}};
}

PageFields about_the_levels(const HazardResults& results) {
    const HazardSettings& hazard = results.scenario.hazard;
    return {{"hazard_energy", energy_in_words(hazard.energy)},
            {"least_reach_is_set", hazard.least_reach_percent > 0.0},
            {"hazard_least_reach_percent", report::exact(hazard.least_reach_percent)},
            {"matrix", matrix_drawing(results)},
            {"own_matrix", !hazard.matrix.empty()},
            {"hazard_matrix", hazard.matrix}};
}

/// Its number, or what the table calls several zones that share their rocks.
std::string zone_in_words(const std::string& zone) {
    return zone == "others" ? page_text("other zones") : zone == "all" ? page_text("all zones") : zone;
}

std::vector<PageFields> rocks_by_zone(const HazardResults& results) {
    std::vector<std::string> zones;
    for (const ZoneRocks& rocks : results.rocks) {
        if (std::find(zones.begin(), zones.end(), rocks.zone) == zones.end()) {
            zones.push_back(rocks.zone);
        }
    }
    std::vector<PageFields> rows;
    for (const std::string& zone : zones) {
        std::vector<PageFields> cells;
        for (const FinishedPeriod& period : results.periods) {
            std::optional<PageFields> here;
            for (const ZoneRocks& rocks : results.rocks) {
                if (rocks.zone == zone && rocks.return_period_years == period.return_period_years) {
                    here = PageFields{{"diameter", report::three_digits(rocks.diameter_m)},
                                      {"mass", report::three_digits(rocks.mass_kg)},
                                      {"rocks", report::grouped(rocks.rocks)}};
                }
            }
            cells.push_back({{"rocks_fall", here}});
        }
        rows.push_back({{"zone", zone_in_words(zone)}, {"cells", cells}});
    }
    return rows;
}

/// Maps of all slopes side by side.
template <class ContentOf>
std::string map_of_each_slope(const HazardResults& results, const report::MapSheet& sheet,
                              const ContentOf& content_of) {
    std::string html;
    for (const SlopeHazard& slope : results.slopes) {
        html += sheet.figure(content_of(slope, slope_words(slope.cover)), report::MapSize::half);
    }
    return html;
}

/// Of each cell the class of the mean time between two arrivals of rocks of all return periods, from 1; NaN
/// where none arrives.
config::Raster<float> arrival_classes(const SlopeHazard& slope, const Matrix& matrix) {
    config::Raster<float> classes = slope.map.arrival_years.front();
    for (std::size_t cell = 0; cell < classes.values.size(); ++cell) {
        double per_year = 0.0;
        for (const config::Raster<float>& of_period : slope.map.arrival_years) {
            const float years = of_period.values[cell];
            per_year += std::isnan(years) ? 0.0 : 1.0 / static_cast<double>(years);
        }
        classes.values[cell] = per_year > 0.0 ? static_cast<float>(matrix.frequency_of(1.0 / per_year) + 1)
                                              : std::numeric_limits<float>::quiet_NaN();
    }
    return classes;
}

/// Classes of return periods of the matrix, the most frequent one darkest.
std::vector<ClassColour> arrival_colours(const Matrix& matrix) {
    std::vector<ClassColour> classes;
    for (std::size_t i = 0; i < matrix.frequencies(); ++i) {
        const double place = 1.0 - static_cast<double>(i) / static_cast<double>(matrix.frequencies());
        classes.push_back(
            {static_cast<double>(i + 1), matrix.frequency_name(i), colour_at(Palette::reach, place)});
    }
    return classes;
}

/// The square in which rocks count for a cell; nothing where it is the cell alone.
std::optional<PageFields> counted_square(const HazardResults& results) {
    const config::GridFrame& frame = results.site.map_frame;
    const double width_m = results.scenario.hazard.counted_width_m();
    const rockfall::CellReach reach = rockfall::reach_of_width(width_m, frame);
    if (reach.is_of_one_cell()) {
        return std::nullopt;
    }
    return PageFields{{"square_m", report::three_digits((2 * reach.columns + 1) * frame.cell_width_m)},
                      {"reference_width_m", report::three_digits(width_m)}};
}

PageFields maps(const HazardResults& results) {
    report::MapSheet sheet{
        results.site, report::window_around(results.site.map_frame, [&](config::Cell cell) {
            return std::any_of(results.slopes.begin(), results.slopes.end(), [&](const SlopeHazard& slope) {
                return std::any_of(
                    slope.map.intensity.begin(), slope.map.intensity.end(),
                    [&](const config::Raster<float>& intensity) { return intensity.at(cell) > 0.0F; });
            });
        })};
    sheet.name_only(first_targets(results, most_rows));
    // White cells would hide the ground where no level holds.
    std::vector<ClassColour> shown{level_colours().begin() + 1, level_colours().end()};
    const ColourScale by_level = ColourScale::classes(named(shown));
    const auto level_map = [&](const HazardMap& map, const std::string& cover) {
        return report::MapContent{cover,
                                  page_text("Hazard levels, {words_of_slope}", {{"words_of_slope", cover}}),
                                  sheet.picture(map.level, by_level), by_level.legend("levels"), ""};
    };
    const ColourScale by_energy = ColourScale::classes(named(intensity_colours(results.matrix)));
    const ColourScale by_arrival = ColourScale::classes(named(arrival_colours(results.matrix)));
    const auto arrival_map = [&](const SlopeHazard& slope, const std::string& cover) {
        return report::MapContent{
            cover, page_text("Return period of arrival, {words_of_slope}", {{"words_of_slope", cover}}),
            sheet.picture(arrival_classes(slope, results.matrix), by_arrival), by_arrival.legend("arrivals"),
            ""};
    };
    std::vector<PageFields> periods;
    for (std::size_t i = 0; i < results.periods.size(); ++i) {
        const std::string years = report::years_in_words(results.periods[i].return_period_years);
        const auto intensity_map = [&](const SlopeHazard& slope, const std::string& cover) {
            return report::MapContent{report::join_with_commas({years, cover}),
                                      page_text("Intensity, {years}, {words_of_slope}",
                                                {{"years", years}, {"words_of_slope", cover}}),
                                      sheet.picture(slope.map.intensity[i], by_energy),
                                      by_energy.legend("intensities"), ""};
        };
        periods.push_back({{"years", years},
                           {"folder", results.periods[i].folder.filename().string()},
                           {"intensity_maps", map_of_each_slope(results, sheet, intensity_map)}});
    }
    return {{"map_definitions", sheet.definitions()},
            {"level_maps", map_of_each_slope(results, sheet,
                                             [&](const SlopeHazard& slope, const std::string& cover) {
                                                 return level_map(slope.map, cover);
                                             })},
            {"arrival_maps", map_of_each_slope(results, sheet, arrival_map)},
            {"compared_maps", map_of_each_slope(results, sheet,
                                                [&](const SlopeHazard& slope, const std::string& cover) {
                                                    return level_map(slope.compared, cover);
                                                })},
            {"intensity_key", by_energy.legend("intensities-of-all")},
            {"map_frame_cell_width_m", report::three_digits(results.site.map_frame.cell_width_m)},
            {"counted_square", counted_square(results)},
            {"return_periods", periods}};
}

std::optional<PageFields> risk_part(const HazardResults& results) {
    return results.risk ? std::optional{risk::risk_fields(*results.risk, results.site, results.scenario)}
                        : std::nullopt;
}

}  // namespace

void write_page(std::ostream& out, const HazardResults& results, const std::vector<WrittenFile>& files) {
    const report::WritingLanguage language{results.scenario.report.language};
    const report::NamesOfScenario names_of_scenario{results.scenario};
    const report::PageFrame frame{
        .title = report::page_title(results.scenario.report, about()),
        .version = results.version,
        .scripts = {},
        .style = joined(report::page_file("short_print.css"), report::page_file("hazard.css")),
        .before_main = {}};
    PageFields fields{
        {"risk", risk_part(results)},
        {"state", state_of_slopes(results)},
        {"zones", rocks_by_zone(results)},
        {"warnings", report::list_of_warnings(results.warnings)},
        {"settings", report::settings_section(results.scenario, [](const std::string&) { return true; })},
        {"inputs", report::table_of_inputs(results.inputs)},
        {"files",
         report::table_of_files(
             page_text("Grids have their projection (.prj) and a QGIS style (.qml) beside them."), files)},
        {"citation", report::citation(results.version, results.scenario)}};
    const auto few_rocks = [&](std::size_t target) { return warning_of_few(results, target); };
    for (const PageFields& part : {opening(results), answer_fields(results, few_rocks), maps(results),
                                   areas_of_levels(results), about_the_levels(results)}) {
        fields.insert(fields.end(), part.begin(), part.end());
    }
    report::begin_page(out, frame);
    out << report::filled_template("hazard_page.html", fields);
    report::end_page(out, frame);
}

}  // namespace coupling::hazard
