#include "coupling/assessments/nets/net_drawing.hpp"

#include <algorithm>
#include <array>

#include "config/text/joined.hpp"
#include "config/units/constants.hpp"
#include "coupling/assessments/nets/figures/net_figures.hpp"
#include "coupling/assessments/nets/figures/net_quantiles.hpp"
#include "coupling/results/figures/colours.hpp"
#include "coupling/results/report/chart.hpp"
#include "coupling/results/report/map/energy_classes.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::report {
namespace {

using config::j_per_kj;
using config::joined;

constexpr double left = 52.0;
constexpr double right = 888.0;
constexpr double drawing_top = 14.0;
constexpr double drawing_bottom = 236.0;
/// By energy class: as many as there are colours.
constexpr std::array<double, energy_class_colours.size()> radii{2.2, 2.8, 3.4, 4.0, 4.6, 5.2};
static_assert(radii.back() > 0.0);

/// Held: disc. Over: triangle that points up. Below: triangle that points down. Broke: cross.
std::string shape_of(rockfall::NetOutcome outcome, std::size_t energy_class, double x, double y) {
    const double r = radii[energy_class];
    const std::string colour = to_hex(energy_class_colours[energy_class]);
    const auto filled = [&](std::string_view name, Attributes shape) {
        shape.insert(shape.end(), {{"fill", colour}, {"class", "edge"}, {"stroke-width", "0.7"}});
        return element(name, shape);
    };
    const auto triangle = [&](double up) {
        return filled("path",
                      {{"d", joined("M", place(x - r), " ", place(y + up * 0.8 * r), "h", place(2.0 * r), "L",
                                    place(x), " ", place(y - up * 1.1 * r), "z")}});
    };
    switch (outcome) {
        case rockfall::NetOutcome::held:
            return filled("circle", {{"cx", x}, {"cy", y}, {"r", r}});
        case rockfall::NetOutcome::over:
            return triangle(1.0);
        case rockfall::NetOutcome::below:
            return triangle(-1.0);
        case rockfall::NetOutcome::broke:
            break;
    }
    const std::string cross =
        joined("M", place(x - r), " ", place(y - r), "L", place(x + r), " ", place(y + r), "M", place(x - r),
               " ", place(y + r), "L", place(x + r), " ", place(y - r));
    return joined(
        element("path", {{"d", cross}, {"fill", "none"}, {"class", "edge"}, {"stroke-width", "3.4"}}),
        element("path", {{"d", cross}, {"fill", "none"}, {"stroke", colour}, {"stroke-width", "1.8"}}));
}

/// The net itself, seen from the side.
std::string net_between(double x, double y, double width, double height) {
    return element("rect", {{"x", x},
                            {"y", y},
                            {"width", width},
                            {"height", height},
                            {"fill", "#2458ad"},
                            {"fill-opacity", "0.13"},
                            {"stroke", "#2458ad"},
                            {"stroke-width", "1.6"}});
}

/// A drawing of the section: axes in metres, both from 0.
class View {
public:
    View(double length_m, double highest_m)
        : along_{Axis::from_zero(page_text("Along the net, m"), length_m)},
          up_{Axis::from_zero(page_text("Above the ground, m"), highest_m)} {
        along_.high = length_m;
    }
    [[nodiscard]] double x_of(double along_m) const {
        return left + along_.share_of(along_m) * (right - left);
    }
    [[nodiscard]] double y_of(double height_m) const {
        return drawing_bottom - up_.share_of(height_m) * (drawing_bottom - drawing_top);
    }
    [[nodiscard]] double highest_m() const { return up_.high; }
    [[nodiscard]] std::string axes() const {
        std::string grid;
        std::string axis = joined("M", place(left), " ", place(drawing_bottom), "H", place(right));
        std::string labels;
        for (const double tick : up_.ticks()) {
            grid += joined("M", place(left), " ", place(y_of(tick)), "H", place(right));
            labels += svg_text(left - 6.0, y_of(tick) + 4.0, tick_text(tick),
                               {{"class", "axis-number"}, {"text-anchor", "end"}});
        }
        for (const double tick : along_.ticks()) {
            axis += joined("M", place(x_of(tick)), " ", place(drawing_bottom), "v5");
            labels += svg_text(x_of(tick), drawing_bottom + 19.0, tick_text(tick),
                               {{"class", "axis-number"}, {"text-anchor", "middle"}});
        }
        const std::string upwards =
            joined("translate(14 ", place(0.5 * (drawing_top + drawing_bottom)), ")rotate(-90)");
        return joined(svg_path("grid", grid), svg_path("axis", axis), labels,
                      svg_text(0.5 * (left + right), drawing_bottom + 38.0, along_.title,
                               {{"class", "axis-title"}, {"text-anchor", "middle"}}),
                      svg_text(0.0, 0.0, up_.title,
                               {{"class", "axis-title"}, {"text-anchor", "middle"}, {"transform", upwards}}));
    }

private:
    Axis along_;
    Axis up_;
};

}  // namespace

