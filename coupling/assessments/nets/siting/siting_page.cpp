#include "coupling/assessments/nets/siting/siting_page.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/version.hpp"
#include "coupling/assessments/nets/figures/net_figures.hpp"
#include "coupling/assessments/nets/siting/siting_words.hpp"
#include "coupling/inputs/nets/net_classes.hpp"
#include "coupling/results/figures/figures.hpp"
#include "coupling/results/report/chart.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/report/map/map_sheet.hpp"
#include "coupling/results/report/page_frame.hpp"
#include "coupling/results/report/page_head.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/messages.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/writing_language.hpp"

namespace coupling::siting {
namespace {

using config::joined;
using report::escaped;
using report::page_text;

std::string cover_name(Cover cover) {
    return cover == Cover::forest ? page_text("with forest") : page_text("bare slope");
}

/// The terrain, the lines as targets and the nets, as maps draw them.
Site site_of(const SitingResults& results, const rockfall::Terrain& terrain) {
    config::GridFrame frame = results.frame;
    config::Raster<double> heights_m{frame, std::numeric_limits<double>::quiet_NaN()};
    std::uint32_t hint = 0;
    for (std::size_t i = 0; i < heights_m.values.size(); ++i) {
        const config::Cell cell = frame.cell_of(i);
        const double x_m = frame.x_centre_m(cell.column);
        const double y_m = frame.y_centre_m(cell.row);
        if (const auto triangle = terrain.locate(x_m, y_m, hint)) {
            hint = *triangle;
            heights_m.values[i] = terrain.plane_of(*triangle).height_m(x_m, y_m);
        }
    }
    frame.x_west_m += terrain.origin_m().x();
    frame.y_south_m += terrain.origin_m().y();
    heights_m.frame = frame;
    std::vector<rockfall::Target> targets;
    for (const ProtectedLine& line : results.lines) {
        targets.push_back(rockfall::with_bounds({line.name, line.name, false, {line.line_m}}));
    }
    return {{terrain, rockfall::SurfaceMap::uniform(rockfall::SurfaceId{0}), {}},
            heights_m,
            {},
            {},
            frame,
            {},
            {},
            {},
            targets,
            results.nets,
            {},
            {},
            {}};
}

std::string map(const SitingResults& results, const rockfall::Terrain& terrain) {
    const Site site = site_of(results, terrain);
    const report::MapSheet sheet{site};
    config::Raster<float> ways = results.ways;
    ways.frame = site.map_frame;
    float most = 1.0F;
    for (const float count : ways.values) {
        most = std::isnan(count) ? most : std::max(most, count);
    }
    const report::ColourScale scale = report::ColourScale::logarithmic(
        Palette::passages, 1.0, static_cast<double>(most), page_text("Rocks"));
    return joined(
        sheet.definitions(), "<h2>", page_text("Map"), "</h2>\n",
        sheet.figure({page_text("Rocks on their way to the lines"),
                      page_text("Map of the rocks that come to the lines, with the lines and the best nets"),
                      sheet.picture(ways, scale), scale.legend("ways"),
                      page_text("Rocks that come to a line {cover}, counted once in each cell on their way "
                                "to it. Black: the lines. Blue broken lines: the best net of each stretch.",
                                {{"cover", cover_name(results.judged)}})},
                     report::MapSize::half));
}

/// Heights over the pieces of a line.
void add_steps(report::Chart& chart, const std::string& series, const std::string& name,
               const std::vector<LineBin>& bins, double rocks) {
    constexpr double per_1000 = 1000.0;
    std::vector<double> edges{bins.front().from_m};
    std::vector<double> heights;
    for (const LineBin& bin : bins) {
        edges.push_back(bin.to_m);
        heights.push_back(per_1000 * bin.energy_sum_kj / rocks);
    }
    chart.add_steps(series, edges, heights);
    chart.add_name(series, name);
}

double highest_of(const SitingResults& results, std::size_t line) {
    double highest = 0.0;
    for (const Cover cover : {Cover::forest, Cover::bare}) {
        for (const LineBin& bin : results.by_line[line].bins[index_of(cover)]) {
            const auto rocks =
                static_cast<double>(std::max<std::uint64_t>(1, results.rocks[index_of(cover)]));
            highest = std::max(highest, 1000.0 * bin.energy_sum_kj / rocks);
        }
    }
    return std::max(highest, 1e-3);
}

/// Energy against position: what comes on each slope, and what the nets leave on the judged one.
std::string curve(const SitingResults& results, std::size_t line) {
    report::Axis x =
        report::Axis::from_zero(page_text("Along the line, m"), length_m(results.lines[line].line_m));
    report::Chart chart{
        page_text("Energy that comes to {line}", {{"line", escaped(results.lines[line].name)}}), std::move(x),
        report::Axis::from_zero(page_text("kJ per 1 000 rocks and 10 m"), highest_of(results, line))};
    const LineResult& of_line = results.by_line[line];
    const auto rocks = [&](Cover cover) {
        return static_cast<double>(std::max<std::uint64_t>(1, results.rocks[index_of(cover)]));
    };
    add_steps(chart, "bare", page_text("bare slope"), of_line.bins[index_of(Cover::bare)],
              rocks(Cover::bare));
    if (results.with_forest) {
        add_steps(chart, "forest", page_text("with forest"), of_line.bins[index_of(Cover::forest)],
                  rocks(Cover::forest));
    }
    std::vector<report::ChartPoint> left;
    for (const LineBin& bin : of_line.left[index_of(results.judged)]) {
        left.push_back({0.5 * (bin.from_m + bin.to_m), 1000.0 * bin.energy_sum_kj / rocks(results.judged)});
    }
    chart.add_line("left", left);
    chart.add_name("left", page_text("with the nets, {cover}", {{"cover", cover_name(results.judged)}}));
    for (const StretchResult& stretch : results.stretches) {
        if (stretch.sited.line == line) {
            chart.add_mark(stretch.sited.stretch.from_m, "");
            chart.add_mark(stretch.sited.stretch.to_m, "");
        }
    }
    return chart.figure(
        page_text("Sum of the energies of the rocks that come to each piece of 10 m. Vertical lines: ends of "
                  "the stretches where works are needed."));
}

std::string table_of_candidates(const SitingResults& results, const StretchResult& stretch) {
    report::HtmlTable table{
        page_text("Candidates: the net that each place needs, and what it leaves below. Rocks at the net are "
                  "all that reach it, also those that would stop before the line."),
        {page_text("Upslope, m"), page_text("Energy class"), page_text("Height, m"), page_text("Length, m"),
         page_text("Rocks kept"), page_text("Energy left"), page_text("Largest left, kJ"),
         page_text("Rocks at the net; largest energy, kJ"), ""}};
    table.text_columns({1, 8});
    for (std::size_t i = 0; i < stretch.candidates.size(); ++i) {
        const CandidateFigures& found = results.figures[stretch.candidates[i]][index_of(results.judged)];
        const Judged& judged = found.judged;
        const bool best = stretch.ranking.best == i;
        const std::string word = best                      ? page_text("best")
                                 : stretch.ranking.ties[i] ? page_text("as good")
                                 : judged.net && !keeps_wanted(judged, results.wanted_share)
                                     ? page_text("keeps less than wanted")
                                     : "";
        if (!judged.net) {
            table.row({config::to_text(judged.distance_m), page_text("too few rocks"), "–", "–", "–", "–",
                       "–", "–", ""});
            continue;
        }
        table.row(
            {config::to_text(judged.distance_m),
             page_text("{class} ({capacity_kj} kJ)",
                       {{"class", judged.net->energy_class},
                        {"capacity_kj", report::tick_text(judged.net->capacity_kj)}}),
             report::fixed(judged.net->height_m, 1), report::fixed(judged.net->length_m(), 0),
             report::percent(judged.left.kept.value), report::percent(0.01 * judged.left.energy_percent),
             report::three_digits(judged.left.largest_kj),
             joined(report::grouped(found.reached), ", ", report::three_digits(found.energy_max_kj)), word},
            best ? "best" : "");
    }
    return joined("<div class=\"wide\">", table.html(), "</div>\n");
}

std::string opening(const SitingResults& results, const ReportSettings& head) {
    std::string html =
        joined(report::page_head(head, page_text("Where nets are needed")), "<p class=\"lead\">",
               page_text("Where works are needed along each line, which net holds {wanted} of the rocks "
                         "there, and what it leaves below.",
                         {{"wanted", report::percent(results.wanted_share)}}),
               "</p>\n");
    for (std::size_t line = 0; line < results.lines.size(); ++line) {
        html += joined("<section class=\"card\"><h3>", escaped(results.lines[line].name),
                       "</h3><p class=\"answer\">", escaped(line_in_words(results, line)), "</p><ul>");
        for (const StretchResult& stretch : results.stretches) {
            if (stretch.sited.line == line) {
                html += joined("<li>", escaped(stretch_in_words(results, stretch)), "</li>");
            }
        }
        html += "</ul></section>\n";
    }
    if (!results.remarks.empty()) {
        html += "<ul class=\"notes\">";
        for (const std::string& remark : results.remarks) {
            html += joined("<li>", report::message_html(remark), "</li>");
        }
        html += "</ul>\n";
    }
    return html;
}

std::string details(const SitingResults& results) {
    std::string html;
    for (std::size_t line = 0; line < results.lines.size(); ++line) {
        html += joined("<h2>", escaped(results.lines[line].name), "</h2>\n<div class=\"halves\">",
                       curve(results, line), "</div>\n");
        for (const StretchResult& stretch : results.stretches) {
            if (stretch.sited.line != line) {
                continue;
            }
            html +=
                joined("<h3>",
                       page_text(stretch.rocks == 1
                                     ? "{from_m} to {to_m} m: {rocks} rock, the largest {energy_max_kj} kJ"
                                     : "{from_m} to {to_m} m: {rocks} rocks, the largest {energy_max_kj} kJ",
                                 {{"from_m", report::fixed(stretch.sited.stretch.from_m, 0)},
                                  {"to_m", report::fixed(stretch.sited.stretch.to_m, 0)},
                                  {"rocks", report::grouped(stretch.rocks)},
                                  {"energy_max_kj", report::three_digits(stretch.energy_max_kj)}}),
                       "</h3>\n", table_of_candidates(results, stretch));
        }
    }
    return html;
}

std::string how_found(const SitingResults& results) {
    std::string html = joined("<h2>", page_text("How this was found"), "</h2>\n<section class=\"card\"><ul>");
    html += joined(
        "<li>",
        page_text(
            "Stretches: the pieces of 10 m with the most energy for each metre, as few as together receive "
            "{wanted} of the energy that comes to the line. Those with gaps of at most 20 m are one stretch.",
            {{"wanted", report::percent(results.wanted_share)}}),
        "</li><li>",
        page_text(
            "Candidates: the stretch and what lies beside it, moved towards where the rocks come from."),
        "</li><li>",
        page_text("Of the rocks that may pass, half may pass beside the net, half of the others by their "
                  "energy, the rest over it. Class, height and length follow from that."),
        "</li><li>",
        page_text("Best: keeps the wanted share, then the weakest class, then the smallest area. As good: "
                  "the same class and at most a tenth more area."),
        "</li><li>",
        page_text("What the nets leave together is followed rock by rock. A rock that breaks through counts "
                  "with all its energy."),
        "</li><li>",
        page_text("Energy classes: maximum energy levels of ETAG 027 / EAD 340059-00-0106, as data sheets of "
                  "nets give them. The service level (SEL) is a third of it."),
        "</li><li>",
        page_text("Heights are those of the rock&#39;s centre. Its radius and the margins of guidelines on "
                  "energy and height come on top."),
        "</li>");
    return joined(html, "</ul></section>\n");
}

std::string files() {
    report::HtmlTable table{page_text("All files stand beside this page."),
                            {page_text("File"), page_text("What it holds")}};
    table.text_columns({1});
    for (const auto& [file, key] :
         {std::pair{"nets.csv", "The best net of each stretch, ready for nets.file of a scenario."},
          std::pair{"net_stretches.csv", "Where works are needed."},
          std::pair{"net_candidates.csv",
                    "All candidates with their figures, with forest and on the bare slope."},
          std::pair{"net_along.csv", "What comes to each piece of 10 m, and what the nets leave."},
          std::pair{"net_place.gpkg", "All of it as layers for QGIS."}}) {
        table.row({file, page_text(key)});
    }
    return joined("<h2>", page_text("Files"), "</h2>\n<section class=\"card\">", table.html(),
                  "</section>\n");
}

}  // namespace

void write_siting_page(std::ostream& out, const SitingResults& results, const rockfall::Terrain& terrain,
                       const ReportSettings& head) {
    const report::WritingLanguage language{head.language};
    const report::PageFrame frame{.title = report::page_title(head, page_text("Where nets are needed")),
                                  .version = config::version(),
                                  .scripts = {},
                                  .style =
                                      ".left{stroke:#7b3294;stroke-width:2.2;fill:none}"
                                      ".best>*{font-weight:600}",
                                  .before_main = {}};
    report::begin_page(out, frame);
    out << opening(results, head) << map(results, terrain) << details(results) << how_found(results)
        << files();
    report::end_page(out, frame);
}

}  // namespace coupling::siting
