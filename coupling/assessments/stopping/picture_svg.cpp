#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "coupling/assessments/stopping/pictures.hpp"
#include "coupling/assessments/stopping/plain_number.hpp"
#include "coupling/results/figures/colours.hpp"
#include "coupling/results/text/markup.hpp"

namespace coupling {

namespace {

using report::escaped;
using report::fixed;
using report::place;
using rockfall::Block;

constexpr double map_px = 720.0;
constexpr double left_px = 20.0;
constexpr double top_px = 64.0;
constexpr double cut_gap_px = 48.0;  ///< between the map and the ground of the cut's strip
constexpr double legend_px = left_px + map_px + 24.0;
constexpr double width_px = legend_px + 130.0;
constexpr double compared_rock_m = 0.95;
constexpr double cut_width_m = 1.0;  ///< blocks with centres within half of this of the line are in the cut

/// Draws one surface.
class Picture {
public:
    Picture(const rockfall::BlockCover& cover, std::ostream& out)
        : out_{out},
          side_m_{shown_side_m(cover)},
          blocks_{shown_blocks(cover)},
          px_per_m_{map_px / side_m_},
          highest_m_{std::max(cover.highest_m(), 0.05)} {}

    void draw(const std::string& title, const std::string& description) {
        const double cut_px = (highest_m_ + compared_rock_m) * px_per_m_;
        const double ground_px = top_px + map_px + cut_gap_px + cut_px;
        const double height_px = ground_px + 60.0;
        out_ << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << place(width_px) << ' '
             << place(height_px) << "\" width=\"" << place(width_px) << "\" height=\"" << place(height_px)
             << "\" font-family=\"sans-serif\" font-size=\"13\" fill=\"#222\">\n<rect width=\"100%\" "
                "height=\"100%\" "
                "fill=\"#fff\"/>\n";
        text(left_px, 26.0, title, "font-size=\"18\" font-weight=\"bold\"");
        text(left_px, 48.0, description, "");
        map();
        cut(ground_px);
        legend();
        out_ << "</svg>\n";
    }

private:
    void text(double x_px, double y_px, std::string_view words, std::string_view style) {
        out_ << "<text x=\"" << place(x_px) << "\" y=\"" << place(y_px) << "\" " << style << '>'
             << escaped(words) << "</text>\n";
    }
    void line(double x1_px, double y1_px, double x2_px, double y2_px, std::string_view style) {
        out_ << "<line x1=\"" << place(x1_px) << "\" y1=\"" << place(y1_px) << "\" x2=\"" << place(x2_px)
             << "\" y2=\"" << place(y2_px) << "\" " << style << "/>\n";
    }
    void circle(double x_px, double y_px, double radius_px, std::string_view style) {
        out_ << "<circle cx=\"" << plain_number(x_px, 2) << "\" cy=\"" << plain_number(y_px, 2) << "\" r=\""
             << plain_number(radius_px, 2) << "\" " << style << "/>\n";
    }
    [[nodiscard]] std::string fill_of(double height_m) const {
        // The palest end is left to the ground.
        const double shade = 0.2 + 0.8 * std::min(1.0, height_m / highest_m_);
        return "fill=\"" + to_hex(colour_at(Palette::deposits, shade)) + "\"";
    }
    [[nodiscard]] double y_px(double y_m) const { return top_px + map_px - y_m * px_per_m_; }
    [[nodiscard]] double x_px(double x_m) const { return left_px + x_m * px_per_m_; }

    void map() {
        out_ << "<defs><clipPath id=\"patch\"><rect x=\"" << place(left_px) << "\" y=\"" << place(top_px)
             << "\" width=\"" << place(map_px) << "\" height=\"" << place(map_px)
             << "\"/></clipPath></defs>\n<g clip-path=\"url(#patch)\" stroke=\"#333\" stroke-width=\"0.5\">\n"
             << "<rect x=\"" << place(left_px) << "\" y=\"" << place(top_px) << "\" width=\"" << place(map_px)
             << "\" height=\"" << place(map_px) << "\" fill=\"#f4f4ef\" stroke=\"none\"/>\n";
        for (const Block& block : blocks_) {
            circle(x_px(block.x_m), y_px(block.y_m), block.radius_m * px_per_m_, fill_of(block.top_m()));
        }
        out_ << "</g>\n";
        const double middle_px = y_px(0.5 * side_m_);
        line(left_px, middle_px, left_px + map_px, middle_px,
             "stroke=\"#0072b2\" stroke-width=\"1\" stroke-dasharray=\"6 4\"");
    }

    /// Blocks along the middle of the map, seen from the south, with a rock beside them.
    void cut(double ground_px) {
        text(left_px, top_px + map_px + 20.0,
             "cut along the dashed line: blocks within " + fixed(0.5 * cut_width_m, 1) + " m of it", "");
        out_ << "<g clip-path=\"url(#cut)\" stroke=\"#333\" stroke-width=\"0.5\">\n<defs><clipPath "
                "id=\"cut\"><rect x=\""
             << place(left_px) << "\" y=\"0\" width=\"" << place(map_px) << "\" height=\"" << place(ground_px)
             << "\"/></clipPath></defs>\n";
        for (const Block& block : blocks_) {
            if (std::abs(block.y_m - 0.5 * side_m_) < 0.5 * cut_width_m) {
                circle(x_px(block.x_m), ground_px - block.z_m * px_per_m_, block.radius_m * px_per_m_,
                       fill_of(block.top_m()));
            }
        }
        out_ << "</g>\n";
        line(left_px, ground_px, left_px + map_px, ground_px, "stroke=\"#333\" stroke-width=\"1.5\"");
        scale_bar(ground_px + 26.0);
    }

    void scale_bar(double y_px) {
        const double length_m = std::floor(side_m_ / 5.0) >= 4.0 ? 5.0 : 1.0;
        line(left_px, y_px, left_px + length_m * px_per_m_, y_px, "stroke=\"#222\" stroke-width=\"3\"");
        for (double m = 0.0; m <= length_m; m += 1.0) {
            line(x_px(m), y_px - 5.0, x_px(m), y_px + 5.0, "stroke=\"#222\" stroke-width=\"1\"");
        }
        text(left_px + length_m * px_per_m_ + 8.0, y_px + 5.0, fixed(length_m, 0) + " m", "");
    }

    void legend() {
        text(legend_px, top_px + 12.0, "block height", "");
        text(legend_px, top_px + 28.0, "above ground, m", "");
        constexpr int steps = 5;
        for (int i = 0; i < steps; ++i) {
            const double height_m = highest_m_ * (steps - i) / steps;
            const double y = top_px + 40.0 + 22.0 * i;
            out_ << "<rect x=\"" << place(legend_px) << "\" y=\"" << place(y)
                 << "\" width=\"22\" height=\"22\" stroke=\"#333\" stroke-width=\"0.5\" " << fill_of(height_m)
                 << "/>\n";
            text(legend_px + 30.0, y + 16.0, fixed(height_m, 2), "");
        }
        const double radius_px = 0.5 * compared_rock_m * px_per_m_;
        const double y = top_px + 190.0;
        circle(legend_px + radius_px, y + radius_px, radius_px,
               "fill=\"none\" stroke=\"#d55e00\" stroke-width=\"2\"");
        text(legend_px, y + 2.0 * radius_px + 20.0, "a rock of", "");
        text(legend_px, y + 2.0 * radius_px + 36.0, fixed(compared_rock_m, 2) + " m", "");
    }

    std::ostream& out_;
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
    Picture{cover, out}.draw(title, description);
}

}  // namespace coupling
