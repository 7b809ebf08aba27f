#include "coupling/assessments/decades/members/member_keys.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "tests/coupling/inputs/forest_project.hpp"

namespace coupling::decades::member_keys_test {
namespace {

/// A study of two regimes, as far as keys need it.
class MemberKeysOfAStudy : public ::testing::Test {
protected:
    struct Study {
        Opened opened;
        Management management;

        [[nodiscard]] MemberKeys keys() const { return {*opened.scenario, *opened.site, management}; }
        [[nodiscard]] std::string of(std::uint32_t regime, std::uint32_t replicate = 0) const {
            return keys().of({.regime = regime, .replicate = replicate});
        }
    };
    [[nodiscard]] Study study(std::vector<std::string> overrides = {}) const {
        overrides.insert(overrides.begin(), {"regimes.list=none, pfm1", "trees.file=",
                                             "stands.records=records.csv", "climate.sequence=random"});
        Study made{open(project_, overrides), {}};
        EXPECT_TRUE(made.opened.site) << made.opened.errors;
        config::Warnings ignored;
        made.management = read_management(*made.opened.scenario, *made.opened.site->forest, ignored, 0.5);
        return made;
    }

    ForestProject project_;
};

// Whatever file is read next: it counts, but that of another regime. Weather and places of targets count in
// place of their files.
TEST_F(MemberKeysOfAStudy, DependOnEachInput) {
    Study made = study({"run.years=2"});
    const std::string key = made.of(0);
    const std::string bare = made.keys().of_bare(0, 0);
    ASSERT_GT(made.opened.site->inputs.size(), 5U);
    for (InputFile& input : made.opened.site->inputs) {
        const std::string hash = std::exchange(input.hash, "another");
        const bool counts = !input.role.starts_with("climate") && !input.role.starts_with("targets");
        EXPECT_EQ(made.of(0) != key, counts) << input.role;
        EXPECT_EQ(made.keys().of_bare(0, 0) != bare, counts) << input.role;
        input.hash = hash;
    }
    made.management.read_for[1] = "another regime";
    EXPECT_EQ(made.of(0), key);
    made.management.read_for[0] = "another regime";
    EXPECT_NE(made.of(0), key);
    EXPECT_EQ(made.keys().of_bare(0, 0), bare);
    made.management.shared_inputs.push_back({"prices", "prices.csv", "hash", 1});
    EXPECT_NE(made.keys().of_bare(0, 0), bare);
}

TEST_F(MemberKeysOfAStudy, DependOnTheWeatherOfTheirYears) {
    const Study made = study();
    EXPECT_NE(made.of(0), made.of(1));
    EXPECT_NE(made.of(0, 0), made.of(0, 1));
    for (const char* change : {"climate.temperature_change_k=0.01", "climate.precipitation_change=1.01",
                               "climate.window_last_year=2007", "climate.elevation_m=501"}) {
        EXPECT_NE(study({change}).of(0), made.of(0)) << change;
    }
    // A value of one month.
    project_.replace("climate.csv", ",110,", ",111,");
    EXPECT_NE(study().of(0), made.of(0));
}

TEST_F(MemberKeysOfAStudy, DependOnWhereTargetsAreAndNotOnWhatIsThere) {
    const auto with_targets = [&](const std::string& columns, const std::string& wkt,
                                  const std::string& fields) {
        project_.write("targets.csv",
                       "target_id,name,wkt" + columns + "\nroad,road,\"" + wkt + "\"" + fields + "\n");
        return study().of(0);
    };
    const std::string line = "LINESTRING (1105 2010, 1105 2090)";
    const std::string key = with_targets("", line, "");
    const std::string traffic = ",vehicles_per_day,speed_kmph,persons_per_vehicle";
    EXPECT_EQ(with_targets(traffic, line, ",1200,60,1.6"), key);
    EXPECT_EQ(with_targets(traffic, line, ",600,60,1.6"), key);
    project_.write("others.csv", project_.read("targets.csv"));
    EXPECT_EQ(study({"targets.file=others.csv"}).of(0), key);
    EXPECT_NE(study({"targets.file="}).of(0), key);
    EXPECT_NE(with_targets("", "LINESTRING (1105 2010, 1105.5 2090)", ""), key);
    EXPECT_NE(with_targets("", "LINESTRING (1105 2010, 1105 2050, 1105 2090)", ""), key);
    EXPECT_NE(with_targets("", "POLYGON ((1105 2010, 1105 2090, 1107 2090, 1105 2010))", ""), key);
}

TEST_F(MemberKeysOfAStudy, DoNotDependOnWhatAStudyCompares) {
    const Study made = study();
    for (const char* change : {"run.replicates=7", "decision.protection_at_least=60", "report.title=Wald",
                               "output.geopackage=no", "risk.rocks_per_year=3", "risk.prevented_death=1",
                               "risk.currency=EUR", "risk.vehicle_length_m=9", "risk.passages_per_day=7"}) {
        EXPECT_EQ(study({change}).of(0), made.of(0)) << change;
    }
    for (const char* change : {"run.years=3", "release.rocks=9", "run.seed=5", "disturbance.wind=yes"}) {
        EXPECT_NE(study({change}).of(0), made.of(0)) << change;
    }
}

TEST_F(MemberKeysOfAStudy, AreThoseOfALongerRunForItsFirstYears) {
    const Member second{.regime = 1, .replicate = 1};
    const auto with_change = [&](std::vector<std::string> more, const char* change_years) {
        more.insert(more.end(),
                    {"climate.temperature_change_k=2", std::string{"climate.change_years="} + change_years});
        return study(more);
    };
    const Study two = with_change({"run.years=2"}, "3");
    const Study five = with_change({"run.years=5", "output.map_years=1", "output.tree_list_years=2, 4"}, "3");
    const Study slower = with_change({"run.years=5"}, "4");
    const std::string key = two.keys().of(second);
    const MemberKeys longer = five.keys();
    EXPECT_EQ(longer.of(second, 2), key);
    EXPECT_NE(longer.of(second, 3), key);
    EXPECT_NE(longer.of(second), key);
    EXPECT_NE(slower.keys().of(second, 2), key) << "a setting of all years, and their weather";
}

TEST_F(MemberKeysOfAStudy, KnowASpinUpThatIsLongerThanTheRun) {
    const Member second{.regime = 1, .replicate = 1};
    const auto with_years = [&](const char* years) {
        return study({std::string{"run.years="} + years, "stands.spin_up_years=4"});
    };
    const Study two = with_years("2");
    const Study three = with_years("3");
    const Study four = with_years("4");
    const Study five = with_years("5");
    const MemberKeys of_three = three.keys();
    const MemberKeys of_five = five.keys();
    const std::string key_of_two = two.keys().of(second);
    EXPECT_NE(of_three.of(second, 2), key_of_two) << "both take their weather again";
    EXPECT_NE(of_five.of(second, 2), key_of_two);
    EXPECT_NE(of_five.of(second, 3), of_three.of(second));
    EXPECT_EQ(of_five.of(second, 4), four.keys().of(second));
}

TEST_F(MemberKeysOfAStudy, NameABlockOverTheBareSlopeByItsYearsAndMaps) {
    const Study shorter = study({"run.years=14", "climate.sequence=repeat"});
    const Study longer = study({"run.years=24", "climate.sequence=repeat"});
    ASSERT_EQ(YearBlocks{*shorter.opened.scenario}.count(), 2U);
    EXPECT_EQ(longer.keys().of_bare(0, 0), shorter.keys().of_bare(0, 0)) << "years 0 to 9";
    EXPECT_NE(longer.keys().of_bare(0, 1), shorter.keys().of_bare(0, 1)) << "to 14, to 19";
    EXPECT_NE(longer.keys().of_bare(1, 0), shorter.keys().of_bare(0, 0));
    EXPECT_NE(study({"run.years=14", "climate.sequence=repeat", "output.map_years=3"}).keys().of_bare(0, 0),
              shorter.keys().of_bare(0, 0));
}

}  // namespace
}  // namespace coupling::decades::member_keys_test
