#include "forest/site/season.hpp"

#include <gtest/gtest.h>

#include "forest/climate/summary.hpp"
#include "forest/light/stand_light.hpp"
#include "tests/forest/small_forest.hpp"

namespace forest::season_test {
namespace {

/// A montane slope with a mixed stand in the light of its year.
struct LitForest {
    explicit LitForest(double prec_mm = 110.0) : forest{square_of_forest(6)} {
        for (ClimateYear& year : forest.weather) {
            for (ClimateMonth& month : year.months) {
                month.prec_mm = prec_mm;
            }
        }
        light_year = light_year_of(forest.site, forest.species, weather());
        const std::vector<LightTree> trees = light_trees_of(stand, forest.species);
        const Canopy canopy{forest.site.light().ground(), trees};
        field = compute_light(forest.site.light(), canopy, light_year, trees);
    }

    [[nodiscard]] SiteWeather weather() const { return {.units = forest.weather}; }
    [[nodiscard]] Season season(const Processes& processes = {}) const {
        return compute_season(stand, forest.site, forest.species, weather(), light_year, field, processes);
    }
    [[nodiscard]] const YearOfLightUse& spruce_of(const Season& season) const {
        return season.light_use[index_of(*forest.species.find("piab"))];
    }

    SmallForest forest;
    Stand stand{forest.grid, forest.species.size(), mixed_stand(forest, 1000.0, 1), 2000};
    LightYear light_year;
    LightField field;
};

constexpr std::size_t july = 6;
constexpr std::size_t january = 0;
const Processes no_water_limits{.water = false};

TEST(LightYearOf, HasLeavesInSummerAndNoneInWinter) {
    const LitForest lit;
    EXPECT_TRUE(lit.light_year.leaves_on[july]);
    EXPECT_FALSE(lit.light_year.leaves_on[january]);
}

TEST(ComputeSeason, SumsTheDegreeDaysOfEachUnit) {
    const LitForest lit;
    const Season season = lit.season();
    ASSERT_EQ(season.degree_days.size(), lit.forest.site.units().size());
    EXPECT_DOUBLE_EQ(season.degree_days.front(), degree_days(montane_year()));
}

TEST(ComputeSeason, LosesNoWater) {
    for (const double prec_mm : {0.0, 20.0, 110.0, 300.0}) {
        const WaterYear water = LitForest{prec_mm}.season().water;
        EXPECT_NEAR(water.precipitation_mm, 12.0 * prec_mm, 1e-9);
        EXPECT_NEAR(water.precipitation_mm,
                    water.evapotranspiration_mm + water.runoff_mm + water.storage_gain_mm, 1e-9)
            << prec_mm << " mm a month";
        EXPECT_LE(water.transpiration_mm, water.evapotranspiration_mm);
    }
}

TEST(ComputeSeason, ProducesLessWhereItIsDry) {
    const LitForest wet;
    const LitForest dry{10.0};
    const Season in_rain = wet.season();
    const Season in_drought = dry.season();
    EXPECT_LT(dry.spruce_of(in_drought).npp_gpmj[july], 0.8 * wet.spruce_of(in_rain).npp_gpmj[july]);
    const SpeciesId spruce = *wet.forest.species.find("piab");
    const SpeciesId pine = *wet.forest.species.find("pisy");
    EXPECT_LT(in_drought.drought.response(PatchId{0}, spruce), in_rain.drought.response(PatchId{0}, spruce));
    EXPECT_LT(in_drought.drought.response(PatchId{0}, spruce), in_drought.drought.response(PatchId{0}, pine));
    EXPECT_GT(in_drought.patches.front().drought_index, 0.3);
    EXPECT_LT(in_rain.patches.front().drought_index, 0.1);
    EXPECT_LT(in_drought.patches.front().soil_water_mm, in_rain.patches.front().soil_water_mm);
}

TEST(ComputeSeason, KnowsOnlySpeciesThatStandInTheForest) {
    const LitForest lit;
    const Season season = lit.season();
    EXPECT_GT(lit.spruce_of(season).npp_gpmj[july], 0.0);
    EXPECT_EQ(season.light_use[index_of(*lit.forest.species.find("lade"))].npp_gpmj[july], 0.0);
}

TEST(ComputeSeason, KeepsTheLightOfTheGround) {
    const LitForest lit;
    const Season season = lit.season();
    for (std::uint32_t i = 0; i < lit.forest.grid.size(); ++i) {
        const std::size_t column = lit.forest.site.column_of(PatchId{i});
        EXPECT_FLOAT_EQ(static_cast<float>(season.patches[i].ground_light), lit.field.ground_light[column]);
    }
}

TEST(ComputeSeason, IgnoresDroughtWithoutWaterLimits) {
    const LitForest wet;
    const LitForest dry{0.0};
    const Season in_rain = wet.season(no_water_limits);
    const Season in_drought = dry.season(no_water_limits);
    EXPECT_EQ(dry.spruce_of(in_drought).npp_gpmj, wet.spruce_of(in_rain).npp_gpmj);
    EXPECT_GE(wet.spruce_of(in_rain).npp_gpmj[july], wet.spruce_of(wet.season()).npp_gpmj[july]);
    for (std::size_t i = 0; i < in_drought.patches.size(); ++i) {
        EXPECT_EQ(in_drought.patches[i].drought_index, 0.0);
        EXPECT_EQ(in_drought.drought.response(PatchId{static_cast<std::uint32_t>(i)},
                                              *dry.forest.species.find("piab")),
                  1.0);
        EXPECT_EQ(in_drought.patches[i].soil_water_mm, dry.stand.patch_states()[i].soil_water_mm);
    }
    EXPECT_EQ(in_drought.water.evapotranspiration_mm, 0.0);
}

TEST(ComputeSeason, RespondsToCarbonDioxideOnlyIfAsked) {
    const LitForest lit;
    SiteWeather weather = lit.weather();
    weather.co2_ppm = 560.0;
    const auto july_npp = [&] {
        return lit
            .spruce_of(compute_season(lit.stand, lit.forest.site, lit.forest.species, weather, lit.light_year,
                                      lit.field, {}))
            .npp_gpmj[july];
    };
    EXPECT_EQ(july_npp(), lit.spruce_of(lit.season()).npp_gpmj[july]);
    weather.co2_response = true;
    EXPECT_GT(july_npp(), lit.spruce_of(lit.season()).npp_gpmj[july]);
}

}  // namespace
}  // namespace forest::season_test
