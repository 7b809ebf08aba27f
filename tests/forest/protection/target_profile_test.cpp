#include "forest/protection/target_profile.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace forest::target_profile_test {
namespace {

/// So many stems per hectare of a diameter.
StandFigures stems(double dbh_cm, double stems_pha) {
    StandFigures figures;
    figures.stems_pha_by_class[dbh_class_of(dbh_cm)] = stems_pha;
    return figures;
}

TEST(TargetProfile, AsksForThickerStemsAgainstLargerBlocks) {
    EXPECT_EQ(target_profile(0.3)->dbh_from_cm, 12.0);
    EXPECT_EQ(target_profile(0.4)->least_stems_pha, 400.0);
    EXPECT_EQ(target_profile(0.41)->dbh_from_cm, 24.0);
    EXPECT_EQ(target_profile(0.6)->ideal_stems_pha, 400.0);
    EXPECT_EQ(target_profile(1.0)->dbh_from_cm, 36.0);
    EXPECT_EQ(target_profile(1.8)->least_stems_pha, 150.0);
    EXPECT_FALSE(target_profile(1.81));
}

TEST(TargetProfile, HasLimitsOnBordersOfDiameterClassesAndASource) {
    double block_m = 0.0;
    for (const TargetProfile& profile : target_profiles()) {
        EXPECT_GT(profile.block_to_m, block_m);
        block_m = profile.block_to_m;
        EXPECT_EQ(std::fmod(profile.dbh_from_cm, dbh_class_cm), 0.0);
        EXPECT_GT(profile.ideal_stems_pha, profile.least_stems_pha);
        EXPECT_FALSE(profile.source.empty());
    }
}

TEST(Check, CountsStemsFromTheLimitOnOnly) {
    const TargetProfile profile = *target_profile(0.5);
    EXPECT_TRUE(check(profile, stems(24.0, 300.0), {}).met());
    EXPECT_FALSE(check(profile, stems(24.0, 299.0), {}).met());
    EXPECT_FALSE(check(profile, stems(23.9, 3000.0), {}).met());
    EXPECT_FALSE(check(profile, stems(24.0, 399.0), {}).has_ideal_stems);
    EXPECT_TRUE(check(profile, stems(50.0, 400.0), {}).has_ideal_stems);
}

TEST(Check, MissesWithOneGapThatIsTooLong) {
    const TargetProfile profile = *target_profile(0.5);
    const ProfileCheck short_gaps = check(profile, stems(30.0, 500.0), {.gaps = 3, .max_m = 20.0});
    EXPECT_TRUE(short_gaps.met());
    const ProfileCheck long_gap = check(profile, stems(30.0, 500.0), {.gaps = 3, .max_m = 20.1});
    EXPECT_TRUE(long_gap.has_stems);
    EXPECT_FALSE(long_gap.has_short_gaps);
    EXPECT_FALSE(long_gap.met());
}

}  // namespace
}  // namespace forest::target_profile_test
