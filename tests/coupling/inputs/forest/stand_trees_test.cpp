#include "coupling/inputs/forest/stand_trees.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "coupling/inputs/forest/obstacle_size.hpp"
#include "tests/coupling/inputs/forest_project.hpp"

namespace coupling::stand_trees_test {
namespace {

const std::vector<std::string> today{"trees.file=", "stands.records=records.csv", "run.years=0"};

bool says(const Opened& opened, const std::string& part) {
    return std::any_of(opened.warnings.begin(), opened.warnings.end(),
                       [&](const std::string& sentence) { return sentence.find(part) != std::string::npos; });
}

TEST(TreesOfStands, AreThoseWithWhichARunOverYearsBegins) {
    const ForestProject project;
    const Opened standing = open(project, today);
    ASSERT_TRUE(standing.site) << standing.errors;
    const Opened growing = open(project, {today[0], today[1]});
    ASSERT_TRUE(growing.site) << growing.errors;
    const ForestSite& forest = *growing.site->forest;
    const forest::Stand start = forest.start(growing.scenario->run.seed, 0);
    std::vector<const forest::Tree*> begun;
    for (const forest::Tree& tree : start.trees()) {
        const rockfall::Terrain& terrain = growing.site->slope.terrain;
        const Eigen::Vector2d at_m = Eigen::Vector2d{tree.x_m, tree.y_m} - terrain.origin_m();
        if (tree.dbh_cm >= least_obstacle_cm && terrain.locate(at_m.x(), at_m.y())) {
            begun.push_back(&tree);
        }
    }
    std::map<std::pair<double, double>, const TreeRecord*> at;
    for (const TreeRecord& tree : standing.site->trees) {
        at.emplace(std::pair{tree.stem.x_m, tree.stem.y_m}, &tree);
    }
    ASSERT_EQ(at.size(), begun.size());
    ASSERT_GT(begun.size(), 100U);
    for (const forest::Tree* tree : begun) {
        const auto same = at.find({tree->x_m, tree->y_m});
        ASSERT_NE(same, at.end());
        EXPECT_EQ(same->second->stem.dbh_cm, tree->dbh_cm);
        EXPECT_EQ(same->second->species, forest.species.table[tree->species].code);
        if (same->second->species == "PIAB") {  // the only record with a height
            EXPECT_EQ(same->second->stem.height_m, tree->height_m);
        }
    }
}

TEST(TreesOfStands, AreSaidToBeDerived) {
    const ForestProject project;
    const Opened opened = open(project, today);
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_TRUE(says(opened, "derived from stand records"));
    EXPECT_TRUE(says(opened, "records.csv: 2 stand records without heights"));
    EXPECT_TRUE(says(opened, "settings of [forest], [soil], [climate] have no effect: run.years is 0"));
}

TEST(TreesOfStands, ComeAfterAListOfTrees) {
    const ForestProject project;
    const Opened opened = open(project, {"stands.records=records.csv", "run.years=0"});
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_TRUE(says(opened, "[stands]"));
    EXPECT_FALSE(says(opened, "derived from stand records"));
}

TEST(TreesOfStands, MoveWithTheSeed) {
    const ForestProject project;
    std::vector<std::string> other = today;
    other.emplace_back("run.seed=77");
    const Opened one = open(project, today);
    const Opened two = open(project, other);
    ASSERT_TRUE(one.site && two.site) << one.errors << two.errors;
    EXPECT_NE(one.site->trees.front().stem.x_m, two.site->trees.front().stem.x_m);
}

TEST(TreesOfStands, ReportWhatIsWrongInTheirFiles) {
    ForestProject project;
    project.write("records.csv", "stand,species,stems_pha,mean_dbh_cm\n7,PIAB,600,25\n9,PIAB,600,25\n");
    const Opened opened = open(project, today);
    EXPECT_FALSE(opened.site);
    EXPECT_NE(opened.errors.find("records.csv"), std::string::npos) << opened.errors;
}

}  // namespace
}  // namespace coupling::stand_trees_test
