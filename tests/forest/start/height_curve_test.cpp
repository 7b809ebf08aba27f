#include "forest/start/height_curve.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>

#include "forest/stand/site_height.hpp"

namespace forest::height_curve_test {
namespace {

const SpeciesTable table = SpeciesTable::shipped();
constexpr double montane_degree_days = 1500.0;

TEST(HeightByGrowth, BeginsWithARecruitAndRisesTowardsThePlacesGreatestHeight) {
    for (const Species& kind : table.all()) {
        EXPECT_DOUBLE_EQ(height_by_growth(kind, 1.0, montane_degree_days), 2.0) << kind.code;
        double before_m = 2.0;
        for (double dbh_cm = 5.0; dbh_cm <= 100.0; dbh_cm += 5.0) {
            const double height_m = height_by_growth(kind, dbh_cm, montane_degree_days);
            EXPECT_GT(height_m, before_m) << kind.code << ' ' << dbh_cm;
            EXPECT_LT(height_m, site_height_m(kind.height_growth, montane_degree_days)) << kind.code;
            before_m = height_m;
        }
    }
}

/// Mean heights of yield tables at mean diameters of about 15, 30 and 50 cm (validation/forest_yield). Stands
/// of a table are dense, so its thin trees are slender; classes differ by a quarter at a diameter.
TEST(HeightByGrowth, IsNearThatOfYieldTablesAtADiameter) {
    struct Heights {
        std::string species;
        std::array<double, 3> m;
    };
    const std::array<double, 3> dbh_cm = {15.0, 30.0, 50.0};
    for (const Heights& of : {Heights{"piab", {14.0, 25.0, 37.0}}, Heights{"abal", {15.0, 25.0, 34.5}},
                              Heights{"fasy", {18.0, 28.0, 37.0}}, Heights{"lade", {16.0, 27.0, 37.0}},
                              Heights{"pisy", {12.5, 23.0, 31.0}}, Heights{"qupe", {15.5, 23.0, 29.5}}}) {
        for (std::size_t i = 0; i < dbh_cm.size(); ++i) {
            const double height_m =
                height_by_growth(table[*table.find(of.species)], dbh_cm[i], montane_degree_days);
            EXPECT_NEAR(height_m / of.m[i], 1.0, 0.25) << of.species << ' ' << dbh_cm[i];
        }
    }
}

}  // namespace
}  // namespace forest::height_curve_test
