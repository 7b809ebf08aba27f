#include "coupling/assessments/decades/report/protection.hpp"

#include <gtest/gtest.h>

#include "coupling/assessments/decades/decision/decision.hpp"
#include "coupling/assessments/decades/tables/arrivals.hpp"
#include "tests/coupling/assessments/decades/report/some_years.hpp"
#include "tests/coupling/parts_of_text.hpp"
#include "tests/coupling/results/small_run.hpp"

namespace coupling::decades::protection_test {
namespace {

using text_checks::has;

/// One regime and a road; the arrivals of a replicate are the same in years 0 and 10.
struct SomeArrivals {
    SomeArrivals() { run.site.targets.resize(1); }
    void add_replicate(const PairedCounts& counts) {
        MemberYears member;
        member.member = {0, static_cast<std::uint32_t>(members.size())};
        for (const std::int32_t year : {0, 10}) {
            TargetRow row{.year = year, .target = 0, .paired = counts, .forest = {}, .bare = {}};
            row.forest.share = share_of(counts.forest(), 1000);
            row.bare.share = share_of(counts.bare(), 1000);
            member.targets.push_back(row);
        }
        members.push_back(member);
    }
    [[nodiscard]] std::string html() const {
        const Names names{some.regimes, {}, some.species};
        const std::vector<Series> series = series_of(names, run.site, members, std::nullopt);
        const std::optional<Decision> decision = decide(names, series, members, {});
        return protection_over_years(
            names, run.site, series, members, [&](std::size_t course, const std::string& target) {
                const CourseAtTarget* at = decision ? decision->find(course, target) : nullptr;
                return at != nullptr ? at->forest.lowest : std::nullopt;
            });
    }

