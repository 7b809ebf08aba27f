#include <gtest/gtest.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "coupling/assessments/consequences/risk_words.hpp"
#include "coupling/inputs/formats/json_library.hpp"
#include "tests/runs/years.hpp"

namespace coupling::risk_run_test {
namespace {

void expose(const SampleProject& project, const std::string& vehicles = "1200") {
    project.write("targets.csv",
                  "target_id,name,wkt,vehicles_per_day,speed_kmph,persons_per_vehicle,persons,hours_per_day,"
                  "house_value\nroad,road,\"LINESTRING (1105 2010, 1105 2090)\"," +
                      vehicles +
                      ",60,1.6,,,\nhouse,house,\"POLYGON ((1090 2040, 1100 2040, 1100 2050, 1090 2050, 1090 "
                      "2040))\",,,,4,16,900000\nbrook,brook,\"LINESTRING (1100 2010, 1100 2090)\",,,,,,\n");
}

void add_risk(const SampleProject& project) {
    project.write("blocks.csv", "return_period_years,zone,diameter_m\n10,1,0.3\n100,1,0.8\n");
    project.write("curves.csv",
                  "energy_from_kj,lethality_in_vehicle,lethality_in_house,damage_to_house\n0,0.1,0.001,0.01\n"
                  "5,0.3,0.01,0.05\n40,0.6,0.1,0.3\n");
    project.replace("scenario.ini", "diameter_m = 0.5\n", "");
    project.replace("scenario.ini", "[targets]",
                    "[hazard]\nblocks = blocks.csv\n[risk]\nassess = yes\ncurves = curves.csv\n"
                    "prevented_death = 4e6\nclosure_days = 0.5\nclosure_cost_per_day = 3000\n[targets]");
    expose(project);
}

constexpr const char* quick = "run scenario.ini --set release.rocks=600 ";

struct Counted {
    double arrivals = 0.0;
    double deaths = 0.0;
    double damage = 0.0;
    double money = 0.0;
};

/// The risk of road and house once more, from arrivals.csv alone.
std::map<std::string, Counted> counted_from_arrivals(const SampleProject& project) {
    std::map<std::string, Counted> all;
    for (const auto& [years, diameter_m] : {std::pair{10.0, 0.3}, std::pair{100.0, 0.8}}) {
        const config::Table rows = table(
            project, "out/return_period_" + std::to_string(static_cast<int>(years)) + "/tables/arrivals.csv");
        for (std::size_t row = 0; row < rows.rows(); ++row) {
            const std::string& id = rows.text(row, "target_id");
            const double energy_kj = number(rows, row, "energy_kj");
            const std::size_t k = energy_kj < 5.0 ? 0 : energy_kj < 40.0 ? 1 : 2;
            const double weight = 1.0 / (years * 600.0);
            Counted& of = all[id + ' ' + rows.text(row, "cover")];
            double deaths = 0.0;
            double money = 0.0;
            if (id == "road") {
                const double presence = 1200.0 * (5.0 + diameter_m) / (24.0 * 1000.0 * 60.0);
                deaths = presence * 1.6 * std::vector<double>{0.1, 0.3, 0.6}[k];
                money = 4e6 * deaths + 1500.0;
            } else if (id == "house") {
                deaths = 4.0 * 16.0 / 24.0 * std::vector<double>{0.001, 0.01, 0.1}[k];
                of.damage += weight * 900'000.0 * std::vector<double>{0.01, 0.05, 0.3}[k];
                money = 4e6 * deaths + 900'000.0 * std::vector<double>{0.01, 0.05, 0.3}[k];
            }
            of.arrivals += weight;
            of.deaths += weight * deaths;
            of.money += weight * money;
        }
    }
    return all;
}

TEST(Risk, FollowsFromTheArrivals) {
    const SampleProject project;
    add_risk(project);
    const Outcome outcome = call(project, std::string{quick} + "--out out");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("risk of 2 exposed targets with forest: "), std::string::npos) << outcome.out;
    const auto counted = counted_from_arrivals(project);
    const config::Table risk = table(project, "out/hazard/tables/risk.csv");
    const config::Table total = table(project, "out/hazard/tables/risk_total.csv");
    const config::Table classes = table(project, "out/hazard/tables/risk_classes.csv");
    ASSERT_EQ(risk.rows(), 4U);
    ASSERT_EQ(total.rows(), 2U);
    std::map<std::string, double> money_of_slope;
    for (std::size_t row = 0; row < risk.rows(); ++row) {
        const std::string cover = risk.text(row, "cover");
        const std::string key = risk.text(row, "target_id") + ' ' + cover;
        const Counted& expected = counted.at(key);
        EXPECT_GT(expected.arrivals, 0.0) << key;
        const auto expect = [&](const char* column, double value) {
            EXPECT_NEAR(number(risk, row, column), value, 1e-5 * value) << key << ' ' << column;
        };
        expect("arrivals_per_year", expected.arrivals);
        expect("deaths_per_year", expected.deaths);
        // A road has no value that could be damaged: its field is empty, and not 0.
        EXPECT_EQ(risk.text(row, "damage_per_year").empty(), risk.text(row, "target_id") == "road");
        if (risk.text(row, "target_id") != "road") {
            expect("damage_per_year", expected.damage);
        }
        expect("money_per_year", expected.money);
        EXPECT_LE(number(risk, row, "money_low_per_year"), expected.money);
        EXPECT_GE(number(risk, row, "money_high_per_year"), expected.money);
        money_of_slope[cover] += expected.money;
        double of_classes = 0.0;
        for (std::size_t k = 0; k < classes.rows(); ++k) {
            if (classes.text(k, "target_id") + ' ' + classes.text(k, "cover") == key) {
                of_classes += number(classes, k, "money_per_year");
            }
        }
        EXPECT_NEAR(of_classes, expected.money, 1e-5 * expected.money) << key;
    }
    const Json summary = Json::parse(project.read("out/hazard/summary.json"));
    for (std::size_t row = 0; row < total.rows(); ++row) {
        const std::string cover = total.text(row, "cover");
        EXPECT_NEAR(number(total, row, "money_per_year"), money_of_slope.at(cover),
                    1e-5 * money_of_slope.at(cover));
        EXPECT_NEAR(summary["risk"]["all_targets"][cover]["money_per_year"]["value"].get<double>(),
                    money_of_slope.at(cover), 1e-8 * money_of_slope.at(cover));
        EXPECT_EQ(total.text(row, "spared_money_per_year").empty(), cover == "bare");
    }
    EXPECT_NEAR(number(total, 0, "spared_money_per_year"),
                money_of_slope.at("bare") - money_of_slope.at("forest"), 1e-3);
    EXPECT_EQ(summary["risk"]["targets"].size(), 2U);
    const std::string page = project.read("out/hazard/report.html");
    EXPECT_NE(page.find("What this assumes"), std::string::npos);
    EXPECT_NE(page.find("200 vehicles a day, 60 km/h, 1.6 persons in each, 5 m"), std::string::npos);
    EXPECT_EQ(page.find("a choice of this program"), std::string::npos);  // own curves
}

/// A house without persons has no deaths, which is not the same as 0 deaths.
TEST(Risk, OfAHouseWithoutPersonsHasNoDeaths) {
    const SampleProject project;
    add_risk(project);
    project.write(
        "targets.csv",
        "target_id,name,wkt,house_value\nhouse,house,\"POLYGON ((1090 2040, 1100 2040, 1100 2050, 1090 "
        "2050, 1090 2040))\",900000\n");
    const Outcome outcome = call(project, std::string{quick} + "--out out");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const config::Table risk = table(project, "out/hazard/tables/risk.csv");
    const config::Table total = table(project, "out/hazard/tables/risk_total.csv");
    for (const config::Table* of : {&risk, &total}) {
        EXPECT_EQ(of->text(0, "deaths_per_year"), "");
        EXPECT_EQ(of->text(0, "deaths_high_per_year"), "");
        EXPECT_GT(number(*of, 0, "money_per_year"), 0.0);
        EXPECT_EQ(of->text(0, "money_per_year"), of->text(0, "damage_per_year"));
    }
    EXPECT_EQ(risk.text(0, "individual_risk_per_year"), "");
    const Json summary = Json::parse(project.read("out/hazard/summary.json"));
    EXPECT_TRUE(summary["risk"]["all_targets"]["bare"]["deaths_per_year"]["value"].is_null());
    const std::string page = project.read("out/hazard/report.html");
    EXPECT_NE(page.find("no target has persons"), std::string::npos);
    EXPECT_NE(page.find("no persons given"), std::string::npos);
    EXPECT_EQ(outcome.out.find("deaths"), std::string::npos) << outcome.out;
}

/// Deaths are those of all targets, of which some have no persons; money is that of all.
TEST(Risk, SaysHowManyTargetsHavePersonsAndWhatIsNotCounted) {
    const SampleProject project;
    add_risk(project);
    project.write(
        "targets.csv",
        "target_id,name,wkt,persons,hours_per_day,house_value\n"
        "house,house,\"POLYGON ((1090 2040, 1100 2040, 1100 2050, 1090 2050, 1090 2040))\",4,16,\n"
        "barn,barn,\"POLYGON ((1102 2052, 1110 2052, 1110 2060, 1102 2060, 1102 2052))\",,,90000\n");
    const Outcome outcome = call(project, std::string{quick} + "--out out");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const std::string page = project.read("out/hazard/report.html");
    EXPECT_NE(page.find("at the 2 targets with persons, traffic or value, 1 of them with persons"),
              std::string::npos);
    EXPECT_NE(page.find("and damage alone is"), std::string::npos);
    EXPECT_NE(page.find("closure is not counted"), std::string::npos);
    EXPECT_EQ(page.find("damage and closure alone"), std::string::npos);
}

/// A column that looks like one that decides what a risk counts is warned of, and what would be counted from
/// it is not known, which is not 0.
TEST(Risk, WarnsOfAColumnThatLooksLikeOneOfItsOwn) {
    for (const auto& [misspelt, wanted] : std::vector<std::pair<std::string, std::string>>{
             {"value", "house_value"}, {"Building value", "house_value"}}) {
        const SampleProject project;
        add_risk(project);
        project.write("targets.csv",
                      "target_id,name,wkt,persons,hours_per_day," + misspelt +
                          "\nhouse,house,\"POLYGON ((1090 2040, 1100 2040, 1100 2050, 1090 2050, 1090 "
                          "2040))\",4,16,900000\n");
        const Outcome outcome = call(project, std::string{quick} + "--out out");
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        const std::string found = "column '" + misspelt + "', which is not read, and no " + wanted;
        EXPECT_NE(outcome.err.find(found), std::string::npos) << outcome.err;
        const std::string page = project.read("out/hazard/report.html");
        const std::string first_screen = page.substr(0, page.find("Targets by level"));
        EXPECT_NE(first_screen.find("which is not read, and no " + wanted), std::string::npos);
        EXPECT_NE(page.find("neither damage nor closure is counted"), std::string::npos);
        EXPECT_EQ(table(project, "out/hazard/tables/risk.csv").text(0, "damage_per_year"), "");
        EXPECT_EQ(table(project, "out/hazard/tables/risk_total.csv").text(0, "damage_per_year"), "");
    }
    // Columns of other things are none of its business.
    const SampleProject project;
    add_risk(project);
    project.write("targets.csv",
                  "target_id,name,wkt,persons,hours_per_day,owner,height_m,house_number\nhouse,house,"
                  "\"POLYGON ((1090 2040, 1100 "
                  "2040, 1100 2050, 1090 2050, 1090 2040))\",4,16,Muster,7,12\n");
    const Outcome outcome = call(project, std::string{quick} + "--out out");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err.find("which is not read, and no"), std::string::npos) << outcome.err;
}

