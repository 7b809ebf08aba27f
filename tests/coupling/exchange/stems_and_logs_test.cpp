#include "coupling/exchange/stems_and_logs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/coupling/inputs/forest_project.hpp"

namespace coupling::exchange::stems_and_logs_test {
namespace {

struct Forest {
    [[nodiscard]] const ForestSite& site() const { return *opened.site->forest; }
    [[nodiscard]] Obstacles obstacles_of(const forest::Stand& stand,
                                         const std::vector<rockfall::Stem>& standing = {}) const {
        return stems_and_logs_of(stand, site().species.fracture_energy, standing);
    }
    ForestProject project;
    Opened opened = open(project, {"trees.file=", "stands.records=records.csv"});
};

TEST(StemsAndLogs, AreTheTreesFromTheLimitOnAndNoOthers) {
    const Forest forest;
    const forest::Stand stand = forest.site().start(1, 0);
    const Obstacles obstacles = forest.obstacles_of(stand);
    ASSERT_EQ(obstacles.stems.size(), obstacles.trees.size());
    std::size_t expected = 0;
    for (const forest::Tree& tree : stand.trees()) {
        expected += tree.dbh_cm >= least_obstacle_cm ? 1 : 0;
    }
    ASSERT_GT(expected, 100U);
    EXPECT_EQ(obstacles.stems.size(), expected);
    for (std::size_t i = 0; i < obstacles.stems.size(); ++i) {
        ASSERT_NE(obstacles.trees[i], nullptr);
        EXPECT_EQ(obstacles.stems[i].dbh_cm, obstacles.trees[i]->dbh_cm);
        EXPECT_EQ(obstacles.stems[i].x_m, obstacles.trees[i]->x_m);
        EXPECT_EQ(obstacles.stems[i].height_m, obstacles.trees[i]->height_m);
        EXPECT_DOUBLE_EQ(obstacles.stems[i].strength, 1.0);  // a sound stem
    }
}

TEST(StemsAndLogs, NameNoTreeForStemsThatDoNotGrow) {
    const Forest forest;
    const forest::Stand stand = forest.site().start(1, 0);
    const rockfall::Stem post{1000.0, 2000.0, 30.0, 20.0, 1.0};
    const Obstacles obstacles = forest.obstacles_of(stand, {post});
    EXPECT_EQ(obstacles.stems.size(), forest.obstacles_of(stand).stems.size() + 1);
    EXPECT_EQ(obstacles.stems.back().dbh_cm, 30.0);
    EXPECT_EQ(obstacles.trees.back(), nullptr);
}

TEST(StemsAndLogs, LayALogAlongTheGroundSoThatItsLengthInSpaceStays) {
    const Forest forest;
    const forest::Stand start = forest.site().start(1, 0);
    const forest::Tree& tree = start.trees().front();
    const forest::PatchGrid& grid = start.grid();
    const auto place = grid.at(tree.x_m, tree.y_m);
    ASSERT_TRUE(place);
    const forest::Patch& patch = grid[*place];
    ASSERT_GT(patch.slope.in_degrees(), 1.0);
    forest::Log log{.x_m = tree.x_m, .y_m = tree.y_m, .length_m = 10.0};
    // Down the fall line: the plan length is that of the slope's cosine. Across it: the length itself.
    const double downhill_rad = std::numbers::pi / 2.0 - patch.aspect.in_radians();
    log.direction_rad = static_cast<decltype(log.direction_rad)>(downhill_rad);
    EXPECT_NEAR(plan_length_m(log, grid), 10.0 * std::cos(patch.slope.in_radians()), 1e-5);
    log.direction_rad = static_cast<decltype(log.direction_rad)>(downhill_rad + std::numbers::pi / 2.0);
    EXPECT_NEAR(plan_length_m(log, grid), 10.0, 1e-5);
}

}  // namespace
}  // namespace coupling::exchange::stems_and_logs_test
