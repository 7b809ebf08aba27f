#include <algorithm>
#include <set>

#include "config/text/joined.hpp"
#include "coupling/assessments/decades/report/page_parts.hpp"
#include "coupling/assessments/decades/report/stand_drawing.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::decades {
namespace {

using config::joined;
using report::escaped;

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
        items += joined("<li><svg viewBox=\"0 0 30 14\" aria-hidden=\"true\">",
                        species.conifer ? joined("<path class=\"crown ", fill_of_species(s),
                                                 "\" d=\"M6 13.5L15 .5L24 13.5z\"/>")
                                        : joined("<ellipse class=\"crown ", fill_of_species(s),
                                                 "\" cx=\"15\" cy=\"7\" rx=\"10\" ry=\"6.5\"/>"),
                        "</svg>", escaped(species.latin_name), " (", escaped(species.code), ")</li>");
    }
    return joined("<ul class=\"names\">", items, "</ul>");
}

std::string figure(const std::string& title, const Drawing& drawing) {
    return joined("<figure class=\"map stand\"><figcaption><b>", escaped(title), "</b></figcaption>",
                  drawing.svg, drawing.left_out.empty() ? "" : joined("<p>", drawing.left_out, "</p>"),
                  "</figure>\n");
}

std::string beside(const std::string& figures) {
    return joined("<div class=\"halves\">", figures, "</div>\n");
}

std::string contour_words(const PlanDrawing& plan) {
    return report::page_text("Contours every {step_m} m.",
                             {{"step_m", report::tick_text(plan.contour_step_m())}});
}

}  // namespace

std::string pictures(const PageContent& content, const RunView& run) {
    const std::vector<DrawnYear> scenes = scenes_of(run);
    if (scenes.empty() || content.grid.size() == 0) {
        return "";
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
    std::string points;
    std::string crowns;
    std::string sides;
    for (const DrawnYear& scene : scenes) {
        points += window.whole ? "" : figure(scene.title, whole.points(scene.trees, window.frame));
        crowns += figure(scene.title, near.crowns(scene.trees, strip));
        sides += figure(scene.title, side_view(trees_in_strip(scene.trees, strip), content.names.species,
                                               ground, strip, top_m));
    }
    std::string html =
        joined("<p>",
               report::page_text(
                   "Trees of replicate {member_replicate}; a group of equal young trees is drawn as one.",
                   {{"member_replicate", std::to_string(run.regimes.front().first->member.replicate + 1)}}),
               "</p>\n<svg class=\"definitions stand\" aria-hidden=\"true\"><defs>",
               window.whole ? "" : whole.definitions(), near.definitions(),
               "</defs></svg>\n<section class=\"card map stand\">", legend(content, scenes), "</section>\n");
    if (!window.whole) {
        html +=
            joined("<h3>", report::page_text("The whole forest"), "</h3>\n<p>",
                   report::join_sentences(
                       {report::page_text(
                            "A point is a tree; its size goes with its diameter (below 12, 24, 36, 52 cm and "
                            "above)."),
                        contour_words(whole), report::page_text("The square is shown enlarged below.")}),
                   "</p>\n", beside(points));
    }
    html += joined(
        "<h3>", report::page_text("Crowns from above"), "</h3>\n<p>",
        report::join_sentences({report::page_text("Crowns at their true width, tall trees over low ones."),
                                contour_words(near),
                                report::page_text("The dashed strip P to Q is shown from the side below.")}),
        "</p>\n", beside(crowns));
    return joined(
        html, "<h3>", report::page_text("From the side"), "</h3>\n<p>",
        report::page_text(
            "All trees of a strip {strip_m} m wide from P to Q, {direction}; heights and distances at "
            "one scale, stems drawn {stem_widening} times as thick as they are. Pointed crowns: "
            "conifers; rounded: broadleaves.",
            {{"strip_m", report::tick_text(strip_m)},
             {"direction", strip.falls ? report::page_text("down the mean fall line")
                                       : report::page_text("from west to east, for the ground is flat")},
             {"stem_widening", report::tick_text(stem_widening)}}),
        "</p>\n", beside(sides));
}

}  // namespace coupling::decades
