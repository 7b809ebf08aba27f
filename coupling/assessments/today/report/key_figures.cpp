#include <array>
#include <vector>

#include "config/text/joined.hpp"
#include "coupling/assessments/today/report/sections.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::report {
namespace {

using config::joined;

/// One row of the table of all rocks: a name and how to read the figure.
struct KeyFigure {
    const char* name;
    std::string (*value)(const SlopeFigures&);
};

std::string stop_share(const SlopeFigures& slope, rockfall::StopReason reason) {
    return percent(slope.by_reason[static_cast<std::size_t>(reason)].value);
}

std::string three(const Distribution& d) {
    return joined(three_digits(d.mean), " / ", three_digits(d.p90), " / ", three_digits(d.max));
}

using rockfall::StopReason;

constexpr std::array key_figure_rows{
    KeyFigure{"common.rocks", [](const SlopeFigures& s) { return grouped(s.rocks); }},
    KeyFigure{"common.came_to_rest_on_the_ground",
              [](const SlopeFigures& s) { return stop_share(s, StopReason::at_rest); }},
    KeyFigure{"common.caught_by_the_roughness_of_the",
              [](const SlopeFigures& s) { return stop_share(s, StopReason::caught); }},
    KeyFigure{"today.key_figures.stopped_at_a_tree",
              [](const SlopeFigures& s) { return stop_share(s, StopReason::tree); }},
    KeyFigure{"today.key_figures.stopped_at_a_lying_log",
              [](const SlopeFigures& s) { return stop_share(s, StopReason::log); }},
    KeyFigure{"today.key_figures.held_by_a_net",
              [](const SlopeFigures& s) { return stop_share(s, StopReason::net); }},
    KeyFigure{"today.key_figures.left_the_terrain_not_stopped",
              [](const SlopeFigures& s) { return stop_share(s, StopReason::left_terrain); }},
    KeyFigure{"today.key_figures.given_up_too_many_impacts_not",
              [](const SlopeFigures& s) { return stop_share(s, StopReason::gave_up); }},
    KeyFigure{"today.key_figures.stopped_on_the_terrain",
              [](const SlopeFigures& s) { return percent(s.stopped.value); }},
    KeyFigure{"today.key_figures.run_out_in_plan_m_mean_90",
              [](const SlopeFigures& s) { return three(s.run_out_m); }},
    KeyFigure{"today.key_figures.run_out_at_least",
              [](const SlopeFigures& s) { return three(s.run_out_at_least_m); }},
    KeyFigure{"today.key_figures.highest_speed_of_a_rock_m_s",
              [](const SlopeFigures& s) { return three(s.max_speed_mps); }},
    KeyFigure{"today.key_figures.mean_speed_of_a_rock_m_s",
              [](const SlopeFigures& s) { return three_digits(s.mean_speed_mps); }},
    KeyFigure{"today.key_figures.highest_energy_of_a_rock_kj",
              [](const SlopeFigures& s) { return three(s.max_energy_kj); }},
    KeyFigure{"today.key_figures.highest_jump_of_a_rock_m_mean",
              [](const SlopeFigures& s) { return three(s.max_height_m); }},
    KeyFigure{"today.key_figures.mean_height_of_all_jumps_m",
              [](const SlopeFigures& s) { return three_digits(s.jump_height_mean_m); }},
    KeyFigure{"common.ground_impacts_per_rock",
              [](const SlopeFigures& s) { return three_digits(s.ground_impacts_per_rock); }},
    KeyFigure{"today.key_figures.rocks_that_hit_a_tree",
              [](const SlopeFigures& s) { return percent(s.hit_a_tree.value); }},
    KeyFigure{"common.tree_hits_per_rock",
              [](const SlopeFigures& s) { return three_digits(s.tree_hits_per_rock); }},
    KeyFigure{"today.key_figures.trees_broken_per_rock",
              [](const SlopeFigures& s) { return three_digits(s.trees_broken_per_rock); }},
    KeyFigure{"today.key_figures.energy_taken_by_trees_per_rock",
              [](const SlopeFigures& s) { return three_digits(s.tree_energy_per_rock_kj); }},
    KeyFigure{"today.key_figures.hits_on_lying_logs_per_rock",
              [](const SlopeFigures& s) { return three_digits(s.log_hits_per_rock); }},
    KeyFigure{"today.key_figures.logs_broken_per_rock",
              [](const SlopeFigures& s) { return three_digits(s.logs_broken_per_rock); }},
    KeyFigure{"today.key_figures.energy_taken_by_logs_per_rock",
              [](const SlopeFigures& s) { return three_digits(s.log_energy_per_rock_kj); }},
};

}  // namespace

std::string key_figures(const RunResults& results, const Figures& figures) {
    const std::vector<Cover> covers = covers_of(results);
    std::vector<std::string> head{page_text("common.all_rocks")};
    for (const Cover cover : covers) {
        head.emplace_back(cover == Cover::forest ? page_text("common.with_forest")
                                                 : page_text("common.bare_slope"));
    }
    HtmlTable table{"", head};
    for (const KeyFigure& row : key_figure_rows) {
        std::vector<std::string> cells{page_text(row.name)};
        for (const Cover cover : covers) {
            cells.push_back(row.value(figures.at(cover)));
        }
        table.row(cells);
    }
    return joined("<h2>", page_text("common.key_figures"), "</h2>\n<section class=\"card\">", table.html(),
                  "</section>\n");
}

}  // namespace coupling::report