/// Deaths have the same figure and the same interval on the page, in the table and on the terminal.
TEST(Risk, OfDeathsHasItsIntervalOnTheTerminal) {
    const SampleProject project;
    add_risk(project);
    const Outcome outcome = call(project, std::string{quick} + "--out out");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const std::string page = project.read("out/hazard/report.html");
    const config::Table total = table(project, "out/hazard/tables/risk_total.csv");
    ASSERT_EQ(total.rows(), 2U);
    for (std::size_t row = 0; row < total.rows(); ++row) {
        const auto rate = [&](const char* column) {
            return consequences::rate_text(number(total, row, column));
        };
        const std::string deaths = rate("deaths_per_year") + " deaths a year";
        const std::string interval =
            "(95 %: " + rate("deaths_low_per_year") + " to " + rate("deaths_high_per_year") + ")";
        EXPECT_NE(outcome.out.find(deaths + " " + interval), std::string::npos) << outcome.out;
        EXPECT_NE(page.find(deaths + " at the 2 targets with persons, traffic or value " + interval),
                  std::string::npos);
    }
}

/// Traffic and curves are no part of the falls: finished return periods stay, the risk is another one.
TEST(Risk, OfOtherTrafficKeepsTheFalls) {
    const SampleProject project;
    add_risk(project);
    ASSERT_EQ(call(project, std::string{quick} + "--out out --quiet").code, 0);
    const config::Table before = table(project, "out/hazard/tables/risk.csv");
    expose(project, "2400");
    const Outcome again = call(project, std::string{quick} +
                                            "--out out --set risk.curves= --set risk.closure_days=0 --set "
                                            "risk.closure_cost_per_day=0");
    ASSERT_EQ(again.code, 0) << again.err;
    EXPECT_NE(again.out.find("return period of 10 years: finished before"), std::string::npos) << again.out;
    EXPECT_NE(again.out.find("return period of 100 years: finished before"), std::string::npos) << again.out;
    const config::Table after = table(project, "out/hazard/tables/risk.csv");
    for (std::size_t row = 0; row < 2; ++row) {
        ASSERT_EQ(after.text(row, "target_id"), "road");
        EXPECT_EQ(after.text(row, "arrivals_per_year"), before.text(row, "arrivals_per_year"));
        const double twice = 2.0 * number(before, row, "vehicles_hit_per_year");
        EXPECT_GT(twice, 0.0);
        EXPECT_NEAR(number(after, row, "vehicles_hit_per_year"), twice, 1e-5 * twice);
        for (const char* column :
             {"closure_days_per_year", "closure_cost_per_year", "closure_cost_high_per_year"}) {
            EXPECT_EQ(after.text(row, column), "") << column;
        }
    }
    const Json total = Json::parse(project.read("out/hazard/summary.json"))["risk"]["all_targets"]["bare"];
    EXPECT_TRUE(total["closure_cost_per_year"]["value"].is_null());
    const std::string page_without = project.read("out/hazard/report.html");
    EXPECT_NE(page_without.find("closure is not counted."), std::string::npos);
    EXPECT_EQ(page_without.find("damage and closure alone"), std::string::npos);
    EXPECT_NE(project.read("out/hazard/report.html").find("a choice of this program"), std::string::npos);
}