    SomeYears some;
    coupling::small_runs::SmallRun run;
    std::vector<MemberYears> members;
};

TEST(ProtectionOverYears, OfOneReplicateHasTheIntervalOfItsRocksAndPromisesNoOther) {
    SomeArrivals arrivals;
    arrivals.add_replicate({.both = 10, .only_forest = 0, .only_bare = 290});
    const std::string html = arrivals.html();
    EXPECT_TRUE(has(html, "at the start <b>96.7\u00a0%</b> (95 % interval 93.")) << html;
    EXPECT_TRUE(has(html, "One replicate: no intervals"));
    EXPECT_FALSE(has(html, "90 % intervals over the replicates (Student’s t, skewness by Hall 1992)"));
}

TEST(ProtectionOverYears, OfSeveralReplicatesHasTheIntervalOfTheirMean) {
    SomeArrivals arrivals;
    arrivals.add_replicate({.both = 10, .only_forest = 0, .only_bare = 290});
    arrivals.add_replicate({.both = 20, .only_forest = 0, .only_bare = 280});
    const std::string html = arrivals.html();
    EXPECT_TRUE(has(html, "90 % intervals over the replicates (Student’s t, skewness by Hall 1992)"));
    EXPECT_FALSE(has(html, "One replicate"));
    EXPECT_FALSE(has(html, "(95 % interval"));
}

TEST(ProtectionOverYears, OfAHandfulOfRocksIsNotTold) {
    SomeArrivals arrivals;
    arrivals.add_replicate({.both = 0, .only_forest = 0, .only_bare = 4});
    EXPECT_TRUE(has(arrivals.html(), "No protection figure in any year: fewer than 5 rocks"))
        << arrivals.html();
    EXPECT_FALSE(has(arrivals.html(), "100.0")) << "neither in words nor in a chart";
    arrivals.add_replicate({.both = 0, .only_forest = 0, .only_bare = 1});
    EXPECT_FALSE(has(arrivals.html(), "No protection figure")) << "five in both replicates";
}

TEST(ProtectionOverYears, OfAYearWithAHandfulOfRocksIsLeftOut) {
    SomeArrivals arrivals;
    arrivals.add_replicate({.both = 10, .only_forest = 0, .only_bare = 290});
    TargetRow& start = arrivals.members.front().targets.front();
    start.paired = {.both = 0, .only_forest = 0, .only_bare = 3};
    const std::string html = arrivals.html();
    EXPECT_TRUE(has(html,
                    "at the start – (only 3 rocks arrive over the bare slope: too few for a "
                    "protection figure)"))
        << html;
    EXPECT_TRUE(has(html, "in year 10 <b>96.7\u00a0%</b>"));
    EXPECT_FALSE(has(html, "100.0")) << "neither in words nor in the table";
}

TEST(AtTarget, AddsTheRocksAboveEnergiesOfAllReplicates) {
    SomeArrivals arrivals;
    arrivals.add_replicate({.both = 10, .only_forest = 0, .only_bare = 290});
    arrivals.add_replicate({.both = 20, .only_forest = 0, .only_bare = 280});
    arrivals.members[0].targets[1].bare.above[2] = share_of(30, 1000);
    arrivals.members[1].targets[1].bare.above[2] = share_of(50, 1000);
    const Names names{arrivals.some.regimes, {}, arrivals.some.species};
    const YearAtTarget year = at_target(names, arrivals.members, 0, 0, 10);
    EXPECT_DOUBLE_EQ(year.bare.above[2].value, 0.04);
}

/// A mean over replicates of which one has few rocks is not that of the rocks.
TEST(AtTarget, TakesEnergiesOverTheRocksOfAllReplicates) {
    SomeArrivals arrivals;
    arrivals.add_replicate({.both = 0, .only_forest = 0, .only_bare = 90});
    arrivals.add_replicate({.both = 0, .only_forest = 0, .only_bare = 10});
    arrivals.members[0].targets[1].bare.energy_kj.mean = 100.0;
    arrivals.members[1].targets[1].bare.energy_kj.mean = 500.0;
    arrivals.members[0].targets[1].bare.energy_kj.p95 = 110.0;
    constexpr std::uint16_t low_bin = 40;
    constexpr std::uint16_t high_bin = 60;
    arrivals.members[0].energies = {{10, 0, low_bin, static_cast<std::uint32_t>(Cover::bare), 90}};
    arrivals.members[1].energies = {{10, 0, high_bin, static_cast<std::uint32_t>(Cover::bare), 10}};
    const Names names{arrivals.some.regimes, {}, arrivals.some.species};
    const Distribution energy_kj = at_target(names, arrivals.members, 0, 0, 10).bare.energy_kj;
    EXPECT_DOUBLE_EQ(energy_kj.mean, 0.9 * 100.0 + 0.1 * 500.0);
    const auto low_of = [](std::uint16_t bin) { return rockfall::energy_bins.low_of(bin) / 1000.0; };
    EXPECT_GE(energy_kj.p95, low_of(high_bin)) << "a tenth of all rocks is in the high bin";
    EXPECT_LE(energy_kj.p95, low_of(high_bin + 1));
    EXPECT_LE(energy_kj.p95_interval.low, 110.0);
    EXPECT_GE(energy_kj.p95_interval.high, energy_kj.p95);
}

TEST(ArrivalsOf, SumsOverTheReplicatesOfACourseInAYear) {
    SomeArrivals arrivals;
    arrivals.add_replicate({.both = 1, .only_forest = 2, .only_bare = 3});
    arrivals.add_replicate({.both = 10, .only_forest = 20, .only_bare = 30});
    const Names names{arrivals.some.regimes, {}, arrivals.some.species};
    const PairedCounts sum = arrivals_of(names, arrivals.members, 0, 0, 10);
    EXPECT_EQ(sum.both, 11U);
    EXPECT_EQ(sum.only_forest, 22U);
    EXPECT_EQ(sum.only_bare, 33U);
    EXPECT_EQ(arrivals_of(names, arrivals.members, 0, 0, 5).bare(), 0U) << "no such year";
}

}  // namespace
}  // namespace coupling::decades::protection_test
