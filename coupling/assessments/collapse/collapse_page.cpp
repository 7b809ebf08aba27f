#include <algorithm>
#include <cmath>
#include <functional>

#include "config/text/joined.hpp"
#include "coupling/assessments/collapse/building_damage.hpp"
#include "coupling/assessments/collapse/collapse_results.hpp"
#include "coupling/assessments/collapse/handed_departures.hpp"
#include "coupling/assessments/collapse/side_views.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/page_scripts/page_scripts.hpp"
#include "coupling/results/report/chart.hpp"
#include "coupling/results/report/departures_line.hpp"
#include "coupling/results/report/first_warnings.hpp"
#include "coupling/results/report/listings.hpp"
#include "coupling/results/report/page_frame.hpp"
#include "coupling/results/templates/page_files.hpp"
#include "coupling/results/templates/page_template.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/scenario_names.hpp"
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
using report::PageFields;

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
        energies.push_back({"s6", page_text("motion handed over"), [](const FrameRow& r) {
                                return (r.ledger.handed_motion_j - r.ledger.back_motion_j) / gj;
                            }});
    }
    return joined(
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
                        page_text("Largest way in plan of any block from its start; mean distance of all "
                                  "blocks from their start, by mass."),
                        {{"s0", page_text("Front"), [](const FrameRow& r) { return r.front_m; }},
                         {"s1", page_text("mean displacement"),
                          [](const FrameRow& r) { return r.mean_displacement_m; }}}),
        chart_over_time(results, page_text("Broken bonds"), page_text("Bonds"),
                        page_text("Tension counts bending, shear counts twist."),
                        {{"s0", page_text("tension"), [](const FrameRow& r) { return r.broken_by_tension; }},
                         {"s1", page_text("shear"), [](const FrameRow& r) { return r.broken_by_shear; }}}));
}

PageFields key_facts(const CollapseResults& results) {
    const KeyFigures figures = key_figures(results);
    const BlockCount& count = results.site.count;
    const auto scaled = results.mass.scaled_mass();
    constexpr double smallest_residual = 1e-5;  // of which more digits mean nothing
    return {{"file", results.scenario.scenario.file.filename().string()},
            {"blocks", grouped(count.free)},
            {"volume", fixed(count.blocks_m3, 0)},
            {"front", fixed(figures.front_m, 0)},
            {"speed", fixed(figures.peak_mean_speed_mps, 1)},
            {"time", fixed(figures.peak_time_s, 1)},
            {"at_rest", figures.duration_s
                            ? std::optional{PageFields{{"duration", fixed(*figures.duration_s, 1)}}}
                            : std::nullopt},
            {"still_moving",
             figures.duration_s
                 ? std::nullopt
                 : std::optional{PageFields{{"time", fixed(results.record.rows.back().time_s, 1)}}}},
            {"largest_speed", fixed(figures.largest_speed_mps, 1)},
            {"area", fixed(figures.area_m2, 0)},
            {"left", grouped(figures.left)},
            {"left_share", report::percent(figures.left_share)},
            {"some_left", figures.left > 0},
            {"bonds_intact", grouped(results.mass.bonds_intact())},
            {"bonds", grouped(count.bonds)},
            {"residual_is_tiny", figures.largest_residual < smallest_residual},
            {"share", report::percent(std::max(figures.largest_residual, smallest_residual))},
            {"handed_over", results.hands_over()},
            {"single_blocks", grouped(results.hand_over.blocks())},
            {"returns", grouped(results.hand_over.returns())},
            {"moving", report::percent(figures.moving_share)},
            {"left_out", fixed(count.left_out_m3, 1)},
            {"mass_added", scaled.blocks > 0
                               ? std::optional{PageFields{{"blocks", grouped(scaled.blocks)},
                                                          {"factor", fixed(scaled.largest_factor, 2)},
                                                          {"share", report::percent(scaled.added_share)}}}
                               : std::nullopt},
            {"step", fixed(1e3 * results.mass.step_s(), 3)},
            {"seed", std::to_string(results.scenario.scenario.run.seed)},
            {"version", results.version}};
}