/// Only places and names of the targets belong to a return period: the whole file is packed with it.
TEST(Risk, LeavesReturnPeriodsThatCanBePacked) {
    const SampleProject project;
    add_risk(project);
    ASSERT_EQ(call(project, std::string{quick} + "--out out --quiet").code, 0);
    expose(project, "2400");
    const Outcome packed = call(project, "pack out/return_period_100 --scenario scenario.ini -q");
    EXPECT_EQ(packed.code, 0) << packed.err;
}

/// A place that moves is another run.
TEST(Risk, OfAnotherPlaceIsAnotherRun) {
    const SampleProject project;
    add_risk(project);
    ASSERT_EQ(call(project, std::string{quick} + "--out out --quiet").code, 0);
    project.replace("targets.csv", "1105 2010, 1105 2090", "1104 2010, 1104 2090");
    const Outcome again = call(project, std::string{quick} + "--out out");
    EXPECT_EQ(again.code, 2);
    EXPECT_NE(again.err.find("finished results of other settings or inputs"), std::string::npos) << again.err;
}

TEST(Risk, IsNotThereUnlessItIsAskedFor) {
    const SampleProject project;
    add_risk(project);
    ASSERT_EQ(call(project, std::string{quick} + "--out out --quiet --set risk.assess=no").code, 0);
    EXPECT_FALSE(std::filesystem::exists(project.file("out/hazard/tables/risk.csv")));
    EXPECT_EQ(project.read("out/hazard/report.html").find("What this assumes"), std::string::npos);
    EXPECT_FALSE(Json::parse(project.read("out/hazard/summary.json")).contains("risk"));
}

