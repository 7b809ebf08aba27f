#include "coupling/assessments/nets/net_drawing.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "coupling/results/figures/colours.hpp"

namespace coupling::report::net_drawing_test {
namespace {

TEST(DrawnRocks, AreTheSameShareOnBothSlopes) {
    EXPECT_EQ(drawn_rocks(19'408, 19'408), most_drawn_rocks);
    EXPECT_EQ(drawn_rocks(6'734, 19'408), 520U) << "6734 * 1500 / 19408 = 520.46";
    EXPECT_EQ(drawn_rocks(700, 1'500), 700U) << "all on both";
    EXPECT_EQ(drawn_rocks(0, 19'408), 0U);
}

/// Radii of the discs of a legend, in their order.
std::vector<double> radii_of_discs(const std::string& legend) {
    std::vector<double> radii;
    for (std::size_t at = legend.find(" r=\""); at != std::string::npos; at = legend.find(" r=\"", at + 1)) {
        radii.push_back(std::stod(legend.substr(at + 4)));
    }
    return radii;
}

TEST(DevelopedViewLegend, HasALargerDiscForEachHigherClassOfEnergy) {
    std::vector<double> radii = radii_of_discs(developed_view_legend());
    ASSERT_EQ(radii.size(), energy_class_colours.size() + 1);
    radii.erase(radii.begin());  // the disc that stands for a rock that was held
    EXPECT_GT(radii.front(), 1.0);
    EXPECT_LT(radii.back(), 7.0) << "the sample is 14 high";
    for (std::size_t i = 1; i < radii.size(); ++i) {
        EXPECT_GT(radii[i], radii[i - 1]);
    }
}

RC_GTEST_PROP(DrawnRocks, DifferFromTheSameShareByHalfARockAtMost, ()) {
    const auto most = *rc::gen::inRange<std::size_t>(most_drawn_rocks + 1, 100'000);
    const auto rocks = *rc::gen::inRange<std::size_t>(0, most + 1);
    const double share = static_cast<double>(most_drawn_rocks) / static_cast<double>(most);
    const double drawn = static_cast<double>(drawn_rocks(rocks, most));
    RC_ASSERT(std::abs(drawn - share * static_cast<double>(rocks)) <= 0.5 + 1e-9);
}

RC_GTEST_PROP(EvenlySpaced, DrawsNoRockTwice, ()) {
    const std::vector<NetRow> rows(*rc::gen::inRange<std::size_t>(1, 500));
    std::vector<const NetRow*> all;
    for (const NetRow& row : rows) {
        all.push_back(&row);
    }
    const auto wanted = *rc::gen::inRange<std::size_t>(0, rows.size() + 1);
    const std::vector<const NetRow*> drawn = evenly_spaced(all, wanted);
    RC_ASSERT(drawn.size() == wanted);
    RC_ASSERT(std::set<const NetRow*>(drawn.begin(), drawn.end()).size() == wanted);
}

}  // namespace
}  // namespace coupling::report::net_drawing_test
