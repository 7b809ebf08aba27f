#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "config/text/joined.hpp"
#include "coupling/assessments/decades/report/page_parts.hpp"
#include "coupling/assessments/decades/report/stand_drawing.hpp"
#include "coupling/results/report/map/contours.hpp"
#include "coupling/results/report/map/map_furniture.hpp"
#include "coupling/results/report/map/outlines.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::decades {
namespace {

using config::joined;
using report::element;
using report::place;
using report::svg_path;

constexpr double widest_plan = 430.0;
constexpr double highest_plan_px = 480.0;
constexpr double lettering = 13.0;
/// A page with many regimes must stay readable for a browser.
constexpr std::size_t most_crowns = 2500;
constexpr std::size_t most_points = 6000;

/// The largest trees, the smallest of them first, and how many are left out.
struct Chosen {
    DrawnTrees trees;
    std::size_t left_out = 0;
};
Chosen largest(const DrawnTrees& trees, float TreeRow::*size, std::size_t most) {
    Chosen chosen{trees, 0};
    std::stable_sort(chosen.trees.begin(), chosen.trees.end(),
                     [&](const TreeRow* a, const TreeRow* b) { return a->*size < b->*size; });
    if (chosen.trees.size() > most) {
        chosen.left_out = chosen.trees.size() - most;
        chosen.trees.erase(chosen.trees.begin(),
                           chosen.trees.begin() + static_cast<std::ptrdiff_t>(chosen.left_out));
    }
    return chosen;
}

/// A number that looks random, always the same for the same tree (SplitMix64, Steele et al. 2014).
std::uint64_t lot_of(const TreeRow& tree) {
    std::uint64_t x = tree.tree + 0x9e3779b97f4a7c15U;
    x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31U);
}

/// As many trees as may be drawn, a random sample: every part of the forest and every size keeps its share,
/// and a tree that is drawn in one year is drawn in others too.
Chosen by_lot(const DrawnTrees& trees, std::size_t most) {
    Chosen chosen{trees, 0};
    if (trees.size() > most) {
        chosen.left_out = trees.size() - most;
        std::stable_sort(chosen.trees.begin(), chosen.trees.end(),
                         [](const TreeRow* a, const TreeRow* b) { return lot_of(*a) < lot_of(*b); });
        chosen.trees.resize(most);
    }
    return chosen;
}

std::string one_in_text(const Chosen& chosen) {
    const double ratio = static_cast<double>(chosen.trees.size() + chosen.left_out) /
                         static_cast<double>(std::max<std::size_t>(1, chosen.trees.size()));
    return chosen.left_out == 0 ? ""
                                : report::page_text(
                                      "One tree in {trees_a_point} is drawn, a random sample: every part of "
                                      "the forest keeps its share.",
                                      {{"trees_a_point", report::fixed(ratio, ratio < 9.95 ? 1 : 0)}});
}

std::string left_out_text(const Chosen& chosen, const std::string& which) {
    return chosen.left_out == 0
               ? ""
               : report::page_text("Left out: the {chosen_left_out} {which}.",
                                   {{"chosen_left_out", report::grouped(chosen.left_out)}, {"which", which}});
}

}  // namespace

PlanDrawing::PlanDrawing(const forest::PatchGrid& grid, const ForestGround& ground,
                         const config::GridFrame& shown, std::string id)
    : grid_{grid},
      ground_{ground},
      frame_{shown},
      id_{std::move(id)},
      per_m_{std::min(widest_plan / (shown.x_east_m() - shown.x_west_m),
                      highest_plan_px / (shown.y_north_m() - shown.y_south_m))} {
    double low_m = INFINITY;
    double high_m = -INFINITY;
    for (const forest::Patch& patch : grid.patches()) {
        if (shown.covers(grid.frame().x_centre_m(patch.cell.column),
                         grid.frame().y_centre_m(patch.cell.row))) {
            low_m = std::min(low_m, patch.ground_m);
            high_m = std::max(high_m, patch.ground_m);
        }
    }
    contour_step_m_ = report::contour_step_m(low_m, high_m);
}

std::string PlanDrawing::forest_cells() const {
    config::Raster<std::uint8_t> forest{frame_, 0};
    std::string cells;
    const double side = forest::patch_side_m * per_m_;
    for (std::size_t i = 0; i < forest.values.size(); ++i) {
        const config::Cell cell = frame_.cell_of(i);
        if (grid_.at(frame_.x_centre_m(cell.column), frame_.y_centre_m(cell.row))) {
            forest.values[i] = 1;
            cells += joined("M", place(cell.column * side), " ", place(cell.row * side), "h", place(side),
                            "v", place(side), "h-", place(side), "z");
        }
    }
    return joined(svg_path("forest-cells", cells),
                  svg_path("forest-rim", report::outlines(forest, side, side)));
}

std::string PlanDrawing::contours() const {
    const auto on_sheet = [this](double x_m, double y_m) { return report::DrawnPoint{x_of(x_m), y_of(y_m)}; };
    // From the south-western corner on, counter-clockwise on the sheet's frame.
    const auto is_drawn = [this](const std::array<report::DrawnPoint, 4>& corners) {
        return corners[1].x >= 0.0 && corners[0].x <= width() && corners[2].y >= 0.0 &&
               corners[0].y <= height();
    };
    return report::contours(ground_.heights(), contour_step_m_, on_sheet, is_drawn);
}

