#include "validation/engine/slope/relief.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "tests/validation/case_texts.hpp"
#include "validation/engine/kinds/validation_case.hpp"
#include "validation/engine/slope/rebuild.hpp"

namespace coupling::validation {
namespace {

/// 3 columns of 2 m down the slope, 1 row.
Relief one_row(double shift_m = 0.0) {
    config::Raster<double> heights{{3, 1, 0.0, 0.0, 2.0, 2.0}, 0.0};
    heights.values = {0.0, 1.0, 4.0};
    return {std::make_shared<const config::Raster<double>>(heights), shift_m, 0.0};
}

TEST(Relief, IsStraightBetweenItsCellsAndMirroredBeyondThem) {
    const Relief relief = one_row();
    EXPECT_DOUBLE_EQ(relief.at(0.0, 0.0), 0.0);
    EXPECT_DOUBLE_EQ(relief.at(1.0, 0.0), 0.5);
    EXPECT_DOUBLE_EQ(relief.at(4.0, 3.0), 4.0);
    EXPECT_DOUBLE_EQ(relief.at(5.0, 0.0), 2.5) << "back again";
    EXPECT_DOUBLE_EQ(relief.at(-2.0, 0.0), 1.0);
    EXPECT_DOUBLE_EQ(relief.at(800.0, 0.0), 0.0);
    EXPECT_DOUBLE_EQ(one_row(2.0).at(2.0, 0.0), 0.0) << "moved down the slope";
}

TEST(Relief, HasCornersWhereItsCellsMeet) {
    EXPECT_EQ(one_row().corners_m(0.0, 5.0), (std::vector<double>{2.0, 4.0}));
    EXPECT_TRUE(Relief{}.corners_m(0.0, 5.0).empty());
    EXPECT_DOUBLE_EQ(Relief{}.at(1.0, 1.0), 0.0);
}

CaseFiles with_relief(const std::string& kind) {
    CaseFiles files = testing::even_slope(kind, "[terrain]\nrelief_file = relief.asc\n");
    files.texts["relief.asc"] = "ncols 2\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 50\n0 3\n";
    return files;
}

TEST(Relief, LiesOnTheRebuiltSlopeInSpaceAndAlongAProfile) {
    for (const char* kind : {"slope", "profile"}) {
        const ValidationCase of = read_case(with_relief(kind));
        const auto recipe = of.recipe("strict");
        const RebuiltSlope slope = rebuild(*recipe, of.profile(*recipe));
        for (const double distance_m : {0.0, 50.0, 75.0, 100.0}) {
            const Eigen::Vector2d place = slope.on_terrain(distance_m, 0.0);
            const double above_m = slope.slope.terrain.height_m(place.x(), place.y()).value() -
                                   height_at(slope.profile, distance_m);
            EXPECT_NEAR(above_m, recipe->relief.at(distance_m, 0.0), 1e-6) << kind << " at " << distance_m;
        }
        EXPECT_EQ(recipe->relief.at(50.0, 0.0), 3.0);
    }
}

TEST(Relief, OfAMissingFileIsRefused) {
    CaseFiles files = with_relief("slope");
    files.texts.erase("relief.asc");
    EXPECT_THROW(read_case(files), config::InputError);
}

}  // namespace
}  // namespace coupling::validation
