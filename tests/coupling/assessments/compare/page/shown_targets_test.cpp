#include "coupling/assessments/compare/page/shown_targets.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace coupling::compare::shown_targets_test {
namespace {

Line reached(const std::string& target, const std::vector<double>& percent_by_run) {
    Line line{{target, "", "reached_percent", "today"}, {}, {}};
    for (const double percent : percent_by_run) {
        Figure figure;
        figure.value = percent;
        line.figures.emplace_back(figure);
    }
    return line;
}

/// At most ten have charts and four stand on paper, and no target without is reached by more rocks than one
/// with.
RC_GTEST_PROP(ShownTargets, AreThoseThatMostRocksReach, ()) {
    const auto percents = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 100));
    SideBySide comparison;
    for (std::size_t i = 0; i < percents.size(); ++i) {
        const double percent = percents[i];
        comparison.lines.push_back(
            reached(std::to_string(i), i % 2 == 0 ? std::vector{0.0, percent} : std::vector{percent, 0.0}));
    }
    const ShownTargets shown = shown_targets({}, comparison);
    const std::size_t all = percents.size();
    RC_ASSERT(shown.all == all);
    RC_ASSERT(shown.charted() == std::min<std::size_t>(all, 10));
    RC_ASSERT(shown.not_printed.size() == (all > 10 ? all - 4 : 0));
    for (std::size_t a = 0; a < all; ++a) {
        RC_ASSERT(shown.charts(std::to_string(a)) || !shown.prints(std::to_string(a)));
        for (std::size_t b = 0; b < all; ++b) {
            RC_ASSERT(!shown.charts(std::to_string(a)) || shown.charts(std::to_string(b)) ||
                      percents[a] >= percents[b]);
        }
    }
}

/// A net has no rocks that reach it in the sense of a target; it is what a comparison is about.
TEST(ShownTargets, LeaveNetsAsTheyAre) {
    SideBySide comparison;
    for (int i = 0; i < 30; ++i) {
        comparison.lines.push_back(reached("house " + std::to_string(i), {1.0 * i, 2.0}));
    }
    comparison.lines.push_back({{"net", "", "held_percent", "today"}, {}, {}});
    const ShownTargets shown = shown_targets({}, comparison);
    EXPECT_TRUE(shown.charts("net") && shown.prints("net"));
    EXPECT_FALSE(shown.charts("house 0"));
    EXPECT_TRUE(shown.prints("house 29"));
}

}  // namespace
}  // namespace coupling::compare::shown_targets_test
