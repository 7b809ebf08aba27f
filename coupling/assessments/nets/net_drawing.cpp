#include "coupling/assessments/nets/net_drawing.hpp"

#include <algorithm>
#include <array>

#include "config/text/joined.hpp"
#include "config/units/constants.hpp"
#include "coupling/assessments/nets/figures/net_figures.hpp"
#include "coupling/results/figures/colours.hpp"
#include "coupling/results/report/chart.hpp"
#include "coupling/results/report/map/energy_classes.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::report {
namespace {

using config::j_per_kj;
using config::joined;

constexpr double left = 52.0;
constexpr double right = 888.0;
constexpr double top = 14.0;
constexpr double bottom = 236.0;
/// By energy class: as many as there are colours.
constexpr std::array<double, energy_class_colours.size()> radii{2.2, 2.8, 3.4, 4.0, 4.6, 5.2};
static_assert(radii.back() > 0.0);

/// Held: disc. Over: triangle that points up. Below: triangle that points down. Broke: cross.
std::string shape_of(rockfall::NetOutcome outcome, std::size_t energy_class, double x, double y) {
    const double r = radii[energy_class];
    const std::string colour = to_hex(energy_class_colours[energy_class]);
    const std::string filled = joined(" fill=\"", colour, "\" class=\"edge\" stroke-width=\"0.7\"/>");
    switch (outcome) {
        case rockfall::NetOutcome::held:
            return joined("<circle cx=\"", place(x), "\" cy=\"", place(y), "\" r=\"", place(r), "\"", filled);
        case rockfall::NetOutcome::over:
            return joined("<path d=\"M", place(x - r), " ", place(y + 0.8 * r), "h", place(2.0 * r), "L",
                          place(x), " ", place(y - 1.1 * r), "z\"", filled);
        case rockfall::NetOutcome::below:
            return joined("<path d=\"M", place(x - r), " ", place(y - 0.8 * r), "h", place(2.0 * r), "L",
                          place(x), " ", place(y + 1.1 * r), "z\"", filled);
        case rockfall::NetOutcome::broke:
            break;
    }
    const std::string cross =
        joined("M", place(x - r), " ", place(y - r), "L", place(x + r), " ", place(y + r), "M", place(x - r),
               " ", place(y + r), "L", place(x + r), " ", place(y - r));
    return joined("<path d=\"", cross, "\" fill=\"none\" class=\"edge\" stroke-width=\"3.4\"/><path d=\"",
                  cross, "\" fill=\"none\" stroke=\"", colour, "\" stroke-width=\"1.8\"/>");
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
        return bottom - up_.share_of(height_m) * (bottom - top);
    }
    [[nodiscard]] double highest_m() const { return up_.high; }
    [[nodiscard]] std::string axes() const {
        std::string grid;
        std::string labels;
        for (const double tick : up_.ticks()) {
            grid += joined("M", place(left), " ", place(y_of(tick)), "H", place(right));
            labels += joined("<text text-anchor=\"end\" x=\"", place(left - 6.0), "\" y=\"",
                             place(y_of(tick) + 4.0), "\">", tick_text(tick), "</text>");
        }
        std::string marks;
        for (const double tick : along_.ticks()) {
            marks += joined("M", place(x_of(tick)), " ", place(bottom), "v5");
            labels += joined("<text text-anchor=\"middle\" x=\"", place(x_of(tick)), "\" y=\"",
                             place(bottom + 19.0), "\">", tick_text(tick), "</text>");
        }
        return joined("<path class=\"grid\" d=\"", grid, "\"/><path class=\"axis\" d=\"M", place(left), " ",
                      place(bottom), "H", place(right), marks, "\"/>", labels,
                      "<text text-anchor=\"middle\" x=\"", place(0.5 * (left + right)), "\" y=\"",
                      place(bottom + 38.0), "\">", escaped(along_.title),
                      "</text><text text-anchor=\"middle\" transform=\"translate(14 ",
                      place(0.5 * (top + bottom)), ")rotate(-90)\">", escaped(up_.title), "</text>");
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

std::string developed_view(const NetRecord& net, const std::vector<const NetRow*>& drawn, double highest_m,
                           const std::string& title, const std::string& caption) {
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
    const std::string outline =
        joined("<rect x=\"", place(left), "\" y=\"", place(upper), "\" width=\"", place(right - left),
               "\" height=\"", place(lower - upper),
               "\" fill=\"#2458ad\" fill-opacity=\"0.13\" stroke=\"#2458ad\" stroke-width=\"1.6\"/>");
    return joined(
        "<figure class=\"chart net-view\"><figcaption><b>", escaped(title),
        "</b></figcaption><svg viewBox=\"0 0 900 280\" role=\"img\" aria-label=\"", escaped(title), "\">",
        view.axes(), outline, shapes, "</svg><p>",
        join_sentences(
            {caption, above > 0 ? page_text("{above} of them higher than the drawing: at its upper edge.",
                                            {{"above", grouped(static_cast<std::uint64_t>(above))}})
                                : ""}),
        "</p></figure>\n");
}

std::string developed_view_legend() {
    std::string items;
    const auto add = [&](const std::string& sample, const std::string& name) {
        items += joined("<li><svg viewBox=\"0 0 30 14\" aria-hidden=\"true\">", sample, "</svg>",
                        escaped(name), "</li>");
    };
    constexpr std::array<const char*, rockfall::net_outcomes> words{"held", "over the net", "below it",
                                                                    "broke through"};
    for (std::size_t i = 0; i < words.size(); ++i) {
        add(shape_of(static_cast<rockfall::NetOutcome>(i), 1, 15.0, 7.0), page_text(words[i]));
    }
    for (std::size_t i = 0; i < energy_class_colours.size(); ++i) {
        add(shape_of(rockfall::NetOutcome::held, i, 15.0, 7.0), energy_class_name(i));
    }
    add("<rect x=\"2\" y=\"2\" width=\"26\" height=\"10\" fill=\"#2458ad\" fill-opacity=\"0.13\" "
        "stroke=\"#2458ad\" stroke-width=\"1.6\"/>",
        page_text("the net"));
    return joined("<ul class=\"names\">", items, "</ul>");
}

}  // namespace coupling::report
