#include "forest/treatment/groups.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/forest/small_forest.hpp"

namespace forest::groups_test {
namespace {

/// Ten trees on every patch; on one patch they are thicker.
Stand ripe_at(const SpeciesTable& species, int side, std::uint32_t ripe) {
    const PatchGrid grid = square_of_forest(side);
    std::vector<Tree> trees;
    for (std::uint32_t p = 0; p < grid.size(); ++p) {
        for (int i = 0; i < 10; ++i) {
            trees.push_back(new_tree(species.all()[0], SpeciesId{0}, grid.x_centre_m(PatchId{p}) - 4.5 + i,
                                     grid.y_centre_m(PatchId{p}), p == ripe ? 50.0 : 20.0, 20.0, 80.0));
            trees.back().id = TreeId{p * 10 + static_cast<std::uint64_t>(i)};
        }
    }
    return {grid, species.size(), trees, 2000};
}

std::vector<std::size_t> all_of(const Stand& stand) {
    return trees_in(stand, {});
}

TEST(RipestGroups, BeginWhereMostWoodStands) {
    const SpeciesTable species = SpeciesTable::shipped();
    const Stand stand = ripe_at(species, 10, 47);
    const auto holes = ripest_groups(stand, species, all_of(stand), {}, {.side_m = 10.0, .area_share = 0.01});
    ASSERT_EQ(holes.size(), 1U);
    EXPECT_TRUE(config::point_in_polygon(
        holes[0], {stand.grid().x_centre_m(PatchId{47}), stand.grid().y_centre_m(PatchId{47})}));
}

TEST(RipestGroups, KeepToTheShareOfTheAreaAndToTheirDistance) {
    const SpeciesTable species = SpeciesTable::shipped();
    const Stand stand = ripe_at(species, 20, 3);
    const auto holes = ripest_groups(stand, species, all_of(stand), {}, {.side_m = 25.0, .area_share = 0.1});
    EXPECT_EQ(holes.size(), 6U) << "0.4 ha of 4 ha hold six holes of 0.0625 ha";
    for (std::size_t a = 0; a < holes.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b) {
            const config::Point2 p = holes[a].parts[0][0];
            const config::Point2 q = holes[b].parts[0][0];
            EXPECT_GE(std::max(std::abs(p.x_m - q.x_m), std::abs(p.y_m - q.y_m)), 50.0);
        }
    }
    EXPECT_TRUE(
        ripest_groups(stand, species, all_of(stand), {}, {.side_m = 25.0, .area_share = 0.01}).empty());
}

TEST(RipestGroups, StayInTheirArea) {
    const SpeciesTable species = SpeciesTable::shipped();
    const Stand stand = ripe_at(species, 12, 0);
    const TreatmentArea area{{rectangle({60.0, 60.0}, 60.0, 60.0, {})}, {}};
    const auto holes =
        ripest_groups(stand, species, all_of(stand), area, {.side_m = 20.0, .area_share = 1.0});
    EXPECT_FALSE(holes.empty());
    for (const config::Shape& hole : holes) {
        for (const config::Point2 corner : hole.parts[0]) {
            EXPECT_GE(corner.x_m, 30.0);
            EXPECT_LE(corner.x_m, 90.0);
            EXPECT_GE(corner.y_m, 30.0);
            EXPECT_LE(corner.y_m, 90.0);
        }
    }
}

}  // namespace
}  // namespace forest::groups_test
