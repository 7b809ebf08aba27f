#include "tests/runs/hazard.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "coupling/assessments/hazard/hazard_results.hpp"
#include "coupling/results/tables/data_dictionary.hpp"
#include "tests/runs/years.hpp"

namespace coupling::hazard_test {
namespace {

TEST(Hazard, MapsAllReturnPeriods) {
    const SampleProject project;
    add_blocks(project);
    const Outcome outcome = call(project, "run scenario.ini --set release.rocks=400 --out out");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    for (const char* years : {"10", "30", "100", "300"}) {
        EXPECT_TRUE(
            std::filesystem::exists(project.file("out/return_period_" + std::string{years}) / "report.html"))
            << years;
    }
    EXPECT_NE(outcome.out.find("hazard map of 4 return periods"), std::string::npos) << outcome.out;
    const config::Table targets = table(project, "out/hazard/tables/hazard_targets.csv");
    for (const char* cover : {"forest", "bare"}) {
        const std::size_t row = row_of(targets, "road", cover);
        EXPECT_EQ(targets.text(row, "rule"), "release");
        EXPECT_NE(targets.text(row, "level"), "none");
        EXPECT_GT(number(targets, row, "rocks"), 0.0);
        EXPECT_NE(outcome.out.find(targets.text(row, "level")), std::string::npos) << outcome.out;
    }
    const config::Table arrivals = table(project, "out/hazard/tables/hazard_arrivals.csv");
    const config::Table of_run = table(project, "out/return_period_30/tables/protection.csv");
    ASSERT_EQ(arrivals.rows(), 8U);
    EXPECT_EQ(arrivals.text(1, "target_id"), "road");
    EXPECT_EQ(arrivals.text(1, "return_period_years"), "30");
    EXPECT_EQ(arrivals.text(1, "protection_percent"), of_run.text(0, "protection_percent"));
    const std::string page = project.read("out/hazard/report.html");
    EXPECT_NE(page.find("Rockfall hazard map"), std::string::npos);
    EXPECT_NE(page.find("../return_period_300/report.html"), std::string::npos);
}

/// Pages of finished return periods do not follow a new language: the run says so, and --overwrite writes
/// them.
TEST(Hazard, SaysThatPagesOfReturnPeriodsKeepTheirLanguage) {
    const SampleProject project;
    add_blocks(project);
    ASSERT_EQ(call(project, std::string{quick_hazard} + "--out out").code, 0);
    const std::string said = "as they were written, with another report.language";
    EXPECT_EQ(project.read("out/hazard/summary.json").find(said), std::string::npos);
    const Outcome german = call(project, std::string{quick_hazard} + "--out out --set report.language=de");
    ASSERT_EQ(german.code, 0) << german.err;
    EXPECT_NE(german.err.find(said), std::string::npos) << german.err;
    EXPECT_NE(german.err.find("(return periods: 10, 30, 100, 300)"), std::string::npos) << german.err;
    const std::string page = project.read("out/hazard/report.html");
    EXPECT_NE(page.find("lang=\"de\""), std::string::npos);
    EXPECT_NE(page.find("mit anderem report.language"), std::string::npos);
    EXPECT_NE(project.read("out/return_period_10/report.html").find("lang=\"en\""), std::string::npos);
    ASSERT_EQ(
        call(project, std::string{quick_hazard} + "--out out --set report.language=de --overwrite").code, 0);
    EXPECT_NE(project.read("out/return_period_10/report.html").find("lang=\"de\""), std::string::npos);
    EXPECT_EQ(project.read("out/hazard/summary.json").find(said), std::string::npos);
}

/// The raster of a level, worked out from the rasters of the return periods once more.
TEST(Hazard, FollowsFromTheRastersOfTheReturnPeriods) {
    const SampleProject project;
    add_blocks(project);
    const Outcome outcome = shell(project, std::string{"\"$bannwald\" "} + quick_hazard +
                                               R"(--set hazard.rule=release --out out || exit 1
for cover in forest bare; do
    for years in 10 30 100 300; do
        tail -n +7 out/return_period_$years/rasters/$cover/E_95.asc | tr -s ' ' '\n' | grep -v '^$' > $years.txt
    done
    tail -n +7 out/hazard/rasters/$cover/Hazard_level.asc | tr -s ' ' '\n' | grep -v '^$' > level.txt
    paste 10.txt 30.txt 100.txt 300.txt level.txt | awk '
        function level(e, often) {
            if (e < 0) return -9999
            if (e >= 300 || (e >= 30 && often)) return 4
            return (e >= 30 || often) ? 3 : 2
        }
        { best = level($1, 1); for (i = 2; i < 5; ++i) { l = level($i, i < 3); if (l > best) best = l }
          if (best != $5) bad++; if ($5 > 0) good++ }
        END { print NR, bad + 0, (good > 20) ? "many" : "few" }'
done
)");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "120 0 many\n120 0 many\n");
}

TEST(Hazard, DividesTheReturnPeriodByTheShareThatArrives) {
    const SampleProject project;
    add_blocks(project);
    ASSERT_EQ(call(project, std::string{quick_hazard} + "--out out").code, 0);
    // Arrival = release / share of all rocks of the one row of hazard.blocks, cell by cell.
    const Outcome rasters = shell(project, R"(
paste -d ' ' out/hazard/rasters/bare/Arrival_return_period_100.asc \
             out/return_period_100/rasters/bare/Density.asc | tail -n +7 |
awk '{ n = NF / 2; for (i = 1; i <= n; ++i) if ($i > -9999) { all++; q = 10000 / $(i + n);
       if ($i / q < 0.99999 || $i / q > 1.00001) bad++ } } END { print (all > 20) ? "many" : "few", bad + 0 }'
)");
    EXPECT_EQ(rasters.out, "many 0\n") << rasters.err;
    const config::Table arrivals = table(project, "out/hazard/tables/hazard_arrivals.csv");
    for (std::size_t row = 0; row < arrivals.rows(); ++row) {
        const double years = number(arrivals, row, "return_period_years");
        const double reached = number(arrivals, row, "reached_bare_percent");
        if (reached > 0.0) {
            EXPECT_NEAR(number(arrivals, row, "arrival_period_bare_years"), 100.0 * years / reached,
                        1e-3 * 100.0 * years / reached);
        } else {
            EXPECT_EQ(arrivals.text(row, "arrival_period_bare_years"), "");
        }
    }
}

