#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <string>

#include "tests/runs/years.hpp"

namespace coupling::oversized_input_test {
namespace {

/// The errors in what the program printed, without its warnings.
std::size_t errors_in(const std::string& text) {
    std::size_t errors = 0;
    std::istringstream lines{text};
    for (std::string line; std::getline(lines, line);) {
        errors += line.starts_with("bannwald: ") && !line.starts_with("bannwald: warning: ") ? 1 : 0;
    }
    return errors;
}

void expect_refused(const Outcome& outcome, int code, const std::string& message) {
    EXPECT_EQ(outcome.code, code) << outcome.err;
    EXPECT_NE(outcome.err.find(message), std::string::npos) << outcome.err;
    EXPECT_EQ(errors_in(outcome.err), 1U) << outcome.err;
    EXPECT_LT(outcome.err.size(), 10'000U);
}

TEST(OversizedInput, PackedGridsHoldNoMoreThanTheirHeaderSays) {
    const SampleProject project;
    project.replace("scenario.ini", "dem.asc", "dem.asc.gz");
    // 64 MB of blanks after a grid of 120 values.
    const Outcome outcome =
        shell(project,
              "(cat dem.asc; head -c 64000000 /dev/zero | tr '\\0' ' ') | gzip -1 > dem.asc.gz\n"
              "\"$bannwald\" check scenario.ini\n");
    expect_refused(outcome, 4, "dem.asc.gz: found a gzip file that holds more than 1 MB, expected");
}

TEST(OversizedInput, PackedGridsOfTheirSizeAreRead) {
    const SampleProject project;
    project.replace("scenario.ini", "dem.asc", "dem.asc.gz");
    const Outcome outcome = shell(project, "gzip dem.asc && \"$bannwald\" check scenario.ini\n");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
}

TEST(OversizedInput, PackedTablesHoldNoMoreThanABound) {
    const SampleProject project;
    project.replace("scenario.ini", "trees.csv", "trees.csv.gz");
    const Outcome outcome =
        shell(project,
              "(cat trees.csv; head -c 600000000 /dev/zero | tr '\\0' ' ') | gzip -1 > trees.csv.gz\n"
              "\"$bannwald\" check scenario.ini\n");
    expect_refused(outcome, 4, "trees.csv.gz: found a gzip file that holds more than 537 MB, expected");
}

TEST(OversizedInput, FieldsAndLinesWithoutEndAreRefused) {
    const SampleProject project;
    const std::string head = "x_m,y_m,species,dbh_cm\n1060,2050,";
    project.write("trees.csv", head + std::string(50'000'000, 'P') + ",30\n");
    expect_refused(call(project, "check scenario.ini"), 4,
                   "trees.csv:2:11: found a field of more than 10 million bytes, expected");
    project.write("trees.csv", head + std::string(4'000'000, 'P') + ",30\n");
    expect_refused(call(project, "check scenario.ini"), 4, "trees.csv:2:11: found species 'PPP");
    project.write("trees.csv", head + std::string(12'000'000, ',') + "\n");
    expect_refused(call(project, "check scenario.ini"), 4, "found a line of more than 1000 fields, expected");
}

TEST(OversizedInput, ScenariosOfAnotherKindAreRefused) {
    const SampleProject project;
    project.write("scenario.ini", "[terrain]\n" + std::string(50'000'000, 'x') + " = 1\n");
    expect_refused(call(project, "check scenario.ini"), 2, "scenario.ini: found 50000015 bytes, more than");
    project.write("scenario.ini", "[terrain]\n" + std::string(1'000'000, 'x') + " = 1\n");
    expect_refused(call(project, "check scenario.ini"), 2, "scenario.ini:2:1: found key 'terrain.xxx");
}

TEST(FormulaText, InIdsIsTold) {
    const SampleProject project;
    project.replace("targets.csv", "road,road", "=cmd|' /C calc'!A0,road");
    const Outcome outcome = call(project, "run scenario.ini --set release.rocks=50");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const std::string doubt =
        "targets.csv:2:1: found target_id '=cmd|' /C calc'!A0', which a spreadsheet takes";
    EXPECT_NE(outcome.err.find("bannwald: warning: " + doubt), std::string::npos) << outcome.err;
    EXPECT_NE(project.read("out/summary.json").find("targets.csv:2:1: found target_id"), std::string::npos);
    // It stands in the results as it was given, so that they can be joined.
    EXPECT_NE(project.read("out/tables/targets.csv").find("=cmd|' /C calc'!A0"), std::string::npos);
    EXPECT_EQ(call(project, "check scenario.ini --set run.strict_inputs=yes").code, 4);
}

TEST(StoredPaths, AreRefusedWithAnyByteChanged) {
    const SampleProject project;
    project.write("nets.csv",
                  "name,height_m,capacity_kj,wkt\nlower,3,250,\"LINESTRING (1098 2005, 1098 2095)\"\n");
    ASSERT_EQ(
        call(project, "run scenario.ini --quiet --set release.rocks=20 --set nets.keep_paths=yes --out out")
            .code,
        0);
    const std::string whole = project.read("out/net_paths.bin");
    ASSERT_EQ(call(project, "net try out --nets nets.csv --out whole").code, 0);
    for (std::size_t i = 0; i < 60; ++i) {
        std::string damaged = whole;
        const std::size_t at = 8 + i * (whole.size() - 9) / 59;
        damaged[at] = static_cast<char>(damaged[at] ^ (1 << (i % 8)));
        project.write("out/net_paths.bin", damaged);
        const Outcome outcome = call(project, "net try out --nets nets.csv --out tried");
        EXPECT_EQ(outcome.code, 3) << at << ": " << outcome.err;
        EXPECT_NE(outcome.err.find("found stored paths that are cut off or damaged"), std::string::npos)
            << at << ": " << outcome.err;
        EXPECT_FALSE(std::filesystem::exists(project.file("tried")));
    }
    for (const std::size_t size : {std::size_t{0}, std::size_t{100}, whole.size() / 2, whole.size() - 1}) {
        project.write("out/net_paths.bin", whole.substr(0, size));
        EXPECT_EQ(call(project, "net try out --nets nets.csv --out tried").code, 3) << size << " bytes";
    }
}

}  // namespace
}  // namespace coupling::oversized_input_test
