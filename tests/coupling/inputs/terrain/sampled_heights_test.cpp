// The rules on heights over terrains that are no grids: what a grid is refused or warned of is said of the
// same ground as points and as a mesh, and of contours as far as contours show it.

#include "coupling/inputs/terrain/sampled_heights.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include "coupling/inputs/plausible/terrain/terrain_gate.hpp"
#include "rockfall/terrain/mesh.hpp"
#include "tests/coupling/inputs/plausible/terrain/wrong_terrains.hpp"

namespace coupling::plausible::sampled_heights_test {
namespace {

using terrain::Ground;
using terrain::Wrong;

constexpr double west_m = 5000.0;
constexpr double south_m = 300.0;

Eigen::Vector3d point_of(const Ground& ground, int row, int column) {
    return {west_m + ground.cell_m * column, south_m + ground.cell_m * (ground.rows - 1 - row),
            ground.at(row, column)};
}

HeightInput as_points(const Ground& ground, std::mt19937& random) {
    HeightInput input;
    for (int row = 0; row < ground.rows; ++row) {
        for (int column = 0; column < ground.columns; ++column) {
            if (!std::isnan(ground.at(row, column))) {
                input.points.push_back(point_of(ground, row, column));
            }
        }
    }
    std::shuffle(input.points.begin(), input.points.end(), random);
    return input;
}

/// Two faces for each square of known points, cut along either diagonal; points and faces in any order.
HeightInput as_mesh(const Ground& ground, std::mt19937& random) {
    HeightInput input = as_points(ground, random);
    std::map<std::pair<int, int>, std::uint32_t> index_of;
    for (std::size_t i = 0; i < input.points.size(); ++i) {
        const Eigen::Vector3d& point = input.points[i];
        index_of[{static_cast<int>(std::lround((point.x() - west_m) / ground.cell_m)),
                  static_cast<int>(std::lround((point.y() - south_m) / ground.cell_m))}] =
            static_cast<std::uint32_t>(i);
    }
    for (const auto& [place, south_west] : index_of) {
        const auto at = [&, x = place.first, y = place.second](int dx, int dy) {
            const auto found = index_of.find({x + dx, y + dy});
            return found == index_of.end() ? std::optional<std::uint32_t>{} : found->second;
        };
        const auto south_east = at(1, 0);
        const auto north_west = at(0, 1);
        const auto north_east = at(1, 1);
        if (!south_east || !north_west || !north_east) {
            continue;
        }
        if (random() % 2 == 0) {
            input.faces.push_back({{south_west, *south_east, *north_east}});
            input.faces.push_back({{south_west, *north_east, *north_west}});
        } else {
            input.faces.push_back({{south_west, *south_east, *north_west}});
            input.faces.push_back({{*south_east, *north_east, *north_west}});
        }
    }
    std::shuffle(input.faces.begin(), input.faces.end(), random);
    return input;
}

/// Contours of a grid, piece by piece through the four triangles between the corners of a square and its
/// middle, which has their mean height.
class Contours {
public:
    Contours(const Ground& ground, double interval_m) : ground_{ground}, interval_m_{interval_m} {
        for (int row = 1; row < 2 * ground.rows - 1; row += 2) {
            for (int column = 1; column < 2 * ground.columns - 1; column += 2) {
                const Node middle{row, column};
                if (!std::isnan(height_m(middle))) {
                    cut(middle, {row - 1, column - 1}, {row - 1, column + 1});
                    cut(middle, {row - 1, column + 1}, {row + 1, column + 1});
                    cut(middle, {row + 1, column + 1}, {row + 1, column - 1});
                    cut(middle, {row + 1, column - 1}, {row - 1, column - 1});
                }
            }
        }
    }

    /// Lines and points in any order.
    [[nodiscard]] HeightInput input(std::mt19937& random) const {
        std::vector<std::uint32_t> order(points_.size());
        std::iota(order.begin(), order.end(), 0U);
        std::shuffle(order.begin(), order.end(), random);
        HeightInput input;
        input.points.resize(points_.size());
        for (std::size_t i = 0; i < points_.size(); ++i) {
            input.points[order[i]] = points_[i];
        }
        for (const auto& [from, to] : lines_) {
            input.lines.push_back(random() % 2 == 0 ? rockfall::PointPair{order[from], order[to]}
                                                    : rockfall::PointPair{order[to], order[from]});
        }
        std::shuffle(input.lines.begin(), input.lines.end(), random);
        return input;
    }

private:
    using Node = std::pair<int, int>;  ///< row and column in half cells

