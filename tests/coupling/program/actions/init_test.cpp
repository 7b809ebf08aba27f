#include "coupling/program/actions/init.hpp"

#include <gtest/gtest.h>

#include "config/errors/input_error.hpp"
#include "coupling/examples/embedded.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/program/actions/estimate.hpp"
#include "tests/coupling/inputs/opened.hpp"

namespace coupling::init_test {
namespace {

namespace fs = std::filesystem;

TEST(Example, IsWrittenAsItLiesInTheSourceTree) {
    const SampleProject project;
    const fs::path folder = project.file("new") / "example";
    write_example(folder, "tyrol");
    std::size_t files = 0;
    for (const auto& entry :
         fs::directory_iterator{fs::path{BANNWALD_SOURCE_DIR} / "coupling/examples/tyrol"}) {
        std::ostringstream written;
        std::ostringstream original;
        written << std::ifstream{folder / entry.path().filename(), std::ios::binary}.rdbuf();
        original << std::ifstream{entry.path(), std::ios::binary}.rdbuf();
        EXPECT_EQ(written.str(), original.str()) << entry.path();
        ++files;
    }
    EXPECT_EQ(files, static_cast<std::size_t>(
                         std::distance(fs::directory_iterator{folder}, fs::directory_iterator{})));
}

TEST(Example, NeedsAnEmptyFolder) {
    const SampleProject project;
    EXPECT_THROW(write_example(project.folder(), "tyrol"), config::InputError);
    fs::create_directory(project.file("empty"));
    EXPECT_NO_THROW(write_example(project.file("empty"), "tyrol"));
    EXPECT_THROW(write_example(project.file("dem.asc"), "tyrol"), config::InputError);
    EXPECT_THROW(write_example(project.file("other"), "tirol"), config::InputError);
    EXPECT_FALSE(fs::exists(project.file("other")));
}

TEST(Example, IsAWholeProjectWithoutDoubts) {
    const SampleProject project;
    const fs::path folder = project.file("example");
    write_example(folder, "tyrol");
    config::Warnings warnings;
    const auto scenario = read_scenario(folder / "scenario.ini", {"run.strict_inputs=yes"});
    const Site site = open_site(*scenario, warnings);
    EXPECT_EQ(site.trees.size(), 25'913U);
    EXPECT_EQ(site.targets.size(), 2U);
    EXPECT_EQ(site.slope.types.size(), 4U);
    // A limit of the survey, no slip in a file: cells of 5 m lean the walls of a rock face.
    ASSERT_EQ(warnings.warnings().size(), 1U);
    EXPECT_NE(warnings.warnings().front().find("walls rise within one or two cells of 5 m"),
              std::string::npos);
    // Two species that borrow parameters, columns of two tables that say where their rows come from, and the
    // noise of the heights on four grounds.
    EXPECT_EQ(warnings.notes().size(), 8U);
}

TEST(Estimate, CountsTheMapsOfEveryThread) {
    const SampleProject project;
    const Opened opened = open(project);
    ASSERT_TRUE(opened.site) << opened.errors;
    const auto with = [&](int threads) {
        return estimate_of(*opened.scenario, *opened.site, threads, 0.0, [](const Scenario&, const Site&) {
            return PilotFalls{0.5, 3.0};
        });
    };
    const Estimate one = with(1);
    const Estimate three = with(3);
    EXPECT_EQ(one.rocks, 20U);
    EXPECT_EQ(one.covers, 2);
    EXPECT_EQ(three.map_bytes, 2 * one.map_bytes);
    EXPECT_EQ(three.percentile_bytes, one.percentile_bytes);
    EXPECT_NEAR(3.0 * three.fall_seconds, one.fall_seconds, 1e-12);
    EXPECT_EQ(three.write_seconds, one.write_seconds);
}

}  // namespace
}  // namespace coupling::init_test
