#include "coupling/assessments/stopping/stopping_figures.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "config/data/shipped_tables.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/ground/stopping_input.hpp"

namespace coupling::stopping_figures_test {
namespace {

SurfaceRecipe talus() {
    rockfall::BlockKind kind;
    kind.cover = 0.2;
    return {"talus", 3, {kind}};
}

ThrowPlan small_plan() {
    ThrowPlan plan;
    plan.diameters_m = {0.5, 0.95};
    plan.surfaces = 6;
    plan.throws = 400;
    plan.threads = 1;
    return plan;
}

std::string table_of(const std::vector<SurfaceFigures>& figures) {
    std::ostringstream out;
    write_stopping_table(figures, "# how it was made\n", out);
    return out.str();
}

std::vector<SurfaceFigures> thrown(const std::vector<SurfaceRecipe>& recipes, const ThrowPlan& plan) {
    return throw_at_surfaces(recipes, plan, [] { return true; });
}

std::vector<SurfaceRecipe> shipped_recipes() {
    return read_recipe(config::read_shipped_table("stopping_recipe.csv"));
}

TEST(StoppingFigures, AreTheSameForAnyThreadsAndBesideOtherSurfaces) {
    SurfaceRecipe other = talus();
    other.name = "other";
    other.kinds[0].burial = 0.5;
    ThrowPlan plan = small_plan();
    const std::string alone = table_of(thrown({talus()}, plan));
    plan.threads = 3;
    const std::vector<SurfaceFigures> both = thrown({other, talus()}, plan);
    EXPECT_EQ(table_of({both[1]}), alone);
}

TEST(StoppingFigures, ChangeWithTheSeed) {
    ThrowPlan plan = small_plan();
    const std::string one = table_of(thrown({talus()}, plan));
    plan.seed = 2;
    EXPECT_NE(table_of(thrown({talus()}, plan)), one);
}

TEST(StoppingFigures, EndEarlyWhenAsked) {
    int surfaces = 0;
    EXPECT_TRUE(
        throw_at_surfaces(std::vector{talus()}, small_plan(), [&] { return ++surfaces < 2; }).empty());
    EXPECT_EQ(surfaces, 2);
}

TEST(StoppingFigures, ComeBackFromTheirTable) {
    const std::vector<SurfaceFigures> figures = thrown({talus()}, small_plan());
    std::istringstream in{table_of(figures)};
    const config::Table table = config::Table::read(in, "stopping.csv");
    config::Problems problems;
    const auto curves = read_stopping_curves(table, "code", problems);
    EXPECT_TRUE(problems.empty());
    for (const StoppingFigures& size : figures[0].sizes) {
        EXPECT_NEAR(curves.at("3").stopping.at(size.diameter_m), size.stop.value, 1e-6);
        EXPECT_NEAR(curves.at("3").rolling_stops_per_m.at(size.diameter_m), size.rolling.value, 1e-5);
        EXPECT_GT(size.stop.standard_error, 0.0);
    }
    EXPECT_EQ(table.text(0, "throws"), "2400");
    EXPECT_EQ(table.text(0, "surfaces"), "6");
    EXPECT_NEAR(figures[0].mean_cover, 0.2, 0.001);
}

TEST(ShippedStoppingTable, IsMadeFromTheShippedRecipe) {
    const std::string hash = hash_text(config::shipped_table("stopping_recipe.csv"));
    EXPECT_NE(config::shipped_table("stopping.csv").find("(" + hash + ")"), std::string_view::npos)
        << "make it again: bannwald stopping-table --out DIR";
}

TEST(ShippedStoppingTable, IsMadeAgainByteForByte) {
    // Two rows of it: the rest takes minutes.
    std::vector<SurfaceRecipe> recipes = shipped_recipes();
    std::erase_if(recipes, [](const SurfaceRecipe& recipe) { return recipe.name != "coarse_debris"; });
    ThrowPlan plan;
    plan.diameters_m = {0.5, 0.95};
    const std::string table = table_of(thrown(recipes, plan));
    std::istringstream rows{table};
    std::string row;
    for (int head = 0; head < 2; ++head) {
        std::getline(rows, row);
    }
    while (std::getline(rows, row)) {
        EXPECT_NE(config::shipped_table("stopping.csv").find('\n' + row + '\n'), std::string_view::npos)
            << row;
    }
}

TEST(ShippedStoppingTable, HasTheUsualDiametersForEverySurface) {
    const config::Table table = config::read_shipped_table("stopping.csv");
    EXPECT_EQ(table.rows(), shipped_recipes().size() * usual_diameters_m().size());
}

}  // namespace
}  // namespace coupling::stopping_figures_test
