#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/hazard/hazard_colours.hpp"
#include "coupling/hazard/hazard_results.hpp"
#include "coupling/page_scripts/page_scripts.hpp"
#include "coupling/results/few_rocks.hpp"
#include "coupling/results/report/deciding.hpp"
#include "coupling/results/report/first_warnings.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/report/listings.hpp"
#include "coupling/results/report/map_sheet.hpp"
#include "coupling/results/report/markup.hpp"
#include "coupling/results/report/style.hpp"

namespace coupling::hazard {
namespace {

using config::joined;
using report::ColourScale;
using report::escaped;
using report::HtmlTable;

const char* words_of(Cover cover) {
    return cover == Cover::forest ? "with forest" : "bare slope";
}

std::string years_text(double years) {
    return joined(config::to_text(years), years == 1.0 ? " year" : " years");
}

std::string energy_in_words(HazardEnergy energy) {
    switch (energy) {
        case HazardEnergy::mean:
            return "mean energy";
        case HazardEnergy::max:
            return "largest energy";
        default:
            return joined(stem_of(energy).substr(2), "th percentile of the energies");
    }
}

/// "high on 35.2 % of it, moderate on 20 %": levels above none, the highest first.
std::string levels_in_words(const TargetHazard& target) {
    std::string text;
    for (std::size_t level = levels - 1; level > 0; --level) {
        if (target.levels[level] > 0.0) {
            text += joined(text.empty() ? "" : ", ", level_names[level], " on ",
                           report::percent(target.levels[level]));
        }
    }
    return text.empty() ? "none" : text;
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
        "<ul class=\"notes\"><li>With forest parts of a target have a higher level than without. ",
        of_those_that_pass
            ? "Intensity is the energy of the rocks that still arrive. A forest that stops small and slow "
              "rocks raises their percentiles and their mean, although fewer arrive. "
            : "",
        "Trees also deflect rocks, and where few rocks pass the result is uncertain. The table below has "
        "the number of rocks that the forest stops.</li></ul>\n");
}

/// Smallest and largest rock of all return periods.
std::string sizes_of_rocks(const HazardResults& results) {
    double low_m = std::numeric_limits<double>::infinity();
    double high_m = 0.0;
    for (const FinishedPeriod& period : results.periods) {
        low_m = std::min(low_m, period.diameters.smallest_m);
        high_m = std::max(high_m, period.diameters.largest_m);
    }
    return report::marked(results.scenario,
                          joined(report::fixed(low_m, 2), " to ", report::fixed(high_m, 2),
                                 " m by return period and zone, spheres"),
                          {"hazard.blocks"});
}

std::string opening(const HazardResults& results) {
    const std::string name = escaped(results.scenario.file.stem().string());
    std::string periods;
    std::uint64_t rocks = 0;
    for (const FinishedPeriod& period : results.periods) {
        periods += joined(periods.empty() ? "" : ", ", config::to_text(period.return_period_years));
        rocks += period.rocks;
    }
    std::string html = joined(
        "<h1>Rockfall hazard map: ", name, "</h1>\n<dl class=\"facts\">",
        report::fact("Return periods of the release", joined(periods, " years")),
        report::fact("Intensity",
                     report::marked(results.scenario, energy_in_words(results.scenario.hazard.energy),
                                    {"hazard.energy"})),
        report::fact(
            "Least reach of a cell",
            report::marked(results.scenario,
                           joined(config::to_text(results.scenario.hazard.least_reach_percent), " %"),
                           {"hazard.least_reach_percent"})),
        report::deciding_facts(results.scenario, results.site.sources, report::grouped(rocks),
                               sizes_of_rocks(results)),
        results.site.nets.empty()
            ? ""
            : report::fact("Nets",
                           joined(report::grouped(results.site.nets.size()),
                                  ", standing on both slopes: the levels are those with them, and what "
                                  "they held stands on the page of each return period")),
        "</dl>\n<p class=\"lead\">The highest hazard level of all return periods. A return period here is "
        "that of the <b>release</b>, how often such rocks break off. It is not that of the <b>arrival</b> at "
        "a target: the levels do not depend on how many of the rocks arrive",
        results.scenario.hazard.least_reach_percent > 0.0 ? ", but for cells below the least reach" : "",
        ".</p>\n");
    for (std::size_t i = 0; i < results.site.targets.size(); ++i) {
        html += joined("<section class=\"card\"><h3>", escaped(results.site.targets[i].name), "</h3>");
        for (const SlopeHazard& slope : results.slopes) {
            html +=
                joined("<p class=\"answer\"><b>", slope.cover == Cover::forest ? "With forest" : "Bare slope",
                       ":</b> ", levels_in_words(slope.targets[i]), ".</p>");
        }
        html += "</section>\n";
    }
    return joined(html, note_on_forest(results));
}

/// Rows from the strongest class down, columns from the most frequent on, as guidelines draw it.
std::string matrix_drawing(const HazardResults& results) {
    constexpr double left = 120.0;
    constexpr double width = 150.0;
    constexpr double height = 40.0;
    constexpr double least_width = 1000.0;  // so that the lettering is that of the text around it
    const Matrix& matrix = results.matrix;
    const auto rows = static_cast<double>(matrix.intensities());
    std::string svg =
        joined("<svg viewBox=\"0 0 ",
               report::place(std::max(least_width, left + width * static_cast<double>(matrix.frequencies()))),
               " ", report::place(height * rows + 52.0), "\" role=\"img\" aria-label=\"hazard matrix\">");
    const auto text = [&](double x, double y, const char* anchor, const std::string& words) {
        svg += joined("<text font-size=\"13\" x=\"", report::place(x), "\" y=\"", report::place(y),
                      "\" text-anchor=\"", anchor, "\">", words, "</text>");
    };
    for (std::size_t i = 0; i < matrix.intensities(); ++i) {
        const double y = height * (rows - 1.0 - static_cast<double>(i));
        text(left - 8.0, y + 0.6 * height, "end", escaped(matrix.intensity_name(i)));
        for (std::size_t k = 0; k < matrix.frequencies(); ++k) {
            const Level level = matrix.at(i, k);
            const Colour colour = level_colours()[static_cast<std::size_t>(level)].colour;
            const double x = left + width * static_cast<double>(k);
            svg += joined("<rect x=\"", report::place(x), "\" y=\"", report::place(y), "\" width=\"",
                          report::place(width), "\" height=\"", report::place(height), "\" fill=\"",
                          to_hex(colour), "\" stroke=\"#555\"/>");
            svg +=
                joined("<text font-size=\"14\" font-weight=\"600\" text-anchor=\"middle\" fill=\"",
                       luminance(colour) < 0.3 ? "#fff" : "#111", "\" x=\"", report::place(x + 0.5 * width),
                       "\" y=\"", report::place(y + 0.6 * height), "\">", level_name(level), "</text>");
        }
    }
    for (std::size_t k = 0; k < matrix.frequencies(); ++k) {
        const double x = left + width * (static_cast<double>(k) + 0.5);
        text(x, height * rows + 18.0, "middle", escaped(matrix.frequency_name(k)));
        std::string here;
        for (const FinishedPeriod& period : results.periods) {
            if (matrix.frequency_of(period.return_period_years) == k) {
                here += joined(here.empty() ? "" : ", ", config::to_text(period.return_period_years));
            }
        }
        text(x, height * rows + 38.0, "middle", here.empty() ? "no rocks" : joined("rocks of ", here));
    }
    return joined(svg, "</svg>");
}

std::string about_the_map(const HazardResults& results) {
    const HazardSettings& hazard = results.scenario.hazard;
    const std::string rim =
        hazard.least_reach_percent > 0.0
            ? joined("Cells that fewer than ", config::to_text(hazard.least_reach_percent),
                     " % of the rocks from the sources above them pass are left out.")
            : "A cell counts as soon as one simulated rock passes it: more rocks, and larger cells, widen "
              "its rim; <code>hazard.least_reach_percent</code> sets a limit.";
    const std::string source = hazard.matrix.empty()
                                   ? "After the Swiss federal recommendation (BUWAL/BWW/BRP 1997; FOEN 2016) "
                                     "as the literature draws it, not checked against the original; "
                                     "cantons divide some fields otherwise: <code>bannwald info "
                                     "hazard_matrix</code>, setting <code>hazard.matrix</code>."
                                   : joined("Levels of ", escaped(hazard.matrix), ".");
    return joined(
        "<h2>How a level comes about</h2>\n<section class=\"card\"><p>For each return period its rocks "
        "fall from the release zones that have any. The ",
        energy_in_words(hazard.energy),
        " in a cell (of each rock the largest one there) is its intensity; with the return period it gives a "
        "level. The map shows the highest level of all return periods. ",
        rim, "</p>", matrix_drawing(results), "<p class=\"soft\">", source, "</p></section>\n");
}

std::string rocks_table(const HazardResults& results) {
    std::vector<std::string> head{"Release zone"};
    for (const FinishedPeriod& period : results.periods) {
        head.push_back(years_text(period.return_period_years));
    }
    HtmlTable table{"Diameter, mass and number of the rocks by return period.", head};
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
            cells.push_back(found == results.rocks.end()
                                ? "–"
                                : joined(report::three_digits(found->diameter_m), " m, ",
                                         report::three_digits(found->mass_kg),
                                         " kg<br/><span class=\"soft\">", report::grouped(found->rocks),
                                         " rocks</span>"));
        }
        table.row(cells);
    }
    std::vector<std::string> links{"Page of these rocks"};
    for (const FinishedPeriod& period : results.periods) {
        links.push_back(
            joined("<a href=\"../", escaped(period.folder.filename().string()), "/report.html\">report</a>"));
    }
    table.row(links);
    return joined("<h2>Rocks</h2>\n<section class=\"card\"><div class=\"wide\">", table.html(),
                  "</div></section>\n");
}

