#include "coupling/inputs/drawing/undrawn.hpp"

#include <gtest/gtest.h>

#include "coupling/program/actions/drawing_layers.hpp"
#include "tests/coupling/inputs/drawing/pencil.hpp"
#include "tests/coupling/inputs/opened.hpp"

namespace coupling::undrawn_test {
namespace {

/// The sample project with a drawing beside it.
struct DrawnProject {
    SampleProject project;
    DrawnProject() {
        std::vector<const DrawingLayer*> layers;
        for (const DrawingLayer& layer : drawing_layers()) {
            layers.push_back(&layer);
        }
        project.write("drawing.gpkg", empty_drawing(layers, ""));
    }
    [[nodiscard]] Opened opened(std::vector<std::string> settings) const {
        settings.emplace_back("run.drawing=drawing.gpkg");
        return open(project, settings);
    }
};

TEST(Undrawn, LayersCountAsNotGiven) {
    const DrawnProject drawn;
    const Opened opened = drawn.opened(
        {"targets.file=drawing.gpkg|roads, drawing.gpkg|houses", "nets.file=drawing.gpkg|nets",
         "trees.file=", "stands.polygons=drawing.gpkg|stands", "stands.records=drawing.gpkg|stands"});
    ASSERT_EQ(opened.errors, "");
    EXPECT_TRUE(opened.scenario->targets.file.empty());
    EXPECT_TRUE(opened.scenario->nets.file.empty());
    EXPECT_TRUE(opened.scenario->forest.stand_records.empty());
    EXPECT_TRUE(opened.site->targets.empty());
    ASSERT_EQ(opened.scenario->undrawn.size(), 4U);
    EXPECT_EQ(opened.scenario->undrawn.front().layers, (std::vector<std::string>{"roads", "houses"}));
    EXPECT_TRUE(opened.scenario->undrawn.front().is_all);
    // The drawing is an input of the run all the same: what is drawn in it later makes it another run.
    const auto& inputs = opened.site->inputs;
    EXPECT_TRUE(std::any_of(inputs.begin(), inputs.end(),
                            [](const InputFile& input) { return input.role == "drawing"; }));
}

TEST(Undrawn, WhatIsDrawnStays) {
    const DrawnProject drawn;
    Pencil{drawn.project.file("drawing.gpkg")}.line("roads", {{1105.0, 2010.0}, {1105.0, 2090.0}},
                                                    {{"name", "Road"}});
    const Opened opened = drawn.opened({"targets.file=drawing.gpkg|roads, drawing.gpkg|houses, targets.csv"});
    ASSERT_EQ(opened.errors, "");
    EXPECT_EQ(opened.scenario->targets.file, "drawing.gpkg|roads, targets.csv");
    ASSERT_EQ(opened.site->targets.size(), 3U);
    EXPECT_EQ(opened.site->targets.front().name, "Road");
    ASSERT_EQ(opened.scenario->undrawn.size(), 1U);
    EXPECT_FALSE(opened.scenario->undrawn.front().is_all);
}

TEST(Undrawn, SteepCellsStandInForSourcesUntilSomeAreDrawn) {
    const DrawnProject drawn;
    const std::vector<std::string> settings{
        "release.source=", "release.source_shapes=drawing.gpkg|source_lines, drawing.gpkg|source_areas",
        "release.undrawn_steeper_than_deg=30"};
    const Opened before = drawn.opened(settings);
    ASSERT_EQ(before.errors, "");
    EXPECT_EQ(before.site->sources.size(), 80U);  // all but the outer ring
    Pencil{drawn.project.file("drawing.gpkg")}.line("source_lines", {{1025.0, 2030.0}, {1025.0, 2070.0}});
    const Opened after = drawn.opened(settings);
    ASSERT_EQ(after.errors, "");
    EXPECT_EQ(after.site->sources.size(), 1U);
    EXPECT_EQ(after.scenario->release.steeper_than_deg, 0.0);
}

TEST(Undrawn, EmptyLayersOfOtherFilesAreStillRefusedOrWarnedOf) {
    const DrawnProject drawn;
    drawn.project.write("other.gpkg", drawn.project.read("drawing.gpkg"));
    const Opened opened = drawn.opened({"nets.file=other.gpkg|nets"});
    EXPECT_NE(opened.errors.find("at least one, or no nets.file"), std::string::npos) << opened.errors;
}

TEST(Undrawn, ADrawingIsAGeoPackage) {
    const DrawnProject drawn;
    EXPECT_NE(open(drawn.project, {"run.drawing=gone.gpkg"}).errors.find("gone.gpkg"), std::string::npos);
    EXPECT_NE(open(drawn.project, {"run.drawing=trees.csv"}).errors.find("a file that is no GeoPackage"),
              std::string::npos);
    EXPECT_NE(open(drawn.project, {"run.drawing=drawing.gpkg|nets"}).errors.find("a layer of a GeoPackage"),
              std::string::npos);
}

}  // namespace
}  // namespace coupling::undrawn_test
