#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "config/text/joined.hpp"
#include "coupling/assessments/hazard/arrival_sections.hpp"
#include "coupling/assessments/hazard/hazard_colours.hpp"
#include "coupling/assessments/hazard/hazard_results.hpp"
#include "coupling/assessments/hazard/matrix_drawing.hpp"
#include "coupling/results/figures/few_rocks.hpp"
#include "coupling/results/report/deciding.hpp"
#include "coupling/results/report/departures_line.hpp"
#include "coupling/results/report/first_warnings.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/report/listings.hpp"
#include "coupling/results/report/map/map_sheet.hpp"
#include "coupling/results/report/page_frame.hpp"
#include "coupling/results/report/page_head.hpp"
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

const std::string& words_of(Cover cover) {
    return cover == Cover::forest ? report::page_text("common.with_forest")
                                  : report::page_text("common.bare_slope");
}

/// Names of classes as the page says them.
std::vector<ClassColour> named(std::vector<ClassColour> classes) {
    for (ClassColour& one : classes) {
        one.label = message_text(one.label);
    }
    return classes;
}

std::string years_text(double years) {
    return joined(report::exact(years), years == 1.0 ? report::page_text("hazard_page.year")
                                                     : report::page_text("hazard_page.years"));
}

std::string energy_in_words(HazardEnergy energy) {
    switch (energy) {
        case HazardEnergy::mean:
            return report::page_text("common.mean_energy");
        case HazardEnergy::max:
            return report::page_text("hazard_page.largest_energy");
        default:
            return report::page_text("hazard_page.th_percentile_of_the_energies",
                                     {{"energy_substr", stem_of(energy).substr(2)}});
    }
}

/// "high on 35.2 % of it, moderate on 20 %": levels above none, the highest first.
std::string levels_in_words(const std::vector<double>& shares) {
    std::string text;
    for (std::size_t level = levels - 1; level > 0; --level) {
        if (shares[level] > 0.0) {
            text +=
                report::page_text("hazard_page.on", {{"part", text.empty() ? "" : ", "},
                                                     {"level_names_level", message_text(level_names[level])},
                                                     {"levels_level", report::percent(shares[level])}});
        }
    }
    return text.empty() ? report::page_text("common.none") : text;
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
        report::page_text(
            "hazard_page.with_forest_parts_of_a_target",
            {{"part",
              of_those_that_pass ? report::page_text("hazard_page.intensity_is_the_energy_of_the") : ""}}),
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
        report::page_text("hazard_page.to_m_by_return_period_and_zone",
                          {{"low_m", report::fixed(low_m, 2)}, {"high_m", report::fixed(high_m, 2)}}),
        {"hazard.blocks"});
}

