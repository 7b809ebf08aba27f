#include <algorithm>
#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/assessments/decades/report/page_parts.hpp"
#include "coupling/assessments/decades/report/stand_drawing.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::decades {
namespace {

using config::joined;
using report::element;
using report::place;
using report::svg_path;
using report::svg_text;

constexpr double left_edge = 84.0;
constexpr double widest_strip = 322.0;
/// Beside the strip, for crowns that reach over its ends.
constexpr double beside_strip = 24.0;
constexpr double highest_strip = 420.0;
constexpr double top = 20.0;
constexpr double below_strip = 44.0;
constexpr double ground_step_m = 2.0;
constexpr std::size_t most_trees = 500;

struct Frame {
    double low_m;
    double high_m;
    double per_m;

    [[nodiscard]] double x_of(double distance_m) const { return left_edge + per_m * distance_m; }
    [[nodiscard]] double y_of(double height_m) const { return top + per_m * (high_m - height_m); }
};

std::vector<double> ticks_between(double low, double high, double step) {
    std::vector<double> ticks;
    for (double tick = std::ceil(low / step - 1e-9) * step + 0.0; tick <= high + 1e-9 * step; tick += step) {
        ticks.push_back(tick);
    }
    return ticks;
}

std::string axes_of(const Frame& frame, const Transect& strip) {
    const double right = frame.x_of(strip.length_m);
    const double bottom = frame.y_of(frame.low_m);
    const double least_step_m = 30.0 / frame.per_m;
    const report::Attributes centred{{"text-anchor", "middle"}};
    std::string grid;
    std::string strokes;
    std::string labels;
    for (const double tick : ticks_between(frame.low_m, frame.high_m, report::nice_step(least_step_m))) {
        grid += joined("M", place(left_edge - beside_strip + 4.0), " ", place(frame.y_of(tick)), "H",
                       place(right + beside_strip));
        labels += svg_text(left_edge - beside_strip, frame.y_of(tick) + 4.5, report::fixed(tick, 0),
                           {{"text-anchor", "end"}});
    }
    for (const double tick : ticks_between(0.0, strip.length_m, report::nice_step(least_step_m))) {
        strokes += joined("M", place(frame.x_of(tick)), " ", place(bottom), "v5");
        labels += svg_text(frame.x_of(tick), bottom + 18.0, report::fixed(tick, 0), centred);
    }
    const auto end = [](double x, const char* letter) {
        return svg_text(x, 14.0, letter, {{"class", "letter"}, {"text-anchor", "middle"}});
    };
    const std::string beside = joined("translate(12 ", place(0.5 * (top + bottom)), ")rotate(-90)");
    return joined(
        svg_path("grid", grid),
        svg_path("axis", joined("M", place(left_edge), " ", place(bottom), "H", place(right), strokes)),
        labels, end(left_edge, "P"), end(right, "Q"),
        svg_text(0.5 * (left_edge + right), bottom + 38.0, report::page_text("Distance in plan, m"), centred),
        svg_text(0.0, 0.0, report::page_text("Height above sea level, m"),
                 {{"text-anchor", "middle"}, {"transform", beside}}));
}

double ground_m(const ForestGround& ground, const Transect& strip, double distance_m) {
    return ground.height_m(strip.x_at(distance_m), strip.y_at(distance_m));
}

std::string ground_of(const Frame& frame, const ForestGround& ground, const Transect& strip) {
    std::string path = joined("M", place(left_edge), " ", place(frame.y_of(frame.low_m)));
    const auto steps = static_cast<int>(std::ceil(strip.length_m / ground_step_m));
    for (int i = 0; i <= steps; ++i) {
        const double distance_m = strip.length_m * i / std::max(steps, 1);
        path += joined("L", place(frame.x_of(distance_m)), " ",
                       place(frame.y_of(ground_m(ground, strip, distance_m))));
    }
    return svg_path("forest-ground", joined(path, "L", place(frame.x_of(strip.length_m)), " ",
                                            place(frame.y_of(frame.low_m)), "z"));
}

std::string crown_of(const std::string& fill, bool pointed, double x, double radius, double y_base,
                     double y_top) {
    const std::string style = joined("crown ", fill);
    if (pointed) {
        return svg_path(style, joined("M", place(x - radius), " ", place(y_base), "L", place(x), " ",
                                      place(y_top), "L", place(x + radius), " ", place(y_base), "z"));
    }
    return element("ellipse", {{"class", style},
                               {"cx", x},
                               {"cy", 0.5 * (y_base + y_top)},
                               {"rx", radius},
                               {"ry", 0.5 * (y_base - y_top)}});
}

std::string silhouette(const TreeRow& tree, const forest::Species& species, const Frame& frame,
                       const ForestGround& ground, const Transect& strip) {
    const double distance_m = std::clamp(strip.distance_m(tree.x_m, tree.y_m), 0.0, strip.length_m);
    const double foot_m = ground_m(ground, strip, distance_m);
    const double x = frame.x_of(distance_m);
    const double foot = frame.y_of(foot_m);
    const double base = frame.y_of(foot_m + static_cast<double>(tree.crown_base_m));
    const double tip = frame.y_of(foot_m + static_cast<double>(tree.height_m));
    const double radius = std::max(0.4, static_cast<double>(tree.crown_radius_m) * frame.per_m);
    const double half_stem =
        std::max(0.2, 0.5 * stem_widening * static_cast<double>(tree.dbh_cm) / 100.0 * frame.per_m);
    // Up into the crown, so that no gap shows under a rounded one.
    const double stem_top = std::lerp(base, tip, 0.2);
    const std::string stem = joined("M", place(x - half_stem), " ", place(foot), "V", place(stem_top), "H",
                                    place(x + half_stem), "V", place(foot), "z");
    return joined(svg_path("stem", stem),
                  crown_of(fill_of_species(tree.species), species.conifer, x, radius, base, tip));
}

}  // namespace

