#include "coupling/assessments/collapse/collapse_record.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/rockfall/rock_mass/scenes.hpp"

namespace coupling::collapse {
namespace {

using rockfall::rock_mass::RockMass;
namespace scenes = rockfall::rock_mass::scenes;

/// Two cubes that fly eastward over a map of 10 x 10 cells of 2 m, across a line at x = 5 m.
CollapseSite flying_site() {
    CollapseSite site;
    for (const double y : {4.0, 12.0}) {
        site.blocks.push_back(scenes::cube_at({1.0, y, 50.0}, 1.0));
        site.blocks.back().velocity_mps = {20.0, 0.0, 0.0};
    }
    site.count.free = 2;
    site.map_frame.columns = 10;
    site.map_frame.rows = 10;
    site.map_frame.cell_width_m = site.map_frame.cell_height_m = 2.0;
    rockfall::Target line;
    line.parts = {{{5.0, 0.0}, {5.0, 20.0}}};
    site.targets.push_back(rockfall::with_bounds(line));
    return site;
}

RockMass mass_of(const CollapseSite& site) {
    return {scenes::lossless(), site.blocks, {}, rockfall::rock_mass::Ground{}};
}

/// A record of half a second, looked at every 0.05 s.
void fly(const CollapseSite& site, RockMass& mass, CollapseRecord& record) {
    record.add_frame(site, mass);
    for (int look = 1; look <= 10; ++look) {
        while (mass.time_s() < 0.05 * look) {
            mass.step();
        }
        record.observe(site, mass);
    }
    record.add_frame(site, mass);
}

TEST(CollapseRecord, CountsEachBlockOnceInEachCellAndAtEachTarget) {
    const CollapseSite site = flying_site();
    RockMass mass = mass_of(site);
    CollapseRecord record{site};
    fly(site, mass, record);
    double passages = 0.0;
    for (const double blocks : record.cell_blocks) {
        EXPECT_LE(blocks, 1.0);
        passages += blocks;
    }
    EXPECT_EQ(passages, 2.0 * 5.0);  // from 2 to 11 m: five cells in each of two rows
    ASSERT_EQ(record.hits.size(), 2U);
    for (const TargetHit& hit : record.hits) {
        EXPECT_NEAR(hit.time_s, 0.2, 0.051);
        EXPECT_NEAR(hit.speed_mps, 20.0, 1e-9);
        EXPECT_NEAR(hit.energy_j, 0.5 * 2500.0 * 400.0, 1e-3);
    }
    EXPECT_NEAR(record.rows.back().front_m, 20.0 * mass.time_s(), 1e-6);
    EXPECT_NEAR(record.rows.back().mean_speed_mps, 20.0, 1e-9);
}

TEST(CollapseRecord, HasTheAccelerationOfFreeFallAndTheFloorThatBlocksPassOver) {
    CollapseSite site = flying_site();
    rockfall::Target house;
    house.is_area = true;
    house.parts = {{{6.0, 0.0}, {10.0, 0.0}, {10.0, 8.0}, {6.0, 8.0}, {6.0, 0.0}}};
    site.targets.push_back(rockfall::with_bounds(house));
    auto laws = scenes::lossless();
    laws.gravity_mps2 = 9.81;
    RockMass mass{laws, site.blocks, {}, rockfall::rock_mass::Ground{}};
    CollapseRecord record{site};
    fly(site, mass, record);
    EXPECT_EQ(record.rows.front().mean_acceleration_mps2, 0.0);
    EXPECT_NEAR(record.rows.back().mean_acceleration_mps2, 9.81, 1e-4);
    EXPECT_NEAR(record.rows.back().largest_acceleration_mps2, 9.81, 1e-4);
    EXPECT_NEAR(record.frames.back()[0].velocity().z(), -9.81 * mass.time_s(), 1e-4);
    // One of the two cubes flies over the house, at y = 4: a strip as wide as the sphere of its volume.
    const double radius_m = std::cbrt(3.0 / (4.0 * std::numbers::pi));
    EXPECT_EQ(record.floors[0].floor_m2(), 0.0);
    EXPECT_NEAR(record.floors[1].floor_m2(), 32.0, 1e-9);
    EXPECT_NEAR(record.floors[1].reached_m2(0.0), 4.0 * 2.0 * radius_m, 0.4);
    const auto hit = std::find_if(record.hits.begin(), record.hits.end(),
                                  [](const TargetHit& one) { return one.target == 1.0; });
    ASSERT_NE(hit, record.hits.end());
    EXPECT_EQ(hit->wall, 3.0) << "the western wall";
}

TEST(CollapseRecord, GoesOnFromItsNumbersAndRefusesOthers) {
    const CollapseSite site = flying_site();
    RockMass mass = mass_of(site);
    CollapseRecord record{site};
    fly(site, mass, record);
    const std::vector<double> numbers = record.packed();
    CollapseRecord resumed{site};
    ASSERT_TRUE(resumed.unpack(numbers));
    EXPECT_EQ(resumed.packed(), numbers);
    // What was reached before is not reached again.
    RockMass again = mass_of(site);
    fly(site, again, resumed);
    EXPECT_EQ(resumed.hits.size(), 2U);
    for (std::size_t size = 0; size < numbers.size(); size += 7) {
        EXPECT_FALSE(CollapseRecord{site}.unpack(std::span{numbers}.first(size))) << size;
    }
    std::vector<double> longer = numbers;
    longer.push_back(0.0);
    EXPECT_FALSE(CollapseRecord{site}.unpack(longer));
}

}  // namespace
}  // namespace coupling::collapse
