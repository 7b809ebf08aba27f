#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "config/text/joined.hpp"
#include "coupling/assessments/hazard/arrival_sections.hpp"
#include "coupling/assessments/hazard/hazard_colours.hpp"
#include "coupling/assessments/hazard/hazard_results.hpp"
#include "coupling/assessments/hazard/matrix_drawing.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/report/deciding.hpp"
#include "coupling/results/report/departures_line.hpp"
#include "coupling/results/report/first_warnings.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/report/listings.hpp"
#include "coupling/results/report/map/map_sheet.hpp"
#include "coupling/results/report/page_frame.hpp"
#include "coupling/results/report/page_head.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/messages.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/writing_language.hpp"

namespace coupling::hazard {
namespace {

using config::joined;
using report::ColourScale;
using report::escaped;
using report::HtmlTable;
using report::message_text;
using report::page_text;

/// Names of classes as the page says them.
std::vector<ClassColour> named(std::vector<ClassColour> classes) {
    for (ClassColour& one : classes) {
        one.label = message_text(one.label);
    }
    return classes;
}

std::string energy_in_words(HazardEnergy energy) {
    switch (energy) {
        case HazardEnergy::mean:
            return page_text("mean energy");
        case HazardEnergy::max:
            return page_text("largest energy");
        default:
            return page_text("{energy_substr}th percentile of the energies",
                             {{"energy_substr", stem_of(energy).substr(2)}});
    }
}

/// "high on 35.2 % of it, moderate on 20 %": levels above none, the highest first.
std::string levels_in_words(const std::vector<double>& shares) {
    std::vector<std::string> texts;
    for (std::size_t level = levels - 1; level > 0; --level) {
        if (shares[level] > 0.0) {
            texts.push_back(page_text("{level} on {share}", {{"level", message_text(level_names[level])},
                                                             {"share", report::percent(shares[level])}}));
        }
    }
    return texts.empty() ? page_text("none") : report::join_with_commas(texts);
}

/// Share of a target at a level or above.
double share_from(const TargetHazard& target, std::size_t level) {
    return std::accumulate(target.levels.begin() + static_cast<std::ptrdiff_t>(level), target.levels.end(),
                           0.0);
}

/// Who reads the levels alone would blame the forest.
std::string note_on_forest(const HazardResults& results) {
    if (results.slopes.size() < 2) {
        return "";
    }
    const SlopeHazard& forest = results.slopes.front();
    const SlopeHazard& bare = results.slopes.back();
    bool rises = false;
    for (std::size_t i = 0; i < results.site.targets.size(); ++i) {
        for (std::size_t level = 1; level < levels; ++level) {
            rises = rises || share_from(forest.targets[i], level) > share_from(bare.targets[i], level) + 1e-9;
        }
    }
    if (!rises) {
        return "";
    }
    const bool of_those_that_pass = results.scenario.hazard.energy != HazardEnergy::max;
    return joined(
        "<ul class=\"notes\"><li>",
        report::join_sentences(
            {page_text("With forest parts of a target have a higher level than without."),
             of_those_that_pass
                 ? page_text("Intensity is the energy of the rocks that still arrive. A forest that stops "
                             "small and slow rocks raises their percentiles and their mean, although fewer "
                             "arrive.")
                 : "",
             page_text("Trees also deflect rocks, and where few rocks pass the result is uncertain. The "
                       "table below has the number of rocks that the forest stops.")}),
        "</li></ul>\n");
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
                   years_text(most.return_period_years), ")");
        slopes.insert(slope.cover == Cover::bare ? slopes.begin() : slopes.end(),
                      {name, most.departures[index_of(slope.cover)]});
    }
    return report::departures_line(slopes);
}

