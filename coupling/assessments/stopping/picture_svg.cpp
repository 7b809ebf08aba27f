#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "config/text/joined.hpp"
#include "coupling/assessments/stopping/pictures.hpp"
#include "coupling/assessments/stopping/plain_number.hpp"
#include "coupling/results/figures/colours.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/markup.hpp"

namespace coupling {

namespace {

using config::joined;
using report::Attributes;
using report::element;
using report::fixed;
using report::place;
using report::svg_text;
using rockfall::Block;

constexpr double map_px = 720.0;
constexpr double left_px = 20.0;
constexpr double top_px = 64.0;
constexpr double cut_gap_px = 48.0;  ///< between the map and the ground of the cut's strip
constexpr double legend_px = left_px + map_px + 24.0;
constexpr double width_px = legend_px + 130.0;
constexpr double compared_rock_m = 0.95;
constexpr double cut_width_m = 1.0;  ///< blocks with centres within half of this of the line are in the cut

using Text = std::string_view;

std::string painted(Text name, Attributes shape, Text fill, Text stroke, Text width) {
    shape.insert(shape.end(), {{"fill", fill}, {"stroke", stroke}, {"stroke-width", width}});
    return element(name, shape);
}

std::string line(double x1, double y1, double x2, double y2, Text stroke, Text width, Text dashes = "") {
    return painted("line", {{"x1", x1}, {"y1", y1}, {"x2", x2}, {"y2", y2}, {"stroke-dasharray", dashes}}, "",
                   stroke, width);
}

std::string circle(double x, double y, double radius, Text fill, Text stroke = "", Text width = "") {
    return painted("circle",
                   {{"cx", plain_number(x, 2)}, {"cy", plain_number(y, 2)}, {"r", plain_number(radius, 2)}},
                   fill, stroke, width);
}

std::string box(double x, double y, double side, double height, Text fill = "", Text stroke = "",
                Text width = "") {
    return painted("rect", {{"x", x}, {"y", y}, {"width", side}, {"height", height}}, fill, stroke, width);
}

/// Shapes with thin outlines, of which only what lies in the box is seen.
std::string clipped(std::string_view id, const std::string& to, const std::string& shapes) {
    return joined(
        element("defs", {}, element("clipPath", {{"id", id}}, to)),
        element("g", {{"clip-path", joined("url(#", id, ")")}, {"stroke", "#333"}, {"stroke-width", "0.5"}},
                shapes));
}

/// Draws one surface.
class Picture {
public:
    explicit Picture(const rockfall::BlockCover& cover)
        : side_m_{shown_side_m(cover)},
          blocks_{shown_blocks(cover)},
          px_per_m_{map_px / side_m_},
          highest_m_{std::max(cover.highest_m(), 0.05)} {}

    [[nodiscard]] std::string svg(const std::string& title, const std::string& description) const {
        const double cut_px = (highest_m_ + compared_rock_m) * px_per_m_;
        const double ground_px = top_px + map_px + cut_gap_px + cut_px;
        const double height_px = ground_px + 60.0;
        return element("svg",
                       {{"xmlns", "http://www.w3.org/2000/svg"},
                        {"viewBox", joined("0 0 ", place(width_px), " ", place(height_px))},
                        {"width", width_px},
                        {"height", height_px},
                        {"font-family", "sans-serif"},
                        {"font-size", "13"},
                        {"fill", "#222"}},
                       joined(box(0.0, 0.0, width_px, height_px, "#fff"),
                              svg_text(left_px, 26.0, title, {{"font-size", "18"}, {"font-weight", "bold"}}),
                              svg_text(left_px, 48.0, description), map(), cut(ground_px), legend()));
    }

private:
    [[nodiscard]] std::string fill_of(double height_m) const {
        // The palest end is left to the ground.
        const double shade = 0.2 + 0.8 * std::min(1.0, height_m / highest_m_);
        return to_hex(colour_at(Palette::deposits, shade));
    }
    [[nodiscard]] double y_px(double y_m) const { return top_px + map_px - y_m * px_per_m_; }
    [[nodiscard]] double x_px(double x_m) const { return left_px + x_m * px_per_m_; }
    [[nodiscard]] std::string block_at(double y_px, const Block& block) const {
        return circle(x_px(block.x_m), y_px, block.radius_m * px_per_m_, fill_of(block.top_m()));
    }

