#include "coupling/inputs/terrain/mesh_input.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "config/grid/ascii_grid.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "rockfall/ensemble.hpp"
#include "rockfall/terrain/mesh.hpp"
#include "tests/coupling/inputs/meshes/mesh_texts.hpp"
#include "tests/coupling/inputs/opened.hpp"

namespace coupling::meshes::mesh_input_test {
namespace {

using config::ExitCode;

/// The slope of the sample project as its mesh, with sources that need no grid.
class MeshProject : public SampleProject {
public:
    MeshProject()
        : terrain_{rockfall::triangulate(config::read_ascii_grid(read("dem.asc"), "dem.asc"), 0.0)} {
        write("cliffs.csv", "wkt\n\"LINESTRING (1025 2030, 1025 2060)\"\n");
    }
    [[nodiscard]] MeshTexts texts() const { return MeshTexts{terrain_}; }
    [[nodiscard]] const rockfall::Terrain& terrain() const { return terrain_; }

private:
    rockfall::Terrain terrain_;
};

Opened open_mesh(const MeshProject& project, const std::string& name, const std::string& bytes,
                 std::vector<std::string> overrides = {}) {
    project.write(name, bytes);
    overrides.insert(overrides.end(), {"terrain.dem=", "terrain.mesh=" + name, "release.source=",
                                       "release.source_shapes=cliffs.csv", "output.cell_size_m=10"});
    return open(project, overrides);
}

const std::vector<std::string> one_ground{"terrain.surface=", "terrain.ground=solid_rock"};

TEST(MeshInput, OfAnyFormatIsTheSameTerrain) {
    const MeshProject project;
    for (const auto& [name, bytes] :
         {std::pair{"m.ply", project.texts().ply()}, std::pair{"b.ply", project.texts().binary_ply()},
          std::pair{"m.stl", project.texts().stl()}, std::pair{"b.stl", project.texts().binary_stl()},
          std::pair{"m.xyz", project.texts().points()}}) {
        const Opened opened = open_mesh(project, name, bytes);
        ASSERT_TRUE(opened.site) << name << ": " << opened.errors;
        const rockfall::Terrain& terrain = opened.site->slope.terrain;
        EXPECT_EQ(terrain.triangles().size(), project.terrain().triangles().size()) << name;
        for (const Eigen::Vector2d& place : {Eigen::Vector2d{1031.0, 2044.0}, {1101.5, 2090.25}}) {
            const Eigen::Vector2d mine = place - terrain.origin_m();
            const Eigen::Vector2d given = place - project.terrain().origin_m();
            EXPECT_NEAR(*terrain.height_m(mine.x(), mine.y()),
                        *project.terrain().height_m(given.x(), given.y()), 1e-9)
                << name;
        }
        EXPECT_EQ(opened.site->map_frame.cell_width_m, 10.0);
        EXPECT_EQ(opened.site->map_frame.x_west_m, 1005.0);
    }
}

TEST(MeshInput, TakesTheGroundOfItsFaces) {
    const MeshProject project;
    const std::string ply =
        project.texts().ply_with_codes([](double x, double) { return x < 1030.0 ? 1 : 3; });
    const Opened opened = open_mesh(project, "m.ply", ply, {"terrain.surface="});
    ASSERT_TRUE(opened.site) << opened.errors;
    const rockfall::Slope& slope = opened.site->slope;
    const auto label_at = [&](double x_m, double y_m) {
        const Eigen::Vector2d p = Eigen::Vector2d{x_m, y_m} - slope.terrain.origin_m();
        return slope.type_at(*slope.terrain.locate(p.x(), p.y()), p.x(), p.y()).label;
    };
    EXPECT_EQ(label_at(1015.0, 2051.0), "rock");
    EXPECT_EQ(label_at(1085.0, 2051.0), "soil");
    const config::Cell west = opened.site->map_frame.cell_at(1012.0, 2051.0);
    EXPECT_EQ(slope.types[opened.site->surface.at(west)].label, "rock");
}

TEST(MeshInput, TakesTheGroundOfAGridOnAFrameOfItsOwn) {
    const MeshProject project;
    const Opened opened = open_mesh(project, "m.ply", project.texts().ply());
    ASSERT_TRUE(opened.site) << opened.errors;
    const Eigen::Vector2d origin = opened.site->origin_m();
    EXPECT_EQ(opened.site->slope.type_at(1021.0 - origin.x(), 2051.0 - origin.y()).label, "rock");
    EXPECT_EQ(opened.site->slope.type_at(1061.0 - origin.x(), 2051.0 - origin.y()).label, "soil");
}

/// PLY of these vertices and faces.
std::string ply_of(const std::string& vertices, int points, const std::string& faces, int count) {
    return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(points) +
           "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
           std::to_string(count) + "\nproperty list uchar int vertex_indices\nend_header\n" + vertices +
           faces;
}

TEST(MeshInput, DoubtsAHoleAndSaysWhere) {
    const MeshProject project;
    std::string ply = project.texts().ply();
    // A face in the middle goes: what is left has a hole of three edges.
    const auto triangles = project.terrain().triangles();
    const Eigen::Vector2d middle = Eigen::Vector2d{1062.0, 2053.0} - project.terrain().origin_m();
    const std::uint32_t face = *project.terrain().locate(middle.x(), middle.y());
    const auto& [a, b, c] = triangles[face].corners;
    const std::string line =
        "\n3 " + std::to_string(a) + ' ' + std::to_string(b) + ' ' + std::to_string(c) + '\n';
    ply.replace(ply.find(line), line.size(), "\n");
    const std::string count = "element face ";
    const std::string all = count + std::to_string(triangles.size());
    ply.replace(ply.find(all), all.size(), count + std::to_string(triangles.size() - 1));
    const Opened opened = open_mesh(project, "m.ply", ply);
    ASSERT_TRUE(opened.site) << opened.errors;
    ASSERT_FALSE(opened.warnings.empty());
    EXPECT_TRUE(opened.warnings.front().starts_with("m.ply: found 1 hole at 106")) << opened.warnings.front();
    EXPECT_TRUE(opened.warnings.front().ends_with(
        " with 3 edges, expected ground without holes: rocks that reach one have left the terrain"));
    EXPECT_EQ(open_mesh(project, "m.ply", ply, {"run.strict_inputs=yes"}).code, ExitCode::data);
}

/// Where the rocks of a site end, over the bare slope.
std::vector<rockfall::RockRecord> falls_of(const Opened& opened) {
    const Site& site = *opened.site;
    const rockfall::StemIndex stems{{}, site.slope.terrain, 1.0, true};
    const rockfall::Assessment assessment{site.slope,
                                          stems,
                                          site.sources,
                                          site.targets,
                                          start_law(opened.scenario->release),
                                          opened.scenario->rockfall.fall,
                                          site.map_frame_on_terrain(),
                                          5};
    rockfall::Worker worker{assessment, {nullptr, nullptr}};
    std::vector<rockfall::RockRecord> records;
    for (const rockfall::Chunk& chunk : rockfall::plan_chunks(site.sources)) {
        rockfall::ChunkRows rows;
        worker.run(chunk, rows, nullptr, {});
        const auto& bare = rows.rocks[static_cast<std::size_t>(rockfall::Cover::bare)];
        records.insert(records.end(), bare.begin(), bare.end());
    }
    return records;
}

TEST(MeshInput, GivesTheFallsOfTheGridItWasMadeOf) {
    const MeshProject project;
    project.write("cliffs.csv", "wkt,blocks\n\"LINESTRING (1025 2030, 1025 2060)\",300\n");
    for (const std::string motion : {"picus", "pir3d"}) {
        std::vector<std::string> settings = one_ground;
        settings.push_back("rockfall.motion=" + motion);
        std::vector<std::string> shapes = settings;
        shapes.insert(shapes.end(), {"release.source=", "release.source_shapes=cliffs.csv"});
        const Opened grid = open(project, shapes);
        ASSERT_TRUE(grid.site) << grid.errors;
        const std::vector<rockfall::RockRecord> expected = falls_of(grid);
        ASSERT_EQ(expected.size(), 300U);
        for (const auto& [name, bytes] :
             {std::pair{"m.ply", project.texts().binary_ply()}, std::pair{"m.stl", project.texts().stl()}}) {
            const Opened mesh = open_mesh(project, name, bytes, settings);
            ASSERT_TRUE(mesh.site) << mesh.errors;
            const std::vector<rockfall::RockRecord> found = falls_of(mesh);
            ASSERT_EQ(found.size(), expected.size());
            // The origin differs, and so do last bits; a rock here and there may take another way.
            const Eigen::Vector2d shift_m = grid.site->origin_m() - mesh.site->origin_m();
            std::size_t others = 0;
            for (std::size_t i = 0; i < found.size(); ++i) {
                const double apart_m =
                    (found[i].end_m.head<2>() - expected[i].end_m.head<2>() - shift_m).norm();
                others += apart_m < 0.01 && found[i].reason == expected[i].reason ? 0 : 1;
            }
            EXPECT_LE(others, 6U) << name << ", " << motion;
        }
    }
}

TEST(MeshInput, TakesContoursWhoseLinesAreEdges) {
    const MeshProject project;
    // The slope of the sample falls by 7 m in 10 m towards the east: contours run north-south.
    std::string table = "wkt,height_m\n";
    for (int k = 0; k < 12; ++k) {
        const std::string x = std::to_string(1005 + 10 * k);
        table += "\"LINESTRING (" + x + " 2005, " + x + " 2095)\"," + std::to_string(400 - 7 * k) + '\n';
    }
    const Opened opened = open_mesh(project, "contours.csv", table, one_ground);
    ASSERT_TRUE(opened.site) << opened.errors;
    const rockfall::Terrain& terrain = opened.site->slope.terrain;
    EXPECT_EQ(terrain.triangles().size(), 22U);
    const Eigen::Vector2d p = Eigen::Vector2d{1047.0, 2033.0} - terrain.origin_m();
    EXPECT_NEAR(*terrain.height_m(p.x(), p.y()), 400.0 - 0.7 * 42.0, 1e-9);
}

/// A square of ground, and a roof over a part of it.
const std::string ground_and_roof = ply_of(
    "1000 2000 400\n1120 2000 340\n1120 2100 340\n1000 2100 400\n"
    "1050 2040 390\n1070 2040 380\n1070 2060 380\n1050 2060 390\n",
    8, "3 0 1 2\n3 0 2 3\n3 4 5 6\n3 4 6 7\n", 4);

TEST(MeshInput, KeepsTheUpperFacesIfAsked) {
    const MeshProject project;
    std::vector<std::string> settings{"targets.file=", "trees.file="};
    settings.insert(settings.end(), one_ground.begin(), one_ground.end());
    settings.emplace_back("terrain.mesh_overhangs=keep_upper");
    const Opened opened = open_mesh(project, "m.ply", ground_and_roof, settings);
    ASSERT_TRUE(opened.site) << opened.errors;
    const Site& site = *opened.site;
    const auto height_m = [&](double x_m, double y_m) {
        return site.slope.terrain.height_m(x_m - site.origin_m().x(), y_m - site.origin_m().y()).value();
    };
    EXPECT_NEAR(height_m(1061.0, 2052.0), 390.0 - 0.5 * 11.0, 1e-9);
    EXPECT_NEAR(height_m(1000.5, 2099.0), 400.0 - 0.5 * 0.5, 1.0);
    ASSERT_EQ(site.left_out_faces.size(), 2U);  // both faces of the ground reach below the roof
    EXPECT_EQ(site.left_out_faces[0].file, "m.ply");
    EXPECT_EQ(site.left_out_faces[0].number, 1U);
    ASSERT_FALSE(opened.warnings.empty());
    EXPECT_NE(opened.warnings[0].find("m.ply: 2 faces of 4 left out below others"), std::string::npos)
        << opened.warnings[0];
}

TEST(MeshInput, MayBeSeveralFilesWithAGroundEach) {
    const MeshProject project;
    project.write("west.ply", ply_of("1000 2000 400\n1060 2000 370\n1060 2100 370\n1000 2100 400\n", 4,
                                     "3 0 1 2\n3 0 2 3\n", 2));
    project.write("east.ply", ply_of("1060 2000 370\n1120 2000 340\n1120 2100 340\n1060 2100 370\n", 4,
                                     "3 0 1 2\n3 0 2 3\n", 2));
    project.write("parts.csv", "file,surface\nwest.ply,1\neast.ply,pasture\n");
    const std::vector<std::string> settings{"terrain.dem=",          "terrain.meshes=parts.csv",
                                            "release.source=",       "release.source_shapes=cliffs.csv",
                                            "output.cell_size_m=10", "terrain.surface="};
    const Opened opened = open(project, settings);
    ASSERT_TRUE(opened.site) << opened.errors;
    const rockfall::Slope& slope = opened.site->slope;
    const auto label_at = [&](double x_m, double y_m) {
        const Eigen::Vector2d p = Eigen::Vector2d{x_m, y_m} - slope.terrain.origin_m();
        return slope.type_at(*slope.terrain.locate(p.x(), p.y()), p.x(), p.y()).label;
    };
    EXPECT_EQ(label_at(1059.0, 2051.0), "rock");
    EXPECT_EQ(label_at(1061.0, 2051.0), "pasture");
    EXPECT_EQ(slope.terrain.triangles().size(), 4U);
}

TEST(MeshInput, MayHaveItsYAxisUp) {
    const MeshProject project;
    // The same square as (x, z, -y).
    const std::string upright = ply_of("1000 400 -2000\n1120 340 -2000\n1120 340 -2100\n1000 400 -2100\n", 4,
                                       "3 0 1 2\n3 0 2 3\n", 2);
    std::vector<std::string> settings{"terrain.mesh_up=y"};
    settings.insert(settings.end(), one_ground.begin(), one_ground.end());
    const Opened opened = open_mesh(project, "m.ply", upright, settings);
    ASSERT_TRUE(opened.site) << opened.errors;
    const Site& site = *opened.site;
    EXPECT_NEAR(
        site.slope.terrain.height_m(1060.0 - site.origin_m().x(), 2050.0 - site.origin_m().y()).value(),
        370.0, 1e-9);
}

}  // namespace
}  // namespace coupling::meshes::mesh_input_test
