// The plots of rockfall/virtual_surface/README.md, made from the model each time: a change of the model that
// moves them fails here. To make them again, run the test with BANNWALD_WRITE_PLOTS=1.

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "rockfall/virtual_surface/estimate.hpp"

namespace rockfall::plots_test {
namespace {

constexpr std::uint32_t surfaces = 8;
constexpr std::uint32_t throws = 4000;

struct Point {
    double x;
    SurfaceEstimate percent;
};

struct Curve {
    std::string name;
    std::string style;
    std::vector<Point> points;
};

SurfaceEstimate percent_of(double cover, double burial, double gathering, double rock_m) {
    BlockKind kind;
    kind.cover = cover;
    kind.burial = burial;
    kind.gathering = gathering;
    std::vector<ThrowTally> tallies;
    for (std::uint32_t number = 0; number < surfaces; ++number) {
        const SurfaceKey key{1, number};
        tallies.push_back(
            throw_rocks(lay_blocks(std::array{kind}, default_patch_m, key), rock_m, {}, key, throws));
    }
    const SurfaceEstimate share = stop_probability(tallies);
    return {100.0 * share.value, 100.0 * share.standard_error};
}

std::string number(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.1f", value);
    return text.data();
}

/// A chart of probabilities in per cent with bars of two standard errors.
class Plot {
public:
    Plot(std::string title, std::string x_title, double x_high, double x_step, double y_high, double y_step)
        : x_high_{x_high}, y_high_{y_high} {
        out_
            << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 620 400\" font-family=\"sans-serif\" "
               "font-size=\"12\" fill=\"#222\">\n<rect width=\"620\" height=\"400\" fill=\"#fff\"/>\n"
            << "<text x=\"60\" y=\"26\" font-weight=\"bold\">" << title << "</text>\n";
        for (double x = 0.0; x <= x_high * 1.001; x += x_step) {
            out_ << "<line x1=\"" << at_x(x) << "\" x2=\"" << at_x(x)
                 << "\" y1=\"340\" y2=\"345\" stroke=\"#333\"/>"
                 << "<text x=\"" << at_x(x) << "\" y=\"360\" text-anchor=\"middle\">" << label(x)
                 << "</text>\n";
        }
        for (double y = 0.0; y <= y_high * 1.001; y += y_step) {
            out_ << "<line x1=\"60\" x2=\"440\" y1=\"" << at_y(y) << "\" y2=\"" << at_y(y)
                 << "\" stroke=\"#ddd\"/><text x=\"54\" y=\"" << number(300.0 * (1.0 - y / y_high) + 44.0)
                 << "\" text-anchor=\"end\">" << label(y) << "</text>\n";
        }
        out_ << "<rect x=\"60\" y=\"40\" width=\"380\" height=\"300\" fill=\"none\" stroke=\"#333\"/>\n"
             << "<text x=\"250\" y=\"384\" text-anchor=\"middle\">" << x_title << "</text>\n"
             << "<text x=\"16\" y=\"190\" text-anchor=\"middle\" transform=\"rotate(-90 16 190)\">impacts "
                "that "
                "stop the rock (%)</text>\n";
    }

    void add(const Curve& curve) {
        std::string path;
        for (const auto& [x, percent] : curve.points) {
            path += at_x(x) + ',' + at_y(percent.value) + ' ';
            out_ << "<line x1=\"" << at_x(x) << "\" x2=\"" << at_x(x) << "\" y1=\""
                 << at_y(percent.value - 2.0 * percent.standard_error) << "\" y2=\""
                 << at_y(percent.value + 2.0 * percent.standard_error) << "\" " << curve.style << "/>\n";
        }
        path.pop_back();
        out_ << "<polyline points=\"" << path << "\" fill=\"none\" stroke-width=\"2\" " << curve.style
             << "/>\n";
        const std::string y = number(56.0 + 20.0 * names_++);
        out_ << "<line x1=\"452\" x2=\"480\" y1=\"" << y << "\" y2=\"" << y << "\" stroke-width=\"2\" "
             << curve.style << "/><text x=\"486\" y=\"" << y << "\" dy=\"4\">" << curve.name << "</text>\n";
    }
    [[nodiscard]] std::string text() const { return out_.str() + "</svg>\n"; }

private:
    [[nodiscard]] std::string at_x(double x) const { return number(60.0 + 380.0 * x / x_high_); }
    [[nodiscard]] std::string at_y(double y) const { return number(340.0 - 300.0 * y / y_high_); }
    static std::string label(double value) {
        const std::string text = number(value);
        return text.ends_with(".0") ? text.substr(0, text.size() - 2) : text;
    }

    double x_high_;
    double y_high_;
    int names_ = 0;
    std::ostringstream out_;
};

void expect_in_readme(const std::string& file, const std::string& plot) {
    const std::string path = BANNWALD_SOURCE_DIR "/rockfall/virtual_surface/" + file;
    if (std::getenv("BANNWALD_WRITE_PLOTS") != nullptr) {
        std::ofstream{path, std::ios::binary} << plot;
    }
    std::ifstream in{path, std::ios::binary};
    const std::string stored{std::istreambuf_iterator<char>{in}, {}};
    EXPECT_TRUE(stored == plot) << file << " differs; make it again with BANNWALD_WRITE_PLOTS=1";
}

std::string name_of(double rock_m) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.2f m", rock_m);
    return text.data();
}

const std::array styles{std::string{"stroke=\"#000\""},
                        std::string{"stroke=\"#0072b2\" stroke-dasharray=\"7 3\""},
                        std::string{"stroke=\"#d55e00\" stroke-dasharray=\"2 3\""},
                        std::string{"stroke=\"#009e73\" stroke-dasharray=\"9 3 2 3\""}};

TEST(Plots, ShowTheEffectOfCover) {
    Plot plot{"Blocks of 0.4-0.8 m, rock of 0.95 m: the effect of cover", "cover (%)", 45.0, 10.0, 12.0, 2.0};
    struct Variant {
        std::string name;
        double burial;
        double gathering;
    };
    const std::array variants{Variant{"burial 0", 0.0, 0.0}, Variant{"0, gathered", 0.0, 0.8},
                              Variant{"burial 0.25", 0.25, 0.0}, Variant{"burial 0.5", 0.5, 0.0}};
    for (std::size_t i = 0; i < variants.size(); ++i) {
        Curve curve{variants[i].name, styles[i], {}};
        for (const double cover : {0.01, 0.02, 0.05, 0.08, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45}) {
            curve.points.push_back(
                {100.0 * cover, percent_of(cover, variants[i].burial, variants[i].gathering, 0.95)});
        }
        plot.add(curve);
    }
    expect_in_readme("p_stop_cover.svg", plot.text());
}

TEST(Plots, ShowTheEffectOfBurial) {
    Plot plot{"Blocks of 0.4-0.8 m, gathered, 30 % cover: the effect of burial",
              "burial (share of the diameter)",
              0.5,
              0.1,
              15.0,
              3.0};
    const std::array rocks_m{0.5, 0.7, 0.95, 1.3};
    for (std::size_t i = 0; i < rocks_m.size(); ++i) {
        Curve curve{"rock " + name_of(rocks_m[i]), styles[i], {}};
        for (const double burial : {0.0, 0.1, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.5}) {
            curve.points.push_back({burial, percent_of(0.3, burial, 0.8, rocks_m[i])});
        }
        plot.add(curve);
    }
    expect_in_readme("p_stop_burial.svg", plot.text());
}

}  // namespace
}  // namespace rockfall::plots_test
