#include "coupling/assessments/calibrate/model/surveyed_trees.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "config/random/distributions.hpp"
#include "coupling/assessments/calibrate/model/seen_of.hpp"
#include "coupling/assessments/calibrate/search/self_distance.hpp"
#include "coupling/assessments/calibrate/sites/observation_checks.hpp"
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
    // A stem is held out with all its wounds, and with the hits on it.
    ASSERT_EQ(all.size(), 6U);
    EXPECT_EQ(all[0].seen, Seen::tree_dbh);
    EXPECT_EQ(all[3].seen, Seen::tree_dbh);
    EXPECT_TRUE(all[0].held_out.empty());
    EXPECT_TRUE(all[3].fit.empty());
    EXPECT_EQ(all[0].fit.size() + all[3].held_out.size(), 100U);
    EXPECT_TRUE(all[0].fit.size() == 40U || all[0].fit.size() == 60U) << all[0].fit.size();
    EXPECT_EQ(all[1].witness, all[0].witness);
    EXPECT_NE(all[2].witness, all[0].witness);
    EXPECT_NE(all[3].witness, all[2].witness);
    const bool is_first_fitted = all[0].fit.size() == 40U;
    const std::size_t first = is_first_fitted ? 0 : 3;  // observations of the first stem
    const std::size_t second = 3 - first;
    const auto at = [&](double x_m, double y_m) -> Eigen::Vector2d {
        return Eigen::Vector2d{x_m, y_m} - opened.site->origin_m();
    };
    SetRocks rocks;
    rocks.ends.resize(100);  // twice as many as were seen: every second hit counts
    for (int i = 0; i < 8; ++i) {
        rocks.hits.push_back({at(1060, 2050), 1.0F, 32.5F});
        rocks.hits.push_back({at(1080, 2061), 1.0F, 41.0F});  // not searched
    }
    EXPECT_EQ(seen_of(rocks, all[first], {}).size(), 8U);
    EXPECT_EQ(seen_of(rocks, all[first], {}).points[0].x(), 32.5);
    EXPECT_EQ(seen_of(rocks, all[first + 1], {}).points[0], at(1060, 2050));
    EXPECT_TRUE(seen_of(rocks, all[second], {}).empty());
    ASSERT_EQ(seen_of(rocks, all[first + 2], {}).size(), 1U);
    EXPECT_EQ(seen_of(rocks, all[first + 2], {}).points[0].x(), 4.0);
    ASSERT_EQ(seen_of(rocks, all[second + 2], {}).size(), 1U);
    EXPECT_EQ(seen_of(rocks, all[second + 2], {}).points[0].x(), 0.0);
    EXPECT_EQ(observations_on(*with("1060,2050,40,\n1070,2042,60,\n").site, {}, 1).size(), 4U)
        << "without the number of rocks the number of wounds says nothing";
}

/// Six stems in two columns: a rock that goes far hits those in the east.
class SixStems : public testing::Test {
protected:
    SixStems() {
        std::string trees = "tree_id,x_m,y_m,species,dbh_cm,height_m\n";
        for (int i = 0; i < stems; ++i) {
            trees += std::to_string(i + 1) + "," + std::to_string(east_m(i)) + "," +
                     std::to_string(north_m(i)) + ",ABAL," + std::to_string(dbh_cm(i)) + ",25\n";
        }
        project_.write("trees.csv", trees);
    }

    static constexpr int stems = 6;
    static int east_m(int stem) { return stem < 3 ? 1050 : 1090; }
    static int north_m(int stem) { return 2030 + 20 * (stem % 3); }
    static int dbh_cm(int stem) { return stem < 3 ? 30 : 50; }

