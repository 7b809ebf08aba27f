#include "coupling/assessments/today/figures/grounds.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "config/table/table.hpp"
#include "coupling/assessments/today/report/page.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "tests/coupling/results/small_run.hpp"

namespace coupling::grounds_test {
namespace {

using small_runs::SmallRun;

/// A run over two ground types of which only the second occurs.
SmallRun on_scree() {
    SmallRun run;
    rockfall::SurfaceType rock;
    rock.label = "rock";
    rockfall::SurfaceType scree;
    scree.code = 7;
    scree.label = "scree & sand";
    scree.restitution = {0.3, 0.75};
    scree.stopping = rockfall::StopCurve{{{1.0, 0.02}}};
    scree.rolling_stops_per_m = rockfall::StopCurve{{{1.0, 0.004}}};
    scree.soil = rockfall::Soil{.name = "scree_step_1",
                                .restitution = {0.35, 0.8},
                                .friction = 0.6,
                                .normal_share = {0.2, 0.1, 8.0},
                                .tangential_share = {0.2, 0.05, 8.0},
                                .friction_share = {0.3, 0.15, 6.0},
                                .sideways_rad = {0.5, 0.25, 8.0},
                                .upwards_rad = {0.5, 0.25, 8.0},
                                .threshold_tangent = 0.1};
    run.site.slope.types = {rock, scree};
    run.site.surface = config::Raster<std::uint8_t>{run.site.map_frame, 1};
    return run;
}

config::Table grounds_table(const SmallRun& run) {
    const small_runs::TestFolder folder;
    std::istringstream text{
        small_runs::text_of(folder.path() / write_grounds(folder.path(), run.results()).path)};
    return config::Table::read(text, "grounds.csv");
}

TEST(Grounds, TellWhatPicusHeedsOfThoseThatOccur) {
    const SmallRun run = on_scree();
    const config::Table table = grounds_table(run);
    ASSERT_EQ(table.rows(), 1U);
    EXPECT_EQ(table.text(0, "code"), "7");
    EXPECT_EQ(table.text(0, "ground"), "scree & sand");
    EXPECT_EQ(table.text(0, "area_share"), "1.0000");
    EXPECT_EQ(table.text(0, "r_n"), "0.300");
    EXPECT_EQ(table.text(0, "p_stop"), "0.020000");
    EXPECT_EQ(table.text(0, "rolling_stops_per_m"), "0.004000");
    EXPECT_EQ(table.text(0, "soil"), "");
    EXPECT_EQ(table.text(0, "friction"), "");
}

TEST(Grounds, TellTheSoilThatPir3dHeeds) {
    SmallRun run = on_scree();
    run.scenario->rockfall.fall.motion.model = rockfall::motion_model<rockfall::pir3d::Model>;
    const config::Table table = grounds_table(run);
    ASSERT_EQ(table.rows(), 1U);
    EXPECT_EQ(table.text(0, "soil"), "scree_step_1");
    EXPECT_EQ(table.text(0, "r_n"), "0.350");
    EXPECT_EQ(table.text(0, "friction"), "0.600");
    EXPECT_EQ(table.text(0, "threshold_deg"), "5.71");
    EXPECT_EQ(table.text(0, "dr_slow_percent"), "20.00");
    EXPECT_EQ(table.text(0, "dk_fast_percent"), "15.00");
    EXPECT_EQ(table.text(0, "limit_mps"), "8.00");
    // Where a parameter has a width or a limit of its own.
    EXPECT_EQ(table.text(0, "dr_t_slow_percent"), "20.00");
    EXPECT_EQ(table.text(0, "dr_t_fast_percent"), "5.00");
    EXPECT_EQ(table.text(0, "limit_k_mps"), "6.00");
    EXPECT_EQ(table.text(0, "limit_angle_h_mps"), "8.00");
    EXPECT_EQ(table.text(0, "p_stop"), "");
    std::ostringstream page;
    report::write_page(page, run.results(), figures_of(run.results()), {});
    const std::string html = page.str().substr(page.str().find("<h2>Ground</h2>"));
    EXPECT_NE(html.find("scree &amp; sand"), std::string::npos) << html;
    EXPECT_NE(html.find("<code>scree_step_1</code>"), std::string::npos) << html;
    EXPECT_EQ(html.find("stops at an impact"), std::string::npos) << html;
    EXPECT_NE(html.find("limit of k, m/s"), std::string::npos) << html;
    EXPECT_EQ(html.find("limit of the vertical angle"), std::string::npos) << html;  // that of R_N
}

TEST(Grounds, TellTheFrictionOfTheClassicalModel) {
    SmallRun run = on_scree();
    run.scenario->rockfall.fall.motion.model = rockfall::motion_model<rockfall::classical::Model>;
    const config::Table table = grounds_table(run);
    ASSERT_EQ(table.rows(), 1U);
    EXPECT_EQ(table.text(0, "friction"), "0.333");
    EXPECT_EQ(table.text(0, "r_t"), "0.750");
    EXPECT_EQ(table.text(0, "soil"), "");

    // The figure is that of the fall, which bounds it where the ground takes all of the speed along it.
    for (rockfall::SurfaceType& type : run.site.slope.types) {
        type.restitution.tangential = 0.0;
    }
    EXPECT_EQ(grounds_table(run).text(0, "friction"), "999.000");
}

}  // namespace
}  // namespace coupling::grounds_test
