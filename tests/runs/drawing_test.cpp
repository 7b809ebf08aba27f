// From the heights alone to a project that somebody draws in: `bannwald init DIR --dem FILE --draw`.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "coupling/program/actions/drawing_layers.hpp"
#include "tests/coupling/inputs/drawing/pencil.hpp"
#include "tests/coupling/results/markup_checks.hpp"
#include "tests/runs/lambert.hpp"
#include "tests/runs/program.hpp"

namespace coupling::drawing_test {
namespace {

/// The heights of the sample project, in a system that GIS programs know, and a project made of them.
struct Draft {
    SampleProject project;
    Outcome made;
    explicit Draft(const std::string& more = "") {
        project.write("dem.prj", std::string{lambert} + "\n");
        made = call(project, "init own --dem dem.asc --draw" + more);
    }
    [[nodiscard]] Pencil pencil() const { return Pencil{project.file("own/drawing.gpkg")}; }
};

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(Drawing, IsCheckedAndRunBeforeAnythingIsDrawn) {
    const Draft draft;
    ASSERT_EQ(draft.made.code, 0) << draft.made.err;
    EXPECT_TRUE(has(draft.made.err, "drawing.gpkg: empty layers to draw in: source_lines")) << draft.made.err;
    EXPECT_TRUE(has(draft.made.err, "next: draw in own/drawing.qgs (QGIS), then\n"));
    const Outcome check = call(draft.project, "check own/scenario.ini");
    EXPECT_EQ(check.code, 0) << check.err;
    for (const std::string sentence :
         {"nothing drawn yet in source_lines, source_areas: all cells steeper than 33.7 degrees are sources",
          "nothing drawn yet in roads, houses: as without targets.file",
          "nothing drawn yet in nets: as without nets.file",
          "nothing drawn yet in grounds: as without terrain.surface_polygons",
          "nothing drawn yet in stands: as without stands.polygons", "release.undrawn_steeper_than_deg"}) {
        EXPECT_TRUE(has(check.err, sentence)) << sentence << check.err;
    }
    EXPECT_FALSE(has(check.err, "no effect")) << check.err;
    const Outcome run = call(draft.project, "run own/scenario.ini --out out --set release.rocks=500 --quiet");
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_TRUE(std::filesystem::exists(draft.project.file("out/rasters/forest/E_95.asc")) ||
                std::filesystem::exists(draft.project.file("out/report.html")));
}

TEST(Drawing, IsTakenAsItIsDrawnWithoutEditingTheScenario) {
    const Draft draft;
    ASSERT_EQ(draft.made.code, 0) << draft.made.err;
    {
        Pencil pencil = draft.pencil();
        pencil.line("source_lines", {{1025.0, 2030.0}, {1025.0, 2070.0}});
        pencil.line("roads", {{1105.0, 2010.0}, {1105.0, 2090.0}}, {{"name", "Valley road"}});
        pencil.area("houses", {{1090.0, 2040.0}, {1100.0, 2040.0}, {1100.0, 2050.0}, {1090.0, 2050.0}},
                    {{"name", "Barn"}});
        pencil.area("grounds", {{1000.0, 2000.0}, {1060.0, 2000.0}, {1060.0, 2100.0}, {1000.0, 2100.0}},
                    {{"code", "9"}});
        pencil.area("stands", {{1040.0, 2000.0}, {1120.0, 2000.0}, {1120.0, 2100.0}, {1040.0, 2100.0}},
                    {{"stand", "4"}, {"species", "PIAB"}, {"stems_pha", "600"}, {"mean_dbh_cm", "30"}});
    }
    const Outcome check = call(draft.project, "check own/scenario.ini");
    EXPECT_EQ(check.code, 0) << check.err;
    EXPECT_TRUE(has(check.err, "nothing drawn yet in nets: as without nets.file")) << check.err;
    EXPECT_FALSE(has(check.err, "drawn yet in roads")) << check.err;
    EXPECT_FALSE(has(check.err, "undrawn_steeper_than_deg")) << check.err;  // the guess counts no more
    const Outcome run = call(draft.project, "run own/scenario.ini --out out --set release.rocks=500 --quiet");
    ASSERT_EQ(run.code, 0) << run.err;
    const std::string targets = draft.project.read("out/tables/targets.csv");
    EXPECT_TRUE(has(targets, "Valley road")) << targets;
    EXPECT_TRUE(has(targets, "Barn")) << targets;
    EXPECT_TRUE(has(check.out, "sources       1 in 1 zone")) << check.out;
    EXPECT_TRUE(has(check.out, "trees         4")) << check.out;  // 600 a hectare on 0.7 to 0.8 ha
    // What was run can be packed and run again: the drawing is one of its inputs.
    EXPECT_EQ(call(draft.project, "pack out --scenario own/scenario.ini --out run.zip").code, 0);
    EXPECT_EQ(call(draft.project, "verify run.zip").code, 0);
}

TEST(Drawing, HasLayersForWhatNoFileIsGivenFor) {
    const Draft draft{" --targets targets.csv --trees trees.csv"};
    ASSERT_EQ(draft.made.code, 0) << draft.made.err;
    const std::string scenario = draft.project.read("own/scenario.ini");
    EXPECT_TRUE(has(scenario, "file = ../targets.csv")) << scenario;
    EXPECT_TRUE(has(scenario, "file = ../trees.csv")) << scenario;
    EXPECT_TRUE(has(scenario, "file = drawing.gpkg|nets")) << scenario;
    EXPECT_FALSE(has(scenario, "drawing.gpkg|roads") || has(scenario, "[stands]")) << scenario;
    std::string layers;
    draft.pencil().run("SELECT table_name || ' ' FROM gpkg_contents ORDER BY rowid", &layers);
    EXPECT_EQ(layers, "source_lines source_areas nets corridors grounds ");
    EXPECT_EQ(call(draft.project, "check own/scenario.ini").code, 0);
}

TEST(Drawing, HasAMapThatShowsEachLayerOverAHillshade) {
    const Draft draft;
    const std::string map = draft.project.read("own/drawing.qgs");
    EXPECT_TRUE(map.starts_with("<!DOCTYPE qgis "));
    EXPECT_EQ(text_checks::markup_fault(map), "");
    for (const DrawingLayer& layer : drawing_layers()) {
        EXPECT_TRUE(has(map, "<datasource>./drawing.gpkg|layername=" + std::string{layer.name} + "<"));
    }
    EXPECT_TRUE(has(map, "<datasource>../dem.asc<"));
    EXPECT_TRUE(has(map, "type=\"hillshade\""));
    EXPECT_TRUE(has(map, "<xmin>1000</xmin>"));
}

TEST(Drawing, IsReadAndWrittenByGdal) {
    const Draft draft;
    if (shell(draft.project, "command -v ogrinfo && command -v ogr2ogr").code != 0) {
        GTEST_SKIP() << "GDAL is not installed";
    }
    for (const DrawingLayer& layer : drawing_layers()) {
        const Outcome seen =
            shell(draft.project, "ogrinfo -ro -so own/drawing.gpkg " + std::string{layer.name});
        EXPECT_EQ(seen.code, 0) << seen.err;
        EXPECT_EQ(seen.err, "");
        EXPECT_TRUE(has(seen.out, "Feature Count: 0")) << seen.out;
        EXPECT_TRUE(has(seen.out, "Austria Lambert")) << seen.out;
    }
    // As somebody draws: a road, with its triggers, by another program.
    draft.project.write("road.csv", "name,wkt\nForest road,\"LINESTRING (1105 2010, 1105 2090)\"\n");
    const Outcome drawn =
        shell(draft.project,
              "ogr2ogr -update -append own/drawing.gpkg road.csv -nln roads -nlt PROMOTE_TO_MULTI "
              "-oo GEOM_POSSIBLE_NAMES=wkt -oo KEEP_GEOM_COLUMNS=NO");
    ASSERT_EQ(drawn.code, 0) << drawn.err;
    const Outcome run = call(draft.project, "run own/scenario.ini --out out --set release.rocks=500 --quiet");
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_TRUE(has(draft.project.read("out/tables/targets.csv"), "Forest road"));
}

}  // namespace
}  // namespace coupling::drawing_test
