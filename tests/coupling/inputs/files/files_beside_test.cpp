#include "coupling/inputs/files/files_beside.hpp"

#include <gtest/gtest.h>

#include "tests/coupling/inputs/formats/given_files.hpp"

namespace coupling::files_beside_test {
namespace {

TEST(PathBeside, FindsPartsInAnySpelling) {
    const SampleProject project;
    const auto found = [&](const std::string& file, const std::string& ending) {
        return path_beside(project.file(file), ending).filename().string();
    };
    for (const char* name : {"ROAD.SHP", "ROAD.SHX", "Road.dbf", "house.SHX", "Dem2.PRJ", "map.gpkg-wal"}) {
        project.write(name, name);
    }
    EXPECT_EQ(found("ROAD.SHP", ".shx"), "ROAD.SHX");
    EXPECT_EQ(found("ROAD.SHP", ".dbf"), "Road.dbf");
    EXPECT_EQ(found("house.shp", ".shx"), "house.SHX");
    EXPECT_EQ(found("dem2.asc.gz", ".prj"), "Dem2.PRJ");
    EXPECT_EQ(found("DEM2.ASC.GZ", ".prj"), "Dem2.PRJ");
    EXPECT_EQ(found("map.gpkg", "-wal"), "map.gpkg-wal");
    EXPECT_EQ(found("Map.gpkg", "-wal"), "Map.gpkg-wal");  // of another file
    project.write("house.shx", "");
    EXPECT_EQ(found("house.shp", ".shx"), "house.shx");  // its very name comes first
}

TEST(PathBeside, NamesWhatWouldStandThere) {
    const SampleProject project;
    EXPECT_EQ(path_beside(project.file("lone.asc"), ".prj"), project.file("lone.prj"));
    EXPECT_EQ(path_beside(project.file("LONE.ASC"), ".prj"), project.file("LONE.PRJ"));
    EXPECT_EQ(path_beside("no/such/folder/dem.asc", ".prj"), "no/such/folder/dem.prj");
    EXPECT_FALSE(std::filesystem::exists(project.file("lone.prj")));
}

TEST(FilesBeside, ReadsAShapefileInCapitals) {
    const SampleProject project;
    for (const char* ending : {".shp", ".shx", ".dbf", ".prj"}) {
        std::string capitals = ending;
        std::transform(capitals.begin(), capitals.end(), capitals.begin(),
                       [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
        project.write("ROAD" + capitals, given_file(std::string{"road"} + ending));
    }
    FilesBeside beside{project.file("ROAD.SHP")};
    const formats::ReadLayer read =
        formats::read_layer_file(project.read("ROAD.SHP"), "", "ROAD.SHP", beside.bytes());
    EXPECT_EQ(read.layer.table.rows(), 1U);
    EXPECT_EQ(read.layer.projection, given_file("road.prj"));
}

}  // namespace
}  // namespace coupling::files_beside_test
