#include "forest/deaths/vigour.hpp"

#include <gtest/gtest.h>

namespace forest::vigour_test {
namespace {

const SpeciesTable table = SpeciesTable::shipped();
const Vigour law{.half = 0.6, .power = 4.0};

TEST(Vigour, IsWholeInASeedlingAndHalfWhereItsSpeciesSaysSo) {
    EXPECT_DOUBLE_EQ(vigour(law, 0.0, 0.0), 1.0);
    // Height and life spent alike: x is that share.
    EXPECT_NEAR(vigour(law, 0.6, 0.6), 0.5, 1e-12);
    EXPECT_NEAR(vigour(law, 0.3, 0.3), 1.0 / (1.0 + 0.0625), 1e-12);
}

TEST(Vigour, IsLostWithHeightAtAnyAgeAndWithAgeAtAnyHeight) {
    for (double share = 0.1; share < 1.0; share += 0.1) {
        EXPECT_LT(vigour(law, share, 0.2), vigour(law, share - 0.1, 0.2)) << share;
        EXPECT_LT(vigour(law, 0.2, share), vigour(law, 0.2, share - 0.1)) << share;
        EXPECT_DOUBLE_EQ(vigour(law, share, 0.2), vigour(law, 0.2, share)) << "both count alike";
    }
}

TEST(Vigour, IsNearlyGoneAtTheTopAndBeyondIt) {
    EXPECT_LT(vigour(law, 1.0, 0.1), 0.15);
    EXPECT_DOUBLE_EQ(vigour(law, 1.7, 0.1), vigour(law, 1.0, 0.1));
    EXPECT_GT(vigour(law, 5.0, 5.0), 0.0);
}

TEST(Vigour, OfSpruceFallsBeforeThatOfFirAndBeech) {
    for (const char* shade : {"abal", "fasy"}) {
        EXPECT_LT(vigour(table[*table.find("piab")].vigour, 0.7, 0.4),
                  vigour(table[*table.find(shade)].vigour, 0.7, 0.4));
    }
}

}  // namespace
}  // namespace forest::vigour_test
