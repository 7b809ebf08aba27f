#include "forest/stand/volume_loss.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "forest/deadwood/deadwood.hpp"
#include "forest/deadwood/decay.hpp"

namespace forest::volume_loss_test {
namespace {

/// Years for which a lying log counts: by number until it is soil, and weighted by what is left of it.
struct Residence {
    double by_number = 0.0;
    double by_volume = 0.0;
};

Residence residence_of(const Species& species, double mean_degc) {
    Residence years;
    double density = 1.0;
    const double left =
        yearly_density_left(lying_decay_pyear(species.deadwood), decay_speed(mean_degc, 10.0));
    for (; density >= soil_density; density *= left) {
        years.by_number += 1.0;
        years.by_volume += volume_left(density);
    }
    return years;
}

TEST(VolumeLeft, LosesBarkFirstAndFollowsDensityLater) {
    EXPECT_EQ(volume_left(1.0), 1.0);
    EXPECT_DOUBLE_EQ(volume_left(0.8), 0.95) << "half of the bark";
    EXPECT_DOUBLE_EQ(volume_left(0.6), 0.9) << "all of the wood, no bark";
    EXPECT_DOUBLE_EQ(volume_left(0.3), 0.45);
    EXPECT_NEAR(volume_left(soil_density), 0.9 / 6.0, 1e-12);
}

TEST(VolumeLeft, KeepsSpruceLogsAsLongAsOnBabiaGora) {
    // Holeksa et al. 2008, 2785 snags and logs twice within ten years: 71 to 113 years by number, 47 to 63 by
    // volume. The rate was fitted to both, without bark; 3 degC is the mean of the year there.
    const SpeciesTable table = SpeciesTable::shipped();
    const Residence spruce = residence_of(table[*table.find("piab")], 3.0);
    EXPECT_GT(spruce.by_number, 71.0);
    EXPECT_LT(spruce.by_number, 113.0);
    EXPECT_GT(spruce.by_volume, 47.0);
    EXPECT_LT(spruce.by_volume, 63.0);
}

TEST(VolumeLeft, LetsBeechLogsVanishInAboutThirtyFiveYearsInTheSolling) {
    // Mueller-Using & Bartsch 2009, about 7 degC: not fitted.
    const SpeciesTable table = SpeciesTable::shipped();
    EXPECT_NEAR(residence_of(table[*table.find("fasy")], 7.0).by_number, 35.0, 5.0);
}

TEST(DiameterLeft, HasTheVolumeThatIsLeftAtTheSameLength) {
    Log log;
    log.density_share = 0.3;
    EXPECT_DOUBLE_EQ(diameter_left(log) * diameter_left(log), volume_left(0.3));
    Snag snag;
    snag.density_share = 0.8;
    EXPECT_DOUBLE_EQ(diameter_left(snag) * diameter_left(snag), volume_left(0.8));
}

}  // namespace
}  // namespace forest::volume_loss_test
