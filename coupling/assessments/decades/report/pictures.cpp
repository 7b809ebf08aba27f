#include <algorithm>
#include <set>

#include "config/text/joined.hpp"
#include "coupling/assessments/decades/report/page_parts.hpp"
#include "coupling/assessments/decades/report/stand_drawing.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::decades {
namespace {

using config::joined;
using report::PageField;
using report::PageFields;

/// The trees of one member in one year.
struct DrawnYear {
    std::string title;
    DrawnTrees trees;
};

DrawnTrees trees_of(const MemberYears& member, std::int32_t year) {
    DrawnTrees trees;
    for (const TreeRow& tree : member.trees) {
        if (tree.year == year) {
            trees.push_back(&tree);
        }
    }
    return trees;
}

bool same_trees(const DrawnTrees& a, const DrawnTrees& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const TreeRow* one, const TreeRow* other) {
        return one->tree == other->tree && one->x_m == other->x_m && one->y_m == other->y_m &&
               one->dbh_cm == other->dbh_cm && one->height_m == other->height_m && one->stems == other->stems;
    });
}

std::string year_title(std::int32_t year) {
    return year == 0 ? report::page_text("start")
                     : report::page_text("year {year}", {{"year", std::to_string(year)}});
}

/// First and last year with a list of trees. What all regimes begin with is shown once.
std::vector<DrawnYear> scenes_of(const RunView& run) {
    std::set<std::int32_t> years;
    for (const RegimeView& regime : run.regimes) {
        for (const TreeRow& tree : regime.first->trees) {
            years.insert(tree.year);
        }
    }
    std::vector<DrawnYear> scenes;
    if (years.empty()) {
        return scenes;
    }
    const bool same_start =
        std::all_of(run.regimes.begin(), run.regimes.end(), [&](const RegimeView& regime) {
            return same_trees(trees_of(*regime.first, *years.begin()),
                              trees_of(*run.regimes.front().first, *years.begin()));
        });
    for (const RegimeView& regime : run.regimes) {
        const std::string name = run.regimes.size() > 1 ? regime.title() : "";
        if (!same_start || &regime == &run.regimes.front()) {
            scenes.push_back(
                {report::join_with_commas(
                     {same_start && run.regimes.size() > 1 ? report::page_text("All regimes") : name,
                      year_title(*years.begin())}),
                 trees_of(*regime.first, *years.begin())});
        }
        if (years.size() > 1) {
            scenes.push_back({report::join_with_commas({name, year_title(*years.rbegin())}),
                              trees_of(*regime.first, *years.rbegin())});
        }
    }
    return scenes;
}

/// Species that stand in any scene, each with its fill and its silhouette.
std::string legend(const PageContent& content, const std::vector<DrawnYear>& scenes) {
    std::set<std::uint32_t> seen;
    for (const DrawnYear& scene : scenes) {
        for (const TreeRow* tree : scene.trees) {
            seen.insert(tree->species);
        }
    }
    std::string items;
    for (const std::uint32_t s : seen) {
        const forest::Species& species = content.names.species.all()[s];
        const std::string style = joined("crown ", fill_of_species(s));
        items += report::legend_item(
            species.conifer
                ? report::svg_path(style, "M6 13.5L15 .5L24 13.5z")
                : report::element("ellipse",
                                  {{"class", style}, {"cx", 15.0}, {"cy", 7.0}, {"rx", 10.0}, {"ry", 6.5}}),
            report::escaped(joined(species.latin_name, " (", species.code, ")")));
    }
    return items;
}

PageFields figure_of(const std::string& title, const Drawing& drawing) {
    return {{"title", title},
            {"drawing", drawing.svg},
            {"is_thinned", !drawing.left_out.empty()},
            {"left_out", drawing.left_out}};
}

PageField step_of(const PlanDrawing& plan) {
    return {"step_m", report::tick_text(plan.contour_step_m())};
}

}  // namespace

std::optional<PageFields> pictures(const PageContent& content, const RunView& run) {
    const std::vector<DrawnYear> scenes = scenes_of(run);
    if (scenes.empty() || content.grid.size() == 0) {
        return std::nullopt;
    }
    const ForestGround ground{content.grid};
    const StandWindow window = window_of(content.grid);
    const Transect strip = transect_of(content.grid, window);
    const PlanDrawing whole{content.grid, ground, extent_of(content.grid), "forest-ground"};
    const PlanDrawing near{content.grid, ground, window.frame, "window-ground"};

    double top_m = -INFINITY;
    for (const DrawnYear& scene : scenes) {
        top_m = std::max(top_m, top_of(trees_in_strip(scene.trees, strip), ground, strip));
    }
    std::vector<PageFields> points;
    std::vector<PageFields> crowns;
    std::vector<PageFields> sides;
    for (const DrawnYear& scene : scenes) {
        if (!window.whole) {
            points.push_back(figure_of(scene.title, whole.points(scene.trees, window.frame)));
        }
        crowns.push_back(figure_of(scene.title, near.crowns(scene.trees, strip)));
        sides.push_back(figure_of(scene.title, side_view(trees_in_strip(scene.trees, strip),
                                                         content.names.species, ground, strip, top_m)));
    }
    return PageFields{
        {"member_replicate", std::to_string(run.regimes.front().first->member.replicate + 1)},
        {"definitions", joined(window.whole ? "" : whole.definitions(), near.definitions())},
        {"legend", legend(content, scenes)},
        {"whole_forest",
         window.whole ? std::nullopt : std::optional{PageFields{step_of(whole), {"figures", points}}}},
        step_of(near),
        {"crowns", crowns},
        {"strip_m", report::tick_text(strip_m)},
        {"direction", strip.falls ? report::page_text("down the mean fall line")
                                  : report::page_text("from west to east, for the ground is flat")},
        {"stem_widening", report::tick_text(stem_widening)},
        {"sides", sides}};
}

}  // namespace coupling::decades