std::string PlanDrawing::definitions() const {
    return joined(element("clipPath", {{"id", joined(id_, "-sheet")}},
                          element("rect", {{"width", width()}, {"height", height()}})),
                  element("g", {{"id", id_}}, joined(forest_cells(), svg_path("contour", contours()))));
}

std::string PlanDrawing::sheet(const std::string& label, const std::string& drawing) const {
    const report::SheetSize size{width(), height(), per_m_, lettering};
    // In the middle of the figure, however narrow the forest is.
    const double x = 0.5 * (width() - widest_plan) - 2.0;
    const std::string box = joined(place(x), " -2 ", place(widest_plan + 4.0), " ", place(height() + 4.0));
    const std::string ground = element("use", {{"href", joined("#", id_)}});
    return element(
        "svg", {{"class", "sheet"}, {"viewBox", box}, {"role", "img"}, {"aria-label", label}},
        joined(element("g", {{"clip-path", joined("url(#", id_, "-sheet)")}}, joined(ground, drawing)),
               element("rect", {{"class", "frame"}, {"width", width()}, {"height", height()}}),
               report::scale_bar(size), report::north_arrow(size)));
}

std::string PlanDrawing::strip_outline(const Transect& strip) const {
    std::string path;
    const std::array<std::array<double, 2>, 4> corners{{{0.0, 0.5 * strip_m},
                                                        {strip.length_m, 0.5 * strip_m},
                                                        {strip.length_m, -0.5 * strip_m},
                                                        {0.0, -0.5 * strip_m}}};
    for (const auto& [along_m, aside_m] : corners) {
        path += joined(path.empty() ? "M" : "L", place(x_of(strip.x_at(along_m) - aside_m * strip.along_y)),
                       " ", place(y_of(strip.y_at(along_m) + aside_m * strip.along_x)));
    }
    const auto letter = [&](double along_m, const char* name) {
        return report::svg_text(x_of(strip.x_at(along_m)), y_of(strip.y_at(along_m)) + 4.5, name,
                                {{"class", "letter"}, {"text-anchor", "middle"}});
    };
    // The ends carry the letters of the side view, as far inside as they are high.
    const double inside_m = std::min(0.25 * strip.length_m, lettering / per_m_);
    path += "z";
    return joined(svg_path("halo", path), svg_path("strip", path), letter(inside_m, "P"),
                  letter(strip.length_m - inside_m, "Q"));
}

Drawing PlanDrawing::crowns(const DrawnTrees& trees, const Transect& strip) const {
    DrawnTrees inside;
    std::copy_if(trees.begin(), trees.end(), std::back_inserter(inside),
                 [&](const TreeRow* tree) { return frame_.covers(tree->x_m, tree->y_m); });
    const Chosen chosen = largest(inside, &TreeRow::height_m, most_crowns);
    std::string svg;
    for (const TreeRow* tree : chosen.trees) {
        const double radius = std::max(0.6, static_cast<double>(tree->crown_radius_m) * per_m_);
        svg += element("circle", {{"class", fill_of_species(tree->species)},
                                  {"cx", x_of(tree->x_m)},
                                  {"cy", y_of(tree->y_m)},
                                  {"r", radius}});
    }
    return {sheet(report::page_text("crowns seen from above"),
                  joined(element("g", {{"class", "crown"}}, svg), strip_outline(strip))),
            left_out_text(chosen, report::page_text("lowest trees"))};
}

Drawing PlanDrawing::points(const DrawnTrees& trees, const config::GridFrame& window) const {
    constexpr std::array<float, 4> limits_cm{12.0F, 24.0F, 36.0F, 52.0F};
    const Chosen chosen = by_lot(trees, most_points);
    // Points shrink with the map, but not out of sight.
    const double scale = std::clamp(per_m_, 0.9, 3.0);
    // By size, then by species: one path each.
    std::map<std::pair<std::size_t, std::uint32_t>, std::string> paths;
    for (const TreeRow* tree : chosen.trees) {
        const auto size = static_cast<std::size_t>(
            std::upper_bound(limits_cm.begin(), limits_cm.end(), tree->dbh_cm) - limits_cm.begin());
        paths[{size, tree->species}] +=
            joined("M", place(x_of(tree->x_m)), " ", place(y_of(tree->y_m)), "h0");
    }
    std::string svg;
    for (const auto& [key, path] : paths) {
        svg += element("path", {{"class", joined(fill_of_species(key.second), "-line")},
                                {"stroke-width", scale * (0.7 + 0.5 * static_cast<double>(key.first))},
                                {"d", path}});
    }
    const std::string outline =
        element("rect", {{"class", "window"},
                         {"x", x_of(window.x_west_m)},
                         {"y", y_of(window.y_north_m())},
                         {"width", (window.x_east_m() - window.x_west_m) * per_m_},
                         {"height", (window.y_north_m() - window.y_south_m) * per_m_}});
    return {sheet(report::page_text("trees seen from above"),
                  joined(element("g", {{"class", "points"}}, svg), outline)),
            one_in_text(chosen)};
}

}  // namespace coupling::decades
