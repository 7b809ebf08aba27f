#include <algorithm>
#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/results/report/chart.hpp"
#include "coupling/results/report/map/outlines.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "validation/engine/case/profile.hpp"
#include "validation/engine/page/page_parts.hpp"

namespace coupling::validation {
namespace {

using config::joined;
using report::Axis;
using report::element;
using report::place;
using report::svg_path;
using report::svg_text;

constexpr double left = 64.0;
constexpr double top = 24.0;
constexpr double plot_width = 560.0;
constexpr double plot_height = 330.0;
constexpr double letter_height = 15.0;
constexpr double letter_width = 13.0;

/// The slope on paper: one scale for distance and height.
struct Sheet {
    Axis distance;
    Axis height;
    double per_m;

    explicit Sheet(const std::vector<ProfileCorner>& profile)
        : distance{Axis::from_zero(report::page_text("Distance in plan, m"), profile.back().distance_m)},
          height{report::page_text("Height, m"), profile.front().height_m, profile.front().height_m} {
        for (const ProfileCorner& corner : profile) {
            height.low = std::min(height.low, corner.height_m);
            height.high = std::max(height.high, corner.height_m);
        }
        const double step = report::nice_step((height.high - height.low + 1.0) / 6.0);
        height.low = std::floor(height.low / step) * step;
        height.high = std::max(height.low + step, std::ceil(height.high / step - 1e-9) * step);
        per_m =
            std::min(plot_width / (distance.high - distance.low), plot_height / (height.high - height.low));
    }
    [[nodiscard]] double x_of(double distance_m) const { return left + per_m * (distance_m - distance.low); }
    [[nodiscard]] double y_of(double height_m) const { return top + per_m * (height.high - height_m); }
    [[nodiscard]] double right() const { return x_of(distance.high); }
    [[nodiscard]] double bottom() const { return y_of(height.low); }
};

std::string axes_of(const Sheet& sheet) {
    std::string grid;
    std::string strokes;
    std::string labels;
    for (const double tick : sheet.distance.ticks()) {
        strokes += joined("M", place(sheet.x_of(tick)), " ", place(sheet.bottom()), "v5");
        labels += svg_text(sheet.x_of(tick), sheet.bottom() + 19.0, report::tick_text(tick),
                           {{"text-anchor", "middle"}});
    }
    for (const double tick : sheet.height.ticks()) {
        grid += joined("M", place(left), " ", place(sheet.y_of(tick)), "H", place(sheet.right()));
        labels +=
            svg_text(left - 6.0, sheet.y_of(tick) + 4.0, report::tick_text(tick), {{"text-anchor", "end"}});
    }
    const std::string upwards = joined("translate(13 ", place(0.5 * (top + sheet.bottom())), ")rotate(-90)");
    return joined(svg_path("grid", grid),
                  svg_path("axis", joined("M", place(left), " ", place(sheet.bottom()), "H",
                                          place(sheet.right()), strokes)),
                  labels,
                  svg_text(0.5 * (left + sheet.right()), sheet.bottom() + 38.0, sheet.distance.title,
                           {{"text-anchor", "middle"}}),
                  element("text", {{"text-anchor", "middle"}, {"transform", upwards}},
                          report::escaped(sheet.height.title)));
}

/// Ground types in the order in which a rock meets them; the letter of one is its place in the list.
std::vector<std::string> surfaces_of(const std::vector<ProfileCorner>& profile) {
    std::vector<std::string> surfaces;
    for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
        if (std::find(surfaces.begin(), surfaces.end(), profile[i].surface) == surfaces.end()) {
            surfaces.push_back(profile[i].surface);
        }
    }
    return surfaces;
}

std::string letter_of(const std::vector<std::string>& surfaces, const std::string& surface) {
    const auto place_in_list = std::find(surfaces.begin(), surfaces.end(), surface) - surfaces.begin();
    return {static_cast<char>('a' + place_in_list % 26)};
}

/// Letters above the middle of each stretch of one ground type; a narrow stretch has its letter higher up.
std::string letters(const CaseResult& result, const Sheet& sheet, const std::vector<std::string>& surfaces) {
    const std::vector<ProfileCorner>& profile = result.profile;
    std::string svg;
    std::string changes;
    double last_x = -1e9;
    int raised = 0;
    for (std::size_t first = 0; first + 1 < profile.size();) {
        std::size_t last = first + 1;
        while (last + 1 < profile.size() && profile[last].surface == profile[first].surface) {
            ++last;
        }
        const double from = sheet.x_of(profile[first].distance_m);
        const double middle_m = 0.5 * (profile[first].distance_m + profile[last].distance_m);
        const double middle = sheet.x_of(middle_m);
        changes += joined("M", place(from), " ", place(sheet.y_of(profile[first].height_m) - 5.0), "v10");
        raised = middle - last_x < letter_width ? raised + 1 : 0;
        last_x = middle;
        const double y = sheet.y_of(height_at(profile, middle_m)) - 12.0 - letter_height * raised;
        svg += svg_text(middle, y, letter_of(surfaces, profile[first].surface),
                        {{"class", "letter"}, {"text-anchor", "middle"}});
        first = last;
    }
    return joined(svg_path("change", changes), svg);
}

std::string list_of(const std::vector<std::string>& surfaces) {
    std::string items;
    for (const std::string& surface : surfaces) {
        std::string name = surface;
        std::replace(name.begin(), name.end(), '_', ' ');
        items += element("li", {},
                         joined(element("b", {}, letter_of(surfaces, surface)), " ", report::escaped(name)));
    }
    return element("ul", {{"class", "names"}}, items);
}

std::string section_marks(const CaseResult& result, const Sheet& sheet) {
    std::string svg;
    for (const SectionShare& section : result.sections) {
        const double from = sheet.x_of(section.from_m);
        const double to = sheet.x_of(section.to_m);
        const std::string y = place(sheet.bottom() - 6.0);
        svg += svg_path("change", joined("M", place(from), " ", y, "v-10v5H", place(to), "v-5v10"));
        svg +=
            svg_text(0.5 * (from + to), sheet.bottom() - 16.0, section.section, {{"text-anchor", "middle"}});
    }
    return svg;
}

}  // namespace

std::string profile_drawing(const CaseResult& result) {
    const std::vector<ProfileCorner>& profile = result.profile;
    if (profile.size() < 2 || profile.back().distance_m <= 0.0) {
        return "";
    }
    const Sheet sheet{profile};
    const std::vector<std::string> surfaces = surfaces_of(profile);
    report::PathText ground;
    for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
        ground.line(sheet.x_of(profile[i].distance_m), sheet.y_of(profile[i].height_m),
                    sheet.x_of(profile[i + 1].distance_m), sheet.y_of(profile[i + 1].height_m));
    }
    const std::string title = report::page_text("The slope at true scale");
    const std::string caption = element("figcaption", {}, element("b", {}, title));
    const std::string drawing =
        report::svg_drawing(left + plot_width + 30.0, sheet.bottom() + 48.0, title,
                            joined(axes_of(sheet), section_marks(result, sheet),
                                   svg_path("ground", ground.text()), letters(result, sheet, surfaces)));
    return joined(
        element("figure", {{"class", "chart profile"}}, joined(caption, list_of(surfaces), drawing)), "\n");
}

}  // namespace coupling::validation