std::string opening(const HazardResults& results) {
    const std::string name = escaped(results.scenario.file.stem().string());
    std::string periods;
    std::uint64_t rocks = 0;
    for (const FinishedPeriod& period : results.periods) {
        periods += joined(periods.empty() ? "" : ", ", report::exact(period.return_period_years));
        rocks += period.rocks;
    }
    std::string html = joined(
        report::page_head(results.scenario.report,
                          page_text("Rockfall hazard map: {name}", {{"name", name}})),
        report::first_warnings(results.warnings), leaving(results), "<dl class=\"facts\">",
        report::fact(page_text("Return periods of the release"),
                     page_text("{periods} years", {{"periods", periods}})),
        report::fact(page_text("Return period that the level uses"),
                     page_text("that of the release; beside it that of the arrival")),
        report::fact(page_text("Smallest zone in the GeoPackage"),
                     report::marked(results.scenario,
                                    joined(report::exact(results.scenario.hazard.smallest_zone_m2), " m²"),
                                    {"hazard.smallest_zone_m2"})),
        report::fact(page_text("Intensity"),
                     report::marked(results.scenario, energy_in_words(results.scenario.hazard.energy),
                                    {"hazard.energy"})),
        report::fact(
            page_text("Least reach of a cell"),
            report::marked(results.scenario,
                           joined(report::exact(results.scenario.hazard.least_reach_percent), "\u00a0%"),
                           {"hazard.least_reach_percent"})),
        report::deciding_facts(results.scenario, results.site.sources, report::grouped(rocks),
                               sizes_of_rocks(results)),
        results.site.nets.empty()
            ? ""
            : report::fact(page_text("Nets"),
                           page_text("{nets}, standing on both slopes: the levels are those with them, and "
                                     "what they held stands on the page of each return period",
                                     {{"nets", report::grouped(results.site.nets.size())}})),
        "</dl>\n<p class=\"lead\">",
        report::join_sentences(
            {page_text("The highest hazard level of all return periods. A return period here is that of the "
                       "<b>release</b>, how often such rocks break off. It is not that of the "
                       "<b>arrival</b> at a target."),
             page_text(results.scenario.hazard.least_reach_percent > 0.0
                           ? "The levels do not depend on how many of the rocks arrive, but for cells below "
                             "the least reach."
                           : "The levels do not depend on how many of the rocks arrive.")}),
        "</p>\n");
    for (std::size_t i = 0; i < results.site.targets.size(); ++i) {
        html += joined("<section class=\"card\"><h3>", escaped(results.site.targets[i].name), "</h3>");
        for (const SlopeHazard& slope : results.slopes) {
            html += joined(
                "<p class=\"answer\">",
                page_text("<b>{slope}:</b> {levels}.",
                          {{"slope", page_text(slope.cover == Cover::forest ? "With forest" : "Bare slope")},
                           {"levels", levels_in_words(slope.targets[i].levels)}}),
                "</p><p>",
                page_text("By the return period of the arrival: {levels}.",
                          {{"levels", levels_in_words(slope.targets[i].arrival_levels)}}),
                "</p>");
        }
        html += "</section>\n";
    }
    return joined(html, note_on_forest(results));
}

std::string about_the_map(const HazardResults& results) {
    const HazardSettings& hazard = results.scenario.hazard;
    const std::string rim =
        hazard.least_reach_percent > 0.0
            ? page_text(
                  "Cells that fewer than {hazard_least_reach_percent} % of the rocks from the sources above "
                  "them pass are left out.",
                  {{"hazard_least_reach_percent", report::exact(hazard.least_reach_percent)}})
            : page_text(
                  "A cell counts as soon as one simulated rock passes it: more rocks, and larger cells, "
                  "widen its rim; <code>hazard.least_reach_percent</code> sets a limit.");
    const std::string source =
        hazard.matrix.empty()
            ? page_text(
                  "After the Swiss federal recommendation (BUWAL/BWW/BRP 1997; FOEN 2016) as the literature "
                  "draws it, not checked against the original; cantons divide some fields otherwise: "
                  "<code>bannwald info hazard_matrix</code>, setting <code>hazard.matrix</code>.")
            : page_text("Levels of {hazard_matrix}.", {{"hazard_matrix", escaped(hazard.matrix)}});
    return joined(
        "<h2>", page_text("How a level comes about"), "</h2>\n<section class=\"card\"><p>",
        page_text(
            "For each return period its rocks fall from the release zones that have any. The {hazard_energy} "
            "in a cell (of each rock the largest one there) is its intensity; with the return period it "
            "gives a level. The map shows the highest level of all return periods. {rim}",
            {{"hazard_energy", energy_in_words(hazard.energy)}, {"rim", rim}}),
        "</p>", matrix_drawing(results), "<p class=\"soft\">", source, "</p></section>\n");
}

