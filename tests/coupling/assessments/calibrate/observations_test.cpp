#include "coupling/assessments/calibrate/model/observations.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <set>

#include "coupling/assessments/calibrate/model/seen_of.hpp"
#include "coupling/assessments/calibrate/outcome/calibrated_scenario.hpp"
#include "coupling/assessments/calibrate/sites/observation_checks.hpp"
#include "tests/coupling/inputs/opened.hpp"

namespace coupling::calibrate::observations_test {
namespace {

/// Rows of stops at the foot of the sample slope; `group_of` of each.
std::string stops(int rows, const std::function<std::string(int)>& group_of) {
    std::string text = "x_m,y_m,group\n";
    for (int i = 0; i < rows; ++i) {
        text += std::to_string(1060 + i) + ",2050," + group_of(i) + "\n";
    }
    return text;
}

class Observations : public testing::Test {
protected:
    [[nodiscard]] std::vector<Observation> of(const std::string& table,
                                              std::vector<std::string> settings = {}) const {
        project_.write("stops.csv", table);
        settings.push_back("observed.stops=stops.csv");
        opened_ = std::make_unique<Opened>(open(project_, settings));
        if (!opened_->site) {
            ADD_FAILURE() << opened_->errors;
            return {};
        }
        return observations_on(*opened_->site, opened_->scenario->calibrate, 1);
    }

    SampleProject project_;
    mutable std::unique_ptr<Opened> opened_;
};

TEST_F(Observations, HoldOutAShare) {
    const auto all = of(stops(40, [](int) { return ""; }));
    ASSERT_EQ(all.size(), 2U);  // places and run-outs
    EXPECT_EQ(all[0].held_out.size(), 8U);
    EXPECT_EQ(all[0].fit.size(), 32U);
    EXPECT_EQ(of(stops(40, [](int) { return ""; }), {"calibrate.hold_out_percent=50"})[0].fit.size(), 20U);
}

TEST_F(Observations, HoldOutWholeGroupsWhereThereAreSeveral) {
    const auto all = of(stops(40, [](int i) { return "event " + std::to_string(i / 4); }));
    EXPECT_EQ(all[0].held_out.size(), 8U);
    std::set<int> events;
    for (const Eigen::Vector2d& point : all[0].held_out.points) {
        events.insert(static_cast<int>(point.x() + opened_->site->origin_m().x() - 1060.0) / 4);
    }
    EXPECT_EQ(events.size(), 2U);
}

TEST_F(Observations, HoldOutAGroupByItsName) {
    const auto group = [](int i) { return i < 10 ? "one" : "two"; };
    EXPECT_EQ(of(stops(40, group), {"calibrate.hold_out_group=one"})[0].held_out.size(), 10U);
    EXPECT_THROW((void)of(stops(40, group), {"calibrate.hold_out_group=three"}), config::InputError);
}

TEST_F(Observations, AreRefusedWhereTheyAreTooFew) {
    EXPECT_THROW((void)of(stops(5, [](int) { return ""; })), config::InputError);
}

TEST_F(Observations, DoToSimulatedRocksWhatWasDoneInTheField) {
    project_.write("window.csv",
                   "wkt\n\"POLYGON ((1000 2000, 1080 2000, 1080 2100, 1000 2100, 1000 2000))\"\n");
    const auto all = of(stops(20, [](int) { return ""; }),
                        {"calibrate.window=window.csv", "calibrate.least_diameter_m=0.4"});
    const Search search = search_on(*opened_->site, opened_->scenario->calibrate);
    const Eigen::Vector2d origin = opened_->site->origin_m();
    SetRocks rocks;
    const Eigen::Vector2d start = Eigen::Vector2d{1025.0, 2050.0} - origin;
    for (const auto& [x_m, diameter_m] :
         {std::pair{1060.0, 0.5F}, std::pair{1090.0, 0.5F}, std::pair{1070.0, 0.3F}}) {
        rocks.ends.push_back({start, Eigen::Vector2d{x_m, 2050.0} - origin, 1, diameter_m});
    }
    const Sample seen = seen_of(rocks, all[0], search);
    ASSERT_EQ(seen.size(), 1U);
    EXPECT_EQ(seen.points[0].x() + origin.x(), 1060.0);
    // The sources are cells of 10 m from 1020 to 1030.
    EXPECT_NEAR(seen_of(rocks, all[1], search).points[0].x(), 35.0, 10.0);
}

TEST_F(Observations, ThatCannotBeAreRefusedOrWarnedOf) {
    config::Warnings warnings;
    (void)of(stops(20, [](int) { return ""; }));
    check_observations(*opened_->scenario, *opened_->site, warnings);
    EXPECT_TRUE(warnings.warnings().empty());
    // West of the sources, which lie in the west of a slope that falls eastward.
    (void)of("x_m,y_m\n1005,2050\n" + stops(20, [](int) { return ""; }).substr(14));
    check_observations(*opened_->scenario, *opened_->site, warnings);
    ASSERT_EQ(warnings.warnings().size(), 1U);
    EXPECT_NE(warnings.warnings()[0].find("1 of 21 stops above all sources"), std::string::npos);
    (void)of("x_m,y_m\n1006,2050\n1007,2050\n1008,2050\n" + stops(10, [](int) { return ""; }).substr(14));
    EXPECT_THROW(check_observations(*opened_->scenario, *opened_->site, warnings), config::InputError);
}

TEST(CalibratedScenarios, LeadToTheSameFilesFromElsewhere) {
    const SampleProject project;
    std::filesystem::create_directory(project.file("out"));
    const Opened first =
        open(project, {"release.rocks_per_source=7", "targets.file=targets.csv", "ground.3.r_t=0.71"});
    ASSERT_TRUE(first.site) << first.errors;
    project.write("out/calibrated.ini",
                  calibrated_scenario(*first.scenario, project.file("out"), "", "# from a test\n"));
    const auto again = read_scenario(project.file("out/calibrated.ini"), {});
    EXPECT_EQ(again->release.rocks_per_source, 7U);
    config::Warnings warnings;
    const Site site = open_site(*again, warnings);
    EXPECT_EQ(site.heights.values, first.site->heights.values);
    EXPECT_EQ(site.trees.size(), first.site->trees.size());
    EXPECT_EQ(site.targets.size(), first.site->targets.size());
    EXPECT_EQ(site.slope.types[1].restitution.tangential, 0.71) << "values of single ground types too";
}

}  // namespace
}  // namespace coupling::calibrate::observations_test