    [[nodiscard]] std::string map() const {
        std::string shapes = box(left_px, top_px, map_px, map_px, "#f4f4ef", "none");
        for (const Block& block : blocks_) {
            shapes += block_at(y_px(block.y_m), block);
        }
        const double middle_px = y_px(0.5 * side_m_);
        return joined(clipped("patch", box(left_px, top_px, map_px, map_px), shapes),
                      line(left_px, middle_px, left_px + map_px, middle_px, "#0072b2", "1", "6 4"));
    }

    /// Blocks along the middle of the map, seen from the south, with a rock beside them.
    [[nodiscard]] std::string cut(double ground_px) const {
        std::string shapes;
        for (const Block& block : blocks_) {
            if (std::abs(block.y_m - 0.5 * side_m_) < 0.5 * cut_width_m) {
                shapes += block_at(ground_px - block.z_m * px_per_m_, block);
            }
        }
        return joined(svg_text(left_px, top_px + map_px + 20.0,
                               joined("cut along the dashed line: blocks within ",
                                      fixed(0.5 * cut_width_m, 1), " m of it")),
                      clipped("cut", box(left_px, 0.0, map_px, ground_px), shapes),
                      line(left_px, ground_px, left_px + map_px, ground_px, "#333", "1.5"),
                      scale_bar(ground_px + 26.0));
    }

    [[nodiscard]] std::string scale_bar(double y_px) const {
        const double length_m = std::floor(side_m_ / 5.0) >= 4.0 ? 5.0 : 1.0;
        const double end_px = x_px(length_m);
        std::string bar = line(left_px, y_px, end_px, y_px, "#222", "3");
        for (double m = 0.0; m <= length_m; m += 1.0) {
            bar += line(x_px(m), y_px - 5.0, x_px(m), y_px + 5.0, "#222", "1");
        }
        return joined(bar, svg_text(end_px + 8.0, y_px + 5.0, joined(fixed(length_m, 0), " m")));
    }

    [[nodiscard]] std::string legend() const {
        std::string shapes = joined(svg_text(legend_px, top_px + 12.0, "block height"),
                                    svg_text(legend_px, top_px + 28.0, "above ground, m"));
        constexpr int steps = 5;
        for (int i = 0; i < steps; ++i) {
            const double height_m = highest_m_ * (steps - i) / steps;
            const double y = top_px + 40.0 + 22.0 * i;
            shapes += box(legend_px, y, 22.0, 22.0, fill_of(height_m), "#333", "0.5");
            shapes += svg_text(legend_px + 30.0, y + 16.0, fixed(height_m, 2));
        }
        const double radius_px = 0.5 * compared_rock_m * px_per_m_;
        const double y = top_px + 190.0;
        return joined(
            shapes, circle(legend_px + radius_px, y + radius_px, radius_px, "none", "#d55e00", "2"),
            svg_text(legend_px, y + 2.0 * radius_px + 20.0, "a rock of"),
            svg_text(legend_px, y + 2.0 * radius_px + 36.0, joined(fixed(compared_rock_m, 2), " m")));
    }

    double side_m_;
    std::vector<Block> blocks_;
    double px_per_m_;
    double highest_m_;
};

}  // namespace

double shown_side_m(const rockfall::BlockCover& cover) {
    return std::min(cover.side_m(), rockfall::default_patch_m);
}

std::vector<Block> shown_blocks(const rockfall::BlockCover& cover) {
    const double shown_m = shown_side_m(cover);
    std::vector<Block> shown;
    for (const Block& block : cover.blocks()) {
        const auto reaches_in = [&](double x_m) {
            return x_m > -block.radius_m && x_m < shown_m + block.radius_m;
        };
        for (const double dx_m : {-cover.side_m(), 0.0, cover.side_m()}) {
            for (const double dy_m : {-cover.side_m(), 0.0, cover.side_m()}) {
                if (reaches_in(block.x_m + dx_m) && reaches_in(block.y_m + dy_m)) {
                    shown.push_back({block.x_m + dx_m, block.y_m + dy_m, block.z_m, block.radius_m});
                }
            }
        }
    }
    std::stable_sort(shown.begin(), shown.end(),
                     [](const Block& a, const Block& b) { return a.top_m() < b.top_m(); });
    return shown;
}

void write_surface_svg(const rockfall::BlockCover& cover, const std::string& title,
                       const std::string& description, std::ostream& out) {
    out << Picture{cover}.svg(title, description) << '\n';
}

}  // namespace coupling
