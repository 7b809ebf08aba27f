#include "coupling/assessments/stopping/stopping_recipe.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "config/data/shipped_tables.hpp"
#include "config/errors/input_error.hpp"
#include "coupling/inputs/ground/surface_types.hpp"

namespace coupling::stopping_recipe_test {
namespace {

std::vector<SurfaceRecipe> recipe_of(const std::string& text) {
    std::istringstream in{text};
    return read_recipe(config::Table::read(in, "recipe.csv"));
}

std::string problems_of(const std::string& text) {
    try {
        recipe_of(text);
    } catch (const config::InputError& error) {
        EXPECT_EQ(error.code(), config::ExitCode::data);
        return error.what();
    }
    return "";
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

TEST(StoppingRecipe, TellsEveryFaultWithItsPlace) {
    EXPECT_EQ(problems_of("name,block_low_m,block_high_m,cover,burial,gathering\n"
                          "talus/2,0.4,0.8,0.3,0.25,0.8\n"
                          "talus,0.8,0.4,30,0.7,0.8\n"
                          "meadow,0,0.4,0.4,0.2,x\n"
                          "meadow,0.2,0.4,0.4,0.2,0\n"),
              "recipe.csv:2:1: found 'talus/2', expected letters, digits, _ and -\n"
              "recipe.csv:3:11: found block_high_m 0.4, expected at least block_low_m, 0.8\n"
              "recipe.csv:3:15: found cover '30', expected a number in [0, 0.55]; write a share of 1: divide "
              "percents by 100\n"
              "recipe.csv:3:18: found burial '0.7', expected a number in [0, 0.5]\n"
              "recipe.csv:4:8: found block_low_m '0', expected a number in (0, 5]\n"
              "recipe.csv:4:22: found gathering 'x', expected a number in [0, 1]\n"
              "recipe.csv:5:16: found a cover of 0.8 by all rows of meadow, expected at most 0.55");
}

TEST(StoppingRecipe, RefusesCodesThatDoNotTellSurfacesApart) {
    const std::string text = problems_of(
        "code,name,block_sizes_m,cover,burial,gathering\n"
        "1,a,0.5,0.1,0,0\n1,b,0.5,0.1,0,0\n2,a,0.5 -1,0.1,0,0\n");
    EXPECT_EQ(text,
              "recipe.csv:3:1: found code 1 of a, expected another code\n"
              "recipe.csv:4:1: found code 2 for a, expected code 1 as before\n"
              "recipe.csv:4:5: found block size '-1', expected a number in (0, 5]");
}

TEST(StoppingRecipe, NamesTheColumnsThatItLacks) {
    EXPECT_NE(problems_of("name,cover,burial\na,0.1,0\n").find("no column 'gathering'"), std::string::npos);
    EXPECT_NE(problems_of("name,cover,burial,gathering\na,0.1,0,0\n").find("no column 'block_low_m'"),
              std::string::npos);
    EXPECT_NE(problems_of("name,block_sizes_m,cover,burial,gathering\n").find("no surface"),
              std::string::npos);
}

TEST(StoppingRecipe, OfTheProgramDescribesEveryShippedGroundType) {
    std::istringstream in{std::string{config::shipped_table("stopping_recipe.csv")}};
    const auto recipes = read_recipe(config::Table::read(in, "stopping_recipe.csv"));
    const auto surfaces = shipped_surfaces();
    ASSERT_EQ(recipes.size(), surfaces.size());
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        EXPECT_EQ(recipes[i].name, surfaces[i].name);
    }
}

}  // namespace
}  // namespace coupling::stopping_recipe_test