std::string shares_table(const HazardResults& results) {
    std::vector<std::string> head{""};
    for (std::size_t level = levels; level-- > 0;) {
        head.emplace_back(level_names[level]);
    }
    HtmlTable table{"Shares of a target's length or area, and plan areas of the map.", head};
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
    table.group("Map");
    for (const SlopeHazard& slope : results.slopes) {
        std::vector<std::string> cells{words_of(slope.cover)};
        for (std::size_t level = levels; level-- > 0;) {
            cells.push_back(joined(
                report::fixed(level_area_ha(slope, results.site, static_cast<Level>(level)), 2), " ha"));
        }
        table.row(cells);
    }
    return joined("<h2>Levels</h2>\n<section class=\"card\"><div class=\"wide\">", table.html(),
                  "</div></section>\n");
}

/// Intensities at the targets by return period.
std::string intensities_table(const HazardResults& results) {
    std::vector<std::string> head{"", "Return period"};
    for (std::size_t i = results.matrix.intensities(); i-- > 0;) {
        head.push_back(escaped(results.matrix.intensity_name(i)));
    }
    head.emplace_back("no rock");
    HtmlTable table{"Shares of a target's length or area by intensity.", head};
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
    return joined("<b>", report::fixed(arrivals.protection_percent, 1), " %</b> (",
                  report::fixed(arrivals.protection_low_percent, 1), " to ",
                  report::fixed(arrivals.protection_high_percent, 1), ")");
}

