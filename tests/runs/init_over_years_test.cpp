// From files of users to a project over years: `bannwald init DIR --dem ... --climate ...`.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "coupling/inputs/climate/dates.hpp"
#include "tests/runs/program.hpp"
#include "tests/runs/years.hpp"

namespace coupling::init_over_years_test {
namespace {

constexpr const char* stands =
    "stand,species,stems_pha,basal_area_m2pha,mean_dbh_cm,wkt\n"
    "1,PIAB,600,30,,\"POLYGON ((1000 2000, 1120 2000, 1120 2100, 1000 2100, 1000 2000))\"\n";

/// Days of a SYNTHETIC place, as Daymet has them.
std::string daymet(int first_year, int years) {
    std::string text =
        "Latitude: 47.0  Longitude: 11.0\nElevation: 900 meters\n"
        "year,yday,dayl (s),prcp (mm/day),srad (W/m^2),tmax (deg c),tmin (deg c)\n";
    for (int year = first_year; year < first_year + years; ++year) {
        for (int day = 1; day <= 365; ++day) {
            const double season = std::cos(6.283 * (day - 200) / 365.0);
            text += std::to_string(year) + "," + std::to_string(day) + "," +
                    std::to_string(43200.0 + 12000.0 * season) + "," + std::to_string(3 * (day % 3)) + "," +
                    std::to_string(300.0 + 100.0 * season) + "," + std::to_string(12.0 + 10.0 * season) +
                    "," + std::to_string(3.0 + 8.0 * season) + "\n";
        }
    }
    return text;
}

TEST(InitOverYears, MakesAProjectThatRuns) {
    const SampleProject project;
    project.write("stands.csv", stands);
    project.write("days.csv", daymet(1990, 4));
    const Outcome made = call(project,
                              "init own --dem dem.asc --sources source.asc --stands stands.csv --climate "
                              "days.csv --years 3");
    ASSERT_EQ(made.code, 0) << made.err;
    for (const std::string sentence : {"- days.csv: months made of 1460 days, 1990 to 1993\n",
                                       "- days.csv: elev_m 900, from the lines above the header\n",
                                       "rad_mj_m2_d = 'srad (W/m^2)' * 'dayl (s)' / 1000000\n",
                                       "- days.csv: climate of 1990 to 1993; years are drawn from it\n"}) {
        EXPECT_NE(made.err.find(sentence), std::string::npos) << sentence << made.err;
    }
    const std::string scenario = project.read("own/scenario.ini");
    EXPECT_NE(scenario.find("\nyears = 3\n"), std::string::npos);
    EXPECT_NE(scenario.find("\nfirst_year = 1994 "), std::string::npos);
    EXPECT_EQ(scenario.find("elevation_m"), std::string::npos) << "the climate names its height";
    const Outcome run = call(project, "run own/scenario.ini --quiet --set run.replicates=1");
    ASSERT_EQ(run.code, 0) << run.err;
    const config::Table stands_by_year = table(project, "own/out/tables/stands.csv");
    EXPECT_EQ(stands_by_year.text(stands_by_year.rows() - 1, "year"), "3");
}

TEST(InitOverYears, MarksWhatItGuesses) {
    const SampleProject project;
    project.write("stands.csv", stands);
    project.write("climate.csv", ForestProject::climate_of(2001, 2004));
    const Outcome made = call(
        project, "init own --dem dem.asc --sources source.asc --stands stands.csv --climate climate.csv");
    ASSERT_EQ(made.code, 0) << made.err;
    const std::string scenario = project.read("own/scenario.ini");
    for (const std::string line : {"\nyears = 40 ", "\nelevation_m = ", "\ntype = normal "}) {
        const std::size_t at = scenario.find(line);
        ASSERT_NE(at, std::string::npos) << line;
        const std::string whole = scenario.substr(at + 1, scenario.find('\n', at + 1) - at - 1);
        EXPECT_NE(whole.find("; GUESS"), std::string::npos) << whole;
    }
    EXPECT_NE(made.err.find("the climate names no height"), std::string::npos) << made.err;
}

}  // namespace
}  // namespace coupling::init_over_years_test