std::string rocks_table(const HazardResults& results) {
    std::vector<std::string> head{page_text("Release zone")};
    for (const FinishedPeriod& period : results.periods) {
        head.push_back(years_text(period.return_period_years));
    }
    HtmlTable table{page_text("Diameter, mass and number of the rocks by return period."), head};
    std::vector<std::string> zones;
    for (const ZoneRocks& rocks : results.rocks) {
        if (std::find(zones.begin(), zones.end(), rocks.zone) == zones.end()) {
            zones.push_back(rocks.zone);
        }
    }
    for (const std::string& zone : zones) {
        std::vector<std::string> cells{zone};
        for (const FinishedPeriod& period : results.periods) {
            const auto found =
                std::find_if(results.rocks.begin(), results.rocks.end(), [&](const ZoneRocks& rocks) {
                    return rocks.zone == zone && rocks.return_period_years == period.return_period_years;
                });
            cells.push_back(
                found == results.rocks.end()
                    ? "–"
                    : joined(
                          page_text("{found_diameter_m} m, {found_mass_kg} kg",
                                    {{"found_diameter_m", report::three_digits(found->diameter_m)},
                                     {"found_mass_kg", report::three_digits(found->mass_kg)}}),
                          "<br/><span class=\"soft\">",
                          page_text("{found_rocks} rocks", {{"found_rocks", report::grouped(found->rocks)}}),
                          "</span>"));
        }
        table.row(cells);
    }
    std::vector<std::string> links{page_text("Page of these rocks")};
    for (const FinishedPeriod& period : results.periods) {
        links.push_back(joined("<a href=\"../", escaped(period.folder.filename().string()), "/report.html\">",
                               page_text("report"), "</a>"));
    }
    table.row(links);
    return joined("<h2>", page_text("Rocks"), "</h2>\n<section class=\"card\"><div class=\"wide\">",
                  table.html(), "</div></section>\n");
}

std::string shares_table(const HazardResults& results) {
    std::vector<std::string> head{""};
    for (std::size_t level = levels; level-- > 0;) {
        head.push_back(message_text(level_names[level]));
    }
    HtmlTable table{page_text("Shares of a target's length or area, and plan areas of the map."), head};
    for (std::size_t i = 0; i < results.site.targets.size(); ++i) {
        table.group(escaped(results.site.targets[i].name));
        for (const SlopeHazard& slope : results.slopes) {
            std::vector<std::string> cells{words_of(slope.cover)};
            for (std::size_t level = levels; level-- > 0;) {
                cells.push_back(report::percent(slope.targets[i].levels[level]));
            }
            table.row(cells);
        }
    }
    table.group(page_text("Map"));
    for (const SlopeHazard& slope : results.slopes) {
        std::vector<std::string> cells{words_of(slope.cover)};
        for (std::size_t level = levels; level-- > 0;) {
            cells.push_back(page_text(
                "{level_level} ha",
                {{"level_level",
                  report::fixed(level_area_ha(slope.map.level, results.site, static_cast<Level>(level)),
                                2)}}));
        }
        table.row(cells);
    }
    return joined("<h2>", page_text("Levels"), "</h2>\n<section class=\"card\"><div class=\"wide\">",
                  table.html(), "</div></section>\n");
}

/// Intensities at the targets by return period.
std::string intensities_table(const HazardResults& results) {
    std::vector<std::string> head{"", page_text("Return period")};
    for (std::size_t i = results.matrix.intensities(); i-- > 0;) {
        head.push_back(escaped(message_text(results.matrix.intensity_name(i))));
    }
    head.emplace_back(page_text("no rock"));
    HtmlTable table{page_text("Shares of a target's length or area by intensity."), head};
    for (std::size_t target = 0; target < results.site.targets.size(); ++target) {
        table.group(escaped(results.site.targets[target].name));
        for (const SlopeHazard& slope : results.slopes) {
            for (std::size_t period = 0; period < results.periods.size(); ++period) {
                std::vector<std::string> cells{words_of(slope.cover),
                                               years_text(results.periods[period].return_period_years)};
                for (std::size_t i = results.matrix.intensities() + 1; i-- > 0;) {
                    cells.push_back(report::percent(slope.targets[target].intensities[period][i]));
                }
                table.row(cells);
            }
        }
    }
    return joined("<section class=\"card\"><div class=\"wide\">", table.html(), "</div></section>\n");
}

