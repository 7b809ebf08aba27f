// Nets that are dragged on a page have the numbers of `net try`, and what the page refuses `net try` refuses.

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "config/text/numbers.hpp"
#include "coupling/assessments/nets/figures/net_try.hpp"
#include "coupling/assessments/nets/moving/near_paths.hpp"
#include "coupling/inputs/nets/net_input.hpp"
#include "coupling/inputs/tables/csv_row.hpp"
#include "tests/runs/motion_models.hpp"
#include "tests/runs/nets.hpp"
#include "tests/runs/years.hpp"

namespace coupling::moving_nets_test {
namespace {

constexpr const char* script = "node \"" BANNWALD_SOURCE_DIR "/tests/runs/move_nets.mjs\" ";

bool has_node(const SampleProject& project) {
    return shell(project, "command -v node >/dev/null\n").code == 0;
}

/// As the tables write it: with as many decimals as stand there.
std::string written_like(const std::string& field, const std::string& number) {
    const std::optional<double> value = config::parse_number(number);
    if (!value) {
        return number;
    }
    const std::size_t dot = field.find('.');
    std::ostringstream text;
    CsvRow row{text};
    row.number(*value, dot == std::string::npos ? 0 : static_cast<int>(field.size() - dot - 1));
    row.end();
    return text.str().substr(0, text.str().size() - 1);
}

/// How many fields were compared.
std::size_t expect_same(const config::Table& tried, const config::Table& shown, const std::string& what) {
    EXPECT_EQ(tried.rows(), shown.rows()) << what;
    std::size_t compared = 0;
    for (std::size_t row = 0; row < std::min(tried.rows(), shown.rows()); ++row) {
        for (const std::string& column : shown.columns()) {
            const std::string& expected = tried.text(row, column);
            EXPECT_EQ(written_like(expected, shown.text(row, column)), expected)
                << what << ", row " << row << ", " << column;
            compared += expected.empty() ? 0U : 1U;
        }
    }
    return compared;
}

class MovingNets : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Motion, MovingNets, ::testing::ValuesIn(motion_model_names()),
                         [](const auto& model) { return model.param; });

TEST_P(MovingNets, HaveTheNumbersOfNetTryWhereverTheyAreDragged) {
    const SampleProject project;
    if (!has_node(project)) {
        GTEST_SKIP() << "node is not installed";
    }
    add_nets(project);
    const Outcome run =
        call(project,
             "run scenario.ini --quiet --set nets.keep_paths=yes --set design.rule=own --set "
             "design.energy_factor=1.2 --set design.height_factor=1.1 --set design.freeboard_m=0.5 "
             "--out out " +
                 rocks_for(GetParam(), 3000) + motion_settings(GetParam()));
    ASSERT_EQ(run.code, 0) << run.err;
    constexpr int lines = 6;
    const Outcome moved =
        shell(project, script + std::string{"out/report.html moved "} + std::to_string(lines) + "\n");
    ASSERT_EQ(moved.code, 0) << moved.out << moved.err;
    std::size_t compared = 0;
    for (int line = 1; line <= lines; ++line) {
        const std::string name = "moved/" + std::to_string(line);
        const Outcome tried =
            call(project, "net try out --quiet --overwrite --out tried --nets " + name + ".csv");
        ASSERT_EQ(tried.code, 0) << tried.err;
        compared +=
            expect_same(table(project, "tried/nets.csv"), table(project, name + "_figures.csv"), name);
    }
    for (const char* reason : {"itself", "short", "one_place", "height", "gap", "capacity", "ground"}) {
        const std::string name = "moved/refused_" + std::string{reason} + ".csv";
        EXPECT_EQ(call(project, "net try out --quiet --overwrite --out tried --nets " + name).code, 4)
            << reason;
    }
    EXPECT_GT(compared, lines * 4U * 13U);  // two nets on two slopes; the rest needs rocks at them
}

/// Where the paths do not fit, one rock in so many is kept and its figures are those of the sample.
TEST(MovingNetsSample, KeepsOneRockInSoManyWhereThePathsDoNotFit) {
    const SampleProject project;
    add_nets(project);
    ASSERT_EQ(
        call(project, "run scenario.ini --quiet --set nets.keep_paths=yes --set release.rocks=400 --out out")
            .code,
        0);
    NetPathsReader paths{project.file("out/net_paths.bin")};
    std::vector<std::string> remarks;
    const std::vector<NetRecord> nets =
        nets_on(project.file("nets.csv"), {paths.terrain()}, Standing::together, remarks);
    const auto all = moving::paths_near(paths, nets);
    ASSERT_TRUE(all.has_value());
    EXPECT_EQ(all->every, 1U);
    EXPECT_EQ(all->width_m, 60.0);
    EXPECT_EQ(all->rocks, paths.head().rocks);
    const auto some = moving::paths_near(paths, nets, 100'000);
    ASSERT_TRUE(some.has_value());
    EXPECT_GT(some->every, 1U);
    EXPECT_EQ(some->width_m, 25.0);
    EXPECT_EQ(some->rocks[1], (paths.head().rocks[1] + some->every - 1) / some->every);
    ASSERT_EQ(some->figures.size(), 4U);
    for (const NetFigures& of : some->figures) {
        EXPECT_EQ(of.reached.whole, some->rocks[static_cast<std::size_t>(of.cover)]);
    }
    // Not even the ground fits.
    EXPECT_FALSE(moving::paths_near(paths, nets, 100).has_value());
}

TEST(MovingNetsPage, HasMapsWithTheNetsAndSaysHowMuchIsCounted) {
    const SampleProject project;
    add_nets(project);
    const std::string rocks = "run scenario.ini --quiet --set release.rocks=1000 ";
    ASSERT_EQ(call(project, rocks + "--set nets.keep_paths=yes --out out").code, 0);
    const std::string page = project.read("out/report.html");
    EXPECT_NE(page.find("<h3 class=\"screen-only\">Move the nets</h3>"), std::string::npos);
    EXPECT_NE(page.find("60 m around each net"), std::string::npos);
    EXPECT_NE(page.find("All rocks are counted"), std::string::npos);
    EXPECT_NE(page.find("data-net=\"1\""), std::string::npos);
    ASSERT_EQ(call(project, rocks + "--out without").code, 0);
    EXPECT_EQ(project.read("without/report.html").find("Move the nets"), std::string::npos);
}

}  // namespace
}  // namespace coupling::moving_nets_test