/// Of each slope the return period whose rocks leave most.
std::string leaving(const HazardResults& results) {
    std::vector<report::DeparturesOfSlope> slopes;
    for (const SlopeHazard& slope : results.slopes) {
        const FinishedPeriod& most = leaves_most(results.periods, slope.cover);
        const std::string name = joined(
            report::page_text(slope.cover == Cover::bare ? "common.bare_slope_in_text"
                                                         : "common.with_forest_in_text"),
            " (",
            report::page_text("hazard_page.years_3", {{"years", report::exact(most.return_period_years)}}),
            ")");
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
                          report::page_text("hazard_page.rockfall_hazard_map", {{"name", name}})),
        leaving(results), "<dl class=\"facts\">",
        report::fact(report::page_text("hazard_page.return_periods_of_the_release"),
                     report::page_text("hazard_page.years_2", {{"periods", periods}})),
        report::fact(report::page_text("hazard_page.levels_shown"),
                     report::page_text("hazard_page.of_the_release_beside_arrival")),
        report::fact(report::page_text("hazard_page.smallest_zone"),
                     report::marked(results.scenario,
                                    joined(config::to_text(results.scenario.hazard.smallest_zone_m2), " m²"),
                                    {"hazard.smallest_zone_m2"})),
        report::fact(report::page_text("hazard_page.intensity"),
                     report::marked(results.scenario, energy_in_words(results.scenario.hazard.energy),
                                    {"hazard.energy"})),
        report::fact(report::page_text("hazard_page.least_reach_of_a_cell"),
                     report::marked(results.scenario,
                                    joined(report::exact(results.scenario.hazard.least_reach_percent), " %"),
                                    {"hazard.least_reach_percent"})),
        report::deciding_facts(results.scenario, results.site.sources, report::grouped(rocks),
                               sizes_of_rocks(results)),
        results.site.nets.empty()
            ? ""
            : report::fact(report::page_text("common.nets"),
                           report::page_text("hazard_page.standing_on_both_slopes_the",
                                             {{"nets", report::grouped(results.site.nets.size())}})),
        "</dl>\n<p class=\"lead\">",
        report::page_text("hazard_page.the_highest_hazard_level_of_all",
                          {{"part", results.scenario.hazard.least_reach_percent > 0.0
                                        ? report::page_text("hazard_page.but_for_cells_below_the_least")
                                        : ""}}),
        "</p>\n");
    for (std::size_t i = 0; i < results.site.targets.size(); ++i) {
        html += joined("<section class=\"card\"><h3>", escaped(results.site.targets[i].name), "</h3>");
        for (const SlopeHazard& slope : results.slopes) {
            html += joined("<p class=\"answer\"><b>",
                           slope.cover == Cover::forest ? report::page_text("common.with_forest_2")
                                                        : report::page_text("common.bare_slope_2"),
                           ":</b> ", levels_in_words(slope.targets[i].levels), ".</p><p>",
                           report::page_text("hazard_page.by_the_arrival",
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
            ? report::page_text("hazard_page.cells_that_fewer_than_of_the",
                                {{"hazard_least_reach_percent", report::exact(hazard.least_reach_percent)}})
            : report::page_text("hazard_page.a_cell_counts_as_soon_as_one");
    const std::string source =
        hazard.matrix.empty()
            ? report::page_text("hazard_page.after_the_swiss_federal")
            : report::page_text("hazard_page.levels_of", {{"hazard_matrix", escaped(hazard.matrix)}});
    return joined("<h2>", report::page_text("hazard_page.how_a_level_comes_about"),
                  "</h2>\n<section class=\"card\"><p>",
                  report::page_text("hazard_page.for_each_return_period_its",
                                    {{"hazard_energy", energy_in_words(hazard.energy)}, {"rim", rim}}),
                  "</p>", matrix_drawing(results), "<p class=\"soft\">", source, "</p></section>\n");
}

std::string rocks_table(const HazardResults& results) {
    std::vector<std::string> head{report::page_text("hazard_page.release_zone")};
    for (const FinishedPeriod& period : results.periods) {
        head.push_back(years_text(period.return_period_years));
    }
    HtmlTable table{report::page_text("hazard_page.diameter_mass_and_number_of_the"), head};
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
                    : joined(report::page_text("hazard_page.m_kg",
                                               {{"found_diameter_m", report::three_digits(found->diameter_m)},
                                                {"found_mass_kg", report::three_digits(found->mass_kg)}}),
                             "<br/><span class=\"soft\">",
                             report::page_text("hazard_page.rocks",
                                               {{"found_rocks", report::grouped(found->rocks)}}),
                             "</span>"));
        }
        table.row(cells);
    }
    std::vector<std::string> links{report::page_text("hazard_page.page_of_these_rocks")};
    for (const FinishedPeriod& period : results.periods) {
        links.push_back(joined("<a href=\"../", escaped(period.folder.filename().string()), "/report.html\">",
                               report::page_text("hazard_page.report"), "</a>"));
    }
    table.row(links);
    return joined("<h2>", report::page_text("common.rocks"),
                  "</h2>\n<section class=\"card\"><div class=\"wide\">", table.html(), "</div></section>\n");
}

std::string shares_table(const HazardResults& results) {
    std::vector<std::string> head{""};
    for (std::size_t level = levels; level-- > 0;) {
        head.push_back(message_text(level_names[level]));
    }
    HtmlTable table{report::page_text("hazard_page.shares_of_a_target_s_length_or"), head};
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
    table.group(report::page_text("hazard_page.map"));
    for (const SlopeHazard& slope : results.slopes) {
        std::vector<std::string> cells{words_of(slope.cover)};
        for (std::size_t level = levels; level-- > 0;) {
            cells.push_back(report::page_text(
                "hazard_page.ha", {{"level_level", report::fixed(level_area_ha(slope.map.level, results.site,
                                                                               static_cast<Level>(level)),
                                                                 2)}}));
        }
        table.row(cells);
    }
    return joined("<h2>", report::page_text("hazard_page.levels"),
                  "</h2>\n<section class=\"card\"><div class=\"wide\">", table.html(), "</div></section>\n");
}

