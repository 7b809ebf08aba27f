#include <algorithm>
#include <cmath>
#include <functional>

#include "config/text/joined.hpp"
#include "coupling/assessments/collapse/collapse_results.hpp"
#include "coupling/assessments/collapse/handed_departures.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/page_scripts/page_scripts.hpp"
#include "coupling/results/report/chart.hpp"
#include "coupling/results/report/departures_line.hpp"
#include "coupling/results/report/first_warnings.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/report/listings.hpp"
#include "coupling/results/report/page_frame.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/writing_language.hpp"
#include "rockfall/motion/block_fall.hpp"

namespace coupling::collapse {
namespace {

using config::joined;
using report::Axis;
using report::Chart;
using report::ChartPoint;
using report::escaped;
using report::fixed;
using report::grouped;
using report::page_text;
using report::place;

constexpr const char* page_style =
    ".s0,.s1,.s2,.s3,.s4,.s5{fill:none;stroke-width:2}"
    ".s0{stroke:#00664f}.s1{stroke:#b04a00;stroke-dasharray:6 4}.s2{stroke:#3566b0;stroke-dasharray:2 3}"
    ".s3{stroke:#8a3ea8;stroke-dasharray:9 3 2 3}.s4{stroke:#7a7a00}.s5{stroke:#777;stroke-dasharray:4 2}"
    ".s6{fill:none;stroke-width:2;stroke:#c2185b;stroke-dasharray:1 3}"
    ".views{display:grid;grid-template-columns:repeat(auto-fit,minmax(300px,1fr));gap:12px}"
    ".views>figure>svg{width:100%;height:auto}.views>figure>svg>.ground{fill:none;stroke:#888;stroke-width:1}"
    ".views>figure>svg>circle{stroke:none}.v0{fill:#9aa5b1}.v1{fill:#f0b429}.v2{fill:#de6b1f}"
    ".v3{fill:#a31621}";

using Value = std::function<double(const FrameRow&)>;

struct Series {
    const char* style;
    std::string name;
    Value value;
};

std::string chart_over_time(const CollapseResults& results, const std::string& title, const std::string& axis,
                            const std::string& caption, const std::vector<Series>& series) {
    double high = 0.0, low = 0.0;
    for (const FrameRow& row : results.record.rows) {
        for (const Series& one : series) {
            high = std::max(high, one.value(row));
            low = std::min(low, one.value(row));
        }
    }
    Axis y = Axis::from_zero(axis, std::max(high, 1e-9));
    if (low < 0.0) {
        const double step = report::nice_step((std::max(high, -low)) / 3.0);
        y.low = std::floor(low / step) * step;
        y.high = std::max(step, std::ceil(high / step) * step);
    }
    Chart chart{title, Axis::from_zero(page_text("Time, s"), results.record.rows.back().time_s), y};
    for (const Series& one : series) {
        std::vector<ChartPoint> points;
        for (const FrameRow& row : results.record.rows) {
            points.push_back({row.time_s, one.value(row)});
        }
        chart.add_line(one.style, points);
        chart.add_name(one.style, one.name);
    }
    return chart.figure(caption);
}

std::string charts(const CollapseResults& results) {
    constexpr double gj = 1e9;
    std::vector<Series> energies{
        {"s0", page_text("motion"),
         [](const FrameRow& r) { return (r.ledger.translation_j + r.ledger.rotation_j) / gj; }},
        {"s1", page_text("released by gravity"),
         [](const FrameRow& r) { return r.ledger.given_by_gravity_j() / gj; }},
        {"s2", page_text("friction"), [](const FrameRow& r) { return r.ledger.friction_j / gj; }},
        {"s3", page_text("dashpots"), [](const FrameRow& r) { return r.ledger.dashpot_j / gj; }},
        {"s4", page_text("fracture"), [](const FrameRow& r) { return r.ledger.fracture_j / gj; }},
        {"s5", page_text("strain"), [](const FrameRow& r) {
             return (r.ledger.contact_normal_j + r.ledger.contact_shear_j + r.ledger.bonds.sum_j()) / gj;
         }}};
    if (results.hands_over()) {
        energies.push_back({"s6", page_text("motion handed over"),
                            [](const FrameRow& r) { return r.ledger.handed_motion_j / gj; }});
    }
    const std::string html = joined(
        "<h2>", page_text("Over time"), "</h2>\n<div class=\"halves\">",
        chart_over_time(results, page_text("Energies"), page_text("Energy, GJ"),
                        page_text("All energies of the mass. What gravity released is the sum of the others, "
                                  "up to the residual."),
                        energies),
        chart_over_time(
            results, page_text("Residual"), page_text("Residual, %"),
            page_text("What the energies leave over, by the energy turned over: 0 in an exact ledger."),
            {{"s0", page_text("Residual"), [](const FrameRow& r) { return 100.0 * r.residual_share; }}}),
        chart_over_time(
            results, page_text("Speed"), page_text("Speed, m/s"),
            page_text("Mean by mass, and the largest of any block."),
            {{"s0", page_text("mean"), [](const FrameRow& r) { return r.mean_speed_mps; }},
             {"s1", page_text("largest"), [](const FrameRow& r) { return r.largest_speed_mps; }}}),
        chart_over_time(results, page_text("Front"), page_text("Front, m"),
                        page_text("Largest way in plan of any block from its start."),
                        {{"s0", page_text("Front"), [](const FrameRow& r) { return r.front_m; }}}),
        chart_over_time(results, page_text("Broken bonds"), page_text("Bonds"),
                        page_text("Tension counts bending, shear counts twist."),
                        {{"s0", page_text("tension"), [](const FrameRow& r) { return r.broken_by_tension; }},
                         {"s1", page_text("shear"), [](const FrameRow& r) { return r.broken_by_shear; }}}),
        "</div>\n");
    return html;
}

/// The direction in which the mass went: of the mean way of all blocks.
Eigen::Vector2d main_direction(const CollapseResults& results) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < results.site.count.free; ++i) {
        sum += (results.seen(i).centre_m - results.site.blocks[i].centre_m).head<2>();
    }
    return sum.norm() > 0.0 ? Eigen::Vector2d{sum.normalized()} : Eigen::Vector2d{1.0, 0.0};
}