    /// Hits of 100 rocks on all stems, of which a share are in the west.
    [[nodiscard]] SetRocks hits_by(double share_of_west, std::uint64_t number,
                                   const Eigen::Vector2d& origin_m) const {
        config::RandomStream stream{{1, 0, 0, number}, config::Purpose::parameter};
        SetRocks rocks;
        rocks.ends.resize(200);
        for (int i = 0; i < 200; ++i) {
            const bool is_west = stream.uniform() < share_of_west;
            const int stem = (is_west ? 0 : 3) + std::min(2, static_cast<int>(3.0 * stream.uniform()));
            rocks.hits.push_back({Eigen::Vector2d{east_m(stem), north_m(stem)} - origin_m, 1.0F,
                                  static_cast<float>(dbh_cm(stem))});
        }
        return rocks;
    }

    /// Searched stems of such a survey, as a mapper writes them.
    void write_survey(const SetRocks& rocks, const Eigen::Vector2d& origin_m) const {
        std::string rows = "x_m,y_m,scars,dbh_cm\n";
        for (int i = 0; i < stems; ++i) {
            const Eigen::Vector2d at_m = Eigen::Vector2d{east_m(i), north_m(i)} - origin_m;
            const auto scars = std::count_if(rocks.hits.begin(), rocks.hits.end(),
                                             [&](const SetRocks::Hit& hit) { return hit.stem_m == at_m; });
            rows += std::to_string(east_m(i)) + "," + std::to_string(north_m(i)) + "," +
                    std::to_string(scars) + "," + std::to_string(dbh_cm(i)) + "\n";
        }
        project_.write("searched.csv", rows);
    }

    /// How far surveys of rocks by one law are from sets by another one, in 95 % points of the sets.
    [[nodiscard]] double as_far(double share_seen, double share_of_sets, std::uint64_t number) const {
        const Opened bare = open(project_);
        const Eigen::Vector2d origin_m = bare.site->origin_m();
        write_survey(hits_by(share_seen, number, origin_m), origin_m);
        const Opened opened = open(project_, {"observed.trees=searched.csv", "observed.rocks=200"});
        EXPECT_TRUE(opened.site) << opened.errors;
        CalibrateSettings settings = opened.scenario->calibrate;
        settings.rocks = 300;
        const std::vector<Observation> all = observations_on(*opened.site, settings, number);
        std::vector<Witnessed> observed;
        for (const Observation& observation : all) {
            observed.push_back({observation.fit.size(), observation.witness, observation.least_scale()});
        }
        std::vector<std::vector<Sample>> sets;
        for (std::uint64_t set = 0; set < 20; ++set) {
            const SetRocks rocks = hits_by(share_of_sets, 1000 + set, origin_m);
            std::vector<Sample>& samples = sets.emplace_back();
            for (const Observation& observation : all) {
                samples.push_back(seen_of(rocks, observation, {}));
            }
        }
        const SelfDistance scale = self_distance(sets, observed, 1, 1);
        std::vector<double> distances;
        for (std::size_t i = 0; i < all.size(); ++i) {
            config::RandomStream stream{{2, 0, 0, number}, config::Purpose::parameter};
            distances.push_back(
                all[i].fit.empty()
                    ? 0.0
                    : energy_distance(all[i].fit, drawn_from({&sets[0][i]}, 1, all[i].fit.size(),
                                                             [&] { return stream.uniform(); })));
        }
        return scale.together(distances) / scale.at_95;
    }

    SampleProject project_;
};

/// The survey goes through its file, the hold-out and the samples of the sets. Of 20 honest ones one is
/// expected beyond the 95 % point; five or more of 20 are (binomial) no chance (0.3 %).
TEST_F(SixStems, OfTheModelAreAsNearToItAsItIsToItself) {
    int beyond = 0;
    for (std::uint64_t survey = 0; survey < 20; ++survey) {
        beyond += as_far(0.6, 0.6, survey) > 1.0 ? 1 : 0;
    }
    EXPECT_LT(beyond, 5);
    EXPECT_GT(as_far(0.25, 0.6, 3), 1.0) << "another law hits other stems";
}

}  // namespace
}  // namespace coupling::calibrate::surveyed_trees_test
