#include <array>
#include <vector>

#include "config/text/joined.hpp"
#include "coupling/assessments/today/report/sections.hpp"
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
    KeyFigure{"Rocks", [](const SlopeFigures& s) { return grouped(s.rocks); }},
    KeyFigure{"Came to rest on the ground",
              [](const SlopeFigures& s) { return stop_share(s, StopReason::at_rest); }},
    KeyFigure{"Caught by the roughness of the ground",
              [](const SlopeFigures& s) { return stop_share(s, StopReason::caught); }},
    KeyFigure{"Stopped at a tree", [](const SlopeFigures& s) { return stop_share(s, StopReason::tree); }},
    KeyFigure{"Stopped at a lying log", [](const SlopeFigures& s) { return stop_share(s, StopReason::log); }},
    KeyFigure{"Held by a net", [](const SlopeFigures& s) { return stop_share(s, StopReason::net); }},
    KeyFigure{"Left the terrain (not stopped)",
              [](const SlopeFigures& s) { return stop_share(s, StopReason::left_terrain); }},
    KeyFigure{"Given up (too many impacts, not stopped)",
              [](const SlopeFigures& s) { return stop_share(s, StopReason::gave_up); }},
    KeyFigure{"Stopped on the terrain", [](const SlopeFigures& s) { return percent(s.stopped.value); }},
    KeyFigure{"Run-out in plan of the rocks that stop on the terrain, m: mean / 90 % / largest",
              [](const SlopeFigures& s) { return three(s.run_out_m); }},
    KeyFigure{
        "Run-out of all rocks, at least (those that leave count up to the edge), m: mean / 90 % / largest",
        [](const SlopeFigures& s) { return three(s.run_out_at_least_m); }},
    KeyFigure{"Highest speed of a rock, m/s: mean / 90 % / largest",
              [](const SlopeFigures& s) { return three(s.max_speed_mps); }},
    KeyFigure{"Mean speed of a rock, m/s",
              [](const SlopeFigures& s) { return three_digits(s.mean_speed_mps); }},
    KeyFigure{"Highest energy of a rock, kJ: mean / 90 % / largest",
              [](const SlopeFigures& s) { return three(s.max_energy_kj); }},
    KeyFigure{"Highest jump of a rock, m: mean / 90 % / largest",
              [](const SlopeFigures& s) { return three(s.max_height_m); }},
    KeyFigure{"Mean height of all jumps, m",
              [](const SlopeFigures& s) { return three_digits(s.jump_height_mean_m); }},
    KeyFigure{"Ground impacts per rock",
              [](const SlopeFigures& s) { return three_digits(s.ground_impacts_per_rock); }},
    KeyFigure{"Rocks that hit a tree", [](const SlopeFigures& s) { return percent(s.hit_a_tree.value); }},
    KeyFigure{"Tree hits per rock", [](const SlopeFigures& s) { return three_digits(s.tree_hits_per_rock); }},
    KeyFigure{"Trees broken per rock",
              [](const SlopeFigures& s) { return three_digits(s.trees_broken_per_rock); }},
    KeyFigure{"Energy taken by trees per rock, kJ",
              [](const SlopeFigures& s) { return three_digits(s.tree_energy_per_rock_kj); }},
    KeyFigure{"Hits on lying logs per rock",
              [](const SlopeFigures& s) { return three_digits(s.log_hits_per_rock); }},
    KeyFigure{"Logs broken per rock",
              [](const SlopeFigures& s) { return three_digits(s.logs_broken_per_rock); }},
    KeyFigure{"Energy taken by logs per rock, kJ",
              [](const SlopeFigures& s) { return three_digits(s.log_energy_per_rock_kj); }},
};

}  // namespace

PageFields key_figures(const RunResults& results, const Figures& figures) {
    const std::vector<Cover> covers = covers_of(results);
    std::vector<PageFields> slopes;
    for (const Cover cover : covers) {
        slopes.push_back({{"slope", title_of(cover)}});
    }
    std::vector<PageFields> rows;
    for (const KeyFigure& row : key_figure_rows) {
        std::vector<PageFields> values;
        for (const Cover cover : covers) {
            values.push_back({{"figure", row.value(figures.at(cover))}});
        }
        rows.push_back({{"name", page_text(row.name)}, {"slopes", values}});
    }
    return {{"slopes", slopes}, {"key_figures", rows}};
}

}  // namespace coupling::report
