#include "forest/production/transpiration.hpp"

#include <gtest/gtest.h>

namespace forest::transpiration_test {
namespace {

const EvaporationDay june{30.0, 57600.0, 200.0, 1.0};

TEST(Evaporation, IsNothingThroughAClosedSurface) {
    EXPECT_DOUBLE_EQ(evaporation_mm(june, 0.0, 0.2), 0.0);
}

TEST(Evaporation, RisesWithConductanceRadiationAndDeficit) {
    double before = 0.0;
    for (const double conductance_mps : {0.001, 0.005, 0.01, 0.02, 0.05}) {
        EXPECT_GT(evaporation_mm(june, conductance_mps, 0.2), before);
        before = evaporation_mm(june, conductance_mps, 0.2);
    }
    EXPECT_GT(evaporation_mm({30.0, 57600.0, 300.0, 1.0}, 0.01, 0.2), evaporation_mm(june, 0.01, 0.2));
    EXPECT_GT(evaporation_mm({30.0, 57600.0, 200.0, 2.0}, 0.01, 0.2), evaporation_mm(june, 0.01, 0.2));
}

TEST(Evaporation, OfAnOpenSurfaceIsSetByRadiationAndAir) {
    // Conductance far above that of the air leaves (s Rn + rho q g) / (1 + s), s = 2.2.
    const double deficit_wpm2 = 1.2 * 2.46e6 * 0.00622 * 1.0 * 0.2;
    const double expected_mm = (2.2 * 200.0 + deficit_wpm2) / 3.2 / 2.46e6 * 57600.0 * 30.0;
    EXPECT_NEAR(evaporation_mm(june, 1e9, 0.2), expected_mm, 1e-6 * expected_mm);
}

TEST(NetRadiation, IsALineThroughDaytimeRadiation) {
    EXPECT_DOUBLE_EQ(NetRadiation{}.by_day(20.0, 50000.0), -90.0 + 0.8 * 400.0);
}

TEST(CanopyConductance, RisesToItsLeafAreaAndStays) {
    EXPECT_DOUBLE_EQ(canopy_conductance_mps(0.0, 0.0, 0.02, 4.0), 0.0);
    EXPECT_DOUBLE_EQ(canopy_conductance_mps(2.0, 0.0, 0.02, 4.0), 0.01);
    EXPECT_DOUBLE_EQ(canopy_conductance_mps(9.0, 0.0, 0.02, 4.0), 0.02);
}

TEST(InterceptionShare, RisesToItsLeafAreaAndStays) {
    EXPECT_DOUBLE_EQ(interception_share(1.5, 0.24, 3.0), 0.12);
    EXPECT_DOUBLE_EQ(interception_share(6.0, 0.24, 3.0), 0.24);
    EXPECT_DOUBLE_EQ(interception_share(0.1, 0.24, 0.0), 0.24);
}

}  // namespace
}  // namespace forest::transpiration_test