/// Blocks seen across the direction in which they went, on one scale for all times.
class SideView {
public:
    explicit SideView(const CollapseResults& results) : results_{results}, along_{main_direction(results)} {
        for (const auto& frame : results.record.frames) {
            for (const BlockPlace& block : frame) {
                low_ = std::min(low_, way_of(block));
                high_ = std::max(high_, way_of(block));
                bottom_ = std::min(bottom_, static_cast<double>(block.centre_m[2]));
                top_ = std::max(top_, static_cast<double>(block.centre_m[2]));
            }
        }
        scale_ = width / (high_ - low_ + 2.0 * margin_m);
    }

    [[nodiscard]] std::string at(std::size_t frame) const {
        const double height = scale_ * (top_ - bottom_ + 2.0 * margin_m);
        std::string svg =
            joined("<figure><svg viewBox=\"0 0 ", place(width), " ", place(height), "\" role=\"img\">");
        const auto& blocks = results_.record.frames[frame];
        const std::size_t every = blocks.size() / most_drawn + 1;
        for (std::size_t i = 0; i < blocks.size(); i += every) {
            const double size_m = std::cbrt(results_.site.blocks[i].solid.volume_m3);
            const float speed = blocks[i].speed_mps;
            const char* colour = speed < 1.0F ? "v0" : speed < 5.0F ? "v1" : speed < 15.0F ? "v2" : "v3";
            svg += joined("<circle class=\"", colour, "\" cx=\"",
                          place(scale_ * (way_of(blocks[i]) - low_ + margin_m)), "\" cy=\"",
                          place(scale_ * (top_ + margin_m - static_cast<double>(blocks[i].centre_m[2]))),
                          "\" r=\"", place(std::max(0.5, 0.5 * scale_ * size_m)), "\"/>");
        }
        return joined(svg, "</svg><figcaption>",
                      page_text("after {time} s", {{"time", fixed(results_.record.rows[frame].time_s, 1)}}),
                      "</figcaption></figure>");
    }

private:
    [[nodiscard]] double way_of(const BlockPlace& block) const {
        return along_.x() * static_cast<double>(block.centre_m[0]) +
               along_.y() * static_cast<double>(block.centre_m[1]);
    }
    static constexpr double width = 480.0;
    static constexpr double margin_m = 6.0;
    static constexpr std::size_t most_drawn = 4000;
    const CollapseResults& results_;
    Eigen::Vector2d along_;
    double low_ = 1e300, high_ = -1e300, bottom_ = 1e300, top_ = -1e300, scale_ = 1.0;
};

