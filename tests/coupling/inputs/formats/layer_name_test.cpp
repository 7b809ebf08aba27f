#include "coupling/inputs/formats/layer_name.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace coupling::layer_name_test