    [[nodiscard]] double height_m(Node node) const {
        const int row = node.first / 2;
        const int column = node.second / 2;
        if (node.first % 2 == 0) {
            return ground_.at(row, column);
        }
        std::array<double, 4> four{ground_.at(row, column), ground_.at(row + 1, column),
                                   ground_.at(row, column + 1), ground_.at(row + 1, column + 1)};
        if (std::any_of(four.begin(), four.end(), [](double height) { return std::isnan(height); })) {
            return std::numeric_limits<double>::quiet_NaN();
        }
        std::sort(four.begin(), four.end());  // so that the sum is the same of a turned square
        return 0.25 * (four[0] + four[1] + four[2] + four[3]);
    }
    [[nodiscard]] Eigen::Vector3d place_of(Node node) const {
        return {west_m + 0.5 * ground_.cell_m * node.second,
                south_m + ground_.cell_m * (ground_.rows - 1 - 0.5 * node.first), height_m(node)};
    }

    void cut(Node a, Node b, Node c) {
        const double low_m = std::min({height_m(a), height_m(b), height_m(c)});
        const double high_m = std::max({height_m(a), height_m(b), height_m(c)});
        // A little off whole numbers, which whole heights lie on.
        for (double level = std::ceil(low_m / interval_m_ - 0.3); interval_m_ * (level + 0.3) < high_m;
             level += 1.0) {
            const double level_m = interval_m_ * (level + 0.3);
            std::vector<std::uint32_t> ends;
            for (const auto& [from, to] : {std::pair{a, b}, {b, c}, {a, c}}) {
                if ((height_m(from) < level_m) != (height_m(to) < level_m)) {
                    ends.push_back(crossing(std::min(from, to), std::max(from, to), level_m));
                }
            }
            if (ends.size() == 2 && ends[0] != ends[1]) {
                lines_.emplace_back(ends[0], ends[1]);
            }
        }
    }
    std::uint32_t crossing(Node from, Node to, double level_m) {
        const auto [at, is_new] = index_of_.try_emplace({from, to, level_m}, points_.size());
        if (is_new) {
            const Eigen::Vector3d a = place_of(from);
            const Eigen::Vector3d b = place_of(to);
            Eigen::Vector3d point = a + (level_m - a.z()) / (b.z() - a.z()) * (b - a);
            point.z() = level_m;
            points_.push_back(point);
        }
        return static_cast<std::uint32_t>(at->second);
    }

