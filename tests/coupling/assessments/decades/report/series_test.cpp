#include "coupling/assessments/decades/report/series.hpp"

#include <gtest/gtest.h>

#include "tests/coupling/assessments/decades/report/some_years.hpp"

namespace coupling::decades::series_test {
namespace {

TEST(ViewOf, FindsRowsByYearWhateverTheOrderOfMembers) {
    SomeYears some;
    some.regimes = {"none", "thinning"};
    some.add_member(1, 1, {4.0, 5.0});
    some.add_member(1, 0, {2.0, 3.0});
    some.add_member(0, 0, {1.0, 9.0});
    const Names names{some.regimes, some.interventions(), some.species};
    const RunView run = view_of(names, some.members, some.grid.area_ha());
    ASSERT_EQ(run.regimes.size(), 2U);
    EXPECT_EQ(run.years, 1U);
    EXPECT_EQ(run.replicates(), 2U);
    EXPECT_EQ(run.species, std::vector<std::size_t>{0});
    EXPECT_EQ(run.regimes[1].title(), "B: thinning");
    EXPECT_EQ(run.regimes[1].replicates[0][1].volumes_m3pha[0], 3.0);
    EXPECT_EQ(run.regimes[1].replicates[1][0].stand->volume_m3pha, 4.0);
    const YearFigure volume = [](const YearView& year) { return year.stand->volume_m3pha; };
    EXPECT_EQ(run.regimes[1].band(1, volume).mean, 4.0);
    EXPECT_EQ(run.regimes[1].mean_band(0, 1, volume).mean, 3.5);
}

TEST(ViewOf, TellsClimatesOfARegimeApart) {
    SomeYears some;
    some.regimes = {"none", "thinning"};
    some.add_member(1, 0, {4.0, 5.0});
    some.members.back().member.climate = 1;
    some.add_member(1, 0, {2.0, 3.0});
    some.add_member(0, 0, {1.0, 9.0});
    const Names names{some.regimes, some.interventions(), some.species, {"present", "warm"}};
    const RunView run = view_of(names, some.members, some.grid.area_ha());
    ASSERT_EQ(run.regimes.size(), 3U) << "nothing of a regime in a climate that did not run";
    EXPECT_TRUE(run.chart_a_climate);
    EXPECT_EQ(run.regimes[2].title(), "B: thinning, warm");
    EXPECT_EQ(run.regimes[2].look.title_in_chart(), "B: thinning");
    EXPECT_EQ(run.regimes[2].look.line, run.regimes[1].look.line);
    EXPECT_EQ(run.regimes[2].replicates[0][0].stand->volume_m3pha, 4.0);
    EXPECT_EQ(names.course_folder(run.regimes[2].course), "thinning/warm");
}

TEST(LookOf, NamesTheClimatesOfASingleRegimeByLetters) {
    const SomeYears some;
    const Names names{{"none"}, {}, some.species, {"present", "warm"}};
    EXPECT_EQ(look_of(names, 1).title(), "B: none, warm");
    EXPECT_EQ(look_of(names, 1).title_in_chart(), "B: none, warm");
    EXPECT_EQ(look_of(names, 1).line, 1U);
    EXPECT_FALSE(splits_charts(names));
    const Names alone{{"none"}, {}, some.species};
    EXPECT_EQ(look_of(alone, 0).title(), "none");
    EXPECT_EQ(alone.course_folder(0), "none");
}

TEST(StemsFrom12Cm, LeavesOutTheFirstThreeClasses) {
    forest::StandFigures stand;
    for (std::size_t c = 0; c < forest::dbh_classes; ++c) {
        stand.stems_pha_by_class[c] = c < 3 ? 1000.0 : 1.0;
    }
    EXPECT_EQ(stems_from_12_cm(stand), 27.0);
}

}  // namespace
}  // namespace coupling::decades::series_test
