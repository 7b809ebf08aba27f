#include "coupling/inputs/formats/layer_name.hpp"

#include <gtest/gtest.h>

#include "tests/coupling/inputs/formats/given_files.hpp"

namespace coupling::layer_name_test {
namespace {

using formats::split_layer_name;

TEST(LayerName, IsWrittenAsUsersAndQgisDo) {
    EXPECT_EQ(split_layer_name("a/map.gpkg|roads").layer, "roads");
    EXPECT_EQ(split_layer_name("a/map.gpkg|layername=roads").layer, "roads");
    EXPECT_EQ(split_layer_name("a/map.gpkg|layername=roads").file, "a/map.gpkg");
    EXPECT_EQ(split_layer_name("a/road.SHP|layername=road").layer, "");
    EXPECT_EQ(split_layer_name("trees.csv").file, "trees.csv");
    EXPECT_EQ(split_layer_name("trees.csv").layer, "");
}

// A filter of QGIS would leave out features without a word.
TEST(LayerName, RefusesWhatWouldBeDropped) {
    for (const char* part : {"subset=\"kind\" = 1", "layerid=2", "geometrytype=Point", "more"}) {
        const std::string name = std::string{"map.gpkg|layername=roads|"} + part;
        EXPECT_EQ(
            refusal_of([&] { split_layer_name(name); }),
            name + ": found the part '" + part +
                "' behind |, expected file|layer; leave it out; save the features of a filter as a layer "
                "of their own (QGIS: Save features as)");
    }
    EXPECT_NE(refusal_of([] { split_layer_name("map.gpkg|layerid=2"); }), "");
}

}  // namespace
}  // namespace coupling::layer_name_test
