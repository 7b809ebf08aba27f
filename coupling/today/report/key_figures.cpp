#include <array>
#include <vector>

#include "config/text/joined.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/report/markup.hpp"
#include "coupling/today/report/sections.hpp"

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
    KeyFigure{"Run-out in plan, m: mean / 90 % / largest",
              [](const SlopeFigures& s) { return three(s.run_out_m); }},
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

/// Sums over the trees of a diameter class.
struct DiameterClass {
    const char* name;
    double low_cm;
    std::uint64_t trees = 0;
    std::uint64_t hit = 0;
    std::uint64_t hits = 0;
    std::uint64_t broken = 0;
    std::uint64_t energy_j = 0;
};

std::string share_text(std::uint64_t part, std::uint64_t whole) {
    return whole == 0 ? "–" : percent(static_cast<double>(part) / static_cast<double>(whole));
}

std::string trees_by_diameter(const RunResults& results) {
    std::array<DiameterClass, 6> classes{{{"below 8 cm", 0.0},
                                          {"8 to 20 cm", 8.0},
                                          {"20 to 36 cm", 20.0},
                                          {"36 to 52 cm", 36.0},
                                          {"52 to 72 cm", 52.0},
                                          {"72 cm and more", 72.0}}};
    DiameterClass all{"all", 0.0};
    for (std::size_t i = 0; i < results.site.trees.size(); ++i) {
        const rockfall::StemTally& tally = results.tally.stems[i];
        auto at = classes.begin();
        while (at + 1 != classes.end() && results.site.trees[i].stem.dbh_cm >= (at + 1)->low_cm) {
            ++at;
        }
        for (DiameterClass* sums : {&*at, &all}) {
            ++sums->trees;
            sums->hit += tally.hits > 0 ? 1U : 0U;
            sums->hits += tally.hits;
            sums->broken += tally.broken;
            sums->energy_j += tally.energy_j;
        }
    }
    HtmlTable table{
        "Which trees take the energy: every tree is listed in tables/stems.csv. A hit counts as breaking if "
        "it "
        "exceeds the strength of the stem.",
        {"Diameter at breast height", "trees", "hit at least once", "hits", "of them breaking",
         "share of all energy taken"}};
    const auto add = [&](const DiameterClass& c) {
        table.row({c.name, grouped(c.trees), grouped(c.hit), grouped(c.hits), share_text(c.broken, c.hits),
                   share_text(c.energy_j, all.energy_j)});
    };
    for (const DiameterClass& c : classes) {
        if (c.trees > 0) {
            add(c);
        }
    }
    add(all);
    return table.html();
}

}  // namespace

std::string key_figures(const RunResults& results, const Figures& figures) {
    const std::vector<Cover> covers = covers_of(results);
    std::vector<std::string> head{"All rocks"};
    for (const Cover cover : covers) {
        head.emplace_back(cover == Cover::forest ? "with forest" : "bare slope");
    }
    HtmlTable table{"", head};
    for (const KeyFigure& row : key_figure_rows) {
        std::vector<std::string> cells{row.name};
        for (const Cover cover : covers) {
            cells.push_back(row.value(figures.at(cover)));
        }
        table.row(cells);
    }
    return joined("<h2>Key figures</h2>\n<section class=\"card\">", table.html(), "</section>\n",
                  (results.with_forest && !results.site.trees.empty()
                       ? joined("<section class=\"card\">", trees_by_diameter(results), "</section>\n")
                       : ""));
}

}  // namespace coupling::report
