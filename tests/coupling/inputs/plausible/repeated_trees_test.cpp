#include "coupling/inputs/plausible/repeated_trees.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "config/table/table.hpp"

namespace coupling::plausible::repeated_trees_test {
namespace {

RepeatedTrees found_in(const std::string& text) {
    std::istringstream in{text};
    return repeated_trees(config::Table::read(in, "trees.csv"));
}

/// Trees on the slope of the sample in some censuses, each in a line of its own.
std::string censuses_of(int trees, const std::vector<std::string>& years, std::mt19937& random) {
    std::vector<std::string> lines;
    for (int tree = 0; tree < trees; ++tree) {
        for (std::size_t k = 0; k < years.size(); ++k) {
            lines.push_back(std::to_string(tree) + "," + years[k] + "," + std::to_string(1010 + tree) + "," +
                            std::to_string(2010 + tree % 70) + ",PIAB," +
                            std::to_string(20 + tree % 30 + 2 * k) + ",22\n");
        }
    }
    std::shuffle(lines.begin(), lines.end(), random);
    std::string text;
    for (const std::string& line : lines) {
        text += line;
    }
    return text;
}

TEST(RepeatedTrees, NameTheColumnOfTheCensusesInAnyOrder) {
    std::mt19937 random{2};
    for (const char* name : {"year", "Jahr", "census_no", "annee", "periodo", "w"}) {
        const RepeatedTrees found =
            found_in("tree_id," + std::string{name} + ",x_m,y_m,species,dbh_cm,height_m\n" +
                     censuses_of(40, {"1995", "2005", "2015"}, random));
        EXPECT_EQ(found.again, 80U) << name;
        EXPECT_EQ(found.census, name);
        EXPECT_EQ(found.censuses, (std::vector<std::string>{"1995", "2005", "2015"}));
    }
}

TEST(RepeatedTrees, AreNoneInAListOfOneCensus) {
    std::mt19937 random{4};
    const RepeatedTrees found =
        found_in("tree_id,year,x_m,y_m,species,dbh_cm,height_m\n" + censuses_of(40, {"2015"}, random));
    EXPECT_EQ(found.again, 0U);
    EXPECT_EQ(found.census, "");
}

TEST(RepeatedTrees, AreNoStemsOfOneTree) {
    std::string shrubs = "tree_id,stem,x_m,y_m,species,dbh_cm\n";
    for (int tree = 0; tree < 10; ++tree) {
        for (int stem = 0; stem < 2; ++stem) {
            shrubs += std::to_string(tree) + "," + std::to_string(stem) + "," + std::to_string(3 * tree) +
                      ",5,COAV," + std::to_string(8 + stem) + "\n";
        }
    }
    const RepeatedTrees found = found_in(shrubs);
    EXPECT_EQ(found.again, 10U);
    EXPECT_TRUE(found.are_stems);
    EXPECT_EQ(found.census, "");
}

TEST(RepeatedTrees, ThatAreGoneAreCounted) {
    const auto gone = [](const std::string& column, const std::string& value) {
        return found_in("x_m,y_m,species,dbh_cm," + column + "\n1,1,PIAB,20," + value + "\n2,2,PIAB,30,\n")
            .gone;
    };
    EXPECT_EQ(gone("removed", "TRUE"), 1U);
    EXPECT_EQ(gone("removed", "FALSE"), 0U);
    EXPECT_EQ(gone("Status", "dead"), 1U);
    EXPECT_EQ(gone("status", "alive"), 0U);
    EXPECT_EQ(gone("alive", "0"), 1U);
    EXPECT_EQ(gone("alive", "1"), 0U);
    EXPECT_EQ(gone("quality", "dead"), 0U);
}

}  // namespace
}  // namespace coupling::plausible::repeated_trees_test
