#include "coupling/assessments/today/figures/path_series.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace coupling {
namespace {

using rockfall::PathPoint;
using rockfall::PathRecord;

constexpr double g = 9.81;

/// A rock of 100 kg thrown eastward from 20 m, drawn by corners every 0.01 s, that loses half of its motion
/// at the ground and stops there.
PathRecord thrown() {
    PathRecord path{1, rockfall::Cover::bare, {}};
    const double end_s = std::sqrt(2.0 * 20.0 / g);
    for (int k = 0; k <= 200; ++k) {
        const double t = end_s * k / 200.0;
        PathPoint point{};
        point.position_m = {5.0 * t, 0.0, 20.0 - 0.5 * g * t * t};
        point.time_s = static_cast<float>(t);
        point.speed_mps = static_cast<float>(std::hypot(5.0, g * t));
        point.energy_j = static_cast<float>(50.0 * (25.0 + g * g * t * t));
        path.points.push_back(point);
    }
    PathPoint after = path.points.back();
    after.energy_j *= 0.5F;
    path.points.push_back(after);
    return path;
}

TEST(PathSeries, HasTheLawsOfFlight) {
    const PathRecord path = thrown();
    const std::vector<PathMoment> moments = series_of(path, 100.0, 0.1);
    ASSERT_EQ(moments.size(), 22U);  // 0 to 2.0 s, and the end at 2.0193 s
    EXPECT_EQ(moments.front().displacement_m, 0.0);
    EXPECT_FALSE(moments.front().acceleration_mps2.has_value());
    for (std::size_t k = 0; k < 21; ++k) {
        const double t = 0.1 * static_cast<double>(k);
        EXPECT_NEAR(moments[k].time_s, t, 1e-12);
        EXPECT_NEAR(moments[k].speed_mps, std::hypot(5.0, g * t), 1e-3);
        EXPECT_NEAR(moments[k].displacement_m, std::hypot(5.0 * t, 0.5 * g * t * t), 1e-3);
        EXPECT_NEAR(moments[k].taken_j(), 0.0, 0.5) << "flight takes nothing";
        if (k > 0 && k < 20) {
            EXPECT_NEAR(moments[k].acceleration_mps2.value_or(0.0), g, 0.03);
        }
    }
    EXPECT_FALSE(moments[20].acceleration_mps2.has_value()) << "less than a step before the end";
}

TEST(PathSeries, EndsWithWhatTheLastCornerHas) {
    const PathRecord path = thrown();
    const PathMoment end = series_of(path, 100.0, 0.1).back();
    EXPECT_NEAR(end.time_s, std::sqrt(40.0 / g), 1e-6);
    EXPECT_NEAR(end.displacement_m, std::hypot(5.0 * end.time_s, 20.0), 1e-5);
    EXPECT_NEAR(end.taken_j(), 0.5 * (100.0 * g * 20.0 + 1250.0), 1.0);
}

TEST(PathSeries, SpreadsABlowOverTheStep) {
    // Along a line at 10 m/s until 1.05 s, then at 4 m/s.
    PathRecord path{1, rockfall::Cover::bare, {}};
    for (const auto& [t, x] : {std::pair{0.0, 0.0}, std::pair{1.05, 10.5}, std::pair{3.05, 18.5}}) {
        PathPoint point{};
        point.position_m = {x, 0.0, 0.0};
        point.time_s = static_cast<float>(t);
        path.points.push_back(point);
    }
    double sum = 0.0;
    for (const PathMoment& moment : series_of(path, 100.0, 0.1)) {
        sum += 0.1 * moment.acceleration_mps2.value_or(0.0);
    }
    EXPECT_NEAR(sum, 6.0, 1e-4) << "the change of the velocity, whatever the step";
}

}  // namespace
}  // namespace coupling
