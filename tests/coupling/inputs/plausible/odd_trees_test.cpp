#include "coupling/inputs/plausible/odd_trees.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace coupling::plausible::odd_trees_test {
namespace {

OddTrees found_in(const std::string& text) {
    std::istringstream in{text};
    return odd_trees(config::Table::read(in, "trees.csv"));
}

TEST(OddTrees, LetRealTreesPass) {
    // A stand, a silver fir of the thickest, a tree that grew in the open, a slender pole, a stump.
    const OddTrees found = found_in(
        "dbh_cm,height_m,state\n37.6,23.6,\n15.7,13.9,living\n199,55,\n90,18,\n12,17,\n80,0.5,stump\n");
    EXPECT_TRUE(found.lines.empty());
    EXPECT_FALSE(found.columns_look_swapped);
}

TEST(OddTrees, AreThoseWithADigitTooMany) {
    EXPECT_EQ(found_in("dbh_cm,height_m\n376,23.6\n15.7,13.9\n157,13.9\n").lines,
              (std::vector<std::size_t>{2, 4}));
    EXPECT_EQ(found_in("dbh_cm\n37.6\n342\n").lines, std::vector<std::size_t>{3}) << "without heights";
    EXPECT_TRUE(found_in("dbh_cm,height_m\n5,0.7\nthick,3\n,\n").lines.empty()) << "saplings, no numbers";
}

TEST(OddTrees, ShowThatColumnsAreSwapped) {
    const std::string trees = "\n38,24\n30,22\n45,29\n52,31\n28,23\n61,33\n";
    EXPECT_FALSE(found_in("dbh_cm,height_m" + trees).columns_look_swapped);
    EXPECT_TRUE(found_in("height_m,dbh_cm" + trees).columns_look_swapped);
}

TEST(OddTrees, AreThoseWithSwappedFieldsAmongOthers) {
    // Each third row exchanged: the list as a whole looks like a stand.
    const std::string trees = "\n38,24\n22,32\n45,29\n52,31\n14,28\n61,33\n40,26\n";
    const OddTrees found = found_in("dbh_cm,height_m" + trees);
    EXPECT_FALSE(found.columns_look_swapped);
    EXPECT_EQ(found.slender_lines, std::vector<std::size_t>{6}) << "28 m high and 14 cm thick";
    EXPECT_TRUE(found_in("dbh_cm,height_m\n12,17.5\n8,14\n").slender_lines.empty()) << "poles";
}

TEST(OddTrees, AreThoseAsThinAsAThread) {
    // Each third DBH in metres: the median looks like a stand.
    const OddTrees found =
        found_in("dbh_cm,height_m,state\n38,24,\n0.22,18,\n45,29,\n0.5,15,\n61,33,\n0.3,14,snag\n");
    EXPECT_EQ(found.impossible_lines, (std::vector<std::size_t>{3, 5}));
    EXPECT_TRUE(found_in("dbh_cm,height_m\n0.1,1.4\n0.4,2.2\n2,5.5\n").impossible_lines.empty())
        << "young trees";
}

TEST(OddTrees, ShowThatDiametersAreGirths) {
    std::string stand = "dbh_cm,height_m\n";
    std::string girths = stand;
    std::string without_heights = "dbh_cm\n";
    for (int i = 0; i < 20; ++i) {
        stand += std::to_string(25 + i) + "," + std::to_string(20 + 0.5 * i) + "\n";
        girths += std::to_string(3.14159 * (25 + i)) + "," + std::to_string(20 + 0.5 * i) + "\n";
        without_heights += std::to_string(3.14159 * (25 + i)) + "\n";
    }
    EXPECT_EQ(found_in(stand).girth_slenderness, 0.0);
    EXPECT_NEAR(found_in(girths).girth_slenderness, 72.0 / 3.14159, 2.0);
    EXPECT_EQ(found_in(stand).girth_median_cm, 0.0);
    EXPECT_NEAR(found_in(without_heights).girth_median_cm, 3.14159 * 35.0, 1.0);
}

TEST(OddMeanTrees, AreThoseOfSwappedColumns) {
    const auto found = [](const std::string& text) {
        std::istringstream in{text};
        return odd_mean_trees(config::Table::read(in, "records.csv"));
    };
    // A dense pole stand, an old stand, a thicket, records without a height or a diameter.
    const std::string stands = "\n13,14\n52,33\n30,25\n22.9,18.6\n4,6\n30,\n,20\n";
    EXPECT_TRUE(found("mean_dbh_cm,mean_height_m" + stands).empty());
    EXPECT_EQ(found("mean_height_m,mean_dbh_cm" + stands), (std::vector<std::size_t>{3, 4, 5}));
    EXPECT_EQ(found("mean_dbh_cm,mean_height_m\n229,18.6\n22.9,1.86\n"), (std::vector<std::size_t>{2, 3}));
    EXPECT_TRUE(found("stems_pha,mean_dbh_cm\n500,30\n").empty());
}

}  // namespace
}  // namespace coupling::plausible::odd_trees_test
