#include "validation/engine/case/profile.hpp"

#include <gtest/gtest.h>

#include "config/errors/input_error.hpp"

namespace coupling::validation::profile_test {
namespace {

TEST(ReadProfile, PutsPiecesOneBelowTheOther) {
    const Profile profile =
        read_profile("length_m,slope_deg,surface\n100,45,fine_debris\n20,0,road\n", "profile.csv");
    ASSERT_EQ(profile.size(), 3U);
    EXPECT_NEAR(profile[0].height_m, 100.0, 1e-9);
    EXPECT_DOUBLE_EQ(profile[1].distance_m, 100.0);
    EXPECT_NEAR(profile[1].height_m, 0.0, 1e-9);
    EXPECT_EQ(profile[1].surface, "road");
    EXPECT_DOUBLE_EQ(profile[2].distance_m, 120.0);
    EXPECT_NEAR(profile[2].height_m, 0.0, 1e-9);
}

TEST(ReadProfile, TakesASurveyAsItIs) {
    const Profile profile =
        read_profile("distance_m,height_m,surface\n5,1200.5,fine_debris\n20,1190,\n", "profile.csv");
    ASSERT_EQ(profile.size(), 2U);
    EXPECT_DOUBLE_EQ(profile[0].height_m, 1200.5);
    EXPECT_EQ(profile[1].surface, "fine_debris");
}

TEST(ReadProfile, TellsEveryProblemWithItsPlace) {
    try {
        read_profile("distance_m,height_m,surface\n0,100,fine_debri\n-5,high,road\n10,20,road\n", "p.csv");
        FAIL() << "should have thrown";
    } catch (const config::InputError& error) {
        ASSERT_EQ(error.problems().size(), 2U) << error.what();
        EXPECT_EQ(error.problems()[0].place.line, 2U);
        EXPECT_EQ(error.problems()[0].expected, "'fine_debris'");
        EXPECT_EQ(error.problems()[1].place.line, 3U);
    }
    EXPECT_THROW(read_profile("distance_m,height_m,surface\n0,100,road\n0,50,road\n", "p.csv"),
                 config::InputError);
    EXPECT_THROW(read_profile("length_m,slope_deg,surface\n", "p.csv"), config::InputError);
}

TEST(WithSlopeChange, MovesSteepPiecesOnlyAndKeepsTheFoot) {
    const Profile profile =
        read_profile("length_m,slope_deg,surface\n100,38,fine_debris\n50,10,road\n", "profile.csv");
    const Profile steeper = with_slope_change(profile, 2.0);
    EXPECT_NEAR(steeper[0].height_m - steeper[1].height_m, 100.0 * std::tan(40.0 * M_PI / 180.0), 1e-9);
    EXPECT_DOUBLE_EQ(steeper[1].height_m, profile[1].height_m);
    EXPECT_DOUBLE_EQ(steeper[2].height_m, profile[2].height_m);
}

TEST(HeightAt, GoesOnBeyondTheEnds) {
    const Profile profile =
        read_profile("length_m,slope_deg,surface\n100,45,fine_debris\n50,0,road\n", "profile.csv");
    EXPECT_NEAR(height_at(profile, -10.0), 110.0, 1e-9);
    EXPECT_NEAR(height_at(profile, 25.0), 75.0, 1e-9);
    EXPECT_NEAR(height_at(profile, 170.0), 0.0, 1e-9);
}

TEST(SlopeLength, AddsUpThePieces) {
    const Profile profile =
        read_profile("length_m,slope_deg,surface\n30,53.13010235415598,road\n50,0,road\n", "profile.csv");
    const SlopeLength length{profile};
    EXPECT_NEAR(length.at_m(30.0), 50.0, 1e-9);  // 3-4-5
    EXPECT_NEAR(length.at_m(80.0), 100.0, 1e-9);
    EXPECT_NEAR(length.at_m(-3.0), -5.0, 1e-9);
    EXPECT_EQ(corner_above(profile, 29.9), 0U);
    EXPECT_EQ(corner_above(profile, 30.0), 1U);
}

}  // namespace
}  // namespace coupling::validation::profile_test
