#include "coupling/assessments/stopping/pictures.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "tests/coupling/parts_of_text.hpp"

namespace coupling::pictures_test {
namespace {

using rockfall::BlockCover;
using text_checks::count_of;

BlockCover two_blocks() {
    BlockCover cover{24.0, 1.0};
    cover.add({23.8, 5.0, 0.25, 0.5});  // reaches over the eastern border
    cover.add({10.0, 12.1, 0.3, 0.3});  // near the line of the cut
    return cover;
}

TEST(ShownBlocks, ReachOverTheBorderOnBothSides) {
    const auto shown = shown_blocks(two_blocks());
    ASSERT_EQ(shown.size(), 3U);
    EXPECT_EQ(shown.front().radius_m, 0.3);  // the lowest first
    EXPECT_NEAR(shown[1].x_m + shown[2].x_m, 23.8 - 0.2, 1e-12);
}

TEST(ShownBlocks, AreThoseOfACornerOfALargePatch) {
    BlockCover cover{100.0, 1.0};
    cover.add({23.8, 5.0, 0.5, 0.5});
    cover.add({24.4, 8.0, 0.5, 0.5});  // half a metre reaches in
    cover.add({99.8, 8.0, 0.5, 0.5});  // over the border of the patch
    cover.add({50.0, 5.0, 0.5, 0.5});
    EXPECT_EQ(shown_side_m(cover), 24.0);
    EXPECT_EQ(shown_blocks(cover).size(), 3U);
}

TEST(SurfaceSvg, DrawsEveryBlockToScaleAndThoseOfTheCutAgain) {
    std::ostringstream out;
    write_surface_svg(two_blocks(), "a <surface>", "cover", out);
    const std::string svg = out.str();
    EXPECT_EQ(svg.find("<surface>"), std::string::npos);
    EXPECT_EQ(count_of(svg, "<circle"), 5U);      // three above, one in the cut, the rock compared with
    EXPECT_EQ(count_of(svg, "r=\"15.00\""), 2U);  // 0.5 m at 30 px to the metre
    EXPECT_EQ(count_of(svg, "r=\"9.00\""), 2U);
    EXPECT_EQ(count_of(svg, "r=\"14.25\""), 1U);
    EXPECT_EQ(svg.find("\u2212"), std::string::npos);  // the minus sign of text is none in coordinates
    EXPECT_NE(svg.find("5 m</text>"), std::string::npos);
}

/// Vertices and faces of an ASCII PLY; faces only of the counts that its head gives.
struct Mesh {
    std::vector<std::array<double, 3>> points;
    std::vector<std::vector<std::size_t>> faces;
    bool ended = false;
};

Mesh read_ply(const std::string& text) {
    std::istringstream in{text};
    std::string line;
    std::size_t vertices = 0;
    std::size_t faces = 0;
    while (std::getline(in, line) && line != "end_header") {
        std::istringstream words{line};
        std::string element;
        std::string kind;
        words >> element >> kind;
        if (element == "element") {
            words >> (kind == "vertex" ? vertices : faces);
        }
    }
    Mesh mesh;
    for (std::size_t i = 0; i < vertices; ++i) {
        std::array<double, 3> p{};
        int red = 0;
        int green = 0;
        int blue = 0;
        in >> p[0] >> p[1] >> p[2] >> red >> green >> blue;
        mesh.points.push_back(p);
    }
    for (std::size_t i = 0; i < faces; ++i) {
        std::size_t corners = 0;
        in >> corners;
        std::vector<std::size_t> face(corners);
        for (std::size_t& corner : face) {
            in >> corner;
        }
        mesh.faces.push_back(face);
    }
    in >> line;
    mesh.ended = in.eof();
    return mesh;
}

TEST(SurfacePly, HoldsClosedSpheresThatLieAsTheBlocksDo) {
    std::ostringstream out;
    write_surface_ply(two_blocks(), out);
    const Mesh mesh = read_ply(out.str());
    EXPECT_TRUE(mesh.ended);
    ASSERT_EQ(mesh.points.size(), 4 + 3 * 42U);
    ASSERT_EQ(mesh.faces.size(), 1 + 3 * 80U);
    // Closed and turning one way: each directed edge of a triangle is met once, and so is its opposite.
    std::map<std::pair<std::size_t, std::size_t>, int> edges;
    for (std::size_t i = 1; i < mesh.faces.size(); ++i) {
        const auto& face = mesh.faces[i];
        ASSERT_EQ(face.size(), 3U);
        for (std::size_t k = 0; k < 3; ++k) {
            ASSERT_LT(face[k], mesh.points.size());
            ++edges[{face[k], face[(k + 1) % 3]}];
        }
    }
    for (const auto& [edge, count] : edges) {
        EXPECT_EQ(count, 1);
        EXPECT_TRUE(edges.contains({edge.second, edge.first}));
    }
    double highest_m = 0.0;
    for (const auto& point : mesh.points) {
        highest_m = std::max(highest_m, point[2]);
    }
    EXPECT_NEAR(highest_m, 0.75, 0.05);  // of so few triangles
    EXPECT_LE(highest_m, 0.7505);
}

}  // namespace
}  // namespace coupling::pictures_test
