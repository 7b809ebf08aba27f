#include "coupling/assessments/models/figures/ranges.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "rockfall/motion/models.hpp"

namespace coupling::models::ranges_test {
namespace {

Figure figure(double value, Interval of_rocks = {Figure::unknown, Figure::unknown},
              Interval of_all = {Figure::unknown, Figure::unknown}) {
    return {value, of_rocks, of_all};
}

const std::vector<std::string> all_names = [] {
    std::vector<std::string> names;
    for (const rockfall::MotionModel model : rockfall::all_models()) {
        names.emplace_back(rockfall::description_of(model).name);
    }
    return names;
}();

TEST(RangeOver, NeedsTwoModelsThatKnowTheFigure) {
    EXPECT_FALSE(range_over({{}, {figure(1.0), figure(Figure::unknown)}}));
    EXPECT_FALSE(range_over({{}, {}}));
    EXPECT_TRUE(range_over({{}, {figure(1.0), figure(Figure::unknown), figure(2.0)}}));
}

TEST(RangeOver, NamesTheModelsAndTheFactor) {
    const auto range = range_over({{}, {figure(20.0), figure(Figure::unknown), figure(4.0), figure(8.0)}});
    ASSERT_TRUE(range);
    EXPECT_EQ(range->lowest, 2U);
    EXPECT_EQ(range->highest, 0U);
    EXPECT_DOUBLE_EQ(range->factor.value(), 5.0);
    EXPECT_EQ(range->agreement, Agreement::not_known);
    EXPECT_FALSE(range_over({{}, {figure(0.0), figure(3.0)}})->factor);
    const auto of_equals = range_over({{}, {figure(2.0), figure(2.0)}});
    EXPECT_NE(of_equals->lowest, of_equals->highest);
}

TEST(RangeOver, HoldsIntervalsOfOneKindAgainstEachOther) {
    // The second model has no interval of all: those of the rocks count, and these do not meet.
    const auto by_rocks = range_over({{}, {figure(1.0, {0.5, 1.5}, {0.1, 9.0}), figure(4.0, {3.0, 5.0})}});
    EXPECT_EQ(by_rocks->intervals, Intervals::of_rocks);
    EXPECT_EQ(by_rocks->agreement, Agreement::disagree);
    const auto by_all =
        range_over({{}, {figure(1.0, {0.5, 1.5}, {0.1, 9.0}), figure(4.0, {3.0, 5.0}, {2.0, 6.0})}});
    EXPECT_EQ(by_all->intervals, Intervals::of_all);
    EXPECT_EQ(by_all->agreement, Agreement::agree);
    // A model whose interval is open says nothing, whatever the others say.
    const auto open = range_over({{}, {figure(1.0, {0.5, 1.5}), figure(4.0, {3.0, Figure::unknown})}});
    EXPECT_EQ(open->agreement, Agreement::not_known);
    EXPECT_EQ(open->intervals, Intervals::none);
}

RC_GTEST_PROP(RangeOver, DisagreesExactlyWhereTwoIntervalsAreApart, ()) {
    const auto places = *rc::gen::nonEmpty<std::vector<std::pair<int, int>>>();
    ModelFigure of;
    for (const auto& [place, width] : places) {
        const double value = place % 1000;
        const double half = std::abs(width % 500);
        of.by_model.push_back(figure(value, {value - half, value + half}));
    }
    const auto range = range_over(of);
    RC_ASSERT(range.has_value() == (places.size() > 1));
    if (!range) {
        return;
    }
    bool apart = false;
    for (const Figure& a : of.by_model) {
        for (const Figure& b : of.by_model) {
            apart = apart || a.of_rocks.high < b.of_rocks.low;
        }
        RC_ASSERT(range->low <= a.value);
        RC_ASSERT(range->high >= a.value);
    }
    RC_ASSERT((range->agreement == Agreement::disagree) == apart);
    RC_ASSERT(of.by_model[range->lowest].value == range->low);
    RC_ASSERT(of.by_model[range->highest].value == range->high);
    // The order of the models changes who is named, not what is said.
    std::reverse(of.by_model.begin(), of.by_model.end());
    const auto reversed = range_over(of);
    RC_ASSERT(reversed->low == range->low);
    RC_ASSERT(reversed->high == range->high);
    RC_ASSERT(reversed->agreement == range->agreement);
}

TEST(FieldVerdictsOfModels, NameBestWhoMeetsTheLargestShare) {
    const FieldVerdicts verdicts{all_names};
    std::size_t judged = 0;
    for (const std::string_view quantity : judged_quantities) {
        const std::vector<std::size_t> best = verdicts.best_on(quantity);
        for (std::size_t model = 0; model < all_names.size(); ++model) {
            const QuantityVerdict& one = verdicts.of(model, quantity);
            const bool is_best = std::find(best.begin(), best.end(), model) != best.end();
            if (one.independent() == 0) {
                EXPECT_FALSE(is_best) << all_names[model] << ' ' << quantity;
                continue;
            }
            ++judged;
            if (best.empty()) {
                EXPECT_LT(2 * one.independent_met, one.independent()) << all_names[model] << ' ' << quantity;
                continue;
            }
            const QuantityVerdict& first = verdicts.of(best.front(), quantity);
            const double share =
                static_cast<double>(one.independent_met) / static_cast<double>(one.independent());
            const double largest =
                static_cast<double>(first.independent_met) / static_cast<double>(first.independent());
            EXPECT_TRUE(is_best ? share == largest : share <= largest) << all_names[model] << ' ' << quantity;
        }
    }
    EXPECT_GT(judged, 4U);
    EXPECT_THROW(static_cast<void>(verdicts.of(0, "colour")), std::logic_error);
}

TEST(JudgedQuantity, IsOneOfTheTableOrNone) {
    EXPECT_EQ(judged_quantity({.quantity = "energy_kj"}), "energy");
    EXPECT_EQ(judged_quantity({.quantity = "design_height_m"}), "height");
    EXPECT_EQ(judged_quantity({.quantity = "run_out_m"}), "stops");
    EXPECT_EQ(judged_quantity({.quantity = "protection_percent"}), "");
    EXPECT_EQ(judged_quantity({.quantity = "held_percent"}), "");
}

}  // namespace
}  // namespace coupling::models::ranges_test