std::string views(const CollapseResults& results) {
    const SideView view{results};
    std::string html =
        joined("<h2>", page_text("The mass from the side"), "</h2>\n<section class=\"card\"><p>",
               page_text("Seen across the direction in which the blocks went on average; one scale for all "
                         "times. Grey: below 1 m/s, yellow: below 5, orange: below 15, red: faster."),
               "</p><div class=\"views\">");
    const std::size_t last = results.record.frames.size() - 1;
    std::size_t before = last + 1;
    for (const double share : {0.0, 0.133, 0.333, 0.667, 1.0}) {
        const auto frame = static_cast<std::size_t>(std::lround(share * static_cast<double>(last)));
        if (frame != before) {
            html += view.at(frame);
        }
        before = frame;
    }
    return joined(html, "</div></section>\n");
}

std::string leaving(const CollapseResults& results) {
    return results.hands_over()
               ? report::departures_line({{page_text("Blocks that went on as single ones"),
                                           departures_of_single_blocks(results.hand_over, results.site)}})
               : "";
}

/// A share of which more digits than three mean nothing.
std::string residual_in_words(double share) {
    constexpr double smallest = 1e-5;
    return share < smallest ? page_text("below {share}", {{"share", report::percent(smallest)}})
                            : report::percent(share);
}

std::string opening(const CollapseResults& results) {
    const KeyFigures figures = key_figures(results);
    const BlockCount& count = results.site.count;
    std::string html =
        joined("<h1>", page_text("A rock mass breaks up"), "</h1>\n<p class=\"lead\">",
               page_text("Scenario {file}: {blocks} blocks with {volume} m³ broke up. The fastest mean speed "
                         "was {speed} m/s after {time} s; the front went {front} m.",
                         {{"file", escaped(results.scenario.scenario.file.filename().string())},
                          {"blocks", grouped(count.free)},
                          {"volume", grouped(static_cast<std::uint64_t>(std::llround(count.blocks_m3)))},
                          {"front", fixed(figures.front_m, 0)},
                          {"speed", fixed(figures.peak_mean_speed_mps, 1)},
                          {"time", fixed(figures.peak_time_s, 1)}}),
               "</p>\n", report::first_warnings(results.warnings), leaving(results), "<dl class=\"facts\">");
    const auto fact = [&](const char* key, const std::string& value) {
        html += report::fact(page_text(key), value);
    };
    fact("Duration until at most 1 % of the blocks move",
         figures.duration_s ? joined(fixed(*figures.duration_s, 1), " s")
                            : page_text("more still move at the end ({time} s)",
                                        {{"time", fixed(results.record.rows.back().time_s, 1)}}));
    fact("Largest speed of a block", joined(fixed(figures.largest_speed_mps, 1), " m/s"));
    fact("Area that blocks passed",
         joined(grouped(static_cast<std::uint64_t>(std::llround(figures.area_m2))), " m²"));
    fact("Bonds that hold at the end",
         joined(grouped(results.mass.bonds_intact()), " / ", grouped(count.bonds)));
    fact("Largest residual of the energies", residual_in_words(figures.largest_residual));
    if (results.hands_over()) {
        fact("Blocks that went on as single ones", grouped(results.hand_over.falls().size()));
    }
    fact("Volume that still moves at the end", report::percent(figures.moving_share));
    fact("Slivers left out", joined(fixed(count.left_out_m3, 1), " m³"));
    fact("Time step", joined(fixed(1e3 * results.mass.step_s(), 3), " ms"));
    fact("Random seed", std::to_string(results.scenario.scenario.run.seed));
    fact("Program", page_text("Bannwald {version}", {{"version", escaped(results.version)}}));
    return joined(html, "</dl>\n");
}

