#include "coupling/program/actions/ground_proposals.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "config/data/shipped_tables.hpp"
#include "coupling/inputs/ground/surface_types.hpp"

namespace coupling::ground_proposals_test {
namespace {

TEST(GroundProposals, KnowWordsOfTheLanguagesOfTheAlps) {
    const GroundProposals proposals;
    EXPECT_EQ(proposals.of("Fels, anstehend"), "solid_rock");
    EXPECT_EQ(proposals.of("Wiese"), "pasture");
    EXPECT_EQ(proposals.of("WALDBODEN tief"), "forest_soil");
    EXPECT_EQ(proposals.of("Forêt"), "forest_soil");
    EXPECT_EQ(proposals.of("Éboulis"), "fine_debris");
    EXPECT_EQ(proposals.of("pascolo"), "pasture");
    EXPECT_EQ(proposals.of("Straße"), "road");
    EXPECT_EQ(proposals.of("Typ 7"), "");
}

TEST(GroundProposals, TakeTheLongestWord) {
    const GroundProposals proposals;
    EXPECT_EQ(proposals.of("Blockschutt"), "coarse_debris");
    EXPECT_EQ(proposals.of("nasse Wiese"), "pasture");
}

TEST(GroundProposals, AreShippedTypesByDifferentPlainWords) {
    const config::Table words = config::read_shipped_table("ground_words.csv");
    std::vector<std::string> seen;
    const auto shipped = shipped_surfaces();
    for (std::size_t row = 0; row < words.rows(); ++row) {
        const std::string& word = words.text(row, "word");
        EXPECT_EQ(std::count(seen.begin(), seen.end(), word), 0) << word;
        seen.push_back(word);
        EXPECT_TRUE(std::any_of(shipped.begin(), shipped.end(), [&](const ShippedSurface& surface) {
            return surface.name == words.text(row, "surface");
        })) << word;
        EXPECT_TRUE(std::all_of(word.begin(), word.end(), [](char c) {
            return (c >= 'a' && c <= 'z') || c == ' ';
        })) << word;
    }
}

}  // namespace
}  // namespace coupling::ground_proposals_test