TEST(Hazard, HasSmoothedZonesOfAStatedSmallestAreaAndOpensOnTheLevel) {
    const SampleProject project;
    add_blocks(project);
    ASSERT_EQ(call(project, std::string{quick_hazard} + "--out out --set hazard.smallest_zone_m2=300").code,
              0);
    const std::string qgis = project.read("out/hazard/results.qlr");
    const std::size_t level = qgis.find(" (Hazard_level)\"");
    ASSERT_NE(level, std::string::npos);
    const std::size_t begin = qgis.rfind('<', level);
    EXPECT_NE(qgis.substr(begin, qgis.find('>', level) - begin).find("Qt::Checked"), std::string::npos)
        << qgis.substr(begin, 300);
    // One layer for each rule and slope; that of hazard.rule on the slope as it is is the one that shows.
    for (const std::string name :
         {"Hazard zones by rule release, with forest", "Hazard zones by rule release, bare slope",
          "Hazard zones by rule cadanav, for comparison, with forest",
          "Hazard zones by rule cadanav, for comparison, bare slope"}) {
        const std::size_t at = qgis.find("name=\"" + name + "\"");
        ASSERT_NE(at, std::string::npos) << name << '\n' << qgis.substr(0, 3000);
        const std::size_t from = qgis.rfind('<', at);
        const std::string line = qgis.substr(from, qgis.find('>', at) - from);
        EXPECT_EQ(line.find("Qt::Checked") != std::string::npos,
                  name == "Hazard zones by rule release, with forest")
            << line;
        EXPECT_EQ(line.find("layername=hazard_zones_cadanav|") != std::string::npos,
                  name.find("cadanav") != std::string::npos)
            << line;
    }
    if (shell(project, "command -v ogrinfo && command -v sqlite3").code != 0) {
        GTEST_SKIP() << "gdal-bin and sqlite3 are not installed";
    }
    const Outcome zones =
        shell(project,
              "sqlite3 out/hazard/results.gpkg \"SELECT count(*) > 3, min(smallest_zone_m2) = 300, "
              "count(DISTINCT rule), count(DISTINCT cover) FROM hazard_zones\"\n"
              "sqlite3 out/hazard/results.gpkg \"SELECT group_concat(DISTINCT rule) FROM "
              "hazard_zones_cadanav\"\n"
              "ogrinfo -q -dialect sqlite -sql \"SELECT count(*) AS wrong FROM hazard_zones WHERE "
              "abs(ST_Area(geom) - area_m2) > 1\" out/hazard/results.gpkg | grep 'wrong'\n");
    EXPECT_NE(zones.out.find("1|1|1|2\ncadanav\n"), std::string::npos) << zones.out << zones.err;
    EXPECT_NE(zones.out.find("wrong (Integer) = 0"), std::string::npos) << zones.out << zones.err;
    // A larger smallest area leaves fewer zones; nothing falls again for it.
    const Outcome fewer = call(project,
                               "run scenario.ini --set release.rocks=400 --out out --set "
                               "hazard.smallest_zone_m2=3000");
    EXPECT_EQ(fewer.code, 0) << fewer.err;
    EXPECT_NE(fewer.out.find("return period of 300 years: finished before"), std::string::npos) << fewer.out;
}

