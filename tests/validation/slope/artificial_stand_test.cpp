#include "validation/engine/slope/artificial_stand.hpp"

#include <gtest/gtest.h>

#include "tests/validation/case_texts.hpp"
#include "validation/engine/kinds/validation_case.hpp"

namespace coupling::validation::artificial_stand_test {
namespace {

constexpr StandArea area{0.0, 200.0, 100.0};  // 2 ha

class SiteTwo : public ::testing::Test {
protected:
    std::unique_ptr<Recipe> recipe =
        read_case(testing::even_slope("slope", testing::stand_of_site_2)).recipe("strict");
    std::vector<ArtificialTree> trees = ArtificialStands{*recipe, area}.draw(0);
};

TEST_F(SiteTwo, HasThePublishedNumberOfStems) {
    EXPECT_EQ(trees.size(), 580U);
    EXPECT_EQ(stems_of(trees).size(), trees.size());
}

TEST_F(SiteTwo, HasThePublishedMeanAndDeviationOfDbh) {
    double sum = 0.0;
    double squares = 0.0;
    for (const ArtificialTree& tree : trees) {
        sum += tree.stem.dbh_cm;
        squares += tree.stem.dbh_cm * tree.stem.dbh_cm;
    }
    const double mean = sum / static_cast<double>(trees.size());
    EXPECT_NEAR(mean, 31.0, 0.05);  // quantiles at equal steps: no chance in it
    EXPECT_NEAR(std::sqrt(squares / static_cast<double>(trees.size()) - mean * mean), 14.0, 0.2);
}

TEST_F(SiteTwo, SharesItsBasalAreaAsPublished) {
    std::vector<double> of_species(4, 0.0);
    double all = 0.0;
    for (const ArtificialTree& tree : trees) {
        of_species[tree.species] += tree.stem.dbh_cm * tree.stem.dbh_cm;
        all += tree.stem.dbh_cm * tree.stem.dbh_cm;
    }
    // The shares given sum to 98 %; one tree of 80 cm has 0.9 % of the basal area.
    for (std::size_t i = 0; i < of_species.size(); ++i) {
        EXPECT_NEAR(of_species[i] / all, recipe->species[i].share, 0.01) << recipe->species[i].code;
    }
    EXPECT_NEAR(recipe->species[0].share, 72.0 / 98.0, 1e-12);
}

TEST_F(SiteTwo, KeepsItsStemsApartAndInside) {
    for (std::size_t i = 0; i < trees.size(); ++i) {
        const rockfall::Stem& a = trees[i].stem;
        EXPECT_GE(a.x_m, area.from_m);
        EXPECT_LE(a.x_m, area.to_m);
        EXPECT_LE(std::abs(a.y_m), 50.0);
        for (std::size_t j = 0; j < i; ++j) {
            ASSERT_GE(std::hypot(a.x_m - trees[j].stem.x_m, a.y_m - trees[j].stem.y_m), 2.0);
        }
    }
}

TEST_F(SiteTwo, IsDrawnFromItsNumber) {
    const ArtificialStands stands{*recipe, area};
    EXPECT_EQ(stands.draw(0)[7].stem.x_m, trees[7].stem.x_m);
    EXPECT_NE(stands.draw(1)[7].stem.x_m, trees[7].stem.x_m);
}

TEST(HeightOfDbh, RisesMoreAndMoreSlowly) {
    EXPECT_NEAR(height_of_dbh_m(0.0), 1.3, 1e-12);
    EXPECT_NEAR(height_of_dbh_m(31.0), 22.0, 0.5);
    EXPECT_GT(height_of_dbh_m(60.0), height_of_dbh_m(31.0));
    EXPECT_LT(height_of_dbh_m(60.0), 30.0);
}

}  // namespace
}  // namespace coupling::validation::artificial_stand_test