std::string arrivals_table(const HazardResults& results) {
    if (results.site.targets.empty()) {
        return "";
    }
    HtmlTable table{
        "Shares of the rocks of a return period that arrive; in brackets the 95 % interval of chance in the "
        "simulated rocks.",
        {"Return period", "bare slope", "with forest", "the forest stops"}};
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
                   share(arrivals.forest_percent), stopped_by_forest(arrivals)});
    }
    return joined("<h2>Rocks that arrive</h2>\n<section class=\"card\"><div class=\"wide\">", table.html(),
                  "</div></section>\n");
}

std::string maps(const HazardResults& results) {
    const report::MapSheet sheet{results.site};
    // White cells would hide the ground where no level holds.
    std::vector<ClassColour> shown{level_colours().begin() + 1, level_colours().end()};
    const ColourScale by_level = ColourScale::classes(shown);
    std::string html = joined(sheet.definitions(), "<h2>Hazard map</h2>\n<div class=\"halves\">");
    for (const SlopeHazard& slope : results.slopes) {
        html += sheet.figure({words_of(slope.cover), joined("Hazard levels, ", words_of(slope.cover)),
                              sheet.picture(slope.map.level, by_level), by_level.legend("levels"), ""},
                             report::MapSize::half);
    }
    html += joined("</div>\n<p class=\"soft\">North is up; coordinates and scale in metres; cells of ",
                   report::three_digits(results.site.map_frame.cell_width_m),
                   " m. Thin outlines: release sources of the longest return period. Thick lines: "
                   "targets.</p>\n",
                   shares_table(results), "<h2>Intensity by return period</h2>\n");
    const ColourScale by_energy = ColourScale::classes(intensity_colours(results.matrix));
    for (std::size_t i = 0; i < results.periods.size(); ++i) {
        const std::string years = years_text(results.periods[i].return_period_years);
        html += joined("<h3>", years, "</h3>\n<div class=\"halves\">");
        for (const SlopeHazard& slope : results.slopes) {
            html += sheet.figure(
                {joined(years, ", ", words_of(slope.cover)),
                 joined("Intensity, ", years, ", ", words_of(slope.cover)),
                 sheet.picture(slope.map.intensity[i], by_energy), by_energy.legend("intensities"), ""},
                report::MapSize::half);
        }
        html += "</div>\n";
    }
    return results.site.targets.empty() ? html : joined(html, intensities_table(results));
}

}  // namespace

void write_page(std::ostream& out, const HazardResults& results, const std::vector<WrittenFile>& files) {
    const std::vector<page_scripts::Script> scripts{};
    out << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
        << page_scripts::policy(scripts)
        << "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
           "<meta name=\"generator\" content=\"Bannwald "
        << escaped(results.version)
        << "\"/>\n<title>Rockfall hazard map: " << escaped(results.scenario.file.stem().string())
        << "</title>\n<style>" << report::style() << "</style>\n</head>\n<body>\n<main>\n"
        << report::first_warnings(results.warnings) << opening(results) << arrivals_table(results)
        << maps(results) << about_the_map(results) << rocks_table(results) << "<h2>Warnings</h2>\n"
        << report::list_of_warnings(results.warnings) << "<h2>Settings</h2>\n"
        << report::table_of_settings(results.scenario, [](const std::string&) { return true; })
        << "<h2>Data</h2>\n<section class=\"card\">" << report::table_of_inputs(results.inputs)
        << "</section>\n<h2>Files</h2>\n<section class=\"card\">"
        << report::table_of_files("Grids have their projection (.prj) and a QGIS style (.qml) beside them.",
                                  files)
        << "</section>\n"
        << report::citation(results.version, results.scenario) << "</main>\n</body>\n</html>\n";
}

}  // namespace coupling::hazard
