// Nets tried on the stored paths of a run, and where they should stand.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "coupling/inputs/formats/read_file.hpp"
#include "tests/runs/nets.hpp"
#include "tests/runs/years.hpp"

namespace coupling::net_place_test {
namespace {

TEST(NetTry, TakesLayersAsTablesAre) {
    const SampleProject project;
    add_nets(project);
    project.write(
        "nets.geojson",
        R"({"type":"FeatureCollection","features":[)"
        R"({"type":"Feature","properties":{"id":"upper","height_m":1.2,"capacity_kj":5,"gap_m":0.1},)"
        R"("geometry":{"type":"LineString","coordinates":[[1075,2010],[1078,2050],[1075,2090]]}},)"
        R"({"type":"Feature","properties":{"id":"lower","height_m":3,"class":"1"},)"
        R"("geometry":{"type":"LineString","coordinates":[[1098,2005],[1098,2095]]}}]})");
    const std::string rocks = "run scenario.ini --quiet --set release.rocks=1000 ";
    ASSERT_EQ(call(project, rocks + "--out table").code, 0);
    const Outcome run = call(project, rocks + "--set nets.file=nets.geojson --out layer");
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(project.read("layer/tables/net_crossings.csv"), project.read("table/tables/net_crossings.csv"));
    ASSERT_EQ(call(project, rocks + "--set nets.file= --set nets.keep_paths=yes --out kept").code, 0);
    ASSERT_EQ(call(project, "net try kept --nets nets.csv --out of_table").code, 0);
    const Outcome of_layer = call(project, "net try kept --nets nets.geojson --out of_layer");
    ASSERT_EQ(of_layer.code, 0) << of_layer.err;
    EXPECT_EQ(project.read("of_layer/nets.csv"), project.read("of_table/nets.csv"));
    EXPECT_NE((of_layer.out + of_layer.err).find("nets.geojson: column 'id' is taken as name"),
              std::string::npos)
        << of_layer.out << of_layer.err;
}

TEST(NetPlace, PutsNoNetThroughAHouseAndNeedsNone) {
    const SampleProject project;
    add_nets(project);
    project.write("targets.csv",
                  "target_id,name,wkt\nhouse,house,\"POLYGON ((1066 2040, 1071 2040, 1071 2060, 1066 2060, "
                  "1066 2040))\"\n");
    project.write("road.csv",
                  "name,height_m,capacity_kj,wkt\nroad,2,100,\"LINESTRING (1098 2015, 1098 2085)\"\n");
    project.write("line.csv", "name,wkt\nline,\"LINESTRING (1098 2015, 1098 2085)\"\n");
    const std::string rocks =
        "run scenario.ini --quiet --set nets.file= --set release.rocks=1000 --set nets.keep_paths=yes ";
    ASSERT_EQ(call(project, rocks + "--out house").code, 0);
    ASSERT_EQ(call(project, rocks + "--set targets.file= --out none").code, 0);
    for (const char* lines : {"road.csv", "line.csv"}) {
        const std::string past = " --azimuth 270 --distances 10,30 --overwrite --nets ";
        const Outcome beside = call(project, "net place house" + past + lines);
        ASSERT_EQ(beside.code, 0) << beside.err;
        EXPECT_NE(beside.out.find("house"), std::string::npos) << beside.out;
        for (const char* table_name : {"net_candidates.csv", "net_places.csv"}) {
            if (!std::filesystem::exists(project.file(std::string{"house/net_place/"} + table_name))) {
                continue;
            }
            const config::Table found = table(project, std::string{"house/net_place/"} + table_name);
            for (std::size_t row = 0; row < found.rows(); ++row) {
                EXPECT_EQ(number(found, row, "distance_m"), 10.0) << lines << " " << table_name;
            }
        }
        const Outcome without = call(project, "net place none" + past + lines);
        ASSERT_EQ(without.code, 0) << "a run without targets has no houses: " << without.err;
        EXPECT_EQ(without.out.find("house"), std::string::npos) << without.out;
    }
    project.write("through.csv",
                  "name,height_m,capacity_kj,wkt\nthrough,2,100,\"LINESTRING (1068 2015, 1068 2085)\"\n");
    const Outcome tried = call(project, "net try house --nets through.csv --out tried");
    ASSERT_EQ(tried.code, 0) << tried.err;
    EXPECT_NE(tried.out.find("net 'through' runs through the house 'house'"), std::string::npos) << tried.out;
}

TEST(NetPlace, FindsWhereANetKeepsMostFromALine) {
    const SampleProject project;
    add_nets(project);
    const std::string rocks =
        "run scenario.ini --quiet --set nets.file= --set targets.file= --set release.rocks=2000 "
        "--set nets.keep_paths=yes ";
    ASSERT_EQ(call(project, rocks + "--out out").code, 0);
    project.write("road.csv",
                  "name,height_m,capacity_kj,wkt\nroad,2,100,\"LINESTRING (1098 2015, 1098 2085)\"\n");
    const Outcome placed = call(project, "net place out --nets road.csv --distances 0,10,30,500");
    ASSERT_EQ(placed.code, 0) << placed.err;
    EXPECT_NE(placed.out.find("500 m upslope it leaves the terrain"), std::string::npos) << placed.out;
    const std::string page = project.read("out/net_place/report.html");
    for (const auto& file : std::filesystem::directory_iterator{project.file("out/net_place")}) {
        const std::string name = file.path().filename().string();
        EXPECT_TRUE(name == "report.html" || page.find(">" + name + "<") != std::string::npos) << name;
    }
    const config::Table places = table(project, "out/net_place/net_places.csv");
    ASSERT_EQ(places.rows(), 6U);  // three places, with forest and without
    double least = 1e9;
    double of_best = 0.0;
    for (std::size_t row = 0; row < places.rows(); ++row) {
        EXPECT_LE(number(places, row, "kept"), number(places, row, "arrive"));
        if (places.text(row, "cover") == "forest") {
            least = std::min(least, number(places, row, "residual_kj"));
            of_best = places.text(row, "best") == "yes" ? number(places, row, "residual_kj") : of_best;
        }
    }
    EXPECT_EQ(of_best, least);
    // On the line itself the net holds what a run with it there holds.
    ASSERT_EQ(call(project,
                   "run scenario.ini --quiet --set nets.file=road.csv --set release.rocks=2000 --out there")
                  .code,
              0);
    const config::Table there = table(project, "there/tables/nets.csv");
    for (std::size_t row = 0; row < 2; ++row) {
        EXPECT_EQ(places.text(row, "cover"), there.text(row, "cover"));
        EXPECT_EQ(places.text(row, "arrive"), there.text(row, "reached"));
        EXPECT_EQ(places.text(row, "kept"), there.text(row, "held"));
        for (const char* column : {"design_energy_kj", "design_class", "design_height_m", "sold_height_m"}) {
            EXPECT_EQ(places.text(row, column), there.text(row, column)) << column;
        }
    }
    EXPECT_EQ(
        call(project, "run scenario.ini --quiet --set nets.file=out/net_place/nets.csv --out best").code, 0);
}

TEST(NetPlace, TakesTheGivenWayAndNamesNoPlaceThatKeepsNothing) {
    const SampleProject project;
    const std::string rocks =
        "run scenario.ini --quiet --set targets.file= --set release.rocks=300 --set nets.keep_paths=yes ";
    ASSERT_EQ(call(project, rocks + "--out out").code, 0);
    project.write("road.csv",
                  "name,height_m,class,wkt\nroad,2,1,\"LINESTRING (1098 2015, 1098 2085)\"\n"
                  "above the sources,2,1,\"LINESTRING (1008 2012, 1008 2020)\"\n");
    const Outcome rocks_way = call(project, "net place out --nets road.csv --distances 2");
    ASSERT_EQ(rocks_way.code, 0) << rocks_way.err;
    EXPECT_NE(rocks_way.out.find("rocks that reach it come from"), std::string::npos) << rocks_way.out;
    EXPECT_NE(rocks_way.out.find("above the sources: no rock reaches the line"), std::string::npos)
        << rocks_way.out;
    const config::Table best = table(project, "out/net_place/nets.csv");
    ASSERT_EQ(best.rows(), 1U);
    EXPECT_EQ(best.text(0, "class"), "1");
    EXPECT_EQ(best.text(0, "capacity_kj"), "");
    // Downhill of the road a net keeps nothing from it.
    const Outcome given =
        call(project, "net place out --nets road.csv --distances 1 --azimuth 90 --out down");
    ASSERT_EQ(given.code, 0) << given.err;
    EXPECT_NE(given.out.find("road: no place keeps a rock from the line"), std::string::npos) << given.out;
    const config::Table places = table(project, "down/net_places.csv");
    for (std::size_t row = 0; row < places.rows(); ++row) {
        EXPECT_EQ(places.text(row, "best"), "no");
        EXPECT_EQ(number(places, row, "azimuth_deg"), 90.0);
        EXPECT_EQ(places.text(row, "azimuth_from"), "given");
    }
    EXPECT_EQ(table(project, "down/nets.csv").rows(), 0U);
}

/// A road as it is: nothing about nets stands in the file.
TEST(NetPlace, TakesARoadAsItIsAndSaysWhereNetsAreNeeded) {
    const SampleProject project;
    ASSERT_EQ(call(project,
                   "run scenario.ini --quiet --set release.rocks=2000 --set nets.keep_paths=yes --out out "
                   "--set report.language=de --set report.title=Talstrasse --set report.client=Gemeinde")
                  .code,
              0);
    const Outcome placed = call(project, "net place out --nets targets.csv --distances 10,20,30");
    ASSERT_EQ(placed.code, 0) << placed.err;
    EXPECT_NE(placed.out.find("house: an area, left out"), std::string::npos) << placed.out;
    EXPECT_NE(placed.out.find("road: works are needed on"), std::string::npos) << placed.out;

    const config::Table along = table(project, "out/net_place/net_along.csv");
    const config::Table targets = table(project, "out/tables/targets.csv");
    const auto sum_of = [&](const std::string& cover, const char* column) {
        double sum = 0.0;
        for (std::size_t row = 0; row < along.rows(); ++row) {
            sum += along.text(row, "cover") == cover ? number(along, row, column) : 0.0;
        }
        return sum;
    };
    // The road of the run counts the same rocks, those that fall below it too, and those that only touch it
    // with their side.
    const config::Table arrivals = table(project, "out/tables/arrivals.csv");
    const auto beside = [&](const std::string& cover) {
        double rocks = 0.0;
        for (std::size_t row = 0; row < arrivals.rows(); ++row) {
            rocks += arrivals.text(row, "target_id") == "road" && arrivals.text(row, "cover") == cover &&
                             arrivals.text(row, "by_side") == "yes"
                         ? 1.0
                         : 0.0;
        }
        return rocks;
    };
    for (std::size_t row = 0; row < targets.rows(); ++row) {
        if (targets.text(row, "target_id") == "road") {
            const std::string cover = targets.text(row, "cover");
            EXPECT_EQ(sum_of(cover, "rocks") + beside(cover), number(targets, row, "reached"));
        }
    }
    const config::Table stretches = table(project, "out/net_place/net_stretches.csv");
    ASSERT_GE(stretches.rows(), 1U);
    double energy_percent = 0.0;
    for (std::size_t row = 0; row < stretches.rows(); ++row) {
        energy_percent += number(stretches, row, "energy_percent");
        EXPECT_EQ(stretches.text(row, "cover"), "forest");
    }
    EXPECT_GE(energy_percent, 95.0);

    const config::Table candidates = table(project, "out/net_place/net_candidates.csv");
    std::size_t best = 0;
    for (std::size_t row = 0; row < candidates.rows(); ++row) {
        EXPECT_LE(number(candidates, row, "kept"), number(candidates, row, "crossing"));
        EXPECT_EQ(number(candidates, row, "kept") + number(candidates, row, "left_rocks"),
                  number(candidates, row, "rocks"));
        const bool judged = candidates.text(row, "cover") == "forest";
        if (judged && candidates.text(row, "keeps_wanted") == "yes") {
            EXPECT_GE(number(candidates, row, "kept_percent"), 95.0);
        }
        best += judged && candidates.text(row, "best") == "yes" ? 1U : 0U;
    }
    EXPECT_EQ(best, stretches.rows());
    // The page has the head and the language of the run; the screen is English.
    const std::string page = project.read("out/net_place/report.html");
    for (const char* part : {"<html lang=\"de\"", "<h1>Talstrasse</h1>", "Gemeinde"}) {
        EXPECT_NE(page.find(part), std::string::npos) << part;
    }
    EXPECT_EQ(page.find("Where nets are needed"), std::string::npos);

    // The nets stand in a run and leave there what the page says.
    ASSERT_EQ(call(project,
                   "run scenario.ini --quiet --set release.rocks=2000 --set nets.file=out/net_place/nets.csv "
                   "--out with")
                  .code,
              0);
    const config::Table with = table(project, "with/tables/targets.csv");
    for (std::size_t row = 0; row < with.rows(); ++row) {
        if (with.text(row, "target_id") == "road") {
            const double left = sum_of(with.text(row, "cover"), "left_rocks");
            // Rocks that break through may stop behind the net: here they count as they were without it.
            EXPECT_LE(number(with, row, "reached"), left);
            EXPECT_LT(left, 0.2 * sum_of(with.text(row, "cover"), "rocks"));
        }
    }
    const Outcome again = call(project, "net place out --nets targets.csv --distances 10,20,30 --out again");
    ASSERT_EQ(again.code, 0);
    const Outcome same = shell(project, "diff -r out/net_place again\n");
    EXPECT_EQ(same.code, 0) << same.out;
}

TEST(NetPlace, RefusesARoadElsewhere) {
    const SampleProject project;
    ASSERT_EQ(
        call(project, "run scenario.ini --quiet --set release.rocks=50 --set nets.keep_paths=yes --out out")
            .code,
        0);
    project.write("road.csv", "name,wkt\nroad,\"LINESTRING (2010 1105, 2090 1105)\"\n");
    const Outcome outcome = call(project, "net place out --nets road.csv");
    EXPECT_EQ(outcome.code, 4);
    EXPECT_NE(outcome.err.find("line 'road' outside the terrain: x and y look swapped"), std::string::npos)
        << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(project.file("out/net_place")));
}

/// Behind a weak net nothing is known of the rocks that break it, and the row of the net there says so.
TEST(NetTry, MarksNetsOfWhichItDoesNotKnowWhoReachesThem) {
    const SampleProject project;
    const std::string rocks = "run scenario.ini --quiet --set release.rocks=1000 --set nets.keep_paths=yes ";
    ASSERT_EQ(call(project, rocks + "--out out").code, 0);
    project.write("weak.csv",
                  "name,height_m,capacity_kj,wkt\nweak,50,0.001,\"LINESTRING (1090 2005, 1090 2095)\"\n"
                  "behind,3,100,\"LINESTRING (1095 2005, 1095 2095)\"\n");
    const Outcome tried = call(project, "net try out --nets weak.csv");
    ASSERT_EQ(tried.code, 0) << tried.err;
    EXPECT_NE(tried.out.find("behind, bare slope: at least "), std::string::npos) << tried.out;
    const config::Table nets = table(project, "out/net_try/nets.csv");
    for (std::size_t row = 0; row < nets.rows(); ++row) {
        if (nets.text(row, "net") == "weak") {
            EXPECT_EQ(number(nets, row, "inexact_rocks"), 0.0);
        } else {
            EXPECT_GT(number(nets, row, "inexact_rocks"), 0.0);
        }
    }
}

TEST(NetTables, OfTheCommandsAreDescribed) {
    const SampleProject project;
    const Outcome places = call(project, "info tables net_places");
    EXPECT_EQ(places.code, 0);
    EXPECT_NE(places.out.find("residual_kj"), std::string::npos) << places.out;
    EXPECT_NE(call(project, "info tables net_stretches").out.find("left_energy_percent"), std::string::npos);
    EXPECT_EQ(call(project, "info tables net_inexact").code, 0);
}

TEST(NetPaths, TellTheirSizeBeforeTheRun) {
    const SampleProject project;
    EXPECT_EQ(call(project, "check scenario.ini").out.find("net_paths.bin"), std::string::npos);
    const Outcome check = call(project, "check scenario.ini --set nets.keep_paths=yes");
    EXPECT_EQ(check.code, 0) << check.err;
    EXPECT_NE(check.out.find(" for net_paths.bin"), std::string::npos) << check.out;
}

TEST(NetTry, TellsWhichRocksItDoesNotKnow) {
    const SampleProject project;
    add_nets(project);
    const std::string rocks = "run scenario.ini --quiet --set release.rocks=2000 --set nets.keep_paths=yes ";
    ASSERT_EQ(call(project, rocks + "--out out").code, 0);
    const Outcome tried = call(project, "net try out --nets nets.csv");
    ASSERT_EQ(tried.code, 0) << tried.err;
    EXPECT_NE(tried.out.find("break through a net"), std::string::npos) << tried.out;
    const config::Table inexact = table(project, "out/net_try/net_inexact.csv");
    const config::Table crossings = table(project, "out/net_try/net_crossings.csv");
    std::size_t broke = 0;
    for (std::size_t row = 0; row < crossings.rows(); ++row) {
        broke += crossings.text(row, "outcome") == "broke" ? 1U : 0U;
    }
    EXPECT_EQ(inexact.rows(), broke);
    EXPECT_GT(broke, 0U);
    const std::string package = project.read("out/net_try/net_try.gpkg");
    const auto rows_of = [&](const char* layer) {
        return formats::read_layer_file(package, layer, "net_try.gpkg",
                                        [](const std::string&) { return std::string_view{}; })
            .layer.table.rows();
    };
    EXPECT_EQ(rows_of("net_crossings"), crossings.rows());
    EXPECT_EQ(rows_of("nets"), table(project, "out/net_try/nets.csv").rows());
}

TEST(NetTry, RefusesPathsThatAreCutOffOrOfAnotherRun) {
    const SampleProject project;
    add_nets(project);
    const std::string rocks = "run scenario.ini --quiet --set release.rocks=100 --set nets.keep_paths=yes ";
    ASSERT_EQ(call(project, rocks + "--out one").code, 0);
    ASSERT_EQ(call(project, rocks + "--seed 9 --out other").code, 0);
    EXPECT_EQ(call(project, "net try nowhere --nets nets.csv").code, 3);
    EXPECT_EQ(call(project, "net try one").code, 2);
    EXPECT_EQ(shell(project, "cp other/net_paths.bin one/\n\"$bannwald\" net try one --nets nets.csv\n").code,
              4);
    ASSERT_EQ(call(project, rocks + "--set rockfall.motion=classical --out model").code, 0);
    const Outcome other_model =
        shell(project, "cp model/net_paths.bin one/\n\"$bannwald\" net try one --nets nets.csv\n");
    EXPECT_EQ(other_model.code, 4);
    EXPECT_NE(other_model.err.find("of rockfall.motion = classical, where summary.json beside it has picus"),
              std::string::npos)
        << other_model.err;
    EXPECT_EQ(shell(project,
                    "head -c 100000 other/net_paths.bin > cut && cp cut other/net_paths.bin\n"
                    "\"$bannwald\" net try other --nets nets.csv\n")
                  .code,
              3);
    EXPECT_FALSE(std::filesystem::exists(project.file("other/net_try")));
}

}  // namespace
}  // namespace coupling::net_place_test