std::string maps(const HazardResults& results) {
    const report::MapSheet sheet{
        results.site, report::window_around(results.site.map_frame, [&](config::Cell cell) {
            return std::any_of(results.slopes.begin(), results.slopes.end(), [&](const SlopeHazard& slope) {
                return std::any_of(
                    slope.map.intensity.begin(), slope.map.intensity.end(),
                    [&](const config::Raster<float>& intensity) { return intensity.at(cell) > 0.0F; });
            });
        })};
    // White cells would hide the ground where no level holds.
    std::vector<ClassColour> shown{level_colours().begin() + 1, level_colours().end()};
    const ColourScale by_level = ColourScale::classes(named(shown));
    std::string html =
        joined(sheet.definitions(), "<h2>", page_text("Hazard map"), "</h2>\n<div class=\"halves\">");
    for (const SlopeHazard& slope : results.slopes) {
        html += sheet.figure(
            {words_of(slope.cover),
             page_text("Hazard levels, {words_of_slope}", {{"words_of_slope", words_of(slope.cover)}}),
             sheet.picture(slope.map.level, by_level), by_level.legend("levels"), ""},
            report::MapSize::half);
    }
    html += joined("</div>\n", levels_by_arrival(results, sheet, by_level));
    html += joined(
        "<p class=\"soft\">",
        page_text("North is up; coordinates and scale in metres; cells of {map_frame_cell_width_m} m. Thin "
                  "outlines: release sources of the longest return period. Thick lines: targets.",
                  {{"map_frame_cell_width_m", report::three_digits(results.site.map_frame.cell_width_m)}}),
        "</p>\n", shares_table(results), "<h2>", page_text("Intensity by return period"), "</h2>\n");
    const ColourScale by_energy = ColourScale::classes(named(intensity_colours(results.matrix)));
    for (std::size_t i = 0; i < results.periods.size(); ++i) {
        const std::string years = years_text(results.periods[i].return_period_years);
        html += joined("<h3>", years, "</h3>\n<div class=\"halves\">");
        for (const SlopeHazard& slope : results.slopes) {
            html += sheet.figure(
                {joined(years, ", ", words_of(slope.cover)),
                 page_text("Intensity, {years}, {words_of_slope}",
                           {{"years", years}, {"words_of_slope", words_of(slope.cover)}}),
                 sheet.picture(slope.map.intensity[i], by_energy), by_energy.legend("intensities"), ""},
                report::MapSize::half);
        }
        html += "</div>\n";
    }
    return results.site.targets.empty() ? html : joined(html, intensities_table(results));
}

}  // namespace

void write_page(std::ostream& out, const HazardResults& results, const std::vector<WrittenFile>& files) {
    const report::WritingLanguage language{results.scenario.report.language};
    const report::PageFrame frame{
        .title = report::page_title(results.scenario.report,
                                    page_text("Rockfall hazard map: {name}",
                                              {{"name", escaped(results.scenario.file.stem().string())}})),
        .version = results.version,
        .scripts = {},
        .style = {},
        .before_main = {}};
    report::begin_page(out, frame);
    out << opening(results) << arrivals_table(results) << maps(results) << about_the_map(results)
        << rocks_table(results) << joined("<h2>", page_text("Warnings"), "</h2>\n")
        << report::list_of_warnings(results.warnings)
        << report::settings_section(results.scenario, [](const std::string&) { return true; })
        << joined("<h2>", page_text("Data"), "</h2>\n<section class=\"card\">")
        << report::table_of_inputs(results.inputs)
        << joined("</section>\n<h2>", page_text("Files"), "</h2>\n<section class=\"card\">")
        << report::table_of_files(
               page_text("Grids have their projection (.prj) and a QGIS style (.qml) beside them."), files)
        << "</section>\n"
        << report::citation(results.version, results.scenario);
    report::end_page(out, frame);
}

}  // namespace coupling::hazard
