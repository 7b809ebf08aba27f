#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

#include "coupling/assessments/hazard/hazard_matrix.hpp"
#include "tests/runs/hazard.hpp"
#include "tests/runs/years.hpp"

namespace coupling::hazard_page_test {
namespace {

/// Houses below the slope, and the road.
void add_houses(const SampleProject& project) {
    std::string targets = "target_id,name,wkt\nroad,The road,\"LINESTRING (1105 2010, 1105 2090)\"\n";
    for (int i = 0; i < 24; ++i) {
        const int x = 1050 + 9 * (i % 6);
        const int y = 2012 + 20 * (i / 6);
        targets += "h" + std::to_string(i) + ",House " + std::to_string(i) + ",\"POLYGON ((" +
                   std::to_string(x) + ' ' + std::to_string(y) + ',' + std::to_string(x + 4) + ' ' +
                   std::to_string(y) + ',' + std::to_string(x + 4) + ' ' + std::to_string(y + 4) + ',' +
                   std::to_string(x) + ' ' + std::to_string(y) + "))\"\n";
    }
    project.write("houses.csv", targets);
    std::string trees = "tree_id,x_m,y_m,species,dbh_cm,height_m\n";
    for (int i = 0; i < 120; ++i) {
        trees += std::to_string(i + 1) + ',' + std::to_string(1036 + 4 * (i % 4)) + ',' +
                 std::to_string(2010 + 80 * (i / 4) / 30) + ",ABAL,45,28\n";
    }
    project.write("trees.csv", trees);
}

std::vector<std::string> texts_between(const std::string& page, const std::string& before,
                                       const std::string& after) {
    std::vector<std::string> found;
    for (std::size_t at = page.find(before); at != std::string::npos; at = page.find(before, at)) {
        at += before.size();
        found.push_back(page.substr(at, page.find(after, at) - at));
    }
    return found;
}

long level_number(const std::string& name) {
    return std::find(hazard::level_names.begin(), hazard::level_names.end(), name) -
           hazard::level_names.begin();
}

/// Cards from the highest level down; of equal levels the road first, then what is hit most often. The road
/// has a row in the table, and so have targets whose level the forest changes until it has fifteen rows.
TEST(HazardPage, RanksByLevelThenRoadsThenHowOften) {
    const SampleProject project;
    add_blocks(project);
    add_houses(project);
    std::size_t changed = 0;
    for (const std::string rule : {"release", "cadanav"}) {
        const Outcome outcome = call(project, std::string{quick_hazard} +
                                                  "--set targets.file=houses.csv --set hazard.rule=" + rule +
                                                  " --out out_" + rule);
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        const config::Table targets = table(project, "out_" + rule + "/hazard/tables/hazard_targets.csv");
        const std::string page = project.read("out_" + rule + "/hazard/report.html");
        const auto row_named = [&](const std::string& name) {
            for (std::size_t row = 0; row < targets.rows(); ++row) {
                if (targets.text(row, "name") == name && targets.text(row, "cover") == "forest") {
                    return row;
                }
            }
            ADD_FAILURE() << name;
            return std::size_t{0};
        };
        std::vector<std::tuple<long, bool, double>> ranks;
        for (const std::string& name : texts_between(page, "<h3>", "</h3>")) {
            if (name != "The road" && !name.starts_with("House ")) {
                continue;
            }
            const std::size_t row = row_named(name);
            const std::string every = targets.text(row, "hit_every_years");
            ranks.emplace_back(level_number(targets.text(row, "level")), name == "The road",
                               every.empty() ? 0.0 : 1.0 / std::stod(every));
        }
        ASSERT_EQ(ranks.size(), 4U);
        EXPECT_TRUE(std::is_sorted(ranks.rbegin(), ranks.rend())) << rule;
        const std::size_t begin = page.find("Targets by level and how often they are hit");
        const std::string rows = page.substr(begin, page.find("</table>", begin) - begin);
        std::size_t listed = 0;
        for (std::size_t row = 0; row < targets.rows(); ++row) {
            const bool is_first_of_name = targets.text(row, "cover") == "forest";
            listed +=
                is_first_of_name && rows.find(">" + targets.text(row, "name") + "<") != std::string::npos
                    ? 1U
                    : 0U;
        }
        constexpr std::size_t full = 15;
        const bool is_full = listed >= full;
        for (std::size_t row = 0; row < targets.rows(); ++row) {
            const std::string change = targets.text(row, "forest_changes_level");
            const bool differs = change == "lower" || change == "higher";
            const bool stands = rows.find(">" + targets.text(row, "name") + "<") != std::string::npos;
            const bool is_road = targets.text(row, "target_id") == "road";
            // Those that the forest changes stand until the table is full.
            EXPECT_TRUE(stands || !(is_road || (differs && !is_full))) << rule << targets.text(row, "name");
            changed += differs && stands ? 1 : 0;
        }
    }
    EXPECT_GT(changed, 2U);
}

/// By `release` a level that rocks give which come more seldom than once in 300 years says so beside it, and
/// no other level does.
TEST(HazardPage, SaysHowSeldomRocksComeThatGiveALevelOfTheRelease) {
    const SampleProject project;
    add_blocks(project);
    add_houses(project);
    project.write("blocks.csv", "return_period_years,zone,diameter_m\n30,1,0.3\n300,1,1.2\n");
    std::size_t rare = 0;
    for (const std::string rule : {"release", "cadanav"}) {
        ASSERT_EQ(call(project,
                       "run scenario.ini --quiet --set release.rocks=300 --set "
                       "targets.file=houses.csv --set hazard.rule=" +
                           rule + " --out out_" + rule)
                      .code,
                  0);
        const config::Table targets = table(project, "out_" + rule + "/hazard/tables/hazard_targets.csv");
        const std::string page = project.read("out_" + rule + "/hazard/report.html");
        for (std::size_t row = 0; row < targets.rows(); ++row) {
            const std::size_t card = page.find("<h3>" + targets.text(row, "name") + "</h3>");
            if (card == std::string::npos) {
                continue;
            }
            const std::string words = page.substr(card, page.find("</section>", card) - card);
            const std::string slope = targets.text(row, "cover") == "bare" ? "Bare slope" : "With forest";
            const std::size_t at = words.find("<b>" + slope + ":</b>");
            const std::string answer = words.substr(at, words.find("</p>", at) - at);
            const bool is_rare = rule == "release" && level_number(targets.text(row, "level")) > 1 &&
                                 number(targets, row, "hit_every_years") > 300.0;
            EXPECT_EQ(answer.find("although they hit it only once in") != std::string::npos, is_rare)
                << rule << answer;
            rare += is_rare ? 1 : 0;
        }
    }
    EXPECT_GT(rare, 0U);
}

/// Of each rule the map stands before what the page says of other rules.
TEST(HazardPage, ShowsTheMapBehindItsAnswer) {
    const SampleProject project;
    add_blocks(project);
    ASSERT_EQ(call(project, std::string{quick_hazard} + "--out out").code, 0);
    const std::string page = project.read("out/hazard/report.html");
    const std::size_t answer = page.find(" of 2 targets; map: ");
    const std::size_t map = page.find("<figure");
    const std::size_t other = page.find("By the rule cadanav, for comparison");
    ASSERT_NE(other, std::string::npos);
    EXPECT_LT(answer, map);
    EXPECT_LT(map, other);
    EXPECT_NE(page.find("What counts here is the return period of the release"), std::string::npos);
}

/// A net of 100 kJ that large rocks break: the page names it and leads to the return period.
TEST(HazardPage, NamesNetsThatRocksBreak) {
    const SampleProject project;
    add_blocks(project);
    project.write("nets.csv",
                  "name,wkt,height_m,capacity_kj\nweak,\"LINESTRING (1070 2010, 1070 2090)\",5,10\n"
                  "strong,\"LINESTRING (1080 2010, 1080 2090)\",5,5000\n");
    ASSERT_EQ(call(project, std::string{quick_hazard} + "--set nets.file=nets.csv --out out").code, 0);
    const std::string page = project.read("out/hazard/report.html");
    const std::size_t at = page.find("Nets that rocks break: weak: ");
    ASSERT_NE(at, std::string::npos);
    const std::string words = page.substr(at, page.find("</p>", at) - at);
    EXPECT_EQ(words.find("strong"), std::string::npos) << words;
    EXPECT_NE(words.find("href=\"../return_period_"), std::string::npos) << words;
    EXPECT_EQ(page.find("that no rock reaches"), std::string::npos);
}

TEST(HazardPage, NamesNetsThatNoRockReaches) {
    const SampleProject project;
    add_blocks(project);
    project.write("nets.csv",
                  "name,wkt,height_m,capacity_kj\nabove,\"LINESTRING (1010 2010, 1010 2090)\",5,500\n"
                  "below,\"LINESTRING (1080 2010, 1080 2090)\",5,500\n");
    ASSERT_EQ(call(project, std::string{quick_hazard} + "--set nets.file=nets.csv --out out").code, 0);
    EXPECT_NE(project.read("out/hazard/report.html").find("Nets and works that no rock reaches: above."),
              std::string::npos);
}

/// Levels by so few rocks that other random numbers may show none are counted apart, in the first sentence
/// and in the tables, and the more rocks fall, the fewer are left of a target that is hit often.
TEST(HazardPage, SetsLevelsOfFewRocksApart) {
    const SampleProject project;
    add_blocks(project);
    const auto levels_with = [&](const std::string& rocks) {
        const std::string out = "out" + rocks;
        EXPECT_EQ(
            call(project, "run scenario.ini --quiet --set release.rocks=" + rocks + " --out " + out).code, 0);
        std::istringstream in{project.read(out + "/hazard/tables/hazard_targets.csv")};
        return config::Table::read(in, "hazard_targets.csv");
    };
    const config::Table few = levels_with("4");
    std::size_t of_few = 0;
    for (std::size_t row = 0; row < few.rows(); ++row) {
        const double rocks = std::stod(few.text(row, "level_rocks"));
        EXPECT_LE(rocks, 4.0);
        of_few += rocks > 0.0 ? 1 : 0;
        EXPECT_TRUE(few.text(row, "forest_changes_level") != "lower" &&
                    few.text(row, "forest_changes_level") != "higher");
    }
    ASSERT_GT(of_few, 0U);
    EXPECT_NE(project.read("out4/hazard/report.html").find(" by fewer than 5 rocks)"), std::string::npos);
    const config::Table many = levels_with("4000");
    const std::size_t road = row_of(many, "road", "bare");
    EXPECT_GE(std::stod(many.text(road, "level_rocks")), 5.0);
}

/// Targets that no rock hits have no rows of dashes, and each is named once.
TEST(HazardPage, NamesTargetsWithoutHitsInOneLine) {
    const SampleProject project;
    add_blocks(project);
    std::string houses = project.read("targets.csv");
    for (const char* name : {"upper", "ridge", "cabin"}) {
        const std::string y = std::to_string(2010 + 10 * (name[0] % 7));
        houses += std::string{name} + "," + name + ",\"POLYGON ((1006 " + y + ", 1010 " + y +
                  ", 1010 2092, 1006 " + "2092, 1006 " + y + "))\"\n";
    }
    project.write("targets.csv", houses);
    ASSERT_EQ(call(project, std::string{quick_hazard} + "--out out").code, 0);
    const config::Table targets = table(project, "out/hazard/tables/hazard_targets.csv");
    const std::string page = project.read("out/hazard/report.html");
    const std::size_t at = page.find("No rock hits these targets");
    ASSERT_NE(at, std::string::npos);
    const std::string words = page.substr(at, page.find("</p>", at) - at);
    const std::string levels =
        page.substr(page.find("<h2>Targets by level"), at - page.find("<h2>Targets by level"));
    for (const char* name : {"upper", "ridge", "cabin"}) {
        EXPECT_NE(words.find(name), std::string::npos) << words;
        EXPECT_EQ(levels.find(std::string{">"} + name + "<"), std::string::npos) << name;
    }
    for (const char* name : {"road", "house"}) {
        EXPECT_EQ(words.find(name), std::string::npos) << words;
        EXPECT_NE(levels.find(std::string{">"} + name + "<"), std::string::npos) << name;
    }
    EXPECT_EQ(targets.rows(), 10U) << "the table has all of them, on both slopes";
}

}  // namespace
}  // namespace coupling::hazard_page_test
