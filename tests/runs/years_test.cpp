#include "tests/runs/years.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "config/grid/ascii_grid.hpp"

namespace coupling::years_test {
namespace {

namespace fs = std::filesystem;

/// Sum of a column by year.
std::map<int, double> by_year(const config::Table& table, const std::string& column,
                              const std::function<bool(std::size_t row)>& counts) {
    std::map<int, double> sums;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (counts(row) && !table.text(row, column).empty()) {
            sums[static_cast<int>(number(table, row, "year"))] += number(table, row, column);
        }
    }
    return sums;
}

TEST(ForestExample, RunsAsItIsWritten) {
    const SampleProject project;
    ASSERT_EQ(call(project, "init example --example forest --quiet").code, 0);
    const Outcome outcome = call(project, "run example/scenario.ini --quiet");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    for (const std::string name :
         {"report.html", "summary.json", "tables/stands.csv", "tables/dbh_classes.csv",
          "tables/forest_years.csv", "tables/mortality.csv", "tables/trees_0.csv", "tables/trees_50.csv",
          "tables/trees_100.csv", "rasters/forest/none/year_0/volume.asc",
          "rasters/forest/none/year_100/volume.prj"}) {
        EXPECT_TRUE(fs::exists(project.file("example/out/" + name))) << name;
    }
    // No rocks fall and nobody works.
    for (const std::string name :
         {"tables/protection.csv", "tables/interventions.csv", "rasters/rockfall", "parts", ".writing"}) {
        EXPECT_FALSE(fs::exists(project.file("example/out/" + name))) << name;
    }
    for (const std::string kind :
         {"basal_area", "ground_light", "leaf_area_index", "stems", "top_height", "volume"}) {
        const std::string name = "example/out/rasters/forest/none/year_100/" + kind + ".asc";
        const config::Raster<double> raster = config::read_ascii_grid(project.read(name), name);
        EXPECT_EQ(std::count_if(raster.values.begin(), raster.values.end(),
                                [](double value) { return value >= 0.0; }),
                  28)
            << kind;
    }
}

TEST(ForestExample, ClaimsNothingBeforeItsFirstSeason) {
    const SampleProject project;
    ASSERT_EQ(call(project, "init example --example forest --quiet").code, 0);
    ASSERT_EQ(call(project,
                   "run example/scenario.ini --quiet --set run.years=1 "
                   "--set 'output.tree_list_years=0, 1' --set 'output.map_years=0, 1'")
                  .code,
              0);
    for (const std::string year : {"0", "1"}) {
        const bool is_known = year == "1";
        const config::Table trees = table(project, "example/out/tables/trees_" + year + ".csv");
        ASSERT_GT(trees.rows(), 0U);
        EXPECT_EQ(trees.text(0, "light_ratio").empty(), !is_known);
        EXPECT_EQ(
            fs::exists(project.file("example/out/rasters/forest/none/year_" + year + "/ground_light.asc")),
            is_known);
        EXPECT_TRUE(fs::exists(project.file("example/out/rasters/forest/none/year_" + year + "/volume.asc")));
    }
    const config::Table stands = table(project, "example/out/tables/stands.csv");
    for (std::size_t row = 0; row < stands.rows(); ++row) {
        EXPECT_EQ(stands.text(row, "drought_index").empty(), stands.text(row, "year") == "0") << row;
    }
}

TEST(ForestExample, SaysWhichRecordedCutsComeAfterItsEnd) {
    const SampleProject project;
    ASSERT_EQ(call(project, "init example --example forest --quiet").code, 0);
    project.write("example/felled.csv", "tree_id,year\n3,1\n4,2\n5,30\n");
    project.write("example/cut.csv", "treatment,trees\nfell_list,felled.csv\n");
    const auto check_years = [&](const std::string& years) {
        return call(project,
                    "check example/scenario.ini --set regimes.list=cut.csv "
                    "--set output.tree_list_years= --set output.map_years= --set run.years=" +
                        years);
    };
    const Outcome late = check_years("2");
    EXPECT_EQ(late.code, 0) << late.err;
    EXPECT_NE((late.out + late.err)
                  .find("felled.csv: 1 tree to be felled after the last year of the run, 2 (2012)"),
              std::string::npos)
        << late.out << late.err;
    const Outcome whole = check_years("30");
    EXPECT_EQ((whole.out + whole.err).find("to be felled after"), std::string::npos)
        << whole.out << whole.err;
}

TEST(ForestExample, SaysHowManyListedTreesWereFelled) {
    const SampleProject project;
    ASSERT_EQ(call(project, "init example --example forest --quiet").code, 0);
    project.write("example/felled.csv", "tree_id,year\n1,1\n2,3\n3,9\n");
    project.write("example/cut.csv",
                  "name,treatment,trees,first_year\nlist,fell_list,felled.csv,\nall,clear_cut,,2\n");
    project.write("example/list.csv", "name,treatment,trees\nlist,fell_list,felled.csv\n");
    const auto messages_of = [&](const std::string& regime) {
        const Outcome outcome = call(project,
                                     "run example/scenario.ini --quiet --set output.tree_list_years= "
                                     "--set output.map_years= --set run.years=4 --out " +
                                         regime + " --set regimes.list=" + regime + ".csv");
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return outcome.err;
    };
    EXPECT_NE(messages_of("cut").find("regime cut: list felled 1 of 2 listed trees, mean of the replicates"),
              std::string::npos);
    EXPECT_EQ(messages_of("list").find("listed trees"), std::string::npos) << "1 and 2 live for four years";
}

TEST(ForestExample, BeginsWithTheMappedTrees) {
    const SampleProject project;
    ASSERT_EQ(call(project, "init example --example forest --quiet").code, 0);
    ASSERT_EQ(call(project,
                   "run example/scenario.ini --quiet --set run.years=1 "
                   "--set output.tree_list_years= --set output.map_years=")
                  .code,
              0);
    const config::Table mapped = table(project, "example/trees.csv");
    const config::Table start = table(project, "example/out/tables/trees_0.csv");
    ASSERT_EQ(mapped.rows(), 108U);
    ASSERT_EQ(start.rows(), 108U);
    for (std::size_t row = 0; row < start.rows(); ++row) {
        for (const std::string column : {"tree_id", "x_m", "y_m", "dbh_cm", "height_m"}) {
            EXPECT_NEAR(number(start, row, column), number(mapped, row, column), 0.0051)
                << column << " of row " << row;
        }
    }
    const config::Table stands = table(project, "example/out/tables/stands.csv");
    EXPECT_NEAR(number(stands, 0, "stems_pha"), 108 / 0.28, 0.051);
}

TEST(ForestExample, WritesTheColumnsThatItsReadersKnow) {
    const SampleProject project;
    ASSERT_EQ(call(project, "init example --example forest --quiet").code, 0);
    ASSERT_EQ(call(project,
                   "run example/scenario.ini --quiet --set run.years=1 "
                   "--set output.tree_list_years= --set output.map_years=")
                  .code,
              0);
    const std::map<std::string, std::vector<std::string>> columns{
        {"stands",
         {"stand", "species", "stems_pha", "basal_area_m2pha", "volume_m3pha", "above_ground_tpha",
          "mean_dbh_cm", "lorey_height_m", "dominant_height_m", "leaf_area_index", "drought_index"}},
        {"dbh_classes", {"species", "dbh_from_cm", "dbh_to_cm", "stems_pha"}},
        {"forest_years",
         {"calendar_year", "volume_increment_m3pha", "production_tpha", "ingrowth_stems_pha", "saplings_pha",
          "snags_pha", "logs_pha", "precipitation_mm", "mean_temperature_degc"}},
        {"mortality", {"cause", "stems_pha", "volume_m3pha", "above_ground_tpha"}},
        {"trees_1",
         {"tree_id", "x_m", "y_m", "species", "dbh_cm", "height_m", "crown_base_m", "age_years",
          "light_ratio", "vitality", "stems", "rock_hits", "rock_energy_kj"}}};
    for (const auto& [name, wanted] : columns) {
        const config::Table written = table(project, "example/out/tables/" + name + ".csv");
        const std::vector<std::string> first{written.columns().begin(), written.columns().begin() + 4};
        EXPECT_EQ(first, (std::vector<std::string>{"regime", "climate", "replicate", "year"})) << name;
        for (const std::string& column : wanted) {
            EXPECT_TRUE(written.has(column)) << name << ": " << column;
        }
    }
}

TEST(ForestExample, KeepsTheBooksOfItsStems) {
    const SampleProject project;
    ASSERT_EQ(call(project, "init example --example forest --quiet").code, 0);
    ASSERT_EQ(call(project,
                   "run example/scenario.ini --quiet --set run.years=40 "
                   "--set output.tree_list_years= --set output.map_years=")
                  .code,
              0);
    const config::Table stands = table(project, "example/out/tables/stands.csv");
    const config::Table years = table(project, "example/out/tables/forest_years.csv");
    const config::Table losses = table(project, "example/out/tables/mortality.csv");
    const auto every = [](std::size_t) { return true; };
    const auto standing = by_year(stands, "stems_pha", [&](std::size_t row) {
        return stands.text(row, "stand") == "all" && stands.text(row, "species") == "all";
    });
    auto in = by_year(years, "ingrowth_stems_pha", every);
    auto out = by_year(losses, "stems_pha", every);
    ASSERT_EQ(standing.size(), 41U);
    double sum_in = 0.0;
    double sum_out = 0.0;
    for (int year = 1; year <= 40; ++year) {
        sum_in += in[year];
        sum_out += out[year];
        // Rounded to tenths: two standing, one that came in, and thousandths of those that went for few
        // causes.
        EXPECT_NEAR(standing.at(year), standing.at(year - 1) + in[year] - out[year], 0.16) << year;
    }
    EXPECT_GT(sum_in, 100.0);
    EXPECT_GT(sum_out, 10.0);
}

TEST(Years, AreTheSameBytesOnAnyNumberOfThreads) {
    const ForestProject project;
    const Outcome first = call(project, std::string{four_members} + "--threads 1 --out first");
    ASSERT_EQ(first.code, 0) << first.err;
    ASSERT_TRUE(fs::exists(project.file("first/tables/protection.csv")));
    ASSERT_TRUE(fs::exists(project.file("first/tables/interventions.csv")));
    // Two members at a time; and one whose rocks fall on two threads.
    const Outcome two = shell(project, "\"$bannwald\" " + std::string{four_members} +
                                           "--threads 2 --out two && diff -r first two\n");
    EXPECT_EQ(two.code, 0) << two.out << two.err;
    const std::string alone = std::string{four_members} +
                              "--set release.rocks=2000 --set run.replicates=1 --set regimes.list=none ";
    const Outcome rocks =
        shell(project, "\"$bannwald\" " + alone + "--threads 1 --out one_alone && \"$bannwald\" " + alone +
                           "--threads 2 --out two_alone && diff -r one_alone two_alone\n");
    EXPECT_EQ(rocks.code, 0) << rocks.out << rocks.err;
}

TEST(Years, OfAllRegimesSeeTheSameRocksAndReplicatesDoNot) {
    const ForestProject project;
    ASSERT_EQ(call(project, four_members).code, 0);
    const config::Table rows = table(project, "out/tables/protection.csv");
    std::map<std::string, std::set<std::string>> of_place;  // by replicate, year and target
    std::map<std::string, std::set<std::string>> of_replicate;
    for (std::size_t row = 0; row < rows.rows(); ++row) {
        of_place[rows.text(row, "replicate") + '/' + rows.text(row, "year") + '/' +
                 rows.text(row, "target_id")]
            .insert(rows.text(row, "reached_bare"));
        of_replicate[rows.text(row, "replicate")].insert(rows.text(row, "year") + ':' +
                                                         rows.text(row, "reached_bare"));
    }
    EXPECT_EQ(of_place.size(), 2U * 3U * 2U);
    for (const auto& [place, counts] : of_place) {
        EXPECT_EQ(counts.size(), 1U) << place;
    }
    EXPECT_NE(of_replicate["1"], of_replicate["2"]);
}

TEST(BareGround, BeginsWithoutAnyTree) {
    const ForestProject project;
    const Outcome outcome = call(project, "run scenario.ini --set trees.file= --set run.years=3");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("the forest begins on bare ground"), std::string::npos) << outcome.err;
    const config::Table stands = table(project, "out/tables/stands.csv");
    EXPECT_EQ(number(stands, 0, "stems_pha"), 0.0);
    EXPECT_EQ(table(project, "out/tables/trees_0.csv").rows(), 0U);
    const config::Table years = table(project, "out/tables/forest_years.csv");
    EXPECT_GT(number(years, years.rows() - 1, "saplings_pha"), 0.0);
    EXPECT_EQ(table(project, "out/tables/protection.csv").text(0, "protection_percent"), "0.000");
}

}  // namespace
}  // namespace coupling::years_test
