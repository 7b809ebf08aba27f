// The picture of the transitions in rockfall/motion/pir3d/README.md, drawn from the falls themselves. With
// BANNWALD_WRITE_PICTURES in the environment the test writes it anew.

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "tests/rockfall/motion/pir3d/bent_slopes.hpp"

namespace rockfall::pir3d::picture_test {
namespace {

using rockfall::pir3d::testing::Transition;
using rockfall::pir3d::testing::Way;

constexpr double panel_width = 300.0, panel_height = 190.0, shown_m = 24.0, first_x_m = 44.0;
constexpr double per_m = panel_width / shown_m;

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", value);
    return text;
}

/// One transition as a drawing in its panel: side view, the edge in the middle.
class Panel {
public:
    Panel(const Transition& transition, const Way& way, std::size_t place)
        : way_{way},
          left_{static_cast<double>(place % 2) * (panel_width + 20.0) + 10.0},
          top_{static_cast<double>(place / 2) * (panel_height + 20.0) + 10.0},
          middle_z_m_{ground_m(testing::edge_x_m)} {
        svg_ += "<g><clipPath id=\"p" + std::to_string(place) + "\"><rect x=\"" + number(left_) + "\" y=\"" +
                number(top_) + "\" width=\"" + number(panel_width) + "\" height=\"" + number(panel_height) +
                "\"/></clipPath><g clip-path=\"url(#p" + std::to_string(place) + ")\">\n";
        draw_ground();
        for (const auto& roll : way.log.rolls) {
            const RollingPiece& piece = roll.piece;
            if (piece.start_m.x() + way.slope.terrain.origin_m().x() > first_x_m + shown_m) {
                break;
            }
            line({piece.start_m, piece.position_m(piece.duration_s)}, "slide");
        }
        for (const auto& jump : way.log.jumps) {
            std::vector<Eigen::Vector3d> points;
            for (int i = 0; i <= 24; ++i) {
                points.push_back(jump.flight.position_m(jump.until_s * i / 24.0));
            }
            line(points, "flight");
        }
        for (const Eigen::Vector3d& impact : way.log.impacts) {
            svg_ += "<circle class=\"impact\" cx=\"" + x_of(impact) + "\" cy=\"" + y_of(impact) +
                    "\" r=\"4\"/>\n";
        }
        svg_ += "</g>\n<text x=\"" + number(left_ + 8.0) + "\" y=\"" + number(top_ + panel_height - 24.0) +
                "\"><tspan class=\"letter\">" + transition.letter + "</tspan></text>\n<text x=\"" +
                number(left_ + 8.0) + "\" y=\"" + number(top_ + panel_height - 8.0) + "\">" +
                transition.what + "</text></g>\n";
    }
    [[nodiscard]] const std::string& svg() const { return svg_; }

private:
    [[nodiscard]] double ground_m(double x_m) const {
        const Eigen::Vector2d origin = way_.slope.terrain.origin_m();
        return way_.slope.terrain.height_m(x_m - origin.x(), 30.0 - origin.y()).value();
    }
    [[nodiscard]] std::string x_of(const Eigen::Vector3d& p) const {
        return number(left_ + (p.x() + way_.slope.terrain.origin_m().x() - first_x_m) * per_m);
    }
    [[nodiscard]] std::string y_of(const Eigen::Vector3d& p) const {
        return number(top_ + 0.45 * panel_height - (p.z() - middle_z_m_) * per_m);
    }
    void line(const std::vector<Eigen::Vector3d>& points, const std::string& kind) {
        svg_ += "<polyline class=\"" + kind + "\" points=\"";
        for (const Eigen::Vector3d& p : points) {
            svg_ += x_of(p) + "," + y_of(p) + " ";
        }
        svg_ += "\"/>\n";
    }
    void draw_ground() {
        std::vector<Eigen::Vector3d> points;
        const double origin_x_m = way_.slope.terrain.origin_m().x();
        for (const double x_m : {first_x_m, testing::edge_x_m, first_x_m + shown_m}) {
            points.push_back({x_m - origin_x_m, 0.0, ground_m(x_m)});
        }
        std::vector<Eigen::Vector3d> area = points;
        area.push_back({first_x_m + shown_m - origin_x_m, 0.0, middle_z_m_ - 40.0});
        area.push_back({first_x_m - origin_x_m, 0.0, middle_z_m_ - 40.0});
        line(area, "ground");
    }

    const Way& way_;
    double left_, top_, middle_z_m_;
    std::string svg_;
};

std::string picture() {
    std::string svg =
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 640 640\" font-family=\"sans-serif\" "
        "font-size=\"12\">\n<style>.ground{fill:#d9d2c5;stroke:none}.flight{fill:none;stroke:#1f5fa8;"
        "stroke-width:2;stroke-dasharray:6 "
        "3}.slide{fill:none;stroke:#b3401f;stroke-width:3}.impact{fill:#fff;"
        "stroke:#222;stroke-width:1.5}.letter{font-size:16px;font-weight:bold}</style>\n"
        "<rect width=\"640\" height=\"640\" fill=\"#fff\"/>\n";
    for (std::size_t i = 0; i < testing::transitions().size(); ++i) {
        const Transition& transition = testing::transitions()[i];
        svg += Panel{transition, testing::way_of(transition), i}.svg();
    }
    return svg + "</svg>\n";
}

TEST(TransitionPicture, IsWhatTheRocksDo) {
    const std::string file = BANNWALD_SOURCE_DIR "/rockfall/motion/pir3d/transitions.svg";
    const std::string svg = picture();
    if (std::getenv("BANNWALD_WRITE_PICTURES") != nullptr) {
        std::ofstream{file} << svg;
    }
    std::ostringstream shipped;
    shipped << std::ifstream{file}.rdbuf();
    EXPECT_EQ(svg, shipped.str()) << "run this test with BANNWALD_WRITE_PICTURES=1 and look at " << file;
}

}  // namespace
}  // namespace rockfall::pir3d::picture_test
