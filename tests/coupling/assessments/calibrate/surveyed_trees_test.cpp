#include "coupling/assessments/calibrate/model/surveyed_trees.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "config/random/distributions.hpp"
#include "coupling/assessments/calibrate/model/seen_of.hpp"
#include "coupling/assessments/calibrate/observation_checks.hpp"
#include "coupling/assessments/calibrate/search/self_distance.hpp"
#include "tests/coupling/inputs/opened.hpp"

namespace coupling::calibrate::surveyed_trees_test {
namespace {

/// The sample slope has three stems: at 1060, 1070 and 1080 east, of 32.5, 20 and 41 cm.
class SearchedStems : public testing::Test {
protected:
    [[nodiscard]] const Opened& with(const std::string& rows, std::vector<std::string> settings = {}) {
        project_.write("searched.csv", "x_m,y_m,scars,dbh_cm\n" + rows);
        settings.push_back("observed.trees=searched.csv");
        opened_ = std::make_unique<Opened>(open(project_, settings));
        return *opened_;
    }

    SampleProject project_;
    std::unique_ptr<Opened> opened_;
};

TEST_F(SearchedStems, AreTheNearestStemsWithinAMetre) {
    const Opened& opened =
        with("1060.5,2050,4,32\n1070,2042,0,\n1080,2061,1,20\n1065,2045,2,\n1060,2050.4,1,\n");
    ASSERT_TRUE(opened.site) << opened.errors;
    const SurveyedTrees trees{*opened.site, 0.0};
    ASSERT_EQ(trees.trees().size(), 3U);
    EXPECT_EQ(trees.scars(), 5U);
    EXPECT_EQ(std::vector<std::size_t>(trees.without_stem().begin(), trees.without_stem().end()),
              std::vector<std::size_t>{5});
    EXPECT_EQ(std::vector<std::size_t>(trees.repeated().begin(), trees.repeated().end()),
              std::vector<std::size_t>{6});
    EXPECT_EQ(std::vector<std::size_t>(trees.of_other_size().begin(), trees.of_other_size().end()),
              std::vector<std::size_t>{4});
    const auto first = trees.find(Eigen::Vector2d{1060.0, 2050.0} - opened.site->origin_m());
    ASSERT_TRUE(first);
    EXPECT_EQ(trees.trees()[*first].dbh_cm, 32.5);
    EXPECT_FALSE(trees.find(Eigen::Vector2d{1060.5, 2050.0} - opened.site->origin_m()));
    EXPECT_EQ(SurveyedTrees(*opened.site, 25.0).trees().size(), 2U) << "thinner stems were not searched";
}

TEST_F(SearchedStems, AreRefusedWithTheirLine) {
    const Opened& wrong = with("1060,2050,-1,\n1070,,1,\n1080,2061,1.5,\n");
    EXPECT_EQ(wrong.code, config::ExitCode::data);
    for (const char* line : {"searched.csv:2:", "searched.csv:3:", "searched.csv:4:"}) {
        EXPECT_NE(wrong.errors.find(line), std::string::npos) << line << "\n" << wrong.errors;
    }
    config::Warnings warnings;
    const auto refusal = [&](const std::string& rows) {
        const Opened& opened = with(rows);
        try {
            check_observations(*opened.scenario, *opened.site, warnings);
        } catch (const config::InputError& error) {
            return std::string{error.what()};
        }
        return std::string{};
    };
    EXPECT_NE(refusal("1060,2050,1,\n1060.4,2050,1,\n").find("searched.csv:3"), std::string::npos);
    EXPECT_NE(refusal("1060,2050,1,\n1063,2050,1,\n").find("1 of 2 stems where trees.file has none"),
              std::string::npos);
}

TEST_F(SearchedStems, ShowHitsOnThemAlone) {
    const Opened& opened = with("1060,2050,40,\n1070,2042,60,\n", {"observed.rocks=50"});
    ASSERT_TRUE(opened.site) << opened.errors;
    const auto all = observations_on(*opened.site, opened.scenario->calibrate, 1);
    ASSERT_EQ(all.size(), 3U);
    EXPECT_EQ(all[0].seen, Seen::tree_dbh);
    EXPECT_EQ(all[0].fit.size() + all[0].held_out.size(), 100U);
    // A stem is held out with all its wounds.
    EXPECT_TRUE(all[0].held_out.size() == 40U || all[0].held_out.size() == 60U || all[0].held_out.empty())
        << all[0].held_out.size();
    EXPECT_EQ(all[1].witness, all[0].witness);
    EXPECT_NE(all[2].witness, all[0].witness);
    const auto at = [&](double x_m, double y_m) -> Eigen::Vector2d {
        return Eigen::Vector2d{x_m, y_m} - opened.site->origin_m();
    };
    SetRocks rocks;
    rocks.ends.resize(100);  // twice as many as were seen: every second hit counts
    for (int i = 0; i < 8; ++i) {
        rocks.hits.push_back({at(1060, 2050), 1.0F, 32.5F});
        rocks.hits.push_back({at(1080, 2061), 1.0F, 41.0F});  // not searched
    }
    EXPECT_EQ(seen_of(rocks, all[0], {}).size(), 8U);
    EXPECT_EQ(seen_of(rocks, all[0], {}).points[0].x(), 32.5);
    EXPECT_EQ(seen_of(rocks, all[1], {}).points[0], at(1060, 2050));
    const Sample scars = seen_of(rocks, all[2], {});
    ASSERT_EQ(scars.size(), 2U);
    EXPECT_EQ(scars.points[0].x(), 4.0);
    EXPECT_EQ(scars.points[1].x(), 0.0);
    EXPECT_EQ(observations_on(*with("1060,2050,40,\n1070,2042,60,\n").site, {}, 1).size(), 2U)
        << "without the number of rocks the number of wounds says nothing";
}

/// Wounds of the model by one law, and the same wounds as somebody counted them.
TEST_F(SearchedStems, OfTheModelAreAsNearToItAsItIsToItself) {
    const Opened& opened = with("1060,2050,1,\n1070,2042,1,\n1080,2061,8,\n", {"observed.rocks=50"});
    ASSERT_TRUE(opened.site) << opened.errors;
    const auto all = observations_on(*opened.site, opened.scenario->calibrate, 1);
    const auto hits_by = [&](double share_of_first, std::uint64_t number) {
        config::RandomStream stream{{1, 0, 0, number}, config::Purpose::parameter};
        SetRocks rocks;
        rocks.ends.resize(300);
        for (int i = 0; i < 100; ++i) {
            const bool is_first = stream.uniform() < share_of_first;
            const Eigen::Vector2d stem_m =
                Eigen::Vector2d{is_first ? 1060.0 : 1070.0, is_first ? 2050.0 : 2042.0} -
                opened.site->origin_m();
            rocks.hits.push_back({stem_m, 1.0F, is_first ? 32.5F : 20.0F});
        }
        return seen_of(rocks, all[0], {});
    };
    std::vector<std::vector<Sample>> sets;
    for (std::uint64_t set = 0; set < 20; ++set) {
        sets.push_back({hits_by(0.7, set)});
    }
    const SelfDistance scale = self_distance(sets, {{60, 0}}, 1, 1);
    const auto distance_of = [&](double share) {
        return scale.together({energy_distance(thinned(hits_by(share, 99), 60), thinned(sets[0][0], 60))});
    };
    EXPECT_LE(distance_of(0.7), scale.at_95);
    EXPECT_GT(distance_of(0.2), scale.at_95);
}

}  // namespace
}  // namespace coupling::calibrate::surveyed_trees_test
