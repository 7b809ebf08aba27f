#include "coupling/assessments/collapse/collapse_site.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "config/table/table.hpp"
#include "coupling/inputs/collapse_settings.hpp"
#include "tests/coupling/assessments/collapse/collapse_project.hpp"

namespace coupling::collapse {
namespace {

class CollapseSites : public ::testing::Test {
protected:
    void SetUp() override { write_small_collapse(project); }
    CollapseSite open(const std::vector<std::string>& overrides = {}) const {
        config::Warnings warnings;
        return open_collapse(*read_collapse(project.file("scenario.ini"), overrides), warnings);
    }
    SampleProject project;
};

TEST_F(CollapseSites, BlocksHaveTheVolumeOfTheBody) {
    const CollapseSite site = open();
    ASSERT_GT(site.count.free, 20U);
    EXPECT_EQ(site.blocks.size(), site.count.free + site.count.fixed);
    EXPECT_NEAR(site.count.blocks_m3 + site.count.left_out_m3, site.count.body_m3, 1e-6 * site.count.body_m3);
    double volume_m3 = 0.0;
    for (std::size_t i = 0; i < site.blocks.size(); ++i) {
        EXPECT_EQ(site.blocks[i].fixed, i >= site.count.free);
        volume_m3 += i < site.count.free ? site.blocks[i].solid.volume_m3 : 0.0;
    }
    EXPECT_NEAR(volume_m3, site.count.blocks_m3, 1e-6 * volume_m3);
    // The polygon of the example has 24 m by 44 m, its depth is 18 m.
    EXPECT_NEAR(site.count.body_m3, 24.0 * 44.0 * 18.0, 1.0);
}

TEST_F(CollapseSites, HasAFaceOfEachPairEitherOpenOrBonded) {
    const CollapseSite closed = open({"collapse.base_persistence=0"});
    const CollapseSite at_base_open = open({"collapse.base_persistence=1"});
    EXPECT_EQ(closed.count.bonds + closed.count.open_faces,
              at_base_open.count.bonds + at_base_open.count.open_faces);
    EXPECT_GT(closed.count.bonds, at_base_open.count.bonds);
    const auto to_fixed = [](const CollapseSite& site) {
        return std::count_if(site.bonds.begin(), site.bonds.end(),
                             [&](const auto& bond) { return bond.second >= site.count.free; });
    };
    EXPECT_EQ(to_fixed(at_base_open), 0);
    EXPECT_GT(to_fixed(closed), 0);
}

TEST_F(CollapseSites, LeavesNoBlockSmallerThanTheLeast) {
    const CollapseSite coarse = open({"collapse.least_block_m=4"});
    const CollapseSite fine = open({"collapse.least_block_m=1"});
    EXPECT_LT(coarse.count.free, fine.count.free);
    for (std::size_t i = 0; i < coarse.count.free; ++i) {
        EXPECT_GE(std::cbrt(coarse.blocks[i].solid.volume_m3), 4.0 - 1e-6);
    }
}

TEST_F(CollapseSites, IsCutTheSameWayEachTimeAndOtherwiseWithAnotherSeed) {
    const CollapseSite first = open(), again = open(), other = open({"run.seed=2"});
    ASSERT_EQ(first.blocks.size(), again.blocks.size());
    for (std::size_t i = 0; i < first.blocks.size(); ++i) {
        EXPECT_EQ(first.blocks[i].centre_m, again.blocks[i].centre_m);
    }
    EXPECT_TRUE(first.blocks.size() != other.blocks.size() ||
                first.blocks[0].centre_m != other.blocks[0].centre_m);
}

std::vector<rockfall::rock_mass::JointSet> sets_of(const std::string& text) {
    std::istringstream in{text};
    const config::Table table = config::Table::read(in, "joints.csv");
    CollapseSettings settings;
    settings.strength_factor = 0.5;
    return joint_sets_of(table, settings);
}

TEST(JointSetsOfATable, TakeTheStrengthOfTheRockWhereTheyNameNone) {
    const auto sets = sets_of(
        "name,dip_deg,dip_direction_deg,spacing_m,spacing_law,persistence,tensile_mpa\n"
        "a,40,90,3,lognormal,0.25,2\nb,80,270,4,,,\n");
    ASSERT_EQ(sets.size(), 2U);
    EXPECT_EQ(sets[0].law, rockfall::rock_mass::SpacingLaw::lognormal);
    EXPECT_DOUBLE_EQ(sets[0].persistence, 0.25);
    EXPECT_DOUBLE_EQ(sets[0].strength.tensile_pa, 1e6);
    EXPECT_DOUBLE_EQ(sets[0].strength.shear_pa, 13e6);
    EXPECT_DOUBLE_EQ(sets[1].strength.tensile_pa, 18e6);
    EXPECT_DOUBLE_EQ(sets[1].persistence, 1.0);
}

}  // namespace
}  // namespace coupling::collapse