    const Ground& ground_;
    double interval_m_;
    std::vector<Eigen::Vector3d> points_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> lines_;
    std::map<std::tuple<Node, Node, double>, std::size_t> index_of_;
};

/// "stripes (error)", or "" where nothing is said.
std::string said_of(const HeightInput& input) {
    const rockfall::Terrain ground = !input.faces.empty() ? rockfall::terrain_of({input.points, input.faces})
                                     : input.lines.empty()
                                         ? rockfall::triangulate(input.points, 0.0)
                                         : rockfall::triangulate(input.points, input.lines, 0.0);
    const config::Raster<double> samples = sampled_heights(input, ground);
    std::string words;
    for (const terrain::Verdict& verdict : terrain::judge_heights(terrain::field_of(samples))) {
        words += (words.empty() ? "" : ", ") + std::string{verdict.rule} +
                 (verdict.finding.is_error ? " (error)" : "");
    }
    return words;
}

std::string said_of_grid(const Ground& ground) {
    std::string words;
    for (const terrain::Verdict& verdict : terrain::judge_heights(ground.field())) {
        words += (words.empty() ? "" : ", ") + std::string{verdict.rule} +
                 (verdict.finding.is_error ? " (error)" : "");
    }
    return words;
}

std::vector<Wrong> all_terrains() {
    std::vector<Wrong> terrains = terrain::wrong_terrains();
    terrains.push_back({"ground", "", false, terrain::mountainside()});
    terrains.push_back({"hills", "", false, terrain::hills()});
    return terrains;
}

TEST(SampledHeights, OfALatticeAreItsHeights) {
    std::mt19937 random{1};
    const Ground ground = terrain::mountainside();
    const HeightInput input = as_points(ground, random);
    const config::Raster<double> samples = sampled_heights(input, rockfall::triangulate(input.points, 0.0));
    EXPECT_EQ(samples.values, ground.heights_m);
    EXPECT_EQ(samples.frame.cell_width_m, ground.cell_m);
    EXPECT_EQ(samples.frame.x_west_m, west_m - 0.5 * ground.cell_m);
}

TEST(SampledHeights, OfScatteredPointsLieBetweenThem) {
    std::mt19937 random{2};
    HeightInput input;
    for (int i = 0; i < 5000; ++i) {
        const double x_m = 500.0 * std::generate_canonical<double, 32>(random);
        const double y_m = 300.0 * std::generate_canonical<double, 32>(random);
        input.points.emplace_back(std::round(x_m), std::round(y_m), 100.0 + 0.5 * std::round(x_m));
    }
    const config::Raster<double> samples = sampled_heights(input, rockfall::triangulate(input.points, 0.0));
    EXPECT_EQ(samples.frame.cell_width_m, 10.0);  // 30 m2 a point, rounded up
    for (std::size_t i = 0; i < samples.values.size(); ++i) {
        if (!std::isnan(samples.values[i])) {
            EXPECT_NEAR(samples.values[i],
                        100.0 + 0.5 * samples.frame.x_centre_m(samples.frame.cell_of(i).column), 1e-9);
        }
    }
}

/// Turned and mirrored, a different one each time.
std::vector<Ground> seen_otherwise(const Ground& ground) {
    return {ground, ground.turned(), ground.turned().turned().mirrored(), ground.turned().mirrored()};
}

TEST(HeightRules, SayOfPointsAndMeshesWhatTheySayOfTheGrid) {
    std::mt19937 random{3};
    for (const Wrong& wrong : all_terrains()) {
        const std::string expected = said_of_grid(wrong.ground);
        const std::vector<Ground> grounds = seen_otherwise(wrong.ground);
        for (std::size_t i = 0; i < grounds.size(); ++i) {
            const HeightInput input =
                i % 2 == 0 ? as_mesh(grounds[i], random) : as_points(grounds[i], random);
            EXPECT_EQ(said_of(input), expected) << wrong.what << ", turned way " << i;
        }
    }
}

/// Contours of 10 m show what is larger than their interval. What they do not show stands in README.md of the
/// rules, too.
TEST(HeightRules, SayOfContoursWhatContoursShow) {
    const std::map<std::string, std::string> expected{{"feet", "steepness"},
                                                      {"decimetres", "steepness (error)"},
                                                      {"crowns", "steps (error)"},
                                                      {"nearest neighbour", "stripes (error)"},
                                                      {"terraces of 10 m", ""},
                                                      {"terraces of 5 m", ""},
                                                      {"stripes of 4 m", "steps"},
                                                      {"stripes of 1 m", ""},
                                                      {"long stripes", ""},
                                                      {"oblique stripes", "stripes"},
                                                      {"spikes", "spikes"},
                                                      {"pits", "spikes"},
                                                      {"spikes of 2 x 2 cells", "spikes"},
                                                      {"a peak of 8 m in smooth ground", ""},
                                                      {"pits of 4 m in smooth ground", ""},
                                                      {"spikes at the corners", ""},
                                                      {"hillshade", "steps (error)"},
                                                      {"heights in 8 bits", ""},
                                                      {"speeds", "unevenness (error)"},
                                                      {"speeds in few known cells", "unevenness (error)"},
                                                      {"upside down", "upside_down"},
                                                      {"cells of 30 m", "cell_size"},
                                                      {"ground", ""},
                                                      {"hills", ""}};
    std::mt19937 random{4};
    for (const Wrong& wrong : all_terrains()) {
        for (const Ground& seen : {wrong.ground, wrong.ground.turned().mirrored()}) {
            EXPECT_EQ(said_of(Contours{seen, 10.0}.input(random)), expected.at(wrong.what)) << wrong.what;
        }
    }
}

}  // namespace
}  // namespace coupling::plausible::sampled_heights_test
