#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "rockfall/tally/target.hpp"
#include "tests/coupling/inputs/opened.hpp"
#include "tests/runs/motion_models.hpp"
#include "tests/runs/years.hpp"

namespace coupling::works_run_test {
namespace {

constexpr const char* head_of_works =
    "name,kind,height_m,width_m,uphill_face_deg,downhill_face_deg,capacity_kj,investment,life_years,wkt\n";

/// A dam across the fall of the sample project, a wall below it.
void add_works(const SampleProject& project, const std::string& rows = "") {
    project.write(
        "works.csv",
        head_of_works + (rows.empty() ? "dam,dam,4,2,60,56,,200000,80,\"LINESTRING (1075 2025, 1075 2075)\"\n"
                                        "wall,wall,1.5,,,,20,50000,50,\"LINESTRING (1098 2010, 1098 2090)\"\n"
                                      : rows));
    project.replace("scenario.ini", "[targets]", "[works]\nfile = works.csv\n[targets]");
}

class WorksUnderModel : public ::testing::TestWithParam<std::string> {
protected:
    [[nodiscard]] static std::string motion() { return motion_settings(GetParam()); }
};
INSTANTIATE_TEST_SUITE_P(Motion, WorksUnderModel, ::testing::ValuesIn(motion_model_names()),
                         [](const auto& model) { return model.param; });

TEST_P(WorksUnderModel, CountEachRockOnceWithTheSameBytesOnAnyNumberOfThreads) {
    const SampleProject project;
    add_works(project);
    const std::string rocks = "run scenario.ini --quiet " + rocks_for(GetParam(), 9000) + motion();
    ASSERT_EQ(call(project, rocks + "--threads 1 --out first").code, 0);
    const Outcome outcome =
        shell(project, "\"$bannwald\" " + rocks + "--threads 5 --out second && diff -r first second\n");
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    const config::Table works = table(project, "first/tables/works.csv");
    ASSERT_EQ(works.rows(), 4U);  // two works, with forest and without
    for (std::size_t row = 0; row < works.rows(); ++row) {
        double sum = 0.0;
        for (const char* outcome_name : {"held", "over", "beside", "back", "broke"}) {
            sum += works.text(row, outcome_name).empty() ? 0.0 : number(works, row, outcome_name);
        }
        EXPECT_EQ(sum, number(works, row, "reached"));
        EXPECT_GT(sum, 0.0) << works.text(row, "work");
    }
    EXPECT_NE(project.read("first/report.html").find("Dams, ditches, walls and galleries"),
              std::string::npos);
}

TEST(Works, HaveTheirVolumeInTheCheckAsInTheTable) {
    const SampleProject project;
    add_works(project);
    const Outcome check = call(project, "check scenario.ini");
    ASSERT_EQ(check.code, 0) << check.err;
    ASSERT_EQ(call(project, "run scenario.ini --quiet --set release.rocks=20 --out out").code, 0);
    const config::Table works = table(project, "out/tables/works.csv");
    const auto rounded = [&](const char* column) {
        return std::to_string(std::lround(number(works, 0, column)));
    };
    ASSERT_EQ(works.text(0, "work"), "dam");
    EXPECT_NE(check.out.find("dam dam: " + rounded("volume_m3") + " m3 of earth heaped, " +
                             rounded("area_m2") + " m2 of ground\n"),
              std::string::npos)
        << check.out;
    EXPECT_EQ(check.out.find("wall wall"), std::string::npos) << "a wall takes no earth";
}

/// Rocks at rest in the area at which a dam counts are held there, whatever way they took, and no others.
TEST_P(WorksUnderModel, HoldTheRocksThatEndInside) {
    const SampleProject project;
    add_works(project);
    const std::string rocks_of_model = rocks_for(GetParam(), 5000);
    ASSERT_EQ(call(project, "run scenario.ini --quiet " + rocks_of_model + motion() + "--out out").code, 0);
    const Opened opened = open(project);
    ASSERT_TRUE(opened.site) << opened.errors;
    rockfall::Target area;
    area.parts = {opened.site->works.front().counted_m};
    const Eigen::Vector2d origin_m = opened.site->origin_m();
    const config::Table works = table(project, "out/tables/works.csv");
    const config::Table rocks = table(project, "out/tables/rocks.csv");
    for (std::size_t row = 0; row < works.rows(); ++row) {
        if (works.text(row, "work") != "dam") {
            continue;
        }
        double inside = 0.0;
        for (std::size_t rock = 0; rock < rocks.rows(); ++rock) {
            const Eigen::Vector2d end_m{number(rocks, rock, "x_end_m"), number(rocks, rock, "y_end_m")};
            inside += rocks.text(rock, "cover") == works.text(row, "cover") &&
                              rockfall::is_inside(area, end_m - origin_m)
                          ? 1.0
                          : 0.0;
        }
        EXPECT_GT(inside, 0.0);
        EXPECT_EQ(number(works, row, "held"), inside);
    }
}

TEST(Works, LowerThanTheSmallestRockChangeNothing) {
    const SampleProject project;
    add_works(project, "low,wall,0.01,,,,1,,,\"LINESTRING (1098 2010, 1098 2090)\"\n");
    const std::string rocks = "run scenario.ini --quiet --set release.rocks=2000 ";
    ASSERT_EQ(call(project, rocks + "--out with").code, 0);
    ASSERT_EQ(call(project, rocks + "--set works.file= --out without").code, 0);
    for (const char* name : {"rocks.csv", "arrivals.csv", "targets.csv", "runs.csv"}) {
        EXPECT_EQ(project.read("with/tables/" + std::string{name}),
                  project.read("without/tables/" + std::string{name}))
            << name;
    }
}

TEST(Works, CoverARoadWithAGallery) {
    const SampleProject project;
    const std::string roof = "\"POLYGON ((1101 2006, 1109 2006, 1109 2094, 1101 2094, 1101 2006))\"\n";
    add_works(project, "roof,gallery,,,,,,,," + roof);
    const auto reached = [&](const std::string& out) {
        const config::Table targets = table(project, out + "/tables/targets.csv");
        double rocks = 0.0;
        for (std::size_t row = 0; row < targets.rows(); ++row) {
            rocks += targets.text(row, "target_id") == "road" ? number(targets, row, "reached") : 0.0;
        }
        return rocks;
    };
    const std::string rocks = "run scenario.ini --quiet --set release.rocks=2000 ";
    ASSERT_EQ(call(project, rocks + "--out covered").code, 0);
    EXPECT_EQ(reached("covered"), 0.0);
    ASSERT_EQ(call(project, rocks + "--set works.file= --out open").code, 0);
    const double all = reached("open");
    EXPECT_GT(all, 50.0);
    project.write("works.csv", head_of_works + ("roof,gallery,,,,,10,,," + roof));
    ASSERT_EQ(call(project, rocks + "--out weak").code, 0);
    EXPECT_GT(reached("weak"), 0.0);
    EXPECT_LT(reached("weak"), all);
}

/// What they held of the rocks of each return period, and what the maps draw, in the caption and in the key.
TEST(Works, StandOnTheHazardPage) {
    const SampleProject project;
    project.write("blocks.csv", "return_period_years,zone,diameter_m\n10,1,0.3\n100,1,0.8\n");
    project.replace("scenario.ini", "diameter_m = 0.5\n", "");
    project.replace("scenario.ini", "[targets]", "[hazard]\nblocks = blocks.csv\n[targets]");
    add_works(project);
    const std::string run = "run scenario.ini --quiet --set release.rocks=600 ";
    ASSERT_EQ(call(project, run + "--out out").code, 0);
    const std::string page = project.read("out/hazard/report.html");
    const std::size_t section = page.find("<h2>Nets and works</h2>");
    ASSERT_NE(section, std::string::npos);
    std::size_t at = section;
    for (const char* work : {"dam", "wall"}) {
        for (const char* cover : {"forest", "bare"}) {
            at = page.find(
                std::string{work} + ", " + (cover == std::string{"bare"} ? "bare slope" : "with forest"), at);
            ASSERT_NE(at, std::string::npos) << work << cover;
            for (const char* outcome : {"reached", "held", "over", "beside", "back", "broke"}) {
                for (const char* years : {"10", "100"}) {
                    const config::Table works =
                        table(project, std::string{"out/return_period_"} + years + "/tables/works.csv");
                    for (std::size_t row = 0; row < works.rows(); ++row) {
                        const std::string& rocks = works.text(row, outcome);
                        if (works.text(row, "work") == work && works.text(row, "cover") == cover &&
                            !rocks.empty()) {
                            at = page.find("<td>" + rocks + " (", at);
                            ASSERT_NE(at, std::string::npos) << work << cover << outcome << years;
                        }
                    }
                }
            }
        }
    }
    EXPECT_NE(page.find("Blue unbroken lines: dams"), std::string::npos);
    EXPECT_EQ(page.find("Blue broken lines"), std::string::npos);
    ASSERT_EQ(call(project, run + "--set report.language=de --out deutsch").code, 0);
    const std::string german = project.read("deutsch/hazard/report.html");
    EXPECT_NE(german.find("Blau durchgezogen: Dämme"), std::string::npos);
    EXPECT_EQ(german.find("Blau gestrichelt"), std::string::npos);
}

TEST(Works, AreSetAgainstTheirCost) {
    const SampleProject project;
    project.write("targets.csv",
                  "target_id,name,wkt,vehicles_per_day,speed_kmph,persons_per_vehicle\n"
                  "road,road,\"LINESTRING (1105 2010, 1105 2090)\",1200,60,1.6\n");
    project.write("blocks.csv", "return_period_years,zone,diameter_m\n10,1,0.3\n100,1,0.8\n");
    project.replace("scenario.ini", "diameter_m = 0.5\n", "");
    project.replace("scenario.ini", "[targets]",
                    "[hazard]\nblocks = blocks.csv\n[risk]\nassess = yes\nprevented_death = 4e6\n[targets]");
    const std::string run = "run scenario.ini --quiet --set release.rocks=600 ";
    ASSERT_EQ(call(project, run + "--out before").code, 0);
    add_works(project);
    const Outcome outcome = call(project, run + "--set risk.without=before --out with");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const config::Table avoided = table(project, "with/hazard/tables/risk_avoided.csv");
    const config::Table now = table(project, "with/hazard/tables/risk_total.csv");
    const config::Table before = table(project, "before/hazard/tables/risk_total.csv");
    ASSERT_EQ(avoided.rows(), 2U);
    for (std::size_t row = 0; row < avoided.rows(); ++row) {
        ASSERT_EQ(avoided.text(row, "cover"), now.text(row, "cover"));
        const double with = number(now, row, "money_per_year");
        const double without = number(before, row, "money_per_year");
        EXPECT_NEAR(number(avoided, row, "money_with_per_year"), with, 1e-5 * without);
        EXPECT_NEAR(number(avoided, row, "money_without_per_year"), without, 1e-5 * without);
        EXPECT_NEAR(number(avoided, row, "avoided_money_per_year"), without - with, 2e-5 * without);
        EXPECT_GT(without - with, 0.0);
        EXPECT_LE(number(avoided, row, "avoided_money_low_per_year"),
                  number(avoided, row, "avoided_money_per_year"));
        // 200 000 over 80 years and 50 000 over 50 years at 2 %: factors 0.025161 and 0.031823.
        const double cost = number(avoided, row, "cost_per_year");
        EXPECT_NEAR(cost, 200'000.0 * 0.0251607 + 50'000.0 * 0.0318232, 0.1);
        EXPECT_NEAR(number(avoided, row, "benefit_by_cost"), (without - with) / cost, 1e-4 * without / cost);
    }
    EXPECT_EQ(table(project, "with/hazard/tables/risk_barriers.csv").rows(), 2U);
    const std::string page = project.read("with/hazard/report.html");
    EXPECT_NE(page.find("What nets and works spare"), std::string::npos);
    EXPECT_NE(page.find("2, standing on both slopes"), std::string::npos);
    // Levels without them are those of the run without, whatever rule that map was made by.
    const config::Table levels = table(project, "with/hazard/tables/hazard_targets.csv");
    const config::Table levels_before = table(project, "before/hazard/tables/hazard_targets.csv");
    ASSERT_EQ(levels.rows(), levels_before.rows());
    bool differ = false;
    bool is_of_few = false;
    for (std::size_t row = 0; row < levels.rows(); ++row) {
        is_of_few = is_of_few || (levels.text(row, "level") != levels_before.text(row, "level") &&
                                  levels.text(row, "energy_is") == "largest");
        EXPECT_EQ(levels.text(row, "level_without_barriers"), levels_before.text(row, "level"));
        EXPECT_EQ(levels_before.text(row, "level_without_barriers"), "");
        differ = differ || levels.text(row, "level") != levels_before.text(row, "level");
    }
    EXPECT_EQ(page.find("of them too few rocks still arrive") != std::string::npos, is_of_few);
    EXPECT_NE(
        page.find(
            differ
                ? "The nets and works that the run of risk.without lacks change the level at 1 of 1 target:"
                : "The nets and works that the run of risk.without lacks change the level at none of the "
                  "targets (1)"),
        std::string::npos);
    EXPECT_EQ(page.find("With risk.without = the folder"), std::string::npos);

    const Outcome other = call(project, run + "--set risk.without=before --set run.seed=2 --out other");
    EXPECT_EQ(other.code, 2) << other.err;
    EXPECT_NE(other.err.find("run.seed"), std::string::npos) << other.err;
    const Outcome checked =
        call(project, "check scenario.ini --set release.rocks=600 --set risk.without=nowhere");
    EXPECT_EQ(checked.code, 2) << checked.err;
    const Outcome none = call(project, run + "--set risk.without=nowhere --out other");
    EXPECT_EQ(none.code, 2) << none.err;
    EXPECT_NE(none.err.find("no finished return period"), std::string::npos) << none.err;
    // Costs change no fall: nothing is simulated again.
    project.replace("works.csv", "200000", "300000");
    const Outcome dearer =
        call(project, "run scenario.ini --set release.rocks=600 --set risk.without=before --out with");
    EXPECT_EQ(dearer.code, 0) << dearer.err;
    EXPECT_NE(dearer.out.find("finished before"), std::string::npos) << dearer.out;

    // What is set against the cost must be the same rocks, and what the new works spare alone.
    const Outcome central =
        call(project, run + "--set risk.without=before --set run.parameter_draws=no --out other");
    EXPECT_EQ(central.code, 2) << central.err;
    EXPECT_NE(central.err.find("run.parameter_draws"), std::string::npos) << central.err;
    project.replace("works.csv", "dam,dam,4,", "dam,dam,5,");
    const Outcome higher = call(project, run + "--set risk.without=with --out other");
    EXPECT_EQ(higher.code, 2) << higher.err;
    EXPECT_NE(higher.err.find("'dam' of another size"), std::string::npos) << higher.err;
    const Outcome fewer = call(project, run + "--set risk.without=with --set works.file= --out other");
    EXPECT_EQ(fewer.code, 2) << fewer.err;
    EXPECT_NE(fewer.err.find("which this run has not"), std::string::npos) << fewer.err;
}

}  // namespace
}  // namespace coupling::works_run_test
