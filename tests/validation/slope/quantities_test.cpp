#include "validation/engine/slope/quantities.hpp"

#include <gtest/gtest.h>

#include "validation/engine/factors/outcome.hpp"

namespace coupling::validation::quantities_test {
namespace {

using rockfall::StopReason;

/// Three rocks filled by hand; station "net" at line 0, the lower end at line 1.
Falls three_rocks() {
    Falls falls;
    falls.lines = 2;
    falls.rocks = {
        {.reason = StopReason::caught,
         .end_m = 60.0,
         .max_speed_mps = 10.0,
         .mean_speed_mps = 5.0,
         .max_height_m = 1.0,
         .jump_height_sum_m = 2.0,
         .jump_length_sum_m = 8.0,
         .jumps = 4,
         .landed_jumps = 2,
         .impacts = 5,
         .tree_hits = 2,
         .trees_broken = 1},
        {.reason = StopReason::tree,
         .end_m = 110.0,
         .max_speed_mps = 20.0,
         .mean_speed_mps = 7.0,
         .max_height_m = 3.0,
         .jump_height_sum_m = 6.0,
         .jump_length_sum_m = 22.0,
         .jumps = 4,
         .landed_jumps = 4,
         .impacts = 7,
         .tree_hits = 1,
         .trees_broken = 1},
        {.reason = StopReason::left_terrain,
         .end_m = 160.0,
         .max_speed_mps = 30.0,
         .mean_speed_mps = 9.0,
         .max_height_m = 2.0,
         .jump_height_sum_m = 4.0,
         .jump_length_sum_m = 0.0,
         .jumps = 2,
         .landed_jumps = 0,
         .impacts = 3},
    };
    falls.arrivals.resize(6);
    falls.arrivals[2] = {.reached = true, .energy_j = 100e3F, .translational_j = 80e3F, .speed_mps = 10.0F};
    falls.arrivals[4] = {.reached = true, .energy_j = 300e3F, .translational_j = 260e3F, .speed_mps = 20.0F};
    falls.arrivals[5] = {.reached = true, .y_m = 3.0F};
    falls.hit_heights_m = {0.5F, 1.0F, 1.5F};
    return falls;
}

const FigureFrame frame{10.0, 200.0, 0.5, {{"A", 0.0, 100.0}, {"B", 100.0, 200.0}}, {"net"}};

double figure(const std::string& name) {
    return figures_of(three_rocks(), frame).at(name);
}

TEST(Figures, OfSpeed) {
    EXPECT_DOUBLE_EQ(figure("max_speed_mean_mps"), 20.0);
    EXPECT_DOUBLE_EQ(figure("max_speed_p90_mps"), 28.0);  // 0.8 of the way from 20 to 30
    EXPECT_DOUBLE_EQ(figure("max_speed_max_mps"), 30.0);
    EXPECT_DOUBLE_EQ(figure("mean_speed_mps"), 7.0);
}

TEST(Figures, OfHeightCountJumpsNotRocks) {
    EXPECT_DOUBLE_EQ(figure("max_height_max_m"), 3.0);
    EXPECT_DOUBLE_EQ(figure("jump_height_mean_m"), 12.0 / 10.0);
    for (const std::string name : {"max_height_max", "max_height_p90", "jump_height_mean"}) {
        EXPECT_DOUBLE_EQ(figure(name + "_centre_m"), figure(name + "_m") + frame.radius_m) << name;
    }
}

TEST(Figures, OfTreeHits) {
    EXPECT_DOUBLE_EQ(figure("tree_hits_mean"), 1.0);
    EXPECT_DOUBLE_EQ(figure("hit_height_mean_m"), 1.0);
    EXPECT_DOUBLE_EQ(figure("broken_share"), 2.0 / 3.0);
}

TEST(Figures, OfRunOutBeginAtTheStart) {
    EXPECT_DOUBLE_EQ(figure("run_out_mean_m"), 100.0);
    EXPECT_DOUBLE_EQ(figure("run_out_deviation_m"), 50.0);
    EXPECT_DOUBLE_EQ(figure("impacts_mean"), 5.0);
    EXPECT_DOUBLE_EQ(figure("jump_length_mean_m"), 5.0);
}

TEST(Figures, OfSectionsCountOnlyWhatStopped) {
    EXPECT_DOUBLE_EQ(figure("stopped_share:A"), 1.0 / 3.0);
    EXPECT_DOUBLE_EQ(figure("stopped_share:B"), 1.0 / 3.0);  // the third rock left the terrain there
}

TEST(Figures, OfStationsCountOnlyWhatArrives) {
    EXPECT_DOUBLE_EQ(figure("reaching_share:net"), 2.0 / 3.0);
    EXPECT_DOUBLE_EQ(figure("energy_mean_kj:net"), 200.0);
    EXPECT_NEAR(figure("energy_deviation_kj:net"), 100.0 * std::sqrt(2.0), 1e-9);
    EXPECT_DOUBLE_EQ(figure("energy_p90_kj:net"), 280.0);
    EXPECT_DOUBLE_EQ(figure("translational_mean_kj:net"), 170.0);
    EXPECT_DOUBLE_EQ(figure("speed_mean_mps:net"), 15.0);
}

TEST(Figures, ThatNoRockGivesAreNotNumbers) {
    Falls falls = three_rocks();
    falls.hit_heights_m.clear();
    falls.arrivals.assign(6, {});
    const auto figures = figures_of(falls, frame);
    EXPECT_TRUE(std::isnan(figures.at("hit_height_mean_m")));
    EXPECT_TRUE(std::isnan(figures.at("energy_mean_kj:net")));
    EXPECT_TRUE(std::isnan(figures.at("lateral_dispersion")));
    EXPECT_DOUBLE_EQ(figures.at("reaching_share:net"), 0.0);
}

TEST(Figures, OfDispersionAreTheWidthOf95PercentOverTheSlopeLength) {
    Falls falls;
    falls.lines = 1;
    for (int i = 0; i <= 100; ++i) {
        falls.rocks.push_back({});
        falls.arrivals.push_back({.reached = true, .y_m = static_cast<float>(i)});
    }
    const FigureFrame alone{0.0, 190.0, 0.5, {}, {}};
    EXPECT_NEAR(figures_of(falls, alone).at("lateral_dispersion"), 95.0 / 190.0, 1e-9);
}

TEST(Figures, OfTheBareSlopeGiveReductions) {
    std::map<std::string, double> forest{{"tree_hits_mean", 3.0}, {"mean_speed_mps", 6.0}};
    add_open(forest, {{"tree_hits_mean", 0.0}, {"mean_speed_mps", 8.0}});
    EXPECT_DOUBLE_EQ(forest.at("open.mean_speed_mps"), 8.0);
    EXPECT_DOUBLE_EQ(forest.at("reduction.mean_speed_mps"), 0.25);
    EXPECT_TRUE(std::isnan(forest.at("reduction.tree_hits_mean")));
}

TEST(FigureName, SaysWhatItIs) {
    const auto figure_name = parse_figure("reduction.reaching_share:223.5 m");
    ASSERT_TRUE(figure_name);
    EXPECT_EQ(figure_name->place, "223.5 m");
    EXPECT_EQ(figure_name->label(), "reduction of share reaching 223.5 m");
    EXPECT_EQ(figure_name->unit(), "-");
    EXPECT_FALSE(parse_figure("reaching_share"));
    EXPECT_FALSE(parse_figure("mean_speed_mps:net"));
    EXPECT_FALSE(parse_figure("speed"));
}

TEST(FigureName, EachIsComputed) {
    const auto figures = figures_of(three_rocks(), frame);
    const auto names = figure_names(frame, false);
    EXPECT_EQ(figures.size(), names.size());
    for (const std::string& name : names) {
        EXPECT_TRUE(figures.contains(name)) << name;
        EXPECT_TRUE(parse_figure(name)) << name;
    }
}

TEST(Quantile, LiesStraightBetweenOrderStatistics) {
    EXPECT_DOUBLE_EQ(quantile({4.0, 1.0, 3.0, 2.0, 5.0}, 0.9), 4.6);
    EXPECT_DOUBLE_EQ(quantile({7.0}, 0.9), 7.0);
    EXPECT_TRUE(std::isnan(quantile({}, 0.5)));
}

TEST(ValuesOf, TakesMeanAndDeviationOverSeries) {
    Ensembles ensembles;
    ensembles.large = three_rocks();
    ensembles.series.resize(2);
    ensembles.series[0].rocks = {three_rocks().rocks[0]};
    ensembles.series[1].rocks = {three_rocks().rocks[2]};
    for (Falls& series : ensembles.series) {
        series.lines = 2;
        series.arrivals.resize(2);
    }
    const Values values = values_of(ensembles, frame);
    const Value& speed = values.at("max_speed_mean_mps");
    EXPECT_DOUBLE_EQ(speed.value, 20.0);
    EXPECT_DOUBLE_EQ(speed.series.value(), 20.0);
    EXPECT_NEAR(speed.deviation.value(), 10.0 * std::sqrt(2.0), 1e-9);
    EXPECT_FALSE(values.at("energy_mean_kj:net").series);  // no series has an arrival
}

}  // namespace
}  // namespace coupling::validation::quantities_test
