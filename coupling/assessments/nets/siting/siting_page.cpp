#include "coupling/assessments/nets/siting/siting_page.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "config/text/numbers.hpp"
#include "config/version.hpp"
#include "coupling/assessments/nets/figures/net_figures.hpp"
#include "coupling/assessments/nets/figures/net_summary.hpp"
#include "coupling/assessments/nets/figures/net_words.hpp"
#include "coupling/assessments/nets/figures/site_for_maps.hpp"
#include "coupling/assessments/nets/siting/siting_words.hpp"
#include "coupling/inputs/nets/net_classes.hpp"
#include "coupling/results/figures/figures.hpp"
#include "coupling/results/report/chart.hpp"
#include "coupling/results/report/listings.hpp"
#include "coupling/results/report/map/map_key.hpp"
#include "coupling/results/report/map/map_sheet.hpp"
#include "coupling/results/report/page_frame.hpp"
#include "coupling/results/report/page_head.hpp"
#include "coupling/results/templates/page_files.hpp"
#include "coupling/results/templates/page_template.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/messages.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/writing_language.hpp"

namespace coupling::siting {
namespace {

using report::escaped;
using report::page_text;
using report::PageFields;

std::string cover_name(Cover cover) {
    return cover == Cover::forest ? page_text("with forest") : page_text("bare slope");
}

/// The terrain, the lines as targets and the nets, as maps draw them.
Site site_of(const SitingResults& results, const rockfall::Terrain& terrain) {
    std::vector<rockfall::Target> targets;
    for (const ProtectedLine& line : results.lines) {
        rockfall::Target target;
        target.id = target.name = line.name;
        target.parts = {line.line_m};
        targets.push_back(rockfall::with_bounds(std::move(target)));
    }
    return site_for_maps(terrain, results.frame, std::move(targets), results.nets);
}

PageFields map(const SitingResults& results, const rockfall::Terrain& terrain) {
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
    const std::string figure = sheet.figure(
        {page_text("Rocks on their way to the lines"),
         page_text("Map of the rocks that come to the lines, with the lines and the best nets"),
         sheet.picture(ways, scale), scale.legend("ways"),
         page_text(
             "Rocks that come to a line {cover}, counted once in each cell on their way to it. Black: the "
             "lines. Blue broken lines: the best net of each stretch.",
             {{"cover", cover_name(results.judged)}})},
        report::MapSize::half);
    const report::OnMaps drawn{.sources = false, .targets = true, .nets = !results.nets.empty()};
    return {{"map_definitions", sheet.definitions()}, {"map", figure}, {"map_key", report::map_key(drawn)}};
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

PageFields candidate_row(const SitingResults& results, const StretchResult& stretch, std::size_t i) {
    const CandidateFigures& found = results.figures[stretch.candidates[i]][index_of(results.judged)];
    const Judged& judged = found.judged;
    const bool best = stretch.ranking.best == i;
    std::optional<PageFields> net;
    if (judged.net) {
        const bool as_good = !best && stretch.ranking.ties[i];
        net = {{"class", judged.net->energy_class},
               {"capacity_kj", report::tick_text(judged.net->capacity_kj)},
               {"height", report::exact(judged.net->height_m)},
               {"design_energy", found.needed ? report::three_digits(found.needed->design_energy_kj) : "–"},
               {"design_height", found.needed ? report::three_digits(found.needed->design_height_m) : "–"},
               {"length", report::fixed(judged.net->length_m(), 0)},
               {"kept", report::percent(judged.left.kept.value)},
               {"energy_left", report::percent(0.01 * judged.left.energy_percent)},
               {"largest_left", report::three_digits(judged.left.largest_kj)},
               {"over", report::grouped(judged.left.over)},
               {"through", report::grouped(judged.left.through)},
               {"beside", report::grouped(judged.left.beside)},
               {"reached", report::grouped(found.reached)},
               {"largest", report::three_digits(found.energy_max_kj)},
               {"as_good", as_good},
               {"keeps_less", !best && !as_good && !keeps_wanted(judged, results.wish.share)}};
    }
    return {{"best", best}, {"distance", config::to_text(judged.distance_m)}, {"net", net}};
}

PageFields stretch_fields(const SitingResults& results, const StretchResult& stretch) {
    std::vector<PageFields> candidates;
    for (std::size_t i = 0; i < stretch.candidates.size(); ++i) {
        candidates.push_back(candidate_row(results, stretch, i));
    }
    return {
        {"answer", stretch_in_words(results, stretch)},
        {"from_m", report::fixed(stretch.sited.stretch.from_m, 0)},
        {"to_m", report::fixed(stretch.sited.stretch.to_m, 0)},
        {"any_net",
         std::any_of(stretch.candidates.begin(), stretch.candidates.end(),
                     [&](std::size_t candidate) {
                         return results.figures[candidate][index_of(results.judged)].judged.net.has_value();
                     })},
        {"one_rock", stretch.rocks == 1},
        {"rocks", report::grouped(stretch.rocks)},
        {"energy_max_kj", report::three_digits(stretch.energy_max_kj)},
        {"candidates", candidates}};
}

std::vector<PageFields> line_fields(const SitingResults& results) {
    std::vector<PageFields> lines;
    for (std::size_t line = 0; line < results.lines.size(); ++line) {
        std::vector<PageFields> stretches;
        for (const StretchResult& stretch : results.stretches) {
            if (stretch.sited.line == line) {
                stretches.push_back(stretch_fields(results, stretch));
            }
        }
        lines.push_back({{"line", results.lines[line].name},
                         {"answer", line_in_words(results, line)},
                         {"curve", curve(results, line)},
                         {"stretches", stretches}});
    }
    return lines;
}

std::vector<PageFields> remarks(const SitingResults& results) {
    std::vector<PageFields> rows;
    for (const std::string& remark : results.remarks) {
        rows.push_back({{"remark", report::message_html(remark)}});
    }
    return rows;
}

}  // namespace

void write_siting_page(std::ostream& out, const SitingResults& results, const rockfall::Terrain& terrain,
                       const ReportSettings& head, const std::vector<WrittenFile>& files) {
    const report::WritingLanguage language{head.language};
    const std::string title = title_with_period(page_text("Where nets are needed"), results.paths);
    const report::PageFrame frame{.title = report::page_title(head, title),
                                  .version = config::version(),
                                  .scripts = {},
                                  .style = std::string{report::page_file("siting.css")},
                                  .before_main = {}};
    report::begin_page(out, frame);
    PageFields fields = map(results, terrain);
    fields.insert(fields.end(),
                  {{"head", report::page_head(head, title)},
                   {"wanted", report::percent(results.wish.share)},
                   {"rule", design_rule_in_words(results.wish.design)},
                   {"remarked", !results.remarks.empty()},
                   {"remarks", remarks(results)},
                   {"lines", line_fields(results)},
                   {"files", report::table_of_files(page_text("All files stand beside this page."), files)}});
    out << report::filled_template("siting_page.html", fields);
    report::end_page(out, frame);
}

}  // namespace coupling::siting
