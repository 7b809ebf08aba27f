#include "coupling/assessments/stopping/stopping_recipe.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "config/data/shipped_tables.hpp"
#include "coupling/inputs/ground/surface_types.hpp"

namespace coupling::stopping_recipe_test {
namespace {

std::vector<SurfaceRecipe> recipe_of(const std::string& text) {
    std::istringstream in{text};
    return read_recipe(config::Table::read(in, "recipe.csv"));
}

TEST(StoppingRecipe, HoldsOneSurfaceForEachNameInTheOrderOfTheRows) {
    const auto recipes = recipe_of(
        "name,block_low_m,block_high_m,cover,burial,gathering,reason\n"
        "talus,0.4,0.8,0.3,0.25,0.8,as mapped\n"
        "meadow,0.2,0.2,0.01,0.5,0,\n"
        "talus,0.08,0.1,0.1,0,0.5,stones between the blocks\n");
    ASSERT_EQ(recipes.size(), 2U);
    EXPECT_EQ(recipes[0].name, "talus");
    ASSERT_EQ(recipes[0].kinds.size(), 2U);
    EXPECT_EQ(recipes[0].kinds[0].high_m, 0.8);
    EXPECT_EQ(recipes[0].kinds[0].gathering, 0.8);
    EXPECT_EQ(recipes[0].kinds[1].cover, 0.1);
    EXPECT_EQ(recipes[1].kinds[0].burial, 0.5);
    EXPECT_FALSE(recipes[0].code);
}

TEST(StoppingRecipe, TakesObservedDiametersAndCodes) {
    const auto recipes =
        recipe_of("code,name,block_sizes_m,cover,burial,gathering\n7,talus,0.3 0.45 0.45 1.2,0.2,0.25,0.8\n");
    EXPECT_EQ(recipes[0].code, 7);
    EXPECT_EQ(recipes[0].kinds[0].observed_m, (std::vector<double>{0.3, 0.45, 0.45, 1.2}));
}

TEST(StoppingRecipe, OfTheProgramDescribesEveryShippedGroundType) {
    const auto recipes = read_recipe(config::read_shipped_table("stopping_recipe.csv"));
    const auto surfaces = shipped_surfaces();
    ASSERT_EQ(recipes.size(), surfaces.size());
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        EXPECT_EQ(recipes[i].name, surfaces[i].name);
    }
}

}  // namespace
}  // namespace coupling::stopping_recipe_test
