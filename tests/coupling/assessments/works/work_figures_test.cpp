#include "coupling/assessments/works/work_figures.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace coupling::work_figures_test {
namespace {

NetRow crossing(std::uint64_t rock, float along_m, float energy_kj = 10.0F,
                rockfall::NetOutcome outcome = rockfall::NetOutcome::over, std::uint32_t net = 0) {
    NetRow made;
    made.rock = rock;
    made.crossing.net = net;
    made.crossing.along_m = along_m;
    made.crossing.energy_j = 1000.0F * energy_kj;
    made.crossing.height_m = 1.0F;
    made.crossing.radius_m = 0.5F;
    made.crossing.outcome = outcome;
    return made;
}

/// 20 m along the slope, 10 m across.
WorkRecord dam() {
    WorkRecord work;
    work.kind = WorkKind::dam;
    work.outline_m = {{0.0, 0.0}, {20.0, 0.0}, {20.0, -10.0}, {0.0, -10.0}, {0.0, 0.0}};
    work.side_ends_m = {20.0, 30.0, 50.0, 60.0};
    return work;
}

TEST(WorkFigures, SayByTheLastSideWhereARockLeft) {
    const auto outcome = [](std::initializer_list<float> along_m) {
        std::vector<NetRow> rows;
        for (const float along : along_m) {
            rows.push_back(crossing(1, along));
        }
        return outcome_at(dam(), rows);
    };
    EXPECT_EQ(outcome({5.0F}), WorkOutcome::held);
    EXPECT_EQ(outcome({5.0F, 6.0F}), WorkOutcome::back);
    EXPECT_EQ(outcome({5.0F, 25.0F}), WorkOutcome::beside);
    EXPECT_EQ(outcome({5.0F, 40.0F}), WorkOutcome::over);
    EXPECT_EQ(outcome({5.0F, 55.0F}), WorkOutcome::beside);
    EXPECT_EQ(outcome({5.0F, 6.0F, 7.0F}), WorkOutcome::held);
    EXPECT_EQ(outcome({5.0F, 6.0F, 7.0F, 40.0F}), WorkOutcome::over);
}

TEST(WorkFigures, CountEachRockOnceAndOutcomesAddUp) {
    using rockfall::NetOutcome;
    WorkRecord wall;
    wall.kind = WorkKind::wall;
    const std::vector<WorkRecord> works{dam(), wall};
    std::vector<NetRow> rows{crossing(1, 5.0F, 20.0F), crossing(2, 5.0F, 40.0F), crossing(2, 40.0F, 30.0F),
                             crossing(2, 3.0F, 25.0F, NetOutcome::broke, 1),
                             crossing(3, 8.0F, 5.0F, NetOutcome::held, 1)};
    const auto figures = work_figures(works, rows, rockfall::Cover::bare, 10);
    ASSERT_EQ(figures.size(), 2U);
    EXPECT_EQ(figures[0].reached.part, 2U);
    EXPECT_EQ(figures[0].at(WorkOutcome::held).part, 1U);
    EXPECT_EQ(figures[0].at(WorkOutcome::over).part, 1U);
    EXPECT_DOUBLE_EQ(figures[0].energy_kj.mean, 30.0) << "as they first come";
    EXPECT_DOUBLE_EQ(figures[0].height_m.max, 1.5) << "the upper edge";
    EXPECT_TRUE(std::isnan(figures[0].energy_kj.p95.value));
    EXPECT_EQ(figures[1].at(WorkOutcome::broke).part, 1U);
    EXPECT_EQ(figures[1].at(WorkOutcome::held).part, 1U);
    for (const WorkFigures& of : figures) {
        std::uint64_t sum = 0;
        for (const Share& share : of.outcome) {
            sum += share.part;
        }
        EXPECT_EQ(sum, of.reached.part);
    }
    EXPECT_EQ(work_figures(works, rows, rockfall::Cover::forest, 10)[0].reached.part, 0U);
}

TEST(WorkFigures, StandBehindTheNetsInTheIndexOfARun) {
    std::vector<NetRow> rows{crossing(1, 1.0F, 1.0F, rockfall::NetOutcome::held, 0),
                             crossing(1, 1.0F, 1.0F, rockfall::NetOutcome::over, 3),
                             crossing(2, 1.0F, 1.0F, rockfall::NetOutcome::over, 2)};
    const std::vector<NetRow> of_works = take_work_rows(rows, 2);
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_EQ(rows[0].crossing.net, 0U);
    ASSERT_EQ(of_works.size(), 2U);
    EXPECT_EQ(of_works[0].crossing.net, 1U);
    EXPECT_EQ(of_works[1].crossing.net, 0U);
}

TEST(WorkFigures, GiveThe95thPercentileThatOneRockInTwentyExceeds) {
    std::vector<NetRow> rows;
    for (std::uint64_t rock = 0; rock < 20; ++rock) {
        rows.push_back(crossing(rock, 5.0F, static_cast<float>(rock + 1)));
    }
    const std::vector<WorkRecord> works{dam()};
    const WorkFigures figures = work_figures(works, rows, rockfall::Cover::bare, 100)[0];
    EXPECT_DOUBLE_EQ(figures.energy_kj.p95.value, 19.0);
    EXPECT_DOUBLE_EQ(figures.energy_kj.p50, 10.0);
    EXPECT_TRUE(std::isnan(figures.energy_kj.p99.value));
}

}  // namespace
}  // namespace coupling::work_figures_test
