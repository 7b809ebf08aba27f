// Each shipped example and each kind of run through an archive: init, run, pack, verify --rerun, from another
// working directory and in another home. And archives that reach outside of themselves.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>

#include "config/text/sha256.hpp"
#include "coupling/examples/embedded.hpp"
#include "coupling/results/pack/manifest.hpp"
#include "coupling/results/pack/zip_file.hpp"
#include "tests/runs/program.hpp"

namespace coupling::archives_test {
namespace {

namespace fs = std::filesystem;

/// Settings that let an example run in seconds: fewer rocks, years, replicates. The paths of the program are
/// those of the whole example.
std::string short_settings(const std::string& example) {
    static const std::map<std::string, std::string> settings{
        {"calibrate", "--set release.rocks=200"},
        {"calibrate-sites", "--set release.rocks=200"},
        {"calibrate-tschamut", "--set output.sample_paths=10"},
        {"collapse", "--set collapse.duration_s=0.02 --set collapse.settle_s=0"},
        {"collapse-small", "--set collapse.duration_s=0.5 --set collapse.settle_s=0.5"},
        {"forest", "--set run.years=2 --set output.map_years=0,2 --set output.tree_list_years=0,2"},
        {"jura", "--set release.rocks=60"},
        {"profile", "--set release.rocks=200"},
        {"regimes",
         "--set run.years=1 --set run.replicates=1 --set release.rocks=30 --set output.map_years=0,1"},
        {"regimes-small",
         "--set run.years=1 --set run.rockfall_every=1 --set run.replicates=2 --set release.rocks=30 --set "
         "output.map_years=0,1"},
        {"tyrol", "--set release.rocks=200 --set output.xlsx=yes --set output.geotiff=yes"}};
    return settings.at(example);
}

const char* command_of(const std::string& example) {
    return example.starts_with("collapse") ? "collapse" : "run";
}

/// Names of the files below a folder whose bytes hold a text.
std::string files_with(const fs::path& folder, const std::string& text) {
    std::string found;
    for (const auto& entry : fs::recursive_directory_iterator{folder}) {
        std::ostringstream bytes;
        if (entry.is_regular_file()) {
            bytes << std::ifstream{entry.path(), std::ios::binary}.rdbuf();
        }
        if (bytes.str().find(text) != std::string::npos) {
            found += entry.path().lexically_relative(folder).string() + " ";
        }
    }
    return found;
}

/// Verifies an archive of `project` as someone else would: copied, from another folder, in another home.
Outcome repeated_elsewhere(const SampleProject& project, const std::string& archive) {
    const SampleProject elsewhere;
    fs::create_directories(elsewhere.file("home"));
    fs::copy_file(project.file(archive), elsewhere.file("copied.zip"));
    return shell(elsewhere, "mkdir deep && cd deep && HOME='" + elsewhere.file("home").string() +
                                "' \"$bannwald\" verify ../copied.zip --rerun --threads 1 --out again\n");
}

class EveryExample : public testing::TestWithParam<std::string> {};

TEST_P(EveryExample, RepeatsItsArchiveElsewhere) {
    const SampleProject project;
    const std::string example = GetParam();
    ASSERT_EQ(call(project, "init t --quiet --example " + example).code, 0);
    // Named from above and by the whole path: both are in the messages of no result.
    const Outcome run =
        call(project, std::string{command_of(example)} + " '" + project.file("t/scenario.ini").string() +
                          "' --quiet --threads 1 " + short_settings(example));
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(files_with(project.file("t/out"), project.folder().string()), "");
    const Outcome packed = call(project, "pack t/out --out archive.zip");
    ASSERT_EQ(packed.code, 0) << packed.err;
    const Outcome again = repeated_elsewhere(project, "archive.zip");
    EXPECT_EQ(again.code, 0) << again.out << again.err;
    EXPECT_NE(again.out.find("same bytes in every file"), std::string::npos) << again.out << again.err;
}

/// Shipped examples, the large or the others: a large one cuts a cliff or reads a landscape for minutes, and
/// has a small sister that takes the same way.
std::vector<std::string> examples(bool large) {
    std::vector<std::string> names = example_names();
    std::erase_if(
        names, [&](const std::string& name) { return (name == "collapse" || name == "regimes") != large; });
    return names;
}

std::string as_test_name(const testing::TestParamInfo<std::string>& example) {
    std::string name = example.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Archives, EveryExample, testing::ValuesIn(examples(false)), as_test_name);
INSTANTIATE_TEST_SUITE_P(LongArchives, EveryExample, testing::ValuesIn(examples(true)), as_test_name);

TEST(Archives, HoldEveryReturnPeriodOfAHazardRun) {
    const SampleProject project;
    ASSERT_EQ(call(project, "init t --quiet --example jura").code, 0);
    ASSERT_EQ(call(project, "run t/scenario.ini --quiet " + short_settings("jura")).code, 0);
    ASSERT_EQ(call(project, "pack t/out --quiet").code, 0);
    const pack::ZipReader zip{project.file("t/out.zip")};
    std::size_t periods = 0;
    for (const auto& entry : fs::directory_iterator{project.file("t/out")}) {
        const std::string folder = entry.path().filename().string();
        if (folder.starts_with("return_period_")) {
            ++periods;
            EXPECT_TRUE(zip.has("results/" + folder + "/summary.json")) << folder;
            EXPECT_TRUE(zip.has("results/" + folder + "/tables/targets.csv")) << folder;
        }
    }
    EXPECT_GE(periods, 2U);
    EXPECT_TRUE(zip.has("results/hazard/summary.json"));
    const Outcome map_alone = call(project, "pack t/out/hazard");
    EXPECT_EQ(map_alone.code, 2);
    EXPECT_NE(map_alone.err.find("the folder above it, which holds its return periods too"),
              std::string::npos)
        << map_alone.err;
}

TEST(Archives, ArePossibleForOneReturnPeriodAndForNets) {
    const SampleProject project;
    ASSERT_EQ(call(project, "init t --quiet").code, 0);
    ASSERT_EQ(call(project,
                   "run t/scenario.ini --quiet --set hazard.blocks=return_periods.csv --set "
                   "hazard.return_period_years=30 --set nets.file=nets.csv --set release.rocks=200 --set "
                   "nets.keep_paths=yes")
                  .code,
              0);
    ASSERT_EQ(call(project, "pack t/out --quiet --out archive.zip").code, 0);
    const Outcome again = repeated_elsewhere(project, "archive.zip");
    EXPECT_EQ(again.code, 0) << again.out << again.err;
}

/// The same inputs from anywhere: below the scenario, beside it, by whole paths, on the command line.
TEST(Archives, TakeInputsFromOutsideOfTheProjectIn) {
    const SampleProject project;
    fs::create_directories(project.file("secret_a/project"));
    fs::create_directories(project.file("secret_b"));
    for (const char* name : {"dem.asc", "dem.prj", "source.asc"}) {
        fs::rename(project.file(name), project.file("secret_a") / name);
    }
    fs::rename(project.file("trees.csv"), project.file("secret_b/trees.csv"));
    fs::rename(project.file("targets.csv"), project.file("secret_b/targets.csv"));
    for (const char* name : {"scenario.ini", "surface.asc", "surface_types.csv"}) {
        fs::rename(project.file(name), project.file("secret_a/project") / name);
    }
    project.replace("secret_a/project/scenario.ini", "dem = dem.asc", "dem = ../dem.asc   ; heights");
    project.replace("secret_a/project/scenario.ini", "source = source.asc",
                    "source = " + project.file("secret_a/source.asc").string());
    project.replace("secret_a/project/scenario.ini", "surface = surface.asc",
                    "surface = " + project.file("secret_a/project/surface.asc").string());
    project.replace("secret_a/project/scenario.ini", "file = targets.csv",
                    "file = \"" + project.file("secret_b/targets.csv").string() + "\"");
    const Outcome run =
        call(project, "run secret_a/project/scenario.ini --quiet --out results --set trees.file='" +
                          project.file("secret_b/trees.csv").string() + "'");
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(files_with(project.file("results"), "secret"), "");
    // People read what the scenario has, or the name of the file alone.
    const std::string page = project.read("results/report.html");
    EXPECT_EQ(page.find("outside/"), std::string::npos);
    EXPECT_EQ(page.find("outside_2/"), std::string::npos);
    EXPECT_NE(page.find("<td>../dem.asc</td>"), std::string::npos);
    EXPECT_NE(page.find("<td>trees.csv</td>"), std::string::npos);
    const std::string summary = project.read("results/summary.json");
    for (const char* name : {"outside/dem.asc", "outside/dem.prj", "outside/source.asc",
                             "outside_2/trees.csv", "\"surface.asc\""}) {
        EXPECT_NE(summary.find(name), std::string::npos) << name;
    }
    const std::string pack = "pack results --scenario secret_a/project/scenario.ini";
    const Outcome unknown = call(project, pack);
    EXPECT_EQ(unknown.code, 2);
    EXPECT_NE(unknown.err.find("add it, such as --set trees.file=PATH"), std::string::npos) << unknown.err;
    const Outcome packed =
        call(project, pack + " --set trees.file='" + project.file("secret_b/trees.csv").string() + "'");
    ASSERT_EQ(packed.code, 0) << packed.err;
    const pack::ZipReader zip{project.file("results.zip")};
    for (const std::string& name : zip.names()) {
        EXPECT_EQ(zip.text(name, 1U << 26U).find("secret"), std::string::npos) << name;
    }
    const std::string scenario = zip.text("inputs/scenario.ini", 1U << 16U);
    EXPECT_NE(scenario.find("dem = outside/dem.asc   ; heights\n"), std::string::npos) << scenario;
    EXPECT_NE(scenario.find("surface = surface.asc\n"), std::string::npos) << scenario;
    const Outcome again = repeated_elsewhere(project, "results.zip");
    EXPECT_EQ(again.code, 0) << again.out << again.err;
}

TEST(Archives, RefuseFilesFromOutsideThatATableNames) {
    const SampleProject project;
    fs::create_directories(project.file("project"));
    project.write("part.stl",
                  "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 100 0 0\nvertex 0 100 50\n"
                  "endloop\nendfacet\nfacet normal 0 0 1\nouter loop\nvertex 100 0 0\nvertex 100 100 50\n"
                  "vertex 0 100 50\nendloop\nendfacet\nendsolid\n");
    project.write("project/meshes.csv", "file,surface\n../part.stl,solid_rock\n");
    project.write("project/points.csv", "wkt\n\"POINT (50 90)\"\n");
    project.write("project/scenario.ini",
                  "[terrain]\nmeshes = meshes.csv\n[release]\nsource_shapes = points.csv\nrocks = 5\n");
    ASSERT_EQ(call(project, "run project/scenario.ini --quiet").code, 0);
    const Outcome packed = call(project, "pack project/out");
    EXPECT_EQ(packed.code, 2);
    EXPECT_NE(packed.err.find("named in a table by a path outside of the project folder"), std::string::npos)
        << packed.err;
}

/// The same scenario in any folder, called in any way.
TEST(Archives, ResultsHaveTheSameBytesFromEveryFolder) {
    const SampleProject project;
    // A warning and a note that name files.
    project.write("trees.csv", project.read("trees.csv") + "4,5000,2050,PIAB,30,20\n");
    fs::create_directories(project.file("a/b"));
    ASSERT_EQ(shell(project,
                    "cp *.* a/b/\n\"$bannwald\" run scenario.ini --quiet --out one || exit 1\n"
                    "cd a && \"$bannwald\" run b/scenario.ini --quiet --out ../two || exit 1\n"
                    "cd / && HOME=/nowhere \"$bannwald\" run '" +
                        project.file("a/b/scenario.ini").string() + "' --quiet --out '" +
                        project.file("three").string() + "'\n")
                  .code,
              0);
    EXPECT_NE(project.read("one/summary.json").find("\"trees.csv: "), std::string::npos)
        << project.read("one/summary.json");
    const Outcome compared = shell(project, "diff -r one two && diff -r one three\n");
    EXPECT_EQ(compared.code, 0) << compared.out;
}

/// On the screen an error still says where the file lies from here.
TEST(Archives, ErrorsOnTheScreenNamePaths) {
    const SampleProject project;
    project.write("trees.csv", "tree_id,x_m,y_m,species,dbh_cm,height_m\n1,1060,2050,ABAL,thick,25\n");
    const Outcome run = call(project, "run ../" + project.folder().filename().string() + "/scenario.ini");
    EXPECT_EQ(run.code, 4);
    EXPECT_NE(run.err.find("bannwald: ../" + project.folder().filename().string() + "/trees.csv:2"),
              std::string::npos)
        << run.err;
}

/// An archive of a stranger: its checksums are right, its scenario reads what it should not.
class ForgedArchive : public SampleProject {
public:
    ForgedArchive() {
        EXPECT_EQ(call(*this, "run scenario.ini --quiet").code, 0);
        EXPECT_EQ(call(*this, "pack out --quiet").code, 0);
    }
    /// Packed again with a text replaced in one entry.
    [[nodiscard]] Outcome verified(const std::string& entry, const std::string& from,
                                   const std::string& to) const {
        const pack::ZipReader honest{file("out.zip")};
        std::vector<pack::ListedFile> listed;
        {
            pack::ZipWriter forged{file("forged.zip")};
            for (const std::string& name : honest.names()) {
                std::string text = honest.text(name, 1U << 26U);
                if (name == pack::manifest_name) {
                    continue;
                }
                if (name == entry) {
                    const std::size_t at = text.find(from);
                    EXPECT_NE(at, std::string::npos) << text;
                    text.replace(std::min(at, text.size()), from.size(), to);
                }
                listed.push_back({name, config::sha256_of(text)});
                forged.add_text(name, text);
            }
            forged.add_text(pack::manifest_name, pack::manifest_text(listed));
            forged.close();
        }
        fs::remove_all(file("forged-rerun"));
        return call(*this, "verify forged.zip --rerun --quiet");
    }
};

TEST(Archives, ReadNothingOutsideOfThemselves) {
    const ForgedArchive archive;
    const auto refused = [&](const std::string& entry, const std::string& from, const std::string& to) {
        const Outcome forged = archive.verified(entry, from, to);
        EXPECT_EQ(forged.code, 4) << to << forged.err;
        EXPECT_NE(forged.err.find("found the input '"), std::string::npos) << to << forged.err;
    };
    // Every name for a setting, and every setting for a name.
    for (const std::string file :
         {"/etc/passwd", "../../../../etc/passwd", "../scenario.ini", "..", "sub/../../../dem.asc"}) {
        refused("inputs/scenario.ini", "dem = dem.asc", "dem = " + file);
    }
    for (const std::string key : {"surface = ", "file = ", "source = "}) {
        refused("inputs/scenario.ini", "\n" + key, "\n" + key + "/etc/passwd ; ");
    }
    refused("inputs/scenario.ini", "[targets]", "[report]\nlogo = /etc/passwd\n[targets]");
    refused("run.json", "\"overrides\": []", "\"overrides\": [\"trees.logs=../../dem.asc\"]");
    const Outcome profile = archive.verified("inputs/scenario.ini", "dem = dem.asc", "profile = /etc/passwd");
    EXPECT_EQ(profile.code, 4);
    EXPECT_EQ(profile.err.find("root"), std::string::npos) << profile.err;
    EXPECT_EQ(archive.verified("run.json", "\"kind\": \"today\"", "\"kind\": \"shell\"").code, 4);
}

TEST(Archives, NameTheProgramWithAuthorLicenceAndCommit) {
    const ForgedArchive archive;
    const pack::ZipReader zip{archive.file("out.zip")};
    const std::string crate = zip.text("ro-crate-metadata.json", 1U << 20U);
    EXPECT_NE(crate.find("The Bannwald developers"), std::string::npos);
    EXPECT_NE(crate.find("https://spdx.org/licenses/GPL-3.0-or-later"), std::string::npos);
    const std::string run = zip.text("run.json", 1U << 16U);
    for (const char* key :
         {"\"authors\"", "\"licence\": \"GPL-3.0-or-later\"", "\"kind\": \"today\"", "\"commit\""}) {
        EXPECT_NE(run.find(key), std::string::npos) << run;
    }
    EXPECT_NE(zip.text("README.md", 1U << 16U).find("by The Bannwald developers, licence GPL-3.0-or-later"),
              std::string::npos);
}

}  // namespace
}  // namespace coupling::archives_test
