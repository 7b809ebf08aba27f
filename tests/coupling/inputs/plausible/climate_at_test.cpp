#include "coupling/inputs/plausible/climate_at.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <string>
#include <utility>

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
    // Sion, measured, and a grid point of the northern Limestone Alps: sources in the folders of the cases.
    for (const auto& [name, latitude_deg] : {std::pair{"forest_dry", 46.2}, std::pair{"forest_old", 47.7}}) {
        const std::string file = std::string{BANNWALD_SOURCE_DIR "/validation/"} + name + "/climate.csv";
        std::ifstream in{file};
        config::Warnings warnings;
        const forest::ClimateSeries real =
            forest::read_climate_of_one_place(config::Table::read(in, file), warnings);
        for (const double elevation_m : {*real.elevation_m, 1200.0, 2000.0}) {
            const ClimateAt climate =
                climate_at(real, latitude_deg, elevation_m, forest::LapseRates::shipped());
            EXPECT_FALSE(is_of_another_place(climate)) << name << ' ' << climate.mean_degc;
            EXPECT_FALSE(seasons_contradict(hemisphere_of(climate)));
        }
    }
}

TEST(ClimateAt, IsDoubtedForElevationsInFeetAndOtherPlaces) {
    // A series of 900 m, said to be of 900 m in feet, then brought down to the forest.
    EXPECT_FALSE(is_of_another_place(at(series(900.0, 7.0, 10.0), 1140.0)));
    EXPECT_TRUE(is_of_another_place(at(series(2953.0, 7.0, 10.0), 1140.0)));
    EXPECT_TRUE(is_of_another_place(at(series(1100.0, 24.0, 4.0), 1140.0))) << "the tropics";
}

TEST(ClimateAt, KnowsSeasonsOfTheOtherHalf) {
    const auto contradict = [](double swing_k, double latitude_deg) {
        return seasons_contradict(hemisphere_of(means_of(series(500.0, 9.0, swing_k), latitude_deg)));
    };
    EXPECT_FALSE(contradict(10.0, 46.5));
    EXPECT_TRUE(contradict(-10.0, 46.5));
    EXPECT_FALSE(contradict(-10.0, -46.5));
    EXPECT_TRUE(contradict(10.0, -46.5));
    EXPECT_FALSE(contradict(-1.0, 46.5)) << "hardly any season";
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
