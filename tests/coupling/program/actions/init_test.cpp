#include "coupling/program/actions/init.hpp"

#include <gtest/gtest.h>

#include "config/errors/input_error.hpp"
#include "coupling/examples/embedded.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/program/actions/estimate.hpp"
#include "rockfall/motion/models.hpp"
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

double no_pilot(const Scenario&, const Site&) {
    ADD_FAILURE() << "a model of known speed needs no pilot";
    return 0.0;
}

TEST(Estimate, CountsTheMapsOfEveryThread) {
    const SampleProject project;
    const Opened opened = open(project);
    ASSERT_TRUE(opened.site) << opened.errors;
    const Estimate one = estimate_of(*opened.scenario, *opened.site, 1, no_pilot);
    const Estimate three = estimate_of(*opened.scenario, *opened.site, 3, no_pilot);
    EXPECT_EQ(one.rocks, 20U);
    EXPECT_EQ(one.covers, 2);
    EXPECT_EQ(three.map_bytes, 2 * one.map_bytes);
    EXPECT_EQ(three.percentile_bytes, one.percentile_bytes);
    EXPECT_NEAR(3.0 * three.seconds, one.seconds, 1e-12);
}

TEST(Estimate, GivesEachModelItsOwnSpeed) {
    const SampleProject project;
    const auto seconds = [&](const std::string& model) {
        const Opened opened = open(project, {"rockfall.motion=" + model});
        EXPECT_TRUE(opened.site) << opened.errors;
        return opened.site ? estimate_of(*opened.scenario, *opened.site, 1, no_pilot).seconds : 0.0;
    };
    const double picus_s = seconds("picus");
    for (const rockfall::MotionModel model : rockfall::all_models()) {
        const rockfall::ModelDescription& description = rockfall::description_of(model);
        if (description.us_per_path_m == 0.0) {
            continue;  // timed by a pilot
        }
        const double times = description.us_per_path_m / rockfall::description_of({}).us_per_path_m;
        EXPECT_NEAR(seconds(std::string{description.name}) / picus_s, times, 1e-9 * times)
            << description.name;
    }
}

}  // namespace
}  // namespace coupling::init_test
