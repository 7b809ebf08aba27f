#include "coupling/inputs/formats/mesh_file.hpp"

#include <gtest/gtest.h>

#include "config/errors/input_error.hpp"

namespace coupling::meshes::mesh_file_test {
namespace {

const std::string head =
    "ply\nformat ascii 1.0\ncomment made by hand\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nproperty uchar red\nelement face 1\nproperty list uchar int vertex_index\n"
    "property int surface\nend_header\n";
const std::string body = "0 0 5 255\n1 0 5 254\n0 1 6.5 3\n3 0 1 2 7\n";

/// What is wrong with a text, "" if nothing is.
std::string fault_of(const std::string& bytes, const std::string& file) {
    try {
        read_mesh_file(bytes, file);
    } catch (const config::InputError& error) {
        EXPECT_EQ(error.code(), config::ExitCode::data);
        return error.what();
    }
    return "";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

TEST(Ply, IsReadWithCodesAndTellsWhatItPassesOver) {
    const MeshFile mesh = read_mesh_file(head + body, "a.ply");
    ASSERT_EQ(mesh.points_m.size(), 3U);
    EXPECT_EQ(mesh.points_m[2], (Eigen::Vector3d{0.0, 1.0, 6.5}));
    ASSERT_EQ(mesh.faces.size(), 1U);
    EXPECT_EQ(mesh.faces[0], (std::array<std::uint32_t, 3>{0, 1, 2}));
    EXPECT_EQ(mesh.codes, std::vector<std::uint32_t>{7});
    EXPECT_TRUE(mesh.single_precision);
    EXPECT_EQ(mesh.passed_over, std::vector<std::string>{"vertex.red"});
}

TEST(Ply, OfBothByteOrdersIsTheSame) {
    const std::string binary_head =
        "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty double x\nproperty float y\n"
        "property short z\nend_header\n";
    const std::string little("\0\0\0\0\0\0\xF0\x3F\0\0\0\xC0\x02\x01", 14);  // 1, -2, 258
    const std::string big("\x3F\xF0\0\0\0\0\0\0\xC0\0\0\0\x01\x02", 14);
    const Eigen::Vector3d point{1.0, -2.0, 258.0};
    EXPECT_EQ(read_ply(binary_head + little, "a.ply").points_m.at(0), point);
    EXPECT_EQ(read_ply(replaced(binary_head, "little", "big") + big, "a.ply").points_m.at(0), point);
}

const std::string facet =
    "facet normal 0 0 1\n outer loop\n  vertex 0 0 1\n  vertex 1 0 1\n  vertex 0 1 1\n endloop\nendfacet\n";

TEST(Stl, IsReadAsTextWithSeveralSolids) {
    const MeshFile mesh =
        read_mesh_file("solid a\n" + facet + "endsolid a\nsolid b\n" + facet + "endsolid\n", "a.stl");
    EXPECT_EQ(mesh.faces.size(), 2U);
    EXPECT_EQ(mesh.points_m[4], (Eigen::Vector3d{1.0, 0.0, 1.0}));
    EXPECT_FALSE(mesh.single_precision);
}

TEST(Stl, OfAnotherLengthThanItPromisesIsRefused) {
    std::string bytes = std::string(80, 'x') + std::string("\x02\0\0\0", 4) + std::string(50, '\0');
    EXPECT_EQ(fault_of(bytes, "a.stl"),
              "a.stl: found 134 bytes, which hold 1 face, expected 2 faces, as its header says");
    bytes += std::string(50, '\0');
    EXPECT_EQ(read_mesh_file(bytes, "a.stl").faces.size(), 2U);
    bytes.replace(84 + 12, 4, std::string("\0\0\xC0\x7F", 4));
    EXPECT_EQ(fault_of(bytes, "a.stl"),
              "a.stl: found a coordinate that is no finite number in face 1 of 2, expected metres");
}

TEST(Stl, InBinaryMayBeginWithSolid) {
    const std::string bytes =
        "solid" + std::string(75, ' ') + std::string("\x01\0\0\0", 4) + std::string(50, '\0');
    EXPECT_EQ(read_mesh_file(bytes, "a.stl").format, "STL, binary");
}

/// A DXF of these entities, groups divided by blanks.
std::string dxf_of(const std::string& entities) {
    std::string text = "0 SECTION 2 HEADER 9 $EXTMIN 10 1 20 2 30 3 0 ENDSEC 0 SECTION 2 ENTITIES " +
                       entities + " 0 ENDSEC 0 EOF ";
    for (char& c : text) {
        c = c == ' ' ? '\n' : c;
    }
    return text;
}

TEST(Dxf, IsReadWithItsLinesAndPoints) {
    const MeshFile mesh = read_mesh_file(
        dxf_of("0 POINT 8 layer 10 1 20 2 30 3 0 LINE 10 0 20 0 30 5 11 1 21 0 31 6 "
               "0 LWPOLYLINE 90 3 70 1 38 700 10 0 20 0 10 4 20 0 10 4 20 4 "
               "0 POLYLINE 66 1 70 8 0 VERTEX 10 0 20 9 30 1 0 VERTEX 10 5 20 9 30 2 0 SEQEND "
               "0 POLYLINE 66 1 10 0 20 0 30 650 0 VERTEX 10 0 20 8 30 0 0 VERTEX 10 5 20 8 30 0 0 SEQEND "
               "0 TEXT 10 0 20 0 1 words 0 TEXT 10 0 20 0 1 more"),
        "a.dxf");
    EXPECT_TRUE(mesh.faces.empty());
    ASSERT_EQ(mesh.points_m.size(), 10U);
    EXPECT_EQ(mesh.points_m[0], (Eigen::Vector3d{1.0, 2.0, 3.0}));
    EXPECT_EQ(mesh.points_m[2], (Eigen::Vector3d{1.0, 0.0, 6.0}));
    EXPECT_EQ(mesh.points_m[5], (Eigen::Vector3d{4.0, 4.0, 700.0}));
    EXPECT_EQ(mesh.points_m[7], (Eigen::Vector3d{5.0, 9.0, 2.0}));
    EXPECT_EQ(mesh.points_m[9], (Eigen::Vector3d{5.0, 8.0, 650.0}));
    EXPECT_EQ(mesh.lines.size(), 1U + 3U + 1U + 1U);  // the closed line has three pieces
    EXPECT_EQ(mesh.passed_over, std::vector<std::string>{"TEXT (2)"});
}

TEST(Dxf, PolylinesWithoutAHeightOfTheirOwnHaveThatOfTheirVertices) {
    // Neither the flag of a line in space (70 8) nor a height (30): taken as flat it would lie at 0 m.
    const MeshFile mesh = read_mesh_file(
        dxf_of("0 POLYLINE 66 1 0 VERTEX 10 0 20 9 30 380 0 VERTEX 10 5 20 9 30 381 0 SEQEND"), "a.dxf");
    ASSERT_EQ(mesh.points_m.size(), 2U);
    EXPECT_EQ(mesh.points_m[0].z(), 380.0);
    EXPECT_EQ(mesh.points_m[1].z(), 381.0);
}

TEST(Dxf, IsReadWithItsFaces) {
    const MeshFile mesh =
        read_mesh_file(dxf_of("0 3DFACE 10 0 20 0 30 1 11 4 21 0 31 1 12 4 22 4 32 1 13 4 23 4 33 1 "
                              "0 3DFACE 10 0 20 0 30 1 11 4 21 4 31 1 12 2 22 6 32 1 13 0 23 4 33 1"),
                       "a.dxf");
    EXPECT_EQ(mesh.faces.size(), 3U);  // a triangle, and four corners as two of them
    EXPECT_TRUE(mesh.lines.empty());
}

TEST(Ply, PassesOverElementsWithoutPropertiesWhateverTheirNumber) {
    EXPECT_EQ(fault_of(replaced(head, "end_header", "element note 4000000000\nend_header") + body, "a.ply"),
              "");
}

TEST(Contours, AreReadWithHeightsOfPointsOrRows) {
    const MeshFile mesh = read_mesh_file(
        "wkt,height_m\n\"LINESTRING Z (0 0 5, 1 0 6, 2 0 7)\",\n\"LINESTRING (0 4, 2 4)\",700\n"
        "POINT Z (1 2 3),\n",
        "a.csv");
    ASSERT_EQ(mesh.points_m.size(), 6U);
    EXPECT_EQ(mesh.points_m[1].z(), 6.0);
    EXPECT_EQ(mesh.points_m[4].z(), 700.0);
    EXPECT_EQ(mesh.lines, (std::vector<rockfall::PointPair>{{0, 1}, {1, 2}, {3, 4}}));
}

}  // namespace
}  // namespace coupling::meshes::mesh_file_test
