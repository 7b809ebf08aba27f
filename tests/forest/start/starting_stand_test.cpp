#include "forest/start/starting_stand.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "forest/deaths/mortality.hpp"
#include "forest/inventory/tables.hpp"
#include "forest/start/height_curve.hpp"
#include "forest/start/places.hpp"
#include "tests/forest/small_forest.hpp"

namespace forest::starting_stand_test {
namespace {

const SpeciesTable table = SpeciesTable::shipped();
const SpeciesId spruce = *table.find("piab");
const SpeciesId beech = *table.find("fasy");

std::vector<PatchId> all_patches(const PatchGrid& grid) {
    std::vector<PatchId> patches;
    for (std::uint32_t i = 0; i < grid.size(); ++i) {
        patches.push_back(PatchId{i});
    }
    return patches;
}

TEST(HeightCurve, PassesThroughTheMeanTree) {
    const HeightCurve curve = curve_through(30.0, 25.0);
    EXPECT_NEAR(curve.height_m(30.0), 25.0, 1e-9);
    EXPECT_NEAR(curve.height_m(60.0), 1.25 * 25.0, 1e-9);
    EXPECT_LT(curve.height_m(10.0), curve.height_m(11.0));
}

TEST(FitHeights, FindsTheCurveThatMadeTheHeights) {
    const HeightCurve made{1.5, 0.31};
    std::vector<MeasuredHeight> measured;
    for (double dbh_cm = 8.0; dbh_cm < 60.0; dbh_cm += 4.0) {
        measured.push_back({dbh_cm, made.height_m(dbh_cm)});
    }
    const HeightFit fit = fit_heights(measured);
    EXPECT_NEAR(fit.curve.a, 1.5, 1e-6);
    EXPECT_NEAR(fit.curve.b, 0.31, 1e-6);
    EXPECT_NEAR(fit.standard_error_m, 0.0, 1e-5);
}

TEST(FitHeights, RefusesTooFewTreesAndAFallingCurve) {
    EXPECT_EQ(fit_heights(std::vector<MeasuredHeight>(4, {20.0, 15.0})).trees, 0U);
    EXPECT_EQ(fit_heights(std::vector<MeasuredHeight>(9, {20.0, 15.0})).trees, 0U);
    EXPECT_EQ(fit_heights(std::vector<MeasuredHeight>{{10, 30}, {20, 22}, {30, 15}, {40, 9}, {50, 4}}).trees,
              0U);
}

TEST(StandDiameters, HaveTheMeanAskedForAndFall) {
    for (const Structure structure :
         {Structure::even_aged, Structure::two_layered, Structure::plenter, Structure::groups}) {
        const std::vector<double> diameters = stand_diameters_cm(structure, 400, 24.0, 200.0);
        double squares = 0.0;
        for (std::size_t i = 0; i < diameters.size(); ++i) {
            squares += diameters[i] * diameters[i];
            EXPECT_GE(diameters[i], 1.0);
            EXPECT_TRUE(i == 0 || diameters[i] <= diameters[i - 1]);
        }
        EXPECT_NEAR(std::sqrt(squares / 400.0), 24.0, 0.1);
    }
}

TEST(StandDiameters, OfAPlenterStandFallOffAsPublished) {
    // N(D) ~ exp(-0.06 D): twice as many below 11.6 cm excess as above it, and so on.
    const std::vector<double> diameters = stand_diameters_cm(Structure::plenter, 10'000, 24.6, 300.0);
    const auto above = [&](double dbh_cm) {
        return static_cast<double>(
            std::count_if(diameters.begin(), diameters.end(), [dbh_cm](double d) { return d > dbh_cm; }));
    };
    EXPECT_NEAR(std::log(above(10.0) / above(40.0)) / 30.0, 0.06, 0.002);
}

TEST(PlacesFor, GivePatchesAboutTheSameBasalArea) {
    const PatchGrid grid = square_of_forest(8);
    const std::vector<double> diameters = stand_diameters_cm(Structure::even_aged, 640, 25.0, 200.0);
    const std::vector<Place> places =
        places_for(grid, all_patches(grid), diameters, Structure::even_aged, {7, 0, 0});
    std::vector<double> basal_area(grid.size(), 0.0);
    double mean = 0.0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        EXPECT_EQ(grid.at(places[i].x_m, places[i].y_m), places[i].patch);
        basal_area[index_of(places[i].patch)] += diameters[i] * diameters[i];
        mean += diameters[i] * diameters[i] / 64.0;
    }
    for (const double sum : basal_area) {
        EXPECT_NEAR(sum / mean, 1.0, 0.3);
    }
}

TEST(PlacesFor, GivePatchesBasalAreaInProportionToTheirCover) {
    const PatchGrid grid = square_of_forest(8);
    const std::vector<PatchId> patches = all_patches(grid);
    std::vector<double> cover;
    for (std::size_t i = 0; i < patches.size(); ++i) {
        cover.push_back(static_cast<double>(i % 4) / 3.0);
    }
    const std::vector<double> diameters = stand_diameters_cm(Structure::even_aged, 2000, 25.0, 200.0);
    for (const Structure structure : {Structure::even_aged, Structure::plenter, Structure::groups}) {
        const std::vector<Place> places =
            places_for(grid, patches, diameters, structure, {7, 0, 0}, {}, cover);
        ASSERT_EQ(places.size(), diameters.size());
        std::vector<double> by_cover(4, 0.0);
        double all = 0.0;
        for (std::size_t i = 0; i < places.size(); ++i) {
            EXPECT_EQ(grid.at(places[i].x_m, places[i].y_m), places[i].patch);
            by_cover[index_of(places[i].patch) % 4] += diameters[i] * diameters[i];
            all += diameters[i] * diameters[i];
        }
        EXPECT_EQ(by_cover[0], 0.0);
        if (structure != Structure::groups) {  // whose clusters reach over their patch
            EXPECT_NEAR(by_cover[1] / all, 1.0 / 6.0, 0.03);
            EXPECT_NEAR(by_cover[2] / all, 2.0 / 6.0, 0.03);
        }
        EXPECT_GT(by_cover[3], by_cover[1]);
    }
}

TEST(PlacesFor, KeepTreesApart) {
    const PatchGrid grid = square_of_forest(5);
    const std::vector<double> diameters(250, 25.0);  // mean spacing 3.2 m
    const std::vector<Place> places =
        places_for(grid, all_patches(grid), diameters, Structure::even_aged, {7, 0, 0});
    int close = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            close += std::hypot(places[i].x_m - places[j].x_m, places[i].y_m - places[j].y_m) < 1.58 ? 1 : 0;
        }
    }
    EXPECT_LE(close, 5);
}