std::size_t drawn_rocks(std::size_t rocks, std::size_t most_rocks) {
    return most_rocks <= most_drawn_rocks ? rocks : (rocks * most_drawn_rocks + most_rocks / 2) / most_rocks;
}

std::vector<const NetRow*> evenly_spaced(const std::vector<const NetRow*>& rows, std::size_t wanted) {
    std::vector<const NetRow*> chosen;
    for (std::size_t i = 0; i < wanted; ++i) {
        chosen.push_back(rows[i * rows.size() / wanted]);
    }
    return chosen;
}

double drawn_height_m(const rockfall::Net& net, const std::vector<const NetRow*>& rows) {
    std::vector<double> heights_m;
    for (const NetRow* row : rows) {
        heights_m.push_back(static_cast<double>(row->crossing.height_m));
    }
    std::sort(heights_m.begin(), heights_m.end());
    constexpr double above_net = 1.25;
    constexpr double most_nets = 3.0;
    const double least_m = above_net * net.height_m;
    if (heights_m.empty()) {
        return least_m;
    }
    const double most_m = std::max(most_nets * net.height_m, quantile_of(heights_m, 0.99).value);
    return std::max(least_m, std::min(heights_m.back(), most_m));
}

DevelopedView developed_view(const NetRecord& net, const std::vector<const NetRow*>& drawn, double highest_m,
                             const std::string& label) {
    const View view{length_m(net.net), highest_m};
    const auto above = std::count_if(drawn.begin(), drawn.end(), [&](const NetRow* row) {
        return static_cast<double>(row->crossing.height_m) > view.highest_m();
    });
    std::string shapes;
    for (const NetRow* row : drawn) {
        const rockfall::NetCrossingRecord& crossing = row->crossing;
        shapes += shape_of(crossing.outcome, energy_class(static_cast<double>(crossing.energy_j) / j_per_kj),
                           view.x_of(static_cast<double>(crossing.along_m)),
                           view.y_of(std::min(static_cast<double>(crossing.height_m), view.highest_m())));
    }
    const double upper = view.y_of(net.net.height_m);
    const double lower = view.y_of(net.net.gap_m);
    return {svg_drawing(900.0, 280.0, label,
                        joined(view.axes(), net_between(left, upper, right - left, lower - upper), shapes)),
            static_cast<std::size_t>(above)};
}

std::string developed_view_legend() {
    std::string items;
    const auto add = [&](const std::string& sample, const std::string& name) {
        items += legend_item(sample, escaped(name));
    };
    constexpr std::array<const char*, rockfall::net_outcomes> words{"held", "over the net", "below it",
                                                                    "broke through"};
    for (std::size_t i = 0; i < words.size(); ++i) {
        add(shape_of(static_cast<rockfall::NetOutcome>(i), 1, 15.0, 7.0), page_text(words[i]));
    }
    for (std::size_t i = 0; i < energy_class_colours.size(); ++i) {
        add(shape_of(rockfall::NetOutcome::held, i, 15.0, 7.0), energy_class_name(i));
    }
    add(net_between(2.0, 2.0, 26.0, 10.0), page_text("the net"));
    return items;
}

}  // namespace coupling::report
