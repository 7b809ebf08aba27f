#include "coupling/inputs/plausible/climate_at.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace coupling::plausible::climate_at_test {
namespace {

/// Months that swing around a mean, warmest in July (`swing_k` above 0).
forest::ClimateSeries series(double elevation_m, double mean_degc, double swing_k) {
    forest::ClimateSeries series;
    series.elevation_m = elevation_m;
    for (int year = 2001; year <= 2003; ++year) {
        forest::ClimateYear one{};
        one.year = year;
        for (std::size_t m = 0; m < 12; ++m) {
            one.months[m].tave_degc =
                mean_degc - swing_k * std::cos(2.0 * std::numbers::pi * static_cast<double>(m) / 12.0);
            one.months[m].tmin_degc = one.months[m].tave_degc - 4.0;
            one.months[m].tmax_degc = one.months[m].tave_degc + 4.0;
            one.months[m].prec_mm = 80.0;
        }
        series.years.push_back(one);
    }
    return series;
}

ClimateAt at(const forest::ClimateSeries& series, double elevation_m) {
    return climate_at(series, 46.5, elevation_m, forest::LapseRates::shipped());
}

TEST(ClimateAt, IsThatOfTheElevationOfTheForest) {
    const ClimateAt same = at(series(500.0, 9.0, 10.0), 500.0);
    EXPECT_NEAR(same.mean_degc, 9.0, 1e-9);
    EXPECT_NEAR(same.january_degc, -1.0, 1e-9);
    EXPECT_NEAR(same.july_degc, 19.0, 1e-9);
    EXPECT_LT(at(series(500.0, 9.0, 10.0), 1500.0).mean_degc, 5.5);
}

TEST(ClimateAt, OfRealPlacesIsNotDoubted) {
    // Annual means 1991-2020 (MeteoSwiss, GeoSphere, Meteo-France), rounded: Sion, Davos, Saentis, Innsbruck,
    // Chamonix; and two of Europe's ends.
    struct Place {
        double latitude_deg, elevation_m, mean_degc;
    };
    for (const Place& place : {Place{46.2, 482.0, 11.0}, Place{46.8, 1594.0, 4.5}, Place{47.2, 2502.0, -0.8},
                               Place{47.3, 578.0, 9.8}, Place{45.9, 1042.0, 7.6}, Place{37.9, 107.0, 18.8},
                               Place{67.4, 179.0, 0.6}}) {
        EXPECT_FALSE(is_of_another_place({.latitude_deg = place.latitude_deg,
                                          .elevation_m = place.elevation_m,
                                          .mean_degc = place.mean_degc}))
            << place.elevation_m;
    }
}

TEST(ClimateAt, IsDoubtedForElevationsInFeetAndOtherPlaces) {
    // A series of 900 m, said to be of 900 m in feet, then brought down to the forest.
    EXPECT_FALSE(is_of_another_place(at(series(900.0, 7.0, 10.0), 1140.0)));
    EXPECT_TRUE(is_of_another_place(at(series(2953.0, 7.0, 10.0), 1140.0)));
    EXPECT_TRUE(is_of_another_place(at(series(1100.0, 24.0, 4.0), 1140.0))) << "the tropics";
}

TEST(ClimateAt, KnowsSeasonsOfTheOtherHalf) {
    EXPECT_FALSE(has_seasons_of_other_half(at(series(500.0, 9.0, 10.0), 500.0)));
    EXPECT_TRUE(has_seasons_of_other_half(at(series(500.0, 9.0, -10.0), 500.0)));
    EXPECT_FALSE(has_seasons_of_other_half(at(series(500.0, 9.0, -1.0), 500.0))) << "hardly any season";
}

TEST(ClimateAt, KnowsLatitudesAndFactorsThatLookLikeSlips) {
    EXPECT_FALSE(is_far_from_species(46.8));
    EXPECT_TRUE(is_far_from_species(4.68));
    EXPECT_DOUBLE_EQ(mean_factor_on_rain(forest::ClimateChange::of(4.0, 0.7)), 0.7);
    EXPECT_FALSE(is_odd_factor_on_rain(0.7));
    EXPECT_TRUE(is_odd_factor_on_rain(0.0)) << "meant as no change";
    EXPECT_TRUE(is_odd_factor_on_rain(0.2)) << "meant as a fifth more";
}

}  // namespace
}  // namespace coupling::plausible::climate_at_test
