// Pages, tables and comparisons through the program: figures that could mislead stand with what corrects
// them.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

#include "tests/coupling/assessments/profile/profile_project.hpp"
#include "tests/coupling/parts_of_text.hpp"
#include "tests/coupling/results/markup_checks.hpp"
#include "tests/runs/years.hpp"

namespace coupling::honest_figures_test {
namespace {

using text_checks::count_of;

constexpr std::array limits_kj{30, 100, 300, 1000};

/// What stands before the first heading of a part.
std::string first_screen(const SampleProject& project, const std::string& page) {
    const std::string text = project.read(page);
    return text.substr(0, text.find("<h2>"));
}

/// The entry of a name on the first screen.
std::string entry(const std::string& screen, const std::string& name) {
    const std::size_t at = screen.find("<dt>" + name + "</dt>");
    return at == std::string::npos ? "" : screen.substr(at, screen.find("</dd>", at) - at);
}

/// Larger rocks, so that energies lie on both sides of the limits.
constexpr const char* large_rocks =
    "run scenario.ini --quiet --set release.rocks=2000 --set release.diameter_kind=uniform "
    "--set release.diameter_low_m=0.3 --set release.diameter_high_m=1.6 ";

/// "398 stems/ha, 21.4 m" in a text.
std::string density_in(const std::string& text) {
    const std::size_t end = text.find(" stems/ha, ");
    if (end == std::string::npos) {
        return "";
    }
    const std::size_t begin = text.find_last_of(" >;", end - 1) + 1;
    return text.substr(begin, text.find(" m", end) - begin);
}

TEST(StemsPerHectare, AreThoseOfTheCheckOnThePage) {
    const SampleProject project;
    const std::string checked = density_in(call(project, "check scenario.ini").out);
    ASSERT_FALSE(checked.empty());
    ASSERT_EQ(call(project, "run scenario.ini --quiet --set release.rocks=200 --out out").code, 0);
    EXPECT_EQ(density_in(project.read("out/report.html")), checked);
}

TEST(RocksAboveEnergies, AreThoseOfTheTableOfArrivals) {
    const SampleProject project;
    const Outcome outcome = call(project, std::string{large_rocks} + "--out out");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const config::Table arrivals = table(project, "out/tables/arrivals.csv");
    const config::Table targets = table(project, "out/tables/targets.csv");
    ASSERT_EQ(targets.rows(), 4U);
    std::size_t most = 0;
    for (std::size_t row = 0; row < targets.rows(); ++row) {
        for (const int limit_kj : limits_kj) {
            std::size_t above = 0;
            for (std::size_t i = 0; i < arrivals.rows(); ++i) {
                above += arrivals.text(i, "target_id") == targets.text(row, "target_id") &&
                                 arrivals.text(i, "cover") == targets.text(row, "cover") &&
                                 number(arrivals, i, "energy_kj") > limit_kj
                             ? 1U
                             : 0U;
            }
            most = std::max(most, above);
            const std::string column = "above_" + std::to_string(limit_kj) + "_kj_";
            EXPECT_EQ(number(targets, row, column + "rocks"), static_cast<double>(above)) << row << column;
            EXPECT_NEAR(number(targets, row, column + "per_1000"), static_cast<double>(above) / 2.0, 1e-4);
            EXPECT_LE(number(targets, row, column + "low_per_1000"),
                      number(targets, row, column + "per_1000"));
            EXPECT_GE(number(targets, row, column + "high_per_1000"),
                      number(targets, row, column + "per_1000"));
        }
    }
    EXPECT_GT(most, 100U) << "energies on both sides of the limits";
    EXPECT_NE(project.read("out/report.html").find("per 1000 rocks released"), std::string::npos);
    EXPECT_NE(project.read("out/summary.json").find("\"per_1000_released\""), std::string::npos);
}

TEST(RocksAboveEnergies, StandInComparisonsToo) {
    const SampleProject project;
    ASSERT_EQ(call(project, std::string{large_rocks} + "--out a").code, 0);
    ASSERT_EQ(call(project, std::string{large_rocks} + "--seed 7 --out b").code, 0);
    const Outcome outcome = call(project, "compare a b --out compared --page compared.html");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const config::Table compared = table(project, "compared/compare.csv");
    const config::Table targets = table(project, "a/tables/targets.csv");
    bool found = false;
    for (std::size_t row = 0; row < compared.rows(); ++row) {
        if (compared.text(row, "run") == "A" && compared.text(row, "target_id") == "road" &&
            compared.text(row, "quantity") == "above_100_kj_bare_per_1000") {
            found = true;
            EXPECT_EQ(compared.text(row, "value"), targets.text(1, "above_100_kj_per_1000"));
            EXPECT_EQ(compared.text(row, "high"), targets.text(1, "above_100_kj_high_per_1000"));
        }
    }
    EXPECT_TRUE(found);
    EXPECT_NE(outcome.out.find("above_300_kj_per_1000"), std::string::npos) << outcome.out;
    EXPECT_NE(project.read("compared.html").find("Rocks above 300 kJ: road"), std::string::npos);
}

TEST(RocksAboveEnergies, OverYearsAreThoseOfEachYearAndPage) {
    const ForestProject project;
    ASSERT_EQ(call(project, std::string{four_members} + "--set run.years=2 --out out").code, 0);
    const config::Table targets = table(project, "out/tables/targets.csv");
    ASSERT_GT(targets.rows(), 0U);
    for (std::size_t row = 0; row < targets.rows(); ++row) {
        EXPECT_NEAR(number(targets, row, "above_30_kj_per_1000"),
                    1000.0 * number(targets, row, "above_30_kj_rocks") / number(targets, row, "rocks"), 1e-4);
        EXPECT_LE(number(targets, row, "above_30_kj_rocks"), number(targets, row, "reached"));
    }
    const std::string page = project.read("out/report.html");
    EXPECT_EQ(text_checks::markup_fault(page), "");
    EXPECT_NE(page.find("per 1000 rocks released"), std::string::npos);
    EXPECT_NE(page.find("year 2, bare slope"), std::string::npos);
}

TEST(Compare, ShowsNoProtectionFromAHandfulOfRocks) {
    const SampleProject project;
    const std::string run = "run scenario.ini --quiet --set release.rocks=4 ";
    ASSERT_EQ(call(project, run + "--out a").code, 0);
    ASSERT_EQ(call(project, run + "--seed 7 --out b").code, 0);
    const std::string why = "too few for a protection figure";
    ASSERT_NE(project.read("a/report.html").find(why), std::string::npos);
    EXPECT_EQ(table(project, "a/tables/protection.csv").text(0, "too_few_rocks"), "yes");

    const Outcome outcome = call(project, "compare a b --out compared --page compared.html");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find(why), std::string::npos) << outcome.out;
    const config::Table compared = table(project, "compared/compare.csv");
    std::size_t figures = 0;
    for (std::size_t row = 0; row < compared.rows(); ++row) {
        if (compared.text(row, "quantity") == "protection_percent") {
            ++figures;
            EXPECT_EQ(compared.text(row, "value"), "");
            EXPECT_EQ(compared.text(row, "difference"), "");
            EXPECT_NE(compared.text(row, "why_none").find(why), std::string::npos);
        }
    }
    EXPECT_EQ(figures, 4U) << "two targets, two runs";
    const std::string page = project.read("compared.html");
    EXPECT_EQ(text_checks::markup_fault(page), "");
    EXPECT_NE(page.find(why), std::string::npos);
    EXPECT_EQ(page.find("Protection: road"), std::string::npos) << "no chart";
}

TEST(Compare, ShowsNoProtectionOverYearsFromAHandfulOfRocks) {
    const ForestProject project;
    const std::string run = "run scenario.ini --quiet --set run.years=2 --set release.rocks=1 ";
    ASSERT_EQ(call(project, run + "--out a").code, 0);
    ASSERT_EQ(call(project, run + "--seed 7 --out b").code, 0);
    EXPECT_EQ(project.read("a/tables/regimes_by_year.csv").find("protection_percent"), std::string::npos);
    const Outcome outcome = call(project, "compare a b --out compared --page compared.html");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const config::Table compared = table(project, "compared/compare.csv");
    std::size_t figures = 0;
    for (std::size_t row = 0; row < compared.rows(); ++row) {
        if (compared.text(row, "quantity") == "protection_percent") {
            ++figures;
            EXPECT_EQ(compared.text(row, "value"), "");
        }
    }
    EXPECT_GT(figures, 0U);
    EXPECT_EQ(project.read("compared.html").find("<h3>Protection"), std::string::npos);
}

TEST(NetDrawings, ShowTheSameShareOfRocksOnBothSlopes) {
    const SampleProject project;
    std::string trees = "tree_id,x_m,y_m,species,dbh_cm,height_m\n";
    for (int i = 0; i < 120; ++i) {
        trees += std::to_string(i + 1) + "," + std::to_string(1035 + i % 10 * 3) + "," +
                 std::to_string(2010 + i / 10 * 7) + ",PIAB,40,25\n";
    }
    project.write("trees.csv", trees);
    project.write("nets.csv",
                  "name,height_m,capacity_kj,wkt\nlower,3,1000,\"LINESTRING (1080 2005, 1080 2095)\"\n");
    project.replace("scenario.ini", "[targets]", "[nets]\nfile = nets.csv\n[targets]");
    ASSERT_EQ(call(project, "run scenario.ini --quiet --set release.rocks=6000 --out out").code, 0);
    const config::Table nets = table(project, "out/tables/nets.csv");
    const std::string page = project.read("out/report.html");
    const double reached_forest = number(nets, 0, "reached");
    const double reached_bare = number(nets, 1, "reached");
    ASSERT_EQ(nets.text(0, "cover"), "forest");
    ASSERT_GT(reached_bare, 2000.0);
    ASSERT_LT(reached_forest, 0.9 * reached_bare);

    const auto drawn_in = [&](const std::string& title) {
        const std::size_t begin = page.find("<figcaption><b>" + title);
        const std::string figure = page.substr(begin, page.find("</figure>", begin) - begin);
        // Each rock is a disc or a triangle with a thin edge, or a cross with a thick one.
        return count_of(figure, "class=\"edge\" stroke-width=\"0.7\"") +
               count_of(figure, "class=\"edge\" stroke-width=\"3.4\"");
    };
    EXPECT_EQ(drawn_in("lower, bare slope"), 1500U);
    EXPECT_NEAR(static_cast<double>(drawn_in("lower, with forest")), 1500.0 * reached_forest / reached_bare,
                0.5 + 1e-9);
    EXPECT_EQ(count_of(page, "on both slopes the same share of"), 2U);
}

TEST(FirstScreen, MarksDefaultsOfAnAssessmentOfToday) {
    const SampleProject project;
    ASSERT_EQ(call(project, "run scenario.ini --quiet --set release.start_speed_mps=5 --out out").code, 0);
    const std::string screen = first_screen(project, "out/report.html");
    const std::string start = entry(screen, "Start");
    EXPECT_NE(start.find("1.5 m above ground <span class=\"mark\">default</span>"), std::string::npos)
        << start;
    EXPECT_NE(start.find("5 m/s <span class=\"mark given\">set</span>"), std::string::npos) << start;
    EXPECT_NE(entry(screen, "Rock diameter").find("0.5 m, spheres <span class=\"mark given\">set"),
              std::string::npos)
        << screen;
    const std::string spread = entry(screen, "Spread of directions");
    EXPECT_NE(spread.find("at impacts ±16° (slow) to ±11° (fast rocks) <span class=\"mark\">default"),
              std::string::npos)
        << spread;
    EXPECT_NE(entry(screen, "Rocks").find("20 <span class=\"mark given\">set"), std::string::npos);
    EXPECT_NE(entry(screen, "Random seed").find("default"), std::string::npos);
    EXPECT_NE(entry(screen, "Motion").find("default"), std::string::npos);
    EXPECT_EQ(project.read("out/report.html").find("moved by another model"), std::string::npos);
}

TEST(FirstScreen, NamesShapesOfBlocksAndThePageCitesTheirModel) {
    const SampleProject project;
    const Outcome outcome =
        call(project,
             "run scenario.ini --quiet --set rockfall.motion=rigid --set "
             "release.shape=plate,very-platy,cube --set 'release.shape_shares=3, 1, 1' --set "
             "report.language=de --out out");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const std::string page = project.read("out/report.html");
    const std::string size = entry(first_screen(project, "out/report.html"), "Blockdurchmesser");
    EXPECT_NE(size.find("Platte 60,0 %, sehr plattig 20,0 %, Würfel 20,0 %"), std::string::npos) << size;
    EXPECT_NE(page.find("Starre Blöcke: Blöcke sind starre Körper mit einer Form"), std::string::npos);
    EXPECT_NE(page.find("durch die Form des Blocks und des Bodens"), std::string::npos);
    EXPECT_NE(page.find("nach einem anderen Modell: Starre Blöcke (Leine et al. 2014, Multibody Syst. Dyn. "
                        "32:241)."),
              std::string::npos);
}

TEST(FirstScreen, NamesRocksOfTheirOwnBySource) {
    const SampleProject project;
    project.write("sources.csv",
                  "zone,blocks,diameter_m,speed_mps,wkt\n1,10,0.4,1,POINT (1025 2045)\n"
                  "2,10,1.2,4,POINT (1025 2055)\n");
    project.replace("scenario.ini", "source = source.asc", "source_shapes = sources.csv");
    const Outcome outcome = call(project, "run scenario.ini --quiet --out out");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const std::string screen = first_screen(project, "out/report.html");
    EXPECT_NE(entry(screen, "Rock diameter").find("0.40 to 1.20 m"), std::string::npos) << screen;
    EXPECT_NE(entry(screen, "Start").find("1.0 to 4.0 m/s"), std::string::npos) << screen;
    EXPECT_NE(entry(screen, "Start").find("by source"), std::string::npos) << screen;
}

TEST(FirstScreen, MarksDefaultsAlongAProfileAndOverYears) {
    const SampleProject profile;
    make_profile_project(profile);
    ASSERT_EQ(call(profile, "run scenario.ini --quiet --out out").code, 0);
    const std::string along = first_screen(profile, "out/report.html");
    EXPECT_NE(entry(along, "Rocks").find("500 <span class=\"mark given\">set"), std::string::npos) << along;
    EXPECT_NE(entry(along, "Start").find("default"), std::string::npos) << along;
    EXPECT_NE(entry(along, "Spread of directions").find("two dimensions"), std::string::npos) << along;

    const ForestProject years;
    ASSERT_EQ(call(years, "run scenario.ini --quiet --set run.years=1 --out out").code, 0);
    const std::string over_years = first_screen(years, "out/report.html");
    for (const char* name : {"Rocks", "Start", "Spread of directions", "Motion", "Random seed"}) {
        EXPECT_NE(entry(over_years, name).find("class=\"mark"), std::string::npos) << name << over_years;
    }
}

TEST(HonestFigures, OfAForestBesideThePathsAreNone) {
    const SampleProject project;
    project.write("trees.csv", "tree_id,x_m,y_m,species,dbh_cm,height_m\n1,1008,2008,ABAL,32.5,25\n");
    const Outcome run = call(project, "run scenario.ini --quiet --set release.rocks_per_source=50 --out out");
    ASSERT_EQ(run.code, 0) << run.err;
    const config::Table found = table(project, "out/tables/protection.csv");
    ASSERT_GT(found.rows(), 0U);
    for (std::size_t row = 0; row < found.rows(); ++row) {
        // Of 200 rocks none: fewer than 1.8 % of all meet a tree, of which all may arrive on one slope alone.
        EXPECT_EQ(number(found, row, "protection_percent"), 0.0);
        const double high = number(found, row, "protection_high_percent");
        EXPECT_EQ(number(found, row, "protection_low_percent"), -high);
        EXPECT_GE(high, 1.8);
        EXPECT_LT(high, 100.0);
    }
    const std::string page = project.read("out/report.html");
    EXPECT_NE(page.find("No rock meets a tree or a log: the forest changes nothing here."),
              std::string::npos);
    EXPECT_EQ(page.find("The forest stops <b>"), std::string::npos);
    EXPECT_NE(run.err.find("the forest lies beside the paths of the rocks"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace coupling::honest_figures_test