TEST(Hazard, KeepsWhatIsFinishedAndGivesTheSameBytes) {
    const SampleProject project;
    add_blocks(project);
    const Outcome outcome = shell(project, std::string{"\"$bannwald\" "} + quick_hazard +
                                               "--threads 1 --out whole || exit 1\n"
                                               "\"$bannwald\" " +
                                               quick_hazard +
                                               "--set hazard.return_period_years=100 --threads 3 "
                                               "--out parts/return_period_100 || exit 2\n"
                                               "touch -d 2001-01-01 parts/return_period_100/summary.json\n"
                                               "\"$bannwald\" " +
                                               quick_hazard +
                                               "--threads 2 --out parts || exit 3\n"
                                               "find parts -newermt 2001-01-02 -path '*100/summary.json'\n"
                                               "diff -r whole parts\n");
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    EXPECT_EQ(outcome.out, "");
}

TEST(Hazard, IsMadeAnewWithoutNewFalls) {
    const SampleProject project;
    add_blocks(project);
    ASSERT_EQ(call(project, std::string{quick_hazard} + "--out out").code, 0);
    const std::string before = project.read("out/hazard/tables/hazard_levels.csv");
    project.write("matrix.csv", "energy_from_kj,return_period_to_years,level\n0,,low\n1,,high\n");
    const Outcome again = call(project,
                               "run scenario.ini --set release.rocks=400 --out out --set hazard.rule=release "
                               "--set hazard.energy=max "
                               "--set hazard.matrix=matrix.csv --set hazard.least_reach_percent=2");
    ASSERT_EQ(again.code, 0) << again.err;
    EXPECT_NE(again.out.find("return period of 300 years: finished before"), std::string::npos) << again.out;
    const std::string after = project.read("out/hazard/tables/hazard_levels.csv");
    EXPECT_NE(before, after);
    EXPECT_NE(after.find("bare,moderate,0.0000"), std::string::npos) << after;
}

