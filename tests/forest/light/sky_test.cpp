#include "forest/light/sky.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace sky_test {
namespace {

using config::Angle;
using forest::Exposure;
using forest::MonthlyRadiation;
using forest::Sky;
using forest::SkySettings;

MonthlyRadiation even_radiation() {
    MonthlyRadiation radiation;
    radiation.direct_mjpm2.fill(200.0);
    radiation.diffuse_mjpm2.fill(180.0);
    return radiation;
}

/// Monthly global radiation and diffuse share of Prenovel (validation/forest_light/radiation.csv).
MonthlyRadiation jura_radiation() {
    constexpr std::array<double, 12> global{137.09, 206.30, 353.83, 465.82, 535.25, 618.18,
                                            655.17, 557.63, 423.94, 280.28, 157.96, 116.50};
    constexpr std::array<double, 12> share{0.5806, 0.5069, 0.4931, 0.49,  0.5088, 0.4638,
                                           0.425,  0.4363, 0.4469, 0.475, 0.5388, 0.5875};
    MonthlyRadiation radiation;
    for (std::size_t month = 0; month < 12; ++month) {
        radiation.diffuse_mjpm2[month] = share[month] * global[month];
        radiation.direct_mjpm2[month] = (1.0 - share[month]) * global[month];
    }
    return radiation;
}

double sum(const std::array<double, 12>& months) {
    return std::accumulate(months.begin(), months.end(), 0.0);
}

Sky sky_at(double latitude_deg, double y_axis_deg = 0.0) {
    SkySettings settings;
    settings.latitude = Angle::from_degrees(latitude_deg);
    settings.y_axis_azimuth = Angle::from_degrees(y_axis_deg);
    return {settings, even_radiation()};
}

Exposure slope(double slope_deg, double aspect_deg) {
    Exposure place;
    place.normal = forest::ground_normal(Angle::from_degrees(slope_deg), Angle::from_degrees(aspect_deg));
    return place;
}

TEST(Sky, HasZonesAboveTheHorizonPointingWhereTheyLie) {
    const Sky sky = sky_at(47.0);
    EXPECT_EQ(sky.zones().size(), 33U);
    for (const forest::Direction& zone : sky.zones()) {
        EXPECT_GT(zone.z, 0.1);
        EXPECT_NEAR(dot(zone, zone), 1.0, 1e-12);
    }
    EXPECT_GT(sky.zones().back().z, 0.999);
}

TEST(Sky, BringsOnTheFlatWhatItWasGiven) {
    for (const double latitude_deg : {-35.0, 0.0, 46.5, 68.0}) {
        const forest::SlopeRadiation flat =
            slope_radiation(sky_at(latitude_deg), Exposure{}, even_radiation());
        EXPECT_NEAR(sum(flat.slope.diffuse_mjpm2), 12 * 180.0, 0.5) << latitude_deg;
        // In polar night there is no sun to spread the beam over.
        EXPECT_NEAR(flat.slope.direct_mjpm2[5], 200.0, 1e-6) << latitude_deg;
        EXPECT_NEAR(flat.factor(5), 1.0, 1e-3);
    }
}

TEST(Sky, HasEverySampleInItsZone) {
    const Sky sky = sky_at(47.0);
    for (const forest::SkySample& sample : sky.diffuse()) {
        EXPECT_GT(dot(sample.towards, sky.zones()[sample.zone]), std::cos(0.5));
    }
    for (std::size_t beam = 0; beam < sky.beams().size(); ++beam) {
        for (const forest::SkySample& sun : sky.suns_of(beam)) {
            EXPECT_EQ(sun.zone, sky.beams()[beam].zone);
        }
    }
}

TEST(Sky, TurnsWithTheGrid) {
    const forest::SlopeRadiation north_up =
        slope_radiation(sky_at(47.0), slope(30.0, 180.0), even_radiation());
    // The same slope on a grid whose y axis points east.
    const forest::SlopeRadiation east_up =
        slope_radiation(sky_at(47.0, 90.0), slope(30.0, 90.0), even_radiation());
    EXPECT_NEAR(sum(north_up.slope.direct_mjpm2), sum(east_up.slope.direct_mjpm2), 1e-6);
}

TEST(Sky, IsTheSameInTheMirror) {
    const forest::SlopeRadiation east = slope_radiation(sky_at(47.0), slope(30.0, 110.0), even_radiation());
    const forest::SlopeRadiation west = slope_radiation(sky_at(47.0), slope(30.0, 250.0), even_radiation());
    EXPECT_NEAR(sum(east.slope.direct_mjpm2), sum(west.slope.direct_mjpm2), 1e-6);
    EXPECT_NEAR(sum(east.slope.diffuse_mjpm2), sum(west.slope.diffuse_mjpm2), 1e-6);
}

TEST(SlopeRadiation, IsThatOfTheReferenceInTheJura) {
    // SamsaRaLight at 46.5 N, MJ/m2 a year of the slope's area, direct and diffuse; its habits: see
    // compare_light.
    struct Case {
        double slope_deg, aspect_deg, direct, diffuse, least_deg;
    };
    SkySettings settings;
    settings.latitude = Angle::from_degrees(46.52666);
    settings.lowest_sun = {};
    settings.beam_transmission = 1.0;
    const Sky sky{settings, jura_radiation()};
    for (const Case& c : {Case{6, 144, 2440, 2095, 10}, Case{35, 180, 2974, 1845, 10},
                          Case{35, 0, 1061, 1845, 10}, Case{0, 0, 2289, 2110, 10}}) {
        Exposure place = slope(c.slope_deg, c.aspect_deg);
        place.least_cosine = std::sin(c.least_deg * 3.14159265358979 / 180.0);
        const forest::SlopeRadiation found = slope_radiation(sky, place, jura_radiation());
        EXPECT_NEAR(sum(found.slope.direct_mjpm2) / c.direct, 1.0, 0.02)
            << c.slope_deg << " " << c.aspect_deg;
        EXPECT_NEAR(sum(found.slope.diffuse_mjpm2) / c.diffuse, 1.0, 0.02)
            << c.slope_deg << " " << c.aspect_deg;
    }
    // On the flat the reference's 15 degree bands lose the lowest one: 2061 instead of 2110.
    Exposure flat;
    flat.least_cosine = std::sin(15.0 * 3.14159265358979 / 180.0);
    EXPECT_NEAR(sum(slope_radiation(sky, flat, jura_radiation()).slope.diffuse_mjpm2) / 2061.0, 1.0, 0.02);
}

TEST(SlopeRadiation, LosesWhatTheHorizonHides) {
    std::array<float, forest::Horizon::sectors> walls{};
    walls.fill(1.0F);
    Exposure pit;
    pit.horizon = forest::Horizon{walls};
    const forest::SlopeRadiation found = slope_radiation(sky_at(47.0), pit, even_radiation());
    EXPECT_EQ(found.slope.direct_mjpm2[11], 0.0);
    // Standard overcast sky above 45 degrees: 1 - 6/7 (1/4 + sqrt(2)/6).
    EXPECT_NEAR(found.slope.diffuse_mjpm2[0] / 180.0, 1.0 - 6.0 / 7.0 * (0.25 + std::sqrt(2.0) / 6.0), 0.02);
    EXPECT_LT(found.factor(11), found.factor(5));
}

}  // namespace

}  // namespace sky_test
