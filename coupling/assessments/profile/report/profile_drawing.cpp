#include <algorithm>
#include <array>
#include <cmath>

#include "config/text/joined.hpp"
#include "config/units/constants.hpp"
#include "coupling/assessments/profile/report/profile_page.hpp"
#include "coupling/results/figures/colours.hpp"
#include "coupling/results/report/chart.hpp"
#include "coupling/results/report/map/energy_classes.hpp"
#include "coupling/results/report/map/outlines.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/phrases.hpp"
#include "rockfall/motion/models.hpp"

namespace coupling::profile {
namespace {

using config::j_per_kj;
using config::joined;

using report::Axis;
using report::element;
using report::escaped;
using report::place;
using report::svg_path;
using report::svg_text;

constexpr double left_edge = 70.0;
constexpr double top = 64.0;  // room for the names over the upper end
constexpr double widest_sheet = 1010.0;
constexpr double highest_px = 600.0;
constexpr double below = 46.0;
constexpr std::size_t ground_colours = 8;
constexpr std::size_t most_drawn_paths = 100;

/// The slope on paper: one scale for distance and height.
struct Sheet {
    Axis distance;
    Axis height;
    double per_m = 1.0;

    explicit Sheet(const ProfileResults& results)
        : distance{report::page_text("Distance in plan, m"), results.site.first_m(), results.site.last_m()},
          height{report::page_text("Height, m"), results.site.corners.front().height_m,
                 results.site.corners.front().height_m} {
        for (const rockfall::ProfilePoint& corner : results.site.corners) {
            include(corner.height_m);
        }
        for (const SampledPath& path : results.tally.paths) {
            for (const rockfall::PathPoint& point : path.points) {
                include(point.position_m.z());
            }
        }
        const double step = report::nice_step((height.high - height.low + 1.0) / 6.0);
        height.low = std::floor(height.low / step) * step;
        height.high = std::max(height.low + step, std::ceil(height.high / step - 1e-9) * step);
        per_m =
            std::min(widest_sheet / (distance.high - distance.low), highest_px / (height.high - height.low));
    }
    void include(double height_m) {
        height.low = std::min(height.low, height_m);
        height.high = std::max(height.high, height_m);
    }
    [[nodiscard]] double x_of(double distance_m) const {
        return left_edge + per_m * (distance_m - distance.low);
    }
    [[nodiscard]] double distance_at(double x) const { return distance.low + (x - left_edge) / per_m; }
    [[nodiscard]] double y_of(double height_m) const { return top + per_m * (height.high - height_m); }
    [[nodiscard]] double right() const { return x_of(distance.high); }
    [[nodiscard]] double bottom() const { return y_of(height.low); }
};

/// Ticks no nearer to each other on paper than their texts are wide.
std::vector<double> ticks_of(const Axis& axis, double per_m, double text_width) {
    const double step = report::nice_step(std::max((axis.high - axis.low) / 12.0, text_width / per_m));
    std::vector<double> ticks;
    for (int i = 0; std::ceil(axis.low / step - 1e-9) * step + i * step <= axis.high + 1e-9 * step; ++i) {
        ticks.push_back(std::ceil(axis.low / step - 1e-9) * step + i * step);
    }
    return ticks;
}

std::string axes_of(const Sheet& sheet) {
    std::string grid;
    std::string axis = joined("M", place(left_edge), " ", place(sheet.bottom()), "H", place(sheet.right()));
    std::string labels;
    for (const double tick : ticks_of(sheet.distance, sheet.per_m, 50.0)) {
        axis += joined("M", place(sheet.x_of(tick)), " ", place(sheet.bottom()), "v5");
        labels += svg_text(sheet.x_of(tick), sheet.bottom() + 19.0, report::tick_text(tick),
                           {{"text-anchor", "middle"}});
    }
    for (const double tick : ticks_of(sheet.height, sheet.per_m, 24.0)) {
        grid += joined("M", place(left_edge), " ", place(sheet.y_of(tick)), "H", place(sheet.right()));
        labels += svg_text(left_edge - 6.0, sheet.y_of(tick) + 4.0, report::tick_text(tick),
                           {{"text-anchor", "end"}});
    }
    const std::string upwards = joined("translate(13 ", place(0.5 * (top + sheet.bottom())), ")rotate(-90)");
    return joined(
        svg_path("grid", grid), svg_path("axis", axis), labels,
        svg_text(0.5 * (left_edge + sheet.right()), sheet.bottom() + 38.0, sheet.distance.title,
                 {{"text-anchor", "middle"}}),
        svg_text(0.0, 0.0, sheet.height.title, {{"text-anchor", "middle"}, {"transform", upwards}}));
}

/// Ground types in the order in which a rock meets them.
std::vector<std::uint8_t> types_along(const ProfileSite& site) {
    std::vector<std::uint8_t> types;
    for (std::size_t k = 0; k + 1 < site.corners.size(); ++k) {
        if (std::find(types.begin(), types.end(), site.corners[k].surface) == types.end()) {
            types.push_back(site.corners[k].surface);
        }
    }
    return types;
}

std::string ground_style(std::size_t type) {
    return joined("type", std::to_string(type % ground_colours), " ground");
}

std::string path_style(std::size_t energy_class) {
    return joined("class", std::to_string(energy_class));
}

std::string ground_of(const ProfileResults& results, const Sheet& sheet,
                      const std::vector<std::uint8_t>& types) {
    const auto& corners = results.site.corners;
    std::string body = joined("M", place(sheet.x_of(corners.front().distance_m)), " ", place(sheet.bottom()));
    std::vector<report::PathText> lines(types.size());
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const double x = sheet.x_of(corners[k].distance_m);
        const double y = sheet.y_of(corners[k].height_m);
        body += joined("L", place(x), " ", place(y));
        if (k + 1 < corners.size()) {
            const auto type = std::find(types.begin(), types.end(), corners[k].surface) - types.begin();
            lines[static_cast<std::size_t>(type)].line(x, y, sheet.x_of(corners[k + 1].distance_m),
                                                       sheet.y_of(corners[k + 1].height_m));
        }
    }
    std::string surface;
    for (std::size_t i = 0; i < types.size(); ++i) {
        surface += svg_path(ground_style(i), lines[i].text());
    }
    return joined(svg_path("body", joined(body, "L", place(sheet.right()), " ", place(sheet.bottom()), "Z")),
                  // A little below the surface, or paths close to the ground would cover it.
                  element("g", {{"transform", "translate(0 3.5)"}}, surface));
}

std::size_t drawn_every(const ProfileResults& results) {
    return (results.tally.paths.size() + most_drawn_paths - 1) / most_drawn_paths;
}

std::string paths_of(const ProfileResults& results, const Sheet& sheet) {
    std::array<report::PathText, energy_class_colours.size()> by_class;
    for (std::size_t i = 0; i < results.tally.paths.size(); i += drawn_every(results)) {
        const auto& points = results.tally.paths[i].points;
        for (std::size_t k = 0; k + 1 < points.size(); ++k) {
            const float energy_j = std::max(points[k].energy_j, points[k + 1].energy_j);
            by_class[energy_class(static_cast<double>(energy_j) / j_per_kj)].line(
                sheet.x_of(points[k].position_m.x()), sheet.y_of(points[k].position_m.z()),
                sheet.x_of(points[k + 1].position_m.x()), sheet.y_of(points[k + 1].position_m.z()));
        }
    }
    std::string svg;
    for (std::size_t c = 0; c < by_class.size(); ++c) {
        if (const std::string text = by_class[c].text(); !text.empty()) {
            svg += svg_path(path_style(c), text);
        }
    }
    return element("g", {{"class", "paths"}}, svg);
}

/// Where a name stands: its left and right end and its base line.
struct NameBox {
    double from;
    double to;
    double base;
};

/// Lifts a base line until the name covers none of those before it.
double free_base(const std::vector<NameBox>& taken, NameBox box) {
    constexpr double line = 15.0;
    constexpr double gap = 7.0;
    const auto covers = [&](const NameBox& other) {
        return box.from < other.to + gap && other.from < box.to + gap &&
               std::abs(box.base - other.base) < line;
    };
    while (std::any_of(taken.begin(), taken.end(), covers) && box.base > line) {
        box.base -= 1.0;
    }
    return box.base;
}

/// A pole at each place with its name above; names that would touch stand one above the other.
std::string poles(const ProfileResults& results, const Sheet& sheet) {
    std::vector<Station> places = results.site.stations;
    places.insert(places.begin(), {"start", results.site.start_m});
    constexpr double letter = 7.5;
    constexpr double shortest_pole = 24.0;
    constexpr double pole_above_base = 9.0;
    std::string svg;
    std::vector<NameBox> taken;
    for (const Station& station : places) {
        const double x = sheet.x_of(station.distance_m);
        const double width = letter * static_cast<double>(station.name.size());
        const bool to_the_left = x + width > sheet.right();
        const double from = to_the_left ? x - width : x;
        const double ground = sheet.y_of(results.site.height_m(station.distance_m));
        // The name stands clear of the slope at both of its ends.
        const double far_end = sheet.distance_at(to_the_left ? from : from + width);
        const double highest_ground = std::min(ground, sheet.y_of(results.site.height_m(far_end)));
        const double base = free_base(taken, {from, from + width, highest_ground - shortest_pole});
        taken.push_back({from, from + width, base});
        svg +=
            svg_path("pole", joined("M", place(x), " ", place(ground), "V", place(base - pole_above_base)));
        svg += svg_text(x + (to_the_left ? -4.0 : 4.0), base, station.name,
                        {{"class", "pole"}, {"text-anchor", to_the_left ? "end" : "start"}});
    }
    return svg;
}

/// Items of a list.
std::string legend(const ProfileResults& results, const std::vector<std::uint8_t>& types) {
    std::string items;
    for (std::size_t i = 0; i < types.size(); ++i) {
        items +=
            report::legend_item(svg_path(ground_style(i), "M1 7h28"),
                                escaped(report::in_page_language(results.site.slope.types[types[i]].label)));
    }
    for (std::size_t c = 0; c < energy_class_colours.size() && !results.tally.paths.empty(); ++c) {
        items += report::legend_item(
            element("g", {{"class", "paths"}}, svg_path(path_style(c), "M1 11Q15 -4 29 11")),
            report::energy_class_name(c));
    }
    return items;
}

}  // namespace

report::PageFields drawing(const ProfileResults& results) {
    const Sheet sheet{results};
    const std::vector<std::uint8_t> types = types_along(results.site);
    const std::size_t paths = results.tally.paths.size();
    std::optional<report::PageFields> drawn;
    if (paths > 0) {
        const std::size_t every = drawn_every(results);
        drawn = {{"drawn", report::grouped((paths + every - 1) / every)}};
    }
    return {{"legend", legend(results, types)},
            // One unit is one pixel at most, so that letters stay those of the page.
            {"width", place(std::max(sheet.right(), 420.0) + 20.0)},
            {"drawing_height", place(sheet.bottom() + below)},
            {"drawing", joined(axes_of(sheet), ground_of(results, sheet, types), paths_of(results, sheet),
                               poles(results, sheet))},
            {"paths", drawn}};
}

}  // namespace coupling::profile