TEST(Hazard, LetsOnlyThePeriodFallAnewWhoseRowsWereEdited) {
    const SampleProject project;
    add_blocks(project);
    ASSERT_EQ(call(project, std::string{quick_hazard} + "--out out").code, 0);
    project.write("blocks.csv",
                  "zone,diameter_m,return_period_years\n1,1.2,300\n1,0.9,100\n1,0.3,10\n1,0.5,30\n");
    const Outcome refused = call(project, std::string{quick_hazard} + "--out out");
    EXPECT_EQ(refused.code, 2);
    EXPECT_NE(refused.err.find("return_period_100: found finished results of other settings or inputs"),
              std::string::npos)
        << refused.err;
    EXPECT_EQ(refused.err.find("return_period_10:"), std::string::npos) << refused.err;
    const std::string anew = "run scenario.ini --set release.rocks=400 --out out --overwrite";
    const Outcome edited = call(project, anew);
    ASSERT_EQ(edited.code, 0) << edited.err;
    for (const char* years : {"10", "30", "300"}) {
        EXPECT_NE(edited.out.find("return period of " + std::string{years} + " years: finished before"),
                  std::string::npos)
            << edited.out;
    }
    EXPECT_EQ(edited.out.find("return period of 100 years: finished before"), std::string::npos)
        << edited.out;
    // Where nothing is left to do --overwrite means all.
    EXPECT_EQ(call(project, anew).out.find("finished before"), std::string::npos);
}

TEST(Hazard, TellsFoldersOfReturnPeriodsThatTheTableLacks) {
    const SampleProject project;
    add_blocks(project);
    ASSERT_EQ(call(project, std::string{quick_hazard} + "--out out").code, 0);
    project.write("blocks.csv", "return_period_years,zone,diameter_m\n10,1,0.3\n30,1,0.5\n100,1,0.8\n");
    const Outcome fewer = call(project, std::string{quick_hazard} + "--out out");
    ASSERT_EQ(fewer.code, 0) << fewer.err;
    EXPECT_NE(fewer.err.find("return_period_300: a return period that hazard.blocks no longer has"),
              std::string::npos)
        << fewer.err;
    EXPECT_NE(project.read("out/hazard/report.html").find("that hazard.blocks no longer has"),
              std::string::npos);
    EXPECT_TRUE(std::filesystem::exists(project.file("out/return_period_300/report.html")));
}

TEST(Hazard, SaysThatNetsStandOnBothSlopes) {
    const SampleProject project;
    add_blocks(project);
    project.write("nets.csv", "name,height_m,class,wkt\nA,4,5,\"LINESTRING (1090 2020, 1090 2080)\"\n");
    ASSERT_EQ(call(project, std::string{quick_hazard} + "--set nets.file=nets.csv --out out").code, 0);
    EXPECT_NE(project.read("out/hazard/report.html").find("1, standing on both slopes"), std::string::npos);
}

TEST(Hazard, StaysWhereTheFallsCannotBeReplaced) {
    const SampleProject project;
    add_blocks(project);
    ASSERT_EQ(call(project, std::string{quick_hazard} + "--out out").code, 0);
    const std::string before = project.read("out/hazard/report.html");
    const Outcome other = call(project, std::string{quick_hazard} + "--out out --seed 7");
    EXPECT_EQ(other.code, 2);
    EXPECT_NE(other.err.find("return_period_10: found finished results of other settings or inputs"),
              std::string::npos)
        << other.err;
    EXPECT_EQ(project.read("out/hazard/report.html"), before);
}

/// A run that is broken off in a later return period leaves no map of what is no longer there.
TEST(Hazard, GoesBeforeItsRocksFallAnew) {
    const SampleProject project;
    add_blocks(project);
    ASSERT_EQ(call(project, std::string{quick_hazard} + "--out out").code, 0);
    std::filesystem::remove(project.file("out/return_period_300/summary.json"));
    std::filesystem::remove_all(project.file("out/return_period_300"));
    project.write("out/return_period_300", "in the way");
    const Outcome refused = call(project, std::string{quick_hazard} + "--out out");
    EXPECT_EQ(refused.code, 2);
    EXPECT_NE(refused.err.find("is a file"), std::string::npos) << refused.err;
    std::filesystem::remove(project.file("out/return_period_300"));
    const Outcome interrupted =
        shell(project, interrupted_once("out/return_period_10/parts",
                                        "run scenario.ini --quiet --out out --set release.rocks=100000000 "
                                        "--overwrite"));
    EXPECT_EQ(interrupted.code, 75) << interrupted.err;
    EXPECT_NE(interrupted.err.find("interrupted"), std::string::npos) << interrupted.err;
    EXPECT_FALSE(std::filesystem::exists(project.file("out/hazard")));
}

