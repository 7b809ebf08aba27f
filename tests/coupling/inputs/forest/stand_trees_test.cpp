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

/// Crown cover in the cells of the sample project.
template <class Value>
std::string cover_of(Value value) {
    return SampleProject::header() + "NODATA_value -1\n" + SampleProject::rows(value);
}

Opened under_cover(const std::string& cover, const std::vector<std::string>& more = {}) {
    const ForestProject project;
    project.write("cover.asc", cover);
    std::vector<std::string> settings = today;
    settings.emplace_back("stands.cover=cover.asc");
    settings.insert(settings.end(), more.begin(), more.end());
    return open(project, settings);
}

/// Trees of a species that stand west of a line.
std::size_t west_of(double x_m, const Opened& opened, const std::string& species) {
    return static_cast<std::size_t>(std::count_if(
        opened.site->trees.begin(), opened.site->trees.end(),
        [&](const TreeRecord& tree) { return tree.species == species && tree.stem.x_m < x_m; }));
}

constexpr double everywhere_m = 1e9;

TEST(TreesOfStands, UnderEvenCoverAreThoseWithoutAny) {
    const ForestProject project;
    const Opened bare = open(project, today);
    const Opened covered = under_cover(cover_of([](int, int) { return "60"; }));
    ASSERT_TRUE(bare.site && covered.site) << bare.errors << covered.errors;
    ASSERT_EQ(covered.site->trees.size(), bare.site->trees.size());
    for (std::size_t i = 0; i < bare.site->trees.size(); ++i) {
        EXPECT_EQ(covered.site->trees[i].stem.x_m, bare.site->trees[i].stem.x_m);
        EXPECT_EQ(covered.site->trees[i].stem.dbh_cm, bare.site->trees[i].stem.dbh_cm);
    }
}

TEST(TreesOfStands, FollowTheCoverWithinTheirStand) {
    // Stand 7 in columns 4 to 11, rows 0 to 4: three quarters of the cover in its western half.
    const Opened opened = under_cover(cover_of([](int column, int) { return column < 8 ? "90" : "30"; }));
    const ForestProject project;
    const Opened bare = open(project, today);
    ASSERT_TRUE(opened.site && bare.site) << opened.errors << bare.errors;
    // The eastern column of patches ends half a cell inside the terrain, so that some trees are lost there.
    const auto all = static_cast<double>(west_of(everywhere_m, opened, "PIAB"));
    EXPECT_NEAR(static_cast<double>(west_of(1080.0, opened, "PIAB")) / all, 0.76, 0.06);
    EXPECT_NEAR(static_cast<double>(west_of(1080.0, bare, "PIAB")) /
                    static_cast<double>(west_of(everywhere_m, bare, "PIAB")),
                0.52, 0.06);
    EXPECT_TRUE(says(opened, "cover.asc: stems of each stand are placed by crown cover, 60 % in the mean"));
}

TEST(TreesOfStands, LeaveTheGapsOfTheCoverOpenAndKeepTheirNumber) {
    const auto in_gap = [](int column) { return column == 6 || column == 7; };
    const Opened opened =
        under_cover(cover_of([&](int column, int) { return in_gap(column) ? "0" : "1"; }), {});
    const ForestProject project;
    const Opened growing = [&] {
        project.write("cover.asc", cover_of([&](int column, int) { return in_gap(column) ? "0" : "1"; }));
        return open(project, {today[0], today[1], "stands.cover=cover.asc"});
    }();
    const Opened without = open(project, {today[0], today[1]});
    ASSERT_TRUE(opened.site && growing.site && without.site) << opened.errors << growing.errors;
    for (const TreeRecord& tree : opened.site->trees) {
        EXPECT_FALSE(tree.stem.x_m > 1060.0 && tree.stem.x_m < 1080.0) << tree.stem.x_m;
    }
    const auto stems = [](const Opened& run) { return run.site->forest->start(1, 0).trees().size(); };
    EXPECT_EQ(stems(growing), stems(without));
}

TEST(TreesOfStands, StandInGroupsUnderCoverOnly) {
    const ForestProject project;
    project.write(
        "records.csv",
        "stand,species,stems_pha,mean_dbh_cm,structure\n7,PIAB,600,25,groups\n8,FASY,400,20,groups\n");
    project.write("cover.asc", cover_of([](int column, int) { return column % 2 == 0 ? "0" : "80"; }));
    const Opened opened = open(project, {today[0], today[1], today[2], "stands.cover=cover.asc"});
    ASSERT_TRUE(opened.site) << opened.errors;
    ASSERT_GT(opened.site->trees.size(), 100U);
    for (const TreeRecord& tree : opened.site->trees) {
        EXPECT_EQ(static_cast<int>((tree.stem.x_m - 1000.0) / 10.0) % 2, 1) << tree.stem.x_m;
    }
}

TEST(TreesOfStands, NeedACoverThatCanBeMeant) {
    const auto refused = [](const Opened& opened, const std::string& part) {
        EXPECT_FALSE(opened.site);
        EXPECT_NE(opened.errors.find(part), std::string::npos) << opened.errors;
    };
    refused(under_cover(cover_of([](int column, int) { return column == 5 ? "255" : "60"; })),
            "crown cover 255 in row 1, column 6");
    refused(under_cover(cover_of([](int, int row) { return row < 5 ? "0" : "60"; })),
            "no crown cover in stand 7, which has stems");
    const ForestProject project;
    refused(open(project, {"run.years=0", "stands.cover=stands.asc"}),
            "stands.cover without stands.records or stands.dbh_classes");
    EXPECT_TRUE(says(under_cover(cover_of([](int column, int) { return column == 5 ? "-1" : "60"; })),
                     "no crown cover for 10 forest cells of 10 m"));
    EXPECT_TRUE(says(under_cover(cover_of([](int column, int) { return column == 5 ? "60" : "0"; })),
                     "2 stands with crowns on less than half of the area"));
}

}  // namespace
}  // namespace coupling::stand_trees_test
