#include "forest/light/sun.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sun_test {
namespace {

using config::Angle;
using forest::diffuse_share;
using forest::extraterrestrial_mjpm2;
using forest::toward_sun;

const Angle alps = Angle::from_degrees(47.0);

TEST(TowardSun, StandsInTheSouthAtNoonAtLatitudeAndDeclination) {
    const forest::Direction noon = toward_sun(alps, 172, 12.0);
    EXPECT_NEAR(noon.x, 0.0, 1e-10);
    EXPECT_LT(noon.y, 0.0);
    EXPECT_NEAR(noon.z, std::sin((90.0 - 47.0 + 23.45) * 3.14159265358979 / 180.0), 1e-4);
}

TEST(TowardSun, IsTheSameBeforeAndAfterNoonMirrored) {
    for (const double hours : {0.25, 1.75, 4.25, 7.5}) {
        const forest::Direction morning = toward_sun(alps, 100, 12.0 - hours);
        const forest::Direction evening = toward_sun(alps, 100, 12.0 + hours);
        EXPECT_NEAR(morning.x, -evening.x, 1e-12);
        EXPECT_GT(morning.x, 0.0);
        EXPECT_NEAR(morning.z, evening.z, 1e-12);
        EXPECT_NEAR(dot(morning, morning), 1.0, 1e-10);
    }
}

TEST(ExtraterrestrialRadiation, IsThatOfTheTables) {
    // FAO-56, Annex 2, Table 2.6.
    EXPECT_NEAR(extraterrestrial_mjpm2(Angle::from_degrees(46.0), 166), 41.8, 0.3);
    EXPECT_NEAR(extraterrestrial_mjpm2(Angle::from_degrees(46.0), 349), 10.1, 0.3);
    EXPECT_NEAR(extraterrestrial_mjpm2(Angle::from_degrees(-20.0), 246), 32.2, 0.1);
    EXPECT_NEAR(extraterrestrial_mjpm2(Angle::from_degrees(80.0), 355), 0.0, 1e-6);
    EXPECT_GT(extraterrestrial_mjpm2(Angle::from_degrees(90.0), 172), 40.0);
}

TEST(DiffuseShare, FallsWithClearness) {
    for (const int day : {15, 196}) {
        double before = 1.0;
        for (double clearness = 0.3; clearness <= 0.8; clearness += 0.05) {
            const double share = diffuse_share(alps, day, clearness);
            EXPECT_LT(share, before);
            EXPECT_GT(share, 0.0);
            before = share;
        }
        EXPECT_EQ(diffuse_share(alps, day, 0.1), diffuse_share(alps, day, 0.3));
    }
}

TEST(SplitRadiation, KeepsTheSum) {
    std::array<double, 12> global_mjpm2_d{4, 7, 11, 15, 17, 20, 21, 18, 14, 9, 5, 3.5};
    const forest::MonthlyRadiation split = forest::split_radiation(alps, global_mjpm2_d);
    for (std::size_t month = 0; month < 12; ++month) {
        EXPECT_NEAR(split.direct_mjpm2[month] + split.diffuse_mjpm2[month],
                    global_mjpm2_d[month] * forest::days_of_month[month], 1e-9);
    }
}

TEST(SplitRadiation, TakesPolarNight) {
    const forest::MonthlyRadiation split = forest::split_radiation(Angle::from_degrees(80.0), {});
    EXPECT_EQ(split.direct_mjpm2[11], 0.0);
}

}  // namespace

}  // namespace sun_test