TEST(Hazard, LeavesNothingBehindBeforeAnyPartIsFinished) {
    const SampleProject project;
    add_blocks(project);
    const Outcome interrupted = shell(project, interrupted_once("new/return_period_10",
                                                                "run scenario.ini --quiet --out new "
                                                                "--set release.rocks=100000000"));
    EXPECT_EQ(interrupted.code, 75) << interrupted.err;
    EXPECT_FALSE(std::filesystem::exists(project.file("new")));
}

TEST(Hazard, SaysOnItsFirstScreenByWhichRule) {
    const SampleProject project;
    add_blocks(project);
    ASSERT_EQ(call(project,
                   std::string{quick_hazard} + "--out out --set hazard.rule=arrival --set hazard.energy=90")
                  .code,
              0);
    const std::string page = project.read("out/hazard/report.html");
    const std::string first_screen = page.substr(0, page.find("Targets by level"));
    for (const char* part :
         {"Return periods of the release", "return period of their arrival", "<dt>Spread of directions</dt>",
          "<dt>Start</dt>", "90th percentile of the energies <span class=\"mark given\">set</span>"}) {
        EXPECT_NE(first_screen.find(part), std::string::npos) << part;
    }
}

TEST(Hazard, TellsNoProtectionFromAHandfulOfArrivals) {
    const SampleProject project;
    add_blocks(project);
    ASSERT_EQ(call(project, "run scenario.ini --quiet --set release.rocks=4 --out out").code, 0);
    EXPECT_NE(project.read("out/hazard/report.html").find("too few rocks"), std::string::npos);
    ASSERT_EQ(call(project, std::string{quick_hazard} + "--out many").code, 0);
    EXPECT_EQ(project.read("many/hazard/report.html").find("too few rocks"), std::string::npos);
}

TEST(Hazard, OfSourcesAsLinesFollowsTheirZones) {
    const SampleProject project;
    add_blocks(project);
    project.write("blocks.csv", "return_period_years,zone,volume_m3,blocks\n33.3,1,0.2,150\n33.3,2,1,50\n");
    project.write(
        "lines.csv",
        "zone,wkt\n1,\"LINESTRING (1025 2035, 1025 2050)\"\n2,\"LINESTRING (1025 2052, 1025 2065)\"\n");
    project.replace("scenario.ini", "source = source.asc", "source_shapes = lines.csv");
    const Outcome outcome = call(project, "run scenario.ini --out out");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("hazard map of 1 return period\n"), std::string::npos) << outcome.out;
    EXPECT_EQ(project.read("out/hazard/tables/hazard_blocks.csv"),
              "zone,return_period_years,diameter_m,mass_kg,rocks\n1,33.3,0.726,540.0,150\n"
              "2,33.3,1.241,2700.0,50\n");
    EXPECT_TRUE(std::filesystem::exists(project.file("out/hazard/rasters/bare/Intensity_33.3.asc")));
}

TEST(Hazard, DescribesItsTablesAndRasters) {
    const SampleProject project;
    add_blocks(project);
    ASSERT_EQ(call(project, std::string{quick_hazard} + "--out out").code, 0);
    const config::Table dictionary = table(project, "out/hazard/tables/data_dictionary.csv");
    for (const TableLayout& layout : hazard::hazard_layouts()) {
        const config::Table written = table(project, "out/hazard/tables/" + layout.file);
        EXPECT_GT(written.rows(), 0U) << layout.file;
        ASSERT_EQ(written.columns().size(), layout.columns.size()) << layout.file;
    }
    const std::string rasters = project.read("out/hazard/tables/raster_dictionary.csv");
    for (const char* raster : {"Hazard_level", "Hazard_return_period", "Intensity_10", "Intensity_300"}) {
        EXPECT_NE(rasters.find("rasters/forest," + std::string{raster}), std::string::npos) << raster;
    }
}