std::string targets(const CollapseResults& results) {
    if (results.site.targets.empty()) {
        return "";
    }
    report::HtmlTable table{page_text("Energy and speed are those of a block when it first reaches the "
                                      "target; translation and rotation."),
                            {page_text("Target"), page_text("Blocks"), page_text("Volume, m³"),
                             page_text("Largest energy, kJ"), page_text("Largest speed, m/s")}};
    for (std::size_t t = 0; t < results.site.targets.size(); ++t) {
        std::uint64_t blocks = 0;
        double volume_m3 = 0.0, energy_j = 0.0, speed_mps = 0.0;
        for (const TargetHit& hit : results.record.hits) {
            if (hit.target == static_cast<double>(t)) {
                ++blocks;
                volume_m3 += hit.volume_m3;
                energy_j = std::max(energy_j, hit.energy_j);
                speed_mps = std::max(speed_mps, hit.speed_mps);
            }
        }
        table.row({escaped(results.site.targets[t].name), grouped(blocks), fixed(volume_m3, 1),
                   report::three_digits(energy_j / 1e3), fixed(speed_mps, 1)});
    }
    return joined("<h2>", page_text("What reached the targets"), "</h2>\n<section class=\"card\">",
                  table.html(), "</section>\n");
}

bool plays_a_part(const std::string& key) {
    return key.starts_with("collapse.") || key.starts_with("terrain.") || key.starts_with("trees.") ||
           key.starts_with("targets.") || key == "run.seed" || key == "output.vtp" ||
           key == "output.cell_size_m" ||
           key.starts_with(joined(rockfall::BlockModel::description().name, ".")) ||
           key.starts_with("ground.");
}

}  // namespace

void write_page(std::ostream& out, const CollapseResults& results, const std::vector<WrittenFile>& files) {
    const Scenario& scenario = results.scenario.scenario;
    const report::WritingLanguage language{scenario.report.language};
    const report::PageFrame frame{
        .title = page_text("Rock mass: {name}", {{"name", escaped(scenario.file.stem().string())}}),
        .version = results.version,
        .scripts = {page_scripts::charts(), page_scripts::slope()},
        .style = page_style,
        .before_main = {}};
    report::begin_page(out, frame);
    out << opening(results) << views(results) << scene_section(results) << maps_section(results)
        << charts(results) << targets(results) << joined("<h2>", page_text("Warnings"), "</h2>\n")
        << report::list_of_warnings(results.warnings) << joined("<h2>", page_text("Settings"), "</h2>\n")
        << report::table_of_settings(scenario, plays_a_part)
        << joined("<h2>", page_text("Data"), "</h2>\n<section class=\"card\"><p>",
                  page_text("Input files, named as in the scenario; please credit their owners as their "
                            "licences ask."),
                  "</p>")
        << report::table_of_inputs(results.site.inputs)
        << joined("</section>\n<h2>", page_text("Files of this run"), "</h2>\n<section class=\"card\">")
        << report::table_of_files("", files) << "</section>\n"
        << report::citation(results.version, scenario);
    report::end_page(out, frame);
}

}  // namespace coupling::collapse