std::string leaving(const CollapseResults& results) {
    return results.hands_over()
               ? report::departures_line({{page_text("Blocks that went on as single ones"),
                                           departures_of_single_blocks(results.hand_over, results.site)}})
               : "";
}

std::optional<PageFields> targets(const CollapseResults& results) {
    std::vector<PageFields> rows;
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
        rows.push_back({{"name", results.site.targets[t].name},
                        {"hits", grouped(blocks)},
                        {"hit_volume", fixed(volume_m3, 1)},
                        {"hit_energy", report::three_digits(energy_j / 1e3)},
                        {"hit_speed", fixed(speed_mps, 1)}});
    }
    return rows.empty() ? std::nullopt : std::optional{PageFields{{"rows", rows}}};
}

/// What blocks did to targets that are areas, and the sum of all.
std::optional<PageFields> buildings(const CollapseResults& results) {
    std::vector<PageFields> rows;
    double reached_m2 = 0.0, floor_m2 = 0.0;
    for (const BuildingDamage& damage : building_damage(results)) {
        const rockfall::Target& target = results.site.targets[damage.target];
        reached_m2 += damage.reached_m2;
        floor_m2 += damage.floor_m2;
        rows.push_back({{"name", target.name.empty() ? target.id : target.name},
                        {"floor", fixed(damage.floor_m2, 0)},
                        {"reached", fixed(damage.reached_m2, 0)},
                        {"share", report::percent(damage.reached_share())},
                        {"reached_low", fixed(damage.reached_low_m2, 0)},
                        {"reached_high", fixed(damage.reached_high_m2, 0)},
                        {"walls", joined(grouped(damage.walls_hit()), " / ", grouped(damage.walls.size()))},
                        {"largest", report::three_digits(damage.largest_on_wall_j() / 1e3)},
                        {"sum", report::three_digits(damage.energy_on_walls_j() / 1e6)}});
    }
    return rows.empty() ? std::nullopt
                        : std::optional{PageFields{{"rows", rows},
                                                   {"all_reached", fixed(reached_m2, 0)},
                                                   {"all_floor", fixed(floor_m2, 0)}}};
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
    const report::NamesOfScenario names_of_scenario{scenario};
    const report::PageFrame frame{
        .title = page_text("Rock mass: {name}", {{"name", escaped(scenario.file.stem().string())}}),
        .version = results.version,
        .scripts = {page_scripts::charts(), page_scripts::slope()},
        .style = std::string{report::page_file("collapse.css")},
        .before_main = {}};
    report::begin_page(out, frame);
    PageFields fields = key_facts(results);
    const PageFields maps = maps_of_page(results);
    const PageFields sides = side_views(results);
    fields.insert(fields.end(), maps.begin(), maps.end());
    fields.insert(fields.end(), sides.begin(), sides.end());
    fields.insert(fields.end(), {{"warnings_link", report::link_to_first_warnings(results.warnings)},
                                 {"first_warnings", report::first_warnings(results.warnings)},
                                 {"leaving", leaving(results)},
                                 {"scene", scene_of_page(results)},
                                 {"charts", charts(results)},
                                 {"blocks_over_time", block_charts(results)},
                                 {"buildings", buildings(results)},
                                 {"targets", targets(results)},
                                 {"warnings", report::list_of_warnings(results.warnings)},
                                 {"settings", report::table_of_settings(scenario, plays_a_part)},
                                 {"inputs", report::table_of_inputs(results.site.inputs)},
                                 {"files", report::table_of_files("", files)},
                                 {"citation", report::citation(results.version, scenario)}});
    out << report::filled_template("collapse_page.html", fields);
    report::end_page(out, frame);
}

}  // namespace coupling::collapse
