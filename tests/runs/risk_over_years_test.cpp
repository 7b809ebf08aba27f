// Risk in runs over years: the program as a user calls it.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "coupling/inputs/formats/json_library.hpp"
#include "tests/runs/years.hpp"

namespace coupling::risk_over_years_run_test {
namespace {

/// A road with so many vehicles, a house and a brook.
void expose_valley(const SampleProject& project, const std::string& vehicles = "1200") {
    project.write("targets.csv",
                  "target_id,name,wkt,vehicles_per_day,speed_kmph,persons_per_vehicle,persons,hours_per_day,"
                  "house_value\nroad,road,\"LINESTRING (1105 2010, 1105 2090)\"," +
                      vehicles +
                      ",60,1.6,,,\nhouse,house,\"POLYGON ((1090 2040, 1100 2040, 1100 2050, 1090 2050, 1090 "
                      "2040))\",,,,4,16,900000\nbrook,brook,\"LINESTRING (1100 2010, 1100 2090)\",,,,,,\n");
    project.write("curves.csv",
                  "energy_from_kj,lethality_in_vehicle,lethality_in_house,damage_to_house\n0,0.1,0.001,0.01\n"
                  "5.05,0.3,0.01,0.05\n40.4,0.6,0.1,0.3\n");
}

const std::string with_risk =
    std::string{four_members} +
    "--set run.years=4 --set risk.assess=yes --set risk.rocks_per_year=3 --set risk.currency=EUR "
    "--set risk.curves=curves.csv --set risk.closure_days=0.5 --set risk.closure_cost_per_day=2000 ";

Json summary_of(const SampleProject& project, const std::string& out) {
    return Json::parse(project.read(out + "/summary.json"));
}

/// Rows of a table by the text of some columns.
std::map<std::string, std::size_t> by_text(const config::Table& rows,
                                           const std::vector<std::string>& columns) {
    std::map<std::string, std::size_t> found;
    for (std::size_t row = 0; row < rows.rows(); ++row) {
        std::string key;
        for (const std::string& column : columns) {
            key += (key.empty() ? "" : " ") + rows.text(row, column);
        }
        EXPECT_TRUE(found.emplace(key, row).second) << key;
    }
    return found;
}

const std::vector<std::string> of_year{"regime", "target_id", "cover", "year"};

TEST(RiskOverYearsRun, StandsBesideTheCostAndItsBooksBalance) {
    const ForestProject project;
    expose_valley(project);
    const Outcome outcome = call(project, with_risk + "--out out");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const config::Table risk = table(project, "out/tables/risk_by_year.csv");
    const auto rows = by_text(risk, of_year);
    ASSERT_EQ(rows.size(), 2U * 3U * 2U * 3U);  // regimes, places, slopes, years 0, 2 and 4
    const auto money = [&](const std::string& key) { return number(risk, rows.at(key), "money_per_year"); };
    const config::Table reached = table(project, "out/tables/regimes_by_year.csv");
    const auto figures = by_text(reached, {"regime", "target_id", "quantity", "year"});
    for (const std::string regime : {"none", "single_tree_selection"}) {
        for (const std::string year : {"0", "2", "4"}) {
            for (const std::string cover : {"forest", "bare"}) {
                const auto key = [&](const std::string& place) {
                    return regime + " " + place + " " + cover + " " + year;
                };
                EXPECT_GT(money(key("road")), 0.0) << key("road");
                EXPECT_NEAR(money(key("all")), money(key("road")) + money(key("house")),
                            2e-5 * money(key("all")));
                const std::size_t row = rows.at(key("all"));
                EXPECT_NEAR(money(key("all")),
                            5e6 * number(risk, row, "deaths_per_year") +
                                number(risk, row, "damage_per_year") +
                                number(risk, row, "closure_cost_per_year"),
                            2e-5 * money(key("all")));
                EXPECT_TRUE(risk.text(row, "individual_risk_per_year").empty());
                // The same slope under all regimes.
                if (cover == "bare") {
                    EXPECT_EQ(money(key("all")), money("none all bare " + year));
                }
            }
            // Of 3 rocks a year that share arrives.
            const double share =
                number(reached, figures.at(regime + " road reached_percent " + year), "mean");
            EXPECT_NEAR(number(risk, rows.at(regime + " road forest " + year), "arrivals_per_year"),
                        3.0 * share / 100.0, 2e-5);
        }
    }
    // Present values once more, from the means of the years.
    const Json summary = summary_of(project, "out");
    const double area_ha = summary["run"]["area_ha"].get<double>();
    const config::Table decision = table(project, "out/tables/decision.csv");
    ASSERT_EQ(decision.rows(), 2U * 3U);
    for (std::size_t row = 0; row < decision.rows(); ++row) {
        const std::string regime = decision.text(row, "regime");
        const double year_2 = money(regime + " all forest 2");
        const double year_4 = money(regime + " all forest 4");
        EXPECT_NEAR(number(decision, row, "risk_money_per_year"), (year_2 + year_4) / 2.0,
                    2e-5 * (year_2 + year_4));
        double present_value = 0.0;
        for (int year = 1; year <= 4; ++year) {
            present_value += (year <= 2 ? year_2 : year_4) / std::pow(1.015, year) / area_ha;
        }
        EXPECT_NEAR(number(decision, row, "risk_present_value_per_hectare"), present_value,
                    2e-5 * present_value);
        EXPECT_NEAR(number(decision, row, "value_less_risk_eur_pha"),
                    number(decision, row, "present_value_eur_pha") - present_value,
                    0.06 + 2e-5 * present_value);
        EXPECT_EQ(decision.text(row, "risk_currency"), "EUR");
        EXPECT_EQ(decision.text(row, "risk_difference_per_hectare").empty(), regime == "none");
        if (regime != "none") {
            EXPECT_NEAR(number(decision, row, "risk_difference_per_hectare"),
                        number(decision, row, "risk_present_value_per_hectare") -
                            number(decision, 0, "risk_present_value_per_hectare"),
                        4e-5 * present_value);
            EXPECT_NEAR(number(decision, row, "value_less_risk_difference_eur_pha"),
                        number(decision, row, "present_value_difference_eur_pha") -
                            number(decision, row, "risk_difference_per_hectare"),
                        0.06 + 4e-5 * present_value);
        }
    }
    const Json& of_regime = summary["risk"]["regimes"][0];
    EXPECT_EQ(of_regime["regime"], "none");
    EXPECT_NEAR(of_regime["all_targets"]["present_value"]["value"].get<double>() / area_ha,
                number(decision, 0, "risk_present_value_per_hectare"),
                1e-5 * number(decision, 0, "risk_present_value_per_hectare"));
    const std::string page = project.read("out/report.html");
    EXPECT_NE(page.find("<h2>Risk</h2>"), std::string::npos);
    EXPECT_NE(page.find("Work and stock less risk, EUR/ha"), std::string::npos);
    EXPECT_NE(page.find("200 vehicles a day"), std::string::npos);
    EXPECT_EQ(page.find("a choice of this program"), std::string::npos);  // own curves
}

TEST(RiskOverYearsRun, OfOtherTrafficOrCurvesSimulatesNothingAgain) {
    const ForestProject project;
    project.write(
        "targets.csv",
        "target_id,name,wkt\nroad,,\"LINESTRING (1105 2010, 1105 2090)\"\nhouse,,\"POLYGON ((1090 2040, "
        "1100 2040, 1100 2050, 1090 2050, 1090 2040))\"\nbrook,,\"LINESTRING (1100 2010, 1100 2090)\"\n");
    ASSERT_EQ(call(project, std::string{four_members} + "--set run.years=4 --out out").code, 0);
    const auto simulated = [&] {
        return summary_of(project, "out")["run"]["simulated_member_years"].get<int>();
    };
    EXPECT_EQ(simulated(), 16);
    const auto money = [&](const char* key) {
        const config::Table rows = table(project, "out/tables/risk_by_year.csv");
        return number(rows, by_text(rows, of_year).at(key), "money_per_year");
    };
    expose_valley(project);
    const auto run_again = [&](const std::string& change) {
        EXPECT_EQ(call(project, with_risk + change + " --out out --overwrite").code, 0) << change;
        EXPECT_EQ(simulated(), 0) << change;
        return money("none road forest 4");
    };
    // The first risk of a run that had none.
    const double before = run_again("--set risk.closure_days=0 --set risk.closure_cost_per_day=0");
    EXPECT_GT(before, 0.0);
    expose_valley(project, "2400");
    EXPECT_NEAR(run_again("--set risk.closure_days=0 --set risk.closure_cost_per_day=0"), 2.0 * before,
                2e-5 * before);
    expose_valley(project);
    EXPECT_NEAR(run_again("--set risk.closure_days=0 --set risk.closure_cost_per_day=0 --set "
                          "risk.rocks_per_year=15"),
                5.0 * before, 5e-5 * before);
    EXPECT_NE(run_again("--set risk.curves="), before);
    EXPECT_NE(project.read("out/report.html").find("a choice of this program"), std::string::npos);
    // Other traffic alone is another run: what is there is not taken for it.
    expose_valley(project, "600");
    EXPECT_NE(call(project, with_risk + "--set risk.curves= --out out").code, 0);
}

TEST(RiskOverYearsRun, IsTheSameForAnyThreads) {
    const ForestProject project;
    expose_valley(project);
    ASSERT_EQ(call(project, with_risk + "--threads 1 --out one").code, 0);
    ASSERT_EQ(call(project, with_risk + "--threads 3 --out three").code, 0);
    for (const char* name :
         {"tables/risk_by_year.csv", "tables/decision.csv", "report.html", "summary.json"}) {
        EXPECT_EQ(project.read(std::string{"one/"} + name), project.read(std::string{"three/"} + name))
            << name;
    }
}

TEST(RiskOverYearsRun, InAnotherCurrencyJoinsNothingAndSaysSo) {
    const ForestProject project;
    expose_valley(project);
    const Outcome outcome = call(project, with_risk + "--set risk.currency=CHF --out out");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const config::Table decision = table(project, "out/tables/decision.csv");
    EXPECT_GT(number(decision, 0, "risk_money_per_year"), 0.0);
    EXPECT_TRUE(decision.text(0, "value_less_risk_eur_pha").empty());
    EXPECT_NE(project.read("out/report.html").find("Timber and work are in EUR, the risk in CHF"),
              std::string::npos);
    EXPECT_NE(project.read("out/summary.json").find("no figure joins them"), std::string::npos);
    // Without [risk] its columns are empty and there is no table of it.
    ASSERT_EQ(call(project, std::string{four_members} + "--set run.years=4 --out without").code, 0);
    const config::Table plain = table(project, "without/tables/decision.csv");
    EXPECT_TRUE(plain.text(0, "risk_money_per_year").empty());
    EXPECT_EQ(plain.text(0, "present_value_eur_pha"), decision.text(0, "present_value_eur_pha"));
    EXPECT_EQ(plain.text(0, "keeps"), decision.text(0, "keeps"));
    EXPECT_EQ(shell(project, "ls without/tables/risk_by_year.csv").code == 0, false);
}

TEST(RiskOverYearsRun, TakesTheRocksOfTheFeedback) {
    const ForestProject project;
    expose_valley(project);
    const std::string feedback =
        "--set feedback.on=yes --set feedback.rocks_per_year=3 --set run.rockfall_every=1 ";
    ASSERT_EQ(call(project, with_risk + feedback + "--out both").code, 0);
    ASSERT_EQ(call(project, with_risk + feedback + "--set risk.rocks_per_year=0 --out one").code, 0);
    EXPECT_EQ(project.read("both/tables/risk_by_year.csv"), project.read("one/tables/risk_by_year.csv"));
}

}  // namespace
}  // namespace coupling::risk_over_years_run_test
