#include "coupling/inputs/forest/botanical_name.hpp"

#include <gtest/gtest.h>

namespace coupling::botanical_name_test {
namespace {

using Names = std::vector<std::string>;

TEST(BotanicalReadings, AreTheSpeciesWithoutAuthorsAndCultivars) {
    EXPECT_EQ(botanical_readings("Picea abies (L.) H.Karst."), Names{"Picea abies"});
    EXPECT_EQ(botanical_readings("Fagus sylvatica 'Atropunicea'"), Names{"Fagus sylvatica"});
    EXPECT_EQ(botanical_readings("Ulmus 'Lobel'"), Names{"Ulmus"});
    EXPECT_EQ(botanical_readings("ACER CAMPESTRE L."), Names{"ACER CAMPESTRE"});
}

TEST(BotanicalReadings, BeginWithTheNarrowerName) {
    EXPECT_EQ(botanical_readings("Pinus mugo subsp. uncinata (Ramond) Domin"),
              (Names{"Pinus uncinata", "Pinus mugo"}));
}

TEST(BotanicalReadings, AreTheGenusOnlyWhereNothingNarrowsIt) {
    EXPECT_EQ(botanical_readings("Quercus sp."), Names{"Quercus"});
    EXPECT_EQ(botanical_readings("Quercus L."), Names{"Quercus"});
    EXPECT_EQ(botanical_readings("Quercus Frainetto"), Names{});
    EXPECT_EQ(botanical_readings("Tilia x europaea"), Names{});
    EXPECT_EQ(botanical_readings("Tilia \u00d7 europaea"), Names{});
    EXPECT_EQ(botanical_readings(""), Names{});
    EXPECT_EQ(botanical_readings("12 b"), Names{});
}

TEST(WithoutOpenWords, KeepsNamesOfAnyLanguage) {
    EXPECT_EQ(without_open_words("L\u00e4rche spp."), "L\u00e4rche");
    EXPECT_EQ(without_open_words("sp."), "sp.");
}

}  // namespace
}  // namespace coupling::botanical_name_test