/// All languages fill the section, and what is written describes itself.
TEST(Risk, IsWrittenInAllLanguages) {
    const SampleProject project;
    add_risk(project);
    ASSERT_EQ(call(project, std::string{quick} + "--out out --quiet").code, 0);
    for (const auto& [language, words] :
         {std::pair{"de", "Was das annimmt"}, std::pair{"fr", "Ce que cela suppose"},
          std::pair{"it", "Che cosa si assume"}}) {
        const Outcome outcome =
            call(project, std::string{quick} + "--out out --quiet --set report.language=" + language);
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_NE(project.read("out/hazard/report.html").find(words), std::string::npos) << language;
    }
    const std::string dictionary = project.read("out/hazard/tables/data_dictionary.csv");
    for (const char* column : {"risk.csv,individual_risk_per_year", "risk_total.csv,money_per_year",
                               "risk_classes.csv,energy_from_kj"}) {
        EXPECT_NE(dictionary.find(column), std::string::npos) << column;
    }
}

TEST(Risk, StandsInTheGeoPackage) {
    const SampleProject project;
    if (shell(project, "command -v sqlite3").code != 0) {
        GTEST_SKIP() << "sqlite3 is not installed";
    }
    add_risk(project);
    ASSERT_EQ(call(project, std::string{quick} + "--out out --quiet").code, 0);
    const config::Table total = table(project, "out/hazard/tables/risk_total.csv");
    const Outcome sum =
        shell(project,
              "sqlite3 out/hazard/results.gpkg \"SELECT sum(money_per_year) FROM risk WHERE cover = "
              "'bare'\"");
    ASSERT_EQ(sum.code, 0) << sum.err;
    EXPECT_NEAR(std::stod(sum.out), number(total, 1, "money_per_year"),
                1e-5 * number(total, 1, "money_per_year"));
}

