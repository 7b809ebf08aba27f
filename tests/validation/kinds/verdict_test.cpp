#include "validation/engine/kinds/verdict.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/validation/case_texts.hpp"

namespace coupling::validation::verdict_test {
namespace {

ValidationCase judged() {
    CaseFiles files = testing::even_slope();
    files.texts["criteria.csv"] =
        "quantity,low,high,rests_on,rule,cause\nmean_speed_mps,9,11,independent,a rule,a cause\n";
    files.texts["observed.csv"] = "quantity,value,source\nmax_speed_mean_mps,15,Table 1\n";
    files.texts["published.csv"] =
        "quantity,value,deviation,series,source\nmean_speed_mps,9.4,,10000,Table 3\n"
        "mean_speed_mps,9.6,1.5,100x100,Table 3\n";
    return read_case(files);
}

Values speeds(double mean_mps) {
    return {{"mean_speed_mps", {mean_mps, mean_mps, 0.1}}, {"max_speed_mean_mps", {14.0, {}, {}}}};
}

TEST(InReadableUnit, KeepsTheFiguresShort) {
    VerdictRow row;
    row.unit = "ppb";
    row.low = 0.0;
    row.high = 1000.0;
    row.default_value.value = 500.0;
    EXPECT_EQ(in_readable_unit(row).unit, "ppb");
    row.default_value.value = 2.5e8;
    EXPECT_EQ(in_readable_unit(row).unit, "%");
    EXPECT_DOUBLE_EQ(in_readable_unit(row).default_value.value, 25.0);
    EXPECT_DOUBLE_EQ(*in_readable_unit(row).high, 1e-4);
    row.default_value.value = 3e11;
    EXPECT_EQ(in_readable_unit(row).unit, "times");
    EXPECT_DOUBLE_EQ(in_readable_unit(row).default_value.value, 300.0);
    EXPECT_EQ(*in_readable_unit(row).high, 1e-6);
    row.unit = "g/ha";
    EXPECT_EQ(in_readable_unit(row).unit, "t/ha");
    row.unit = "kJ";
    EXPECT_EQ(in_readable_unit(row).unit, "kJ");
}

TEST(VerdictOf, CountsTheBoundsAsInside) {
    const Criterion criterion{9.0, 11.0, {}, {}, {}};
    EXPECT_EQ(verdict_of(9.0, criterion), Verdict::inside);
    EXPECT_EQ(verdict_of(11.0, criterion), Verdict::inside);
    EXPECT_EQ(verdict_of(11.001, criterion), Verdict::missed);
    EXPECT_EQ(verdict_of(std::numeric_limits<double>::quiet_NaN(), criterion), Verdict::missed);
}

TEST(VerdictRows, PutObservedPublishedAndOursSideBySide) {
    const auto rows = verdict_rows(judged(), speeds(10.0), speeds(12.0));
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[0].label, "mean speed");
    EXPECT_EQ(rows[0].published, 9.4);
    EXPECT_EQ(rows[0].published_deviation, 1.5);
    EXPECT_EQ(rows[0].strict_verdict, Verdict::inside);
    EXPECT_EQ(rows[0].default_verdict, Verdict::missed);
    EXPECT_EQ(rows[0].cause, "a cause");
    EXPECT_EQ(rows[1].observed, 15.0);
    EXPECT_EQ(rows[1].strict_verdict, Verdict::no_criterion);
}

TEST(MissesAny, LooksAtStrictAndDefault) {
    CaseResult result;
    result.rows = verdict_rows(judged(), speeds(10.0), speeds(10.0));
    EXPECT_FALSE(misses_any(result));
    result.rows = verdict_rows(judged(), speeds(8.0), speeds(10.0));
    EXPECT_TRUE(misses_any(result));
    result.rows = verdict_rows(judged(), speeds(10.0), speeds(8.0));
    EXPECT_TRUE(misses_any(result));
}

TEST(FlipsOf, CompareWithTheUnmovedSlopeOfAsFewRocks) {
    CaseResult result;
    result.rows = verdict_rows(judged(), speeds(8.0), speeds(10.0));
    result.choices = {{as_rebuilt, "", "", speeds(8.9), speeds(10.0)},
                      {"steeper", "terrain.slope_change_deg=2", "", speeds(9.5), speeds(10.5)},
                      {"gentler", "terrain.slope_change_deg=-2", "", speeds(8.0), speeds(8.5)}};
    const std::vector<Flip> flips = flips_of(result);
    ASSERT_EQ(flips.size(), 2U);
    EXPECT_EQ(flips[0].choice, "steeper");
    EXPECT_TRUE(flips[0].strict);
    EXPECT_EQ(flips[0].becomes, Verdict::inside);
    EXPECT_DOUBLE_EQ(flips[0].before, 8.9);
    EXPECT_EQ(flips[1].choice, "gentler");
    EXPECT_FALSE(flips[1].strict);
    EXPECT_EQ(flips[1].becomes, Verdict::missed);
}

}  // namespace
}  // namespace coupling::validation::verdict_test
