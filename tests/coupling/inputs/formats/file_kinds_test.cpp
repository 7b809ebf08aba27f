#include "coupling/inputs/formats/file_kinds.hpp"

#include <gtest/gtest.h>

#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/formats/mesh_file.hpp"
#include "tests/coupling/inputs/formats/given_files.hpp"

namespace coupling::file_kinds_test {
namespace {

using formats::FileKind;

/// A small file of a kind.
std::string sample_of(const FileKind& kind) {
    std::string bytes(kind.at, ' ');
    bytes += kind.begins;
    if (!kind.root.empty()) {
        bytes += "<?xml version=\"1.0\"?>\n<!-- made by hand -->\n<!DOCTYPE x>\n<a:" +
                 std::string{kind.root == "*" ? "other" : kind.root} + " b=\"c\">\n</a>";
    }
    bytes += " 1.5 rest of it ";
    bytes += kind.holds;
    return bytes + " and more\n";
}

std::string name_of(const FileKind& kind) {
    return "given" + std::string{kind.endings.front()};
}

// Wherever a file of the user is read, each kind of the table is called by its name, with one way out.
TEST(FileKinds, AreNamedWhereverAFileIsRead) {
    for (const FileKind& kind : formats::other_file_kinds()) {
        const std::string bytes = sample_of(kind);
        const std::string name = name_of(kind);
        const std::string found = "found " + std::string{kind.name} + ", expected ";
        for (const std::string& message :
             {refusal_of([&] { formats::read_grid_file(bytes, name, nothing_beside()); }),
              refusal_of([&] { formats::read_layer_file(bytes, "", name, nothing_beside()); }),
              refusal_of([&] { meshes::read_mesh_file(bytes, name); })}) {
            EXPECT_NE(message.find(found), std::string::npos) << name << ": " << message;
            EXPECT_NE(message.find("; " + formats::advice_of(kind, name)), std::string::npos) << message;
        }
    }
}

TEST(FileKinds, AreKnownByAnyOfTheirEndingsInAnyCase) {
    for (const FileKind& kind : formats::other_file_kinds()) {
        for (const std::string_view ending : kind.endings) {
            if (!ending.empty()) {
                std::string name = "GIVEN" + std::string{ending};
                name[6] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[6])));
                EXPECT_NE(formats::other_file_kind(sample_of(kind), name), nullptr) << name;
            }
        }
    }
}

TEST(FileKinds, LeaveAloneWhatIsRead) {
    for (const char* name : {"layers.gpkg", "road.shp", "targets.geojson", "dem.tif"}) {
        EXPECT_EQ(formats::other_file_kind(given_file(name), name), nullptr) << name;
    }
    const SampleProject project;
    for (const char* name : {"dem.asc", "trees.csv", "targets.csv", "scenario.ini"}) {
        EXPECT_EQ(formats::other_file_kind(project.read(name), name), nullptr) << name;
    }
    EXPECT_EQ(formats::other_file_kind("PAR1,PAR2\n1,2\n", "table.csv"), nullptr);
    EXPECT_EQ(formats::other_file_kind("RDX;RDY\n1;2\n", "table.csv"), nullptr);
    EXPECT_EQ(formats::other_file_kind("Version;x\n1;2\n", "table.csv"), nullptr);
}

TEST(FileKinds, NameTheFileInTheirCommands) {
    const FileKind* tile = formats::other_file_kind("\1\2\3", "data/N46E007.hgt");
    ASSERT_NE(tile, nullptr);
    EXPECT_NE(formats::advice_of(*tile, "data/N46E007.hgt")
                  .find("gdalwarp -t_srs EPSG:32632 -r bilinear -dstnodata -9999 data/N46E007.hgt dem.tif"),
              std::string::npos);
    for (const FileKind& kind : formats::other_file_kinds()) {
        EXPECT_EQ(formats::advice_of(kind, "given").find(" IN"), std::string::npos) << kind.way_out;
    }
}

TEST(FileKinds, SayTheZoneOfATileByItsName) {
    const FileKind& tile = *formats::other_file_kind("\1", "N00E010.hgt");
    for (const auto& [name, code] : {std::pair{"N00E010", "32632"},
                                     {"S29W072", "32719"},
                                     {"N46E005", "32631"},
                                     {"N46E006", "32632"},
                                     {"N51W180", "32601"},
                                     {"N60E179", "32660"}}) {
        EXPECT_NE(formats::advice_of(tile, std::string{name} + ".hgt").find(std::string{"EPSG:"} + code),
                  std::string::npos)
            << name;
    }
}

TEST(FileKinds, NameFoldersThatStandForAFile) {
    const SampleProject project;
    std::filesystem::create_directory(project.file("Forest.GDB"));
    EXPECT_NE(refusal_of([&] {
                  open_file(project.file("Forest.GDB"), {}, "a layer");
              }).find("found a file geodatabase of ESRI (.gdb), '"),
              std::string::npos);
    std::filesystem::create_directory(project.file("plain"));
    EXPECT_NE(refusal_of([&] { open_file(project.file("plain"), {}, "a layer"); }).find("found a folder, '"),
              std::string::npos);
}

}  // namespace
}  // namespace coupling::file_kinds_test