/// Intensities at the targets by return period.
std::string intensities_table(const HazardResults& results) {
    std::vector<std::string> head{"", report::page_text("hazard_page.return_period")};
    for (std::size_t i = results.matrix.intensities(); i-- > 0;) {
        head.push_back(escaped(message_text(results.matrix.intensity_name(i))));
    }
    head.emplace_back(report::page_text("hazard_page.no_rock"));
    HtmlTable table{report::page_text("hazard_page.shares_of_a_target_s_length_or_2"), head};
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

std::string stopped_by_forest(const PeriodArrivals& arrivals) {
    if (std::isnan(arrivals.protection_percent)) {
        return "–";
    }
    if (too_few_for_protection(arrivals.bare_rocks)) {
        return too_few_in_words(arrivals.bare_rocks);
    }
    return joined("<b>", report::fixed(arrivals.protection_percent, 1), "\u00a0%</b> (",
                  report::page_text("hazard_page.interval_to",
                                    {{"low", report::fixed(arrivals.protection_low_percent, 1)},
                                     {"high", report::fixed(arrivals.protection_high_percent, 1)}}),
                  ")");
}

std::string arrivals_table(const HazardResults& results) {
    if (results.site.targets.empty()) {
        return "";
    }
    HtmlTable table{
        report::page_text("hazard_page.shares_of_the_rocks_of_a_return"),
        {report::page_text("hazard_page.return_period"), report::page_text("common.bare_slope"),
         report::page_text("common.with_forest"), report::page_text("hazard_page.the_forest_stops"),
         report::page_text("hazard_page.arrival_period_bare"),
         report::page_text("hazard_page.arrival_period_forest")}};
    std::size_t shown = results.site.targets.size();
    for (const PeriodArrivals& arrivals : results.arrivals) {
        if (arrivals.target != shown) {
            shown = arrivals.target;
            table.group(escaped(results.site.targets[shown].name));
        }
        const auto share = [](double percent) {
            return std::isnan(percent) ? std::string{"–"} : report::percent(percent / 100.0);
        };
        table.row({years_text(arrivals.return_period_years), share(arrivals.bare_percent),
                   share(arrivals.forest_percent), stopped_by_forest(arrivals),
                   arrival_period(arrivals.return_period_years, arrivals.bare_percent),
                   arrival_period(arrivals.return_period_years, arrivals.forest_percent)});
    }
    return joined("<h2>", report::page_text("common.rocks_that_arrive"),
                  "</h2>\n<section class=\"card\"><div class=\"wide\">", table.html(), "</div></section>\n");
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
    std::string html = joined(sheet.definitions(), "<h2>", report::page_text("hazard_page.hazard_map"),
                              "</h2>\n<div class=\"halves\">");
    for (const SlopeHazard& slope : results.slopes) {
        html += sheet.figure(
            {words_of(slope.cover),
             report::page_text("hazard_page.hazard_levels", {{"words_of_slope", words_of(slope.cover)}}),
             sheet.picture(slope.map.level, by_level), by_level.legend("levels"), ""},
            report::MapSize::half);
    }
    html += joined("</div>\n", levels_by_arrival(results, sheet, by_level));
    html +=
        joined("<p class=\"soft\">",
               report::page_text(
                   "hazard_page.north_is_up_coordinates_and",
                   {{"map_frame_cell_width_m", report::three_digits(results.site.map_frame.cell_width_m)}}),
               "</p>\n", shares_table(results), "<h2>",
               report::page_text("hazard_page.intensity_by_return_period"), "</h2>\n");
    const ColourScale by_energy = ColourScale::classes(named(intensity_colours(results.matrix)));
    for (std::size_t i = 0; i < results.periods.size(); ++i) {
        const std::string years = years_text(results.periods[i].return_period_years);
        html += joined("<h3>", years, "</h3>\n<div class=\"halves\">");
        for (const SlopeHazard& slope : results.slopes) {
            html += sheet.figure(
                {joined(years, ", ", words_of(slope.cover)),
                 report::page_text("hazard_page.intensity_2",
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
                                    joined(report::page_text("hazard_page.rockfall_hazard_map_2"),
                                           escaped(results.scenario.file.stem().string()))),
        .version = results.version,
        .scripts = {},
        .style = {},
        .before_main = {}};
    report::begin_page(out, frame);
    out << report::first_warnings(results.warnings) << opening(results) << arrivals_table(results)
        << maps(results) << about_the_map(results) << rocks_table(results)
        << joined("<h2>", report::page_text("common.warnings"), "</h2>\n")
        << report::list_of_warnings(results.warnings)
        << report::settings_section(results.scenario, [](const std::string&) { return true; })
        << joined("<h2>", report::page_text("common.data"), "</h2>\n<section class=\"card\">")
        << report::table_of_inputs(results.inputs)
        << joined("</section>\n<h2>", report::page_text("hazard_page.files"),
                  "</h2>\n<section class=\"card\">")
        << report::table_of_files(report::page_text("common.grids_have_their_projection_prj"), files)
        << "</section>\n"
        << report::citation(results.version, results.scenario);
    report::end_page(out, frame);
}

}  // namespace coupling::hazard