TEST(TreesFromRecord, MeetTheInventory) {
    const PatchGrid grid = square_of_forest(10);
    StandRecord record;
    record.patches = all_patches(grid);
    record.species = {
        {.species = spruce, .stems_pha = 500.0, .basal_area_m2pha = 30.0, .mean_height_m = 24.0},
        {.species = beech, .basal_area_m2pha = 10.0, .mean_dbh_cm = 18.0, .mean_height_m = 17.0}};
    const std::vector<Tree> trees = trees_from_record(record, grid, table, 3, 0, 100);
    const Stand stand{grid, table.size(), trees, 2000};
    const std::vector<StandFigures> figures = figures_by_species(stand.trees(), table, 1.0);
    EXPECT_EQ(figures[index_of(spruce)].stems_pha, 500.0);
    EXPECT_NEAR(figures[index_of(spruce)].basal_area_m2pha, 30.0, 0.1);
    EXPECT_NEAR(figures[index_of(beech)].basal_area_m2pha, 10.0, 0.1);
    EXPECT_NEAR(figures[index_of(beech)].mean_dbh_cm, 18.0, 0.1);
    EXPECT_NEAR(figures[index_of(spruce)].lorey_height_m, 24.0, 1.5);
    EXPECT_EQ(number_of(stand.trees()[0].id), 100U);
}

