#include "coupling/assessments/nets/siting/ranking.hpp"

#include <gtest/gtest.h>

namespace coupling::siting::ranking_test {
namespace {

Judged candidate(double distance_m, const char* energy_class, double capacity_kj, double height_m,
                 double length_m, std::uint64_t kept, double left_kj) {
    Judged judged;
    judged.distance_m = distance_m;
    constexpr double highest_on_offer_m = 10.0;
    const auto sold_m = height_m <= highest_on_offer_m ? std::optional{height_m} : std::nullopt;
    judged.net = NetDesign{{energy_class, capacity_kj, sold_m, height_m}, 0.0, length_m};
    judged.left.kept = share_of(kept, 100);
    judged.left.energy_kj = left_kj;
    return judged;
}

TEST(Rank, NamesThoseThatAreAsGood) {
    const std::vector<Judged> candidates{
        candidate(10.0, "1", 250.0, 3.0, 50.0, 96, 40.0), candidate(20.0, "1", 250.0, 3.0, 48.0, 97, 60.0),
        candidate(30.0, "2", 500.0, 2.0, 40.0, 99, 10.0), candidate(40.0, "1", 250.0, 4.0, 50.0, 96, 40.0)};
    const Ranking ranking = rank(candidates, 0.95);
    EXPECT_EQ(ranking.best, 1U);  // the weakest class, then the least area
    EXPECT_EQ(ranking.ties, (std::vector<bool>{true, false, false, false}));
}

TEST(Rank, PrefersTheWantedShareAndHeightsOnOffer) {
    const std::vector<Judged> candidates{candidate(10.0, "0", 100.0, 1.0, 10.0, 60, 500.0),
                                         candidate(20.0, "0", 100.0, 12.0, 10.0, 96, 50.0),
                                         candidate(30.0, "3", 1000.0, 4.0, 50.0, 95, 55.0)};
    EXPECT_EQ(rank(candidates, 0.95).best, 2U);
}

TEST(Rank, GoesByWhatIsLeftWhereNoneKeepsTheWantedShare) {
    const std::vector<Judged> candidates{candidate(10.0, "0", 100.0, 1.0, 10.0, 60, 105.0),
                                         candidate(20.0, "3", 1000.0, 4.0, 50.0, 70, 100.0),
                                         candidate(30.0, "0", 100.0, 1.0, 10.0, 50, 180.0)};
    const Ranking ranking = rank(candidates, 0.95);
    EXPECT_EQ(ranking.best, 1U);
    EXPECT_EQ(ranking.ties, (std::vector<bool>{true, false, false}));
}

TEST(Rank, HasNoBestWhereNothingIsKept) {
    std::vector<Judged> candidates{candidate(10.0, "0", 100.0, 1.0, 10.0, 0, 105.0), Judged{}};
    EXPECT_FALSE(rank(candidates, 0.95).best);
    EXPECT_FALSE(rank({}, 0.95).best);
}

}  // namespace
}  // namespace coupling::siting::ranking_test
