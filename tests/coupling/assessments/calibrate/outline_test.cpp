#include "coupling/assessments/calibrate/model/outline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "coupling/assessments/calibrate/model/seen_of.hpp"
#include "coupling/assessments/calibrate/search/self_distance.hpp"
#include "coupling/assessments/calibrate/sites/observation_checks.hpp"
#include "tests/coupling/inputs/opened.hpp"

namespace coupling::calibrate::outline_test {
namespace {

/// The sample slope, where sources are cells of 10 m from 1020 to 1030 east, and an outline below them.
class DepositOutlines : public testing::Test {
protected:
    [[nodiscard]] const Opened& with(const std::string& polygon, std::vector<std::string> settings = {}) {
        project_.write("outline.csv", "wkt\n\"POLYGON ((" + polygon + "))\"\n");
        settings.push_back("observed.outline=outline.csv");
        opened_ = std::make_unique<Opened>(open(project_, settings));
        EXPECT_TRUE(opened_->site) << opened_->errors;
        return *opened_;
    }
    [[nodiscard]] Eigen::Vector2d at(double x_m, double y_m) const {
        return Eigen::Vector2d{x_m, y_m} - opened_->site->origin_m();
    }

    SampleProject project_;
    std::unique_ptr<Opened> opened_;
};

const std::string rectangle = "1040 2040, 1080 2040, 1080 2060, 1040 2060, 1040 2040";

TEST_F(DepositOutlines, ReachTheirFurthestSide) {
    const Opened& opened = with(rectangle);
    const Outline outline{*opened.site, opened.scenario->calibrate};
    EXPECT_NEAR(outline.reach_m, std::hypot(50.0, 5.0), 0.1);  // from the nearest source to the far corners
    EXPECT_GE(outline.reach_m, outline.sources.at(at(1079.9, 2050)));
    EXPECT_GT(outline.reach_m, outline.sources.at(at(1060, 2050)) + 10.0);
    EXPECT_TRUE(outline.holds(at(1060, 2050)));
    EXPECT_FALSE(outline.holds(at(1060, 2070)));
}

TEST_F(DepositOutlines, AroundStopsLeaveHalfOfTheOthersBeyondTheirFarEnd) {
    const Opened& opened = with(rectangle);
    const Outline outline{*opened.site, opened.scenario->calibrate};
    std::vector<double> distances;
    for (int i = 0; i < 100; ++i) {
        distances.push_back(i);
    }
    // Two of 50: 0, 2, ... 98 and 1, 3, ... 99; 97.5 % lie below place 0.975 * 49.
    const std::vector<double> reaches = outline.reaches_around(distances);
    ASSERT_EQ(reaches.size(), 2U);
    EXPECT_NEAR(reaches[0], 2.0 * 0.975 * 49.0, 1e-9);
    EXPECT_NEAR(reaches[1], 1.0 + 2.0 * 0.975 * 49.0, 1e-9);
    EXPECT_EQ(outline.reaches_around(std::span{distances}.first(3)).size(), 1U);
    EXPECT_TRUE(outline.reaches_around({}).empty());
}

TEST_F(DepositOutlines, AreAShareAndAReach) {
    const Opened& opened = with(rectangle, {"calibrate.outline_percent=90", "calibrate.outline_blocks=30"});
    const std::vector<Observation> all = observations_on(*opened.site, opened.scenario->calibrate, 1);
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(all[0].fit.size(), 30U);
    EXPECT_DOUBLE_EQ(figure_of(all[0].fit, {}), 0.9);
    EXPECT_EQ(all[1].fit.size(), 1U);
    EXPECT_TRUE(all[0].held_out.empty() && all[1].held_out.empty());
    EXPECT_EQ(number_of(all, &Observation::fit), 1U);
    EXPECT_NE(all[0].witness, all[1].witness);
}

/// Rocks that stop evenly between 0 and `longest_m` below the sources.
SetRocks evenly(double longest_m, std::uint64_t number, const Eigen::Vector2d& origin_m) {
    config::RandomStream stream{{1, 0, 0, number}, config::Purpose::parameter};
    const Eigen::Vector2d start_m = Eigen::Vector2d{1030.0, 2050.0} - origin_m;
    SetRocks rocks;
    for (int i = 0; i < 300; ++i) {
        rocks.ends.push_back(
            {start_m, start_m + Eigen::Vector2d{longest_m * stream.uniform(), 0.0}, 1, 0.5F});
    }
    return rocks;
}

TEST_F(DepositOutlines, ThatTheModelMakesAreAsNearToItAsItIsToItself) {
    // Of stops evenly on 64 m, 95 % lie on the inner 60.8 m.
    const Opened& opened = with("1031.6 2040, 1092.4 2040, 1092.4 2060, 1031.6 2060, 1031.6 2040");
    const std::vector<Observation> all = observations_on(*opened.site, opened.scenario->calibrate, 1);
    ASSERT_EQ(all.size(), 2U);
    const auto seen_by = [&](double longest_m, std::uint64_t number) {
        std::vector<Sample> samples;
        for (const Observation& observation : all) {
            samples.push_back(seen_of(evenly(longest_m, number, opened.site->origin_m()), observation, {}));
        }
        return samples;
    };
    std::vector<std::vector<Sample>> sets;
    for (std::uint64_t set = 0; set < 20; ++set) {
        sets.push_back(seen_by(64.0, set));
    }
    std::vector<Witnessed> observed;
    for (const Observation& observation : all) {
        observed.push_back({observation.fit.size(), observation.witness, observation.least_scale()});
    }
    const SelfDistance scale = self_distance(sets, observed, 1, 1);
    const auto distance_of = [&](double longest_m) {
        const std::vector<Sample> seen = seen_by(longest_m, 99);
        return scale.together({energy_distance(all[0].fit, thinned(seen[0], all[0].fit.size())),
                               energy_distance(all[1].fit, thinned(seen[1], 1))});
    };
    EXPECT_LE(distance_of(64.0), scale.at_95);
    EXPECT_GT(distance_of(32.0), scale.at_95) << "too short: all within, but far from the end";
    EXPECT_GT(distance_of(85.0), scale.at_95) << "too far: beyond the end";
}

TEST_F(DepositOutlines, OffTheTerrainAreRefused) {
    const Opened& opened = with("5000 2040, 5080 2040, 5080 2060, 5000 2060, 5000 2040");
    config::Warnings warnings;
    EXPECT_THROW(check_observations(*opened.scenario, *opened.site, warnings), config::InputError);
    project_.write("stops.csv", "x_m,y_m\n1060,2050\n");
    const Opened& both = with(rectangle, {"observed.stops=stops.csv"});
    check_observations(*both.scenario, *both.site, warnings);
    bool says_twice = false;
    for (const auto& warning : warnings.warnings()) {
        says_twice = says_twice || warning.find("they count twice") != std::string::npos;
    }
    EXPECT_TRUE(says_twice);
}

}  // namespace
}  // namespace coupling::calibrate::outline_test
