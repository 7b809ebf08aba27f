#include "coupling/assessments/today/rows.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "config/table/table.hpp"

namespace coupling::rows_test {
namespace {

using rockfall::Cover;

const Eigen::Vector2d origin_m{177000.0, 377000.0};

template <class Row>
config::Table written(const TableOf<Row>& table, const Row& row) {
    std::stringstream text;
    table.write_to(text, [&](auto& rows) { rows.add(row); });
    return config::Table::read(text, "table.csv");
}

TEST(WriteRock, HasAFieldForEveryColumnAndAbsoluteCoordinates) {
    rockfall::RockRecord record;
    record.rock = 123456789012;
    record.source = 4;
    record.reason = rockfall::StopReason::left_terrain;
    record.diameter_m = 0.75F;
    record.start_m = {10.0, 20.0, 1500.126};
    record.end_m = {40.0, 60.0, 1400.0};
    record.path_m = 120.0;
    record.time_s = 10.0;
    record.max_energy_j = 12345.0;
    record.jumps = 2;
    record.jump_height_sum_m = 3.0;
    record.min_speed_mps = 0.25;
    record.long_jumps = 2;
    record.jump_length_sum_m = 9.0;
    record.min_jump_length_m = 3.5;
    record.max_jump_length_m = 5.5;
    record.impacts_by_ground = {{5, 2}, {3, 11}};
    const config::Table table = written(rock_table(), RockRow{record, Cover::forest, origin_m, 7, 3});
    ASSERT_EQ(table.rows(), 1U);
    EXPECT_EQ(table.text(0, "rock"), "123456789012");
    EXPECT_EQ(table.text(0, "cover"), "forest");
    EXPECT_EQ(table.text(0, "zone"), "7");
    EXPECT_EQ(table.text(0, "stop_reason"), "left_terrain");
    EXPECT_EQ(table.text(0, "diameter_m"), "0.750");
    EXPECT_EQ(table.text(0, "x_start_m"), "177010.00");
    EXPECT_EQ(table.text(0, "z_start_m"), "1500.13");
    EXPECT_EQ(table.text(0, "y_end_m"), "377060.00");
    EXPECT_EQ(table.text(0, "run_out_m"), "50.00");
    EXPECT_EQ(table.text(0, "azimuth_deg"), "36.9");  // 30 m east, 40 m north
    EXPECT_EQ(table.text(0, "end_ground"), "3");
    EXPECT_EQ(table.text(0, "mean_speed_mps"), "12.000");
    EXPECT_EQ(table.text(0, "max_energy_kj"), "12.345");
    EXPECT_EQ(table.text(0, "mean_jump_height_m"), "1.500");
    EXPECT_EQ(table.text(0, "min_speed_mps"), "0.250");
    EXPECT_EQ(table.text(0, "min_jump_length_m"), "3.500");
    EXPECT_EQ(table.text(0, "mean_jump_length_m"), "4.500");
    EXPECT_EQ(table.text(0, "max_jump_length_m"), "5.500");
    EXPECT_EQ(table.text(0, "impacts_by_ground"), "3:11 5:2");  // by code
}

TEST(WriteArrival, TellsWhereAndHowARockArrived) {
    const rockfall::Arrival arrival{true, false, 1.25F, 2.5F, 64000.0F, 50000.0F, 11.5F, 0.75F, 1.25F, 2.0F};
    const config::Table table =
        written(arrival_table(), ArrivalOfRock{5, "road, upper", Cover::bare, origin_m, arrival});
    ASSERT_EQ(table.rows(), 1U);
    EXPECT_EQ(table.text(0, "target_id"), "road, upper");
    EXPECT_EQ(table.text(0, "x_m"), "177001.25");
    EXPECT_EQ(table.text(0, "energy_kj"), "64.000");
    EXPECT_EQ(table.text(0, "translational_kj"), "50.000");
    EXPECT_EQ(table.text(0, "speed_mps"), "11.500");
    EXPECT_EQ(table.text(0, "height_m"), "0.750");
    EXPECT_EQ(table.text(0, "centre_height_m"), "1.250");
    EXPECT_EQ(table.text(0, "top_height_m"), "2.000");
    EXPECT_EQ(table.text(0, "by_side"), "no");
}

TEST(WriteLogHit, TellsWhatTheLogTookAndWhatBecameOfTheRock) {
    const rockfall::LogHitRecord hit{
        0, {1.0, 2.0, 1200.0}, 30000.0F, 12000.0F, rockfall::LogOutcome::climbed};
    const config::Table table =
        written(log_hit_table(), HitRow<rockfall::LogHitRecord>{5, "L7", origin_m, hit});
    ASSERT_EQ(table.rows(), 1U);
    EXPECT_EQ(table.text(0, "rock"), "5");
    EXPECT_EQ(table.text(0, "log_id"), "L7");
    EXPECT_EQ(table.text(0, "x_m"), "177001.00");
    EXPECT_EQ(table.text(0, "energy_taken_kj"), "12.000");
    EXPECT_EQ(table.text(0, "outcome"), "climbed");
}

TEST(WriteTreeHit, TellsWhatTheTreeTook) {
    const rockfall::TreeHitRecord hit{0,        {1.0, 2.0, 1200.0},         1.4F,  30000.0F,
                                      12000.0F, rockfall::HitType::scratch, false, true};
    const config::Table table =
        written(tree_hit_table(), HitRow<rockfall::TreeHitRecord>{5, "17", origin_m, hit});
    ASSERT_EQ(table.rows(), 1U);
    EXPECT_EQ(table.text(0, "tree_id"), "17");
    EXPECT_EQ(table.text(0, "energy_taken_kj"), "12.000");
    EXPECT_EQ(table.text(0, "hit_type"), "scratch");
    EXPECT_EQ(table.text(0, "broken"), "no");
    EXPECT_EQ(table.text(0, "stopped"), "yes");
}

const std::vector<rockfall::PathPoint> path{{{0.0, 0.0, 1200.0}, 1000.0F, 0.5F},
                                            {{3.0, -4.0, 1190.0}, 25000.0F, 0.0F}};

TEST(WritePath, HasOneRowAPoint) {
    const config::Table table = written(path_table(), PathRow{9, Cover::bare, 1, origin_m, path[1]});
    EXPECT_EQ(table.text(0, "point"), "1");
    EXPECT_EQ(table.text(0, "y_m"), "376996.00");
    EXPECT_EQ(table.text(0, "energy_kj"), "25.000");
}

TEST(WritePathWkt, IsALineWithHeights) {
    const config::Table table = written(wkt_table(), whole_path(9, Cover::bare, origin_m, path).value());
    EXPECT_EQ(table.text(0, "energy_max_kj"), "25.000");
    EXPECT_EQ(table.text(0, "wkt"), "LINESTRING Z (177000.00 377000.00 1200.00,177003.00 376996.00 1190.00)");
}

TEST(WritePathWkt, LeavesOutWhatIsNoLine) {
    EXPECT_FALSE(whole_path(9, Cover::bare, origin_m, std::span{path}.first(1)).has_value());
}

}  // namespace
}  // namespace coupling::rows_test