TEST(UsualAge, IsTheSpeciesOwnAndLeavesATreeSomeLife) {
    // All species grew 0.25 cm a year: a birch of 40 cm was 160 years old and died within a decade.
    const Species& birch = table[*table.find("bepe")];
    const double age_years = usual_age_years(birch, 40.0);
    EXPECT_LE(age_years, 0.6 * birch.mortality.max_age_years);
    EXPECT_LT(background_death(birch, 40.0, age_years, CanopyPlace{}, {}, false), 0.03);
    EXPECT_NEAR(usual_age_years(table[spruce], 30.0), 100.0, 1e-9);
    EXPECT_GT(usual_age_years(table[*table.find("pice")], 30.0), 150.0);
}

TEST(TreesFromRecord, SaysWhatARecordLacks) {
    EXPECT_EQ(missing_in({.species = spruce}), "neither stems nor basal area");
    EXPECT_NE(missing_in({.species = spruce, .stems_pha = 500.0}), "");
    EXPECT_EQ(missing_in({.species = spruce, .stems_pha = 500.0, .mean_dbh_cm = 20.0}), "");
}

ListedTree listed(std::uint64_t id, double dbh_cm, std::optional<double> height_m, double x_m = 5.0) {
    return {id, x_m, 5.0 + 0.01 * static_cast<double>(id), spruce, dbh_cm, height_m, {}};
}

TEST(TreesFromList, FillsHeightsFromTheSpeciesCurveAndSaysSo) {
    const HeightCurve curve{1.5, 0.31};
    std::vector<ListedTree> list;
    for (std::uint64_t i = 0; i < 20; ++i) {
        const double dbh_cm = 10.0 + 2.0 * static_cast<double>(i);
        list.push_back(listed(i, dbh_cm, i % 4 == 0 ? std::nullopt : std::optional{curve.height_m(dbh_cm)}));
    }
    config::Warnings warnings;
    const StartingTrees start = trees_from_list(list, square_of_forest(1), table, 1300.0, warnings);
    ASSERT_EQ(start.trees.size(), 20U);
    EXPECT_NEAR(start.trees[4].height_m, curve.height_m(18.0), 1e-6);
    ASSERT_EQ(warnings.all().size(), 1U);
    EXPECT_EQ(warnings.all()[0],
              "Picea abies: 5 heights filled in from a height curve through 15 measured trees (standard "
              "error 0.0 m)");
}

TEST(TreesFromList, KeepTheHeightOfATallTree) {
    const double greatest_m = table[spruce].height_growth.max_height_m;
    config::Warnings warnings;
    const StartingTrees start = trees_from_list(std::vector<ListedTree>{listed(1, 90.0, greatest_m + 5.0)},
                                                square_of_forest(1), table, 1300.0, warnings);
    ASSERT_EQ(start.trees.size(), 1U);
    EXPECT_EQ(start.trees[0].height_m, greatest_m + 5.0);
    EXPECT_TRUE(warnings.all().empty());
}

TEST(TreesFromList, CountsWhatItCannotTake) {
    config::Warnings warnings;
    const StartingTrees start = trees_from_list(
        std::vector<ListedTree>{listed(1, 20.0, 15.0), listed(2, 0.5, {}), listed(3, 20.0, 15.0, 500.0),
                                listed(4, 20.0, 1.0), listed(4, 20.0, 12.0)},
        square_of_forest(1), table, 1300.0, warnings);
    EXPECT_EQ(start.trees.size(), 3U);
    EXPECT_EQ(start.outside, std::vector<std::size_t>{2});
    EXPECT_GT(start.trees[1].height_m, 5.0);
    EXPECT_EQ(warnings.all().size(), 5U);
}

}  // namespace
}  // namespace forest::starting_stand_test