/// A map would link a page that is not there.
TEST(Hazard, CountsNoPeriodAsFinishedOfWhichAFileIsMissing) {
    const SampleProject project;
    add_blocks(project);
    ASSERT_EQ(call(project, std::string{quick_hazard} + "--out out").code, 0);
    std::filesystem::remove(project.file("out/return_period_30/report.html"));
    const Outcome refused = call(project, std::string{quick_hazard} + "--out out");
    EXPECT_EQ(refused.code, 2);
    EXPECT_NE(refused.err.find("return_period_30: found results of which report.html is missing"),
              std::string::npos)
        << refused.err;
    const Outcome again = call(project, "run scenario.ini --set release.rocks=400 --out out --overwrite");
    ASSERT_EQ(again.code, 0) << again.err;
    EXPECT_NE(again.out.find("return period of 10 years: finished before"), std::string::npos) << again.out;
    EXPECT_EQ(again.out.find("return period of 30 years: finished before"), std::string::npos) << again.out;
    EXPECT_TRUE(std::filesystem::exists(project.file("out/return_period_30/report.html")));
}

TEST(Hazard, FinishesAPeriodWhosePublishingWasKilled) {
    const SampleProject project;
    add_blocks(project);
    ASSERT_EQ(call(project, std::string{quick_hazard} + "--out out").code, 0);
    const Outcome outcome =
        shell(project, std::string{"cp -r out whole\nmkdir out/return_period_30/.complete\n"
                                   "mv out/return_period_30/summary.json "
                                   "out/return_period_30/.complete\nrm -r out/hazard\n"
                                   "mkdir out/.hazard_replaced\n\"$bannwald\" "} +
                           quick_hazard + "--out out || exit 1\ndiff -r out whole\n");
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
}

TEST(Hazard, KeepsOneFolderForOneRun) {
    const SampleProject project;
    add_blocks(project);
    const std::string run = "run scenario.ini --quiet --out out --set release.rocks=100000000";
    const Outcome outcome = shell(project, "\"$bannwald\" " + run +
                                               " &\nfirst=$!\nwhile kill -0 $first && [ ! -e "
                                               "out/return_period_10/parts ]; do :; done\n\"$bannwald\" " +
                                               run +
                                               "\ncode=$?\nkill -INT $first\nwait $first\n[ $? = 75 ] && "
                                               "[ ! -e out ] && exit $code\n");
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_NE(outcome.err.find("another run of bannwald works in this output folder"), std::string::npos)
        << outcome.err;
}

TEST(Hazard, IsNotComparedAsARun) {
    const SampleProject project;
    add_blocks(project);
    ASSERT_EQ(call(project, std::string{quick_hazard} + "--out out").code, 0);
    const Outcome outcome = call(project, "compare out/hazard out/hazard");
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("a hazard map of several return periods, expected the folder of one of them; "
                               "such as out/return_period_300"),
              std::string::npos)
        << outcome.err;
}

/// Who names the folder of a hazard run where one return period is meant gets their names.
TEST(Hazard, NamesItsReturnPeriodsWhereOneIsMeant) {
    const SampleProject project;
    add_blocks(project);
    ASSERT_EQ(call(project, std::string{quick_hazard} + "--out out").code, 0);
    project.write("nets.csv", "name,height_m,class,wkt\nlow,3,1,\"LINESTRING (1090 2010, 1090 2030)\"\n");
    for (const std::string command : {"compare out out", "net try out --nets nets.csv"}) {
        const Outcome outcome = call(project, command);
        EXPECT_EQ(outcome.code, 3) << command;
        EXPECT_NE(outcome.err.find("name the folder of a finished run: out/hazard, out/return_period_10, "
                                   "out/return_period_30, out/return_period_100 or out/return_period_300"),
                  std::string::npos)
            << outcome.err;
    }
}

}  // namespace
}  // namespace coupling::hazard_test
