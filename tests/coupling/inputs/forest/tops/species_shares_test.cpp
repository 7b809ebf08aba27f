#include "coupling/inputs/forest/tops/species_shares.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace coupling::species_shares_test {
namespace {

TEST(SpeciesShares, AreReadAsPeopleWriteThem) {
    const std::vector<SpeciesShare> shares = species_shares("PIAB 60 %, Fagus sylvatica 30; ABAL 10");
    ASSERT_EQ(shares.size(), 3U);
    EXPECT_EQ(shares[1].name, "Fagus sylvatica");
    EXPECT_DOUBLE_EQ(shares[0].share, 0.6);
    EXPECT_DOUBLE_EQ(shares[2].share, 0.1);
    EXPECT_DOUBLE_EQ(species_shares("PIAB 0.7, FASY 0.3")[0].share, 0.7);
    EXPECT_EQ(species_shares(" Picea abies ").front().name, "Picea abies");
}

TEST(SpeciesShares, AreRefusedWhereTheyAreNone) {
    for (const char* wrong : {"PIAB, FASY", "PIAB 60, FASY 30", "PIAB -20, FASY 120", "", " ",
                              "PIAB 0, FASY 0", "PIAB 60, FASY forty"}) {
        EXPECT_THROW((void)species_shares(wrong), std::invalid_argument) << wrong;
    }
}

RC_GTEST_PROP(SpeciesShares, ComeBackAsTheyWereWritten, ()) {
    const auto weights = *rc::gen::nonEmpty(rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 50)));
    int sum = 0;
    for (const int weight : weights) {
        sum += weight;
    }
    RC_PRE(sum > 0);
    std::string text;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        text += (i > 0 ? ", S" : "S") + std::to_string(i) + " " +
                std::to_string(100.0 * weights[i] / static_cast<double>(sum));
    }
    const std::vector<SpeciesShare> shares = species_shares(text);
    RC_ASSERT(shares.size() == weights.size());
    constexpr int steps = 10'000;
    std::map<std::string, int> drawn;
    for (int k = 0; k < steps; ++k) {
        ++drawn[species_at(shares, (k + 0.5) / steps)];
    }
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const double wanted = static_cast<double>(weights[i]) / sum;
        RC_ASSERT(std::abs(drawn["S" + std::to_string(i)] - wanted * steps) <= 2.0);
    }
}

}  // namespace
}  // namespace coupling::species_shares_test