DrawnTrees trees_in_strip(const DrawnTrees& trees, const Transect& strip) {
    DrawnTrees inside;
    std::copy_if(trees.begin(), trees.end(), std::back_inserter(inside), [&](const TreeRow* tree) {
        const double along_m = strip.distance_m(tree->x_m, tree->y_m);
        return along_m >= 0.0 && along_m <= strip.length_m &&
               std::abs(strip.offset_m(tree->x_m, tree->y_m)) <= 0.5 * strip_m;
    });
    // Seen from the right of one who looks down: what lies on the left is at the back.
    std::stable_sort(inside.begin(), inside.end(), [&](const TreeRow* a, const TreeRow* b) {
        return strip.offset_m(a->x_m, a->y_m) > strip.offset_m(b->x_m, b->y_m);
    });
    return inside;
}

double top_of(const DrawnTrees& in_strip, const ForestGround& ground, const Transect& strip) {
    double top_m = std::max(ground_m(ground, strip, 0.0), ground_m(ground, strip, strip.length_m));
    for (const TreeRow* tree : in_strip) {
        const double distance_m = strip.distance_m(tree->x_m, tree->y_m);
        top_m = std::max(top_m, ground_m(ground, strip, distance_m) + static_cast<double>(tree->height_m));
    }
    return top_m;
}

Drawing side_view(const DrawnTrees& in_strip, const forest::SpeciesTable& species, const ForestGround& ground,
                  const Transect& strip, double top_m) {
    double low_m = INFINITY;
    for (double distance_m = 0.0; distance_m <= strip.length_m; distance_m += ground_step_m) {
        low_m = std::min(low_m, ground_m(ground, strip, distance_m));
    }
    low_m -= 3.0;
    const double high_m = std::max(top_of(in_strip, ground, strip), top_m) + 1.0;
    const Frame frame{
        low_m, high_m,
        std::min(widest_strip / std::max(strip.length_m, 1.0), highest_strip / (high_m - low_m))};
    DrawnTrees drawn = in_strip;
    std::string left_out;
    if (drawn.size() > most_trees) {
        std::vector<float> heights;
        for (const TreeRow* tree : drawn) {
            heights.push_back(tree->height_m);
        }
        const auto limit = heights.end() - static_cast<std::ptrdiff_t>(most_trees);
        std::nth_element(heights.begin(), limit, heights.end());
        std::erase_if(drawn, [least = *limit](const TreeRow* tree) { return tree->height_m < least; });
        left_out = report::page_text("Left out: {in_strip_drawn} trees below {limit} m.",
                                     {{"in_strip_drawn", report::grouped(in_strip.size() - drawn.size())},
                                      {"limit", report::three_digits(static_cast<double>(*limit))}});
    }
    std::string trees;
    for (const TreeRow* tree : drawn) {
        trees += silhouette(*tree, species.all()[tree->species], frame, ground, strip);
    }
    const double drawn_width = frame.x_of(strip.length_m) + beside_strip;
    const double x = 0.5 * (drawn_width - (left_edge + widest_strip + beside_strip));
    const std::string box = joined(place(x), " 0 ", place(left_edge + widest_strip + beside_strip), " ",
                                   place(frame.y_of(low_m) + below_strip));
    return {element("svg",
                    {{"viewBox", box},
                     {"role", "img"},
                     {"aria-label", report::page_text("trees seen from the side")}},
                    joined(axes_of(frame, strip), ground_of(frame, ground, strip), trees)),
            left_out};
}

}  // namespace coupling::decades