/// Of targets that no rock hits one line says so; the table has them.
TEST(Risk, OfTargetsWithoutHitsStandsInOneLine) {
    const SampleProject project;
    add_risk(project);
    std::string targets = project.read("targets.csv");
    for (const char* y : {"2010", "2030", "2070"}) {
        targets += std::string{"h"} + y + ",far " + y + ",\"POLYGON ((1006 " + y + ", 1010 " + y +
                   ", 1010 2092, 1006 2092, 1006 " + y + "))\",,,,4,16,900000\n";
    }
    project.write("targets.csv", targets);
    const Outcome outcome = call(project, std::string{quick} + "--quiet --out out");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const std::string page = project.read("out/hazard/report.html");
    EXPECT_NE(page.find("No rock hits 3 targets with persons, traffic or value"), std::string::npos);
    const std::size_t risk = page.find("<h2>Risk");
    ASSERT_NE(risk, std::string::npos);
    const std::string section = page.substr(risk, page.find("</section>", risk) - risk);
    EXPECT_EQ(section.find("far 20"), std::string::npos);
    const config::Table rows = table(project, "out/hazard/tables/risk.csv");
    EXPECT_EQ(rows.rows(), 10U) << "five targets on both slopes";
}

}  // namespace
}  // namespace coupling::risk_run_test
