#include "coupling/exchange/run_year.hpp"

#include <gtest/gtest.h>

#include "coupling/assessments/decades/members/management.hpp"
#include "tests/coupling/inputs/forest_project.hpp"

namespace coupling::exchange::run_year_test {
namespace {

/// A member of the sample project whose rocks are what the test says.
struct Member {
    explicit Member(SimulateRocks rocks, double real_rock_share = 0.0)
        : opened{open(project, {"trees.file=", "stands.records=records.csv"})},
          management{decades::read_management(*opened.scenario, forest(), warnings)},
          state{forest().start(1, 0), {}},
          site{forest(), forest().species.table, forest().parameters, management.regimes[0], 0,
               {1, 0},   std::move(rocks),       real_rock_share} {}

    [[nodiscard]] const ForestSite& forest() const { return *opened.site->forest; }

    ForestProject project;
    Opened opened;
    config::Warnings warnings;
    decades::Management management;
    MemberState state;
    MemberSite site;
};

TEST(RunYear, SimulatesRocksThroughTheForestThatHasGrown) {
    std::vector<std::pair<int, int>> seen;  // year of the run, calendar year of the stand
    Member member{[&](const forest::Stand& stand, std::int32_t year) {
        seen.emplace_back(year, stand.year());
        return YearFalls{};
    }};
    const int start = member.state.stand.year();
    run_start(member.state, member.site);
    run_year(member.state, member.site, 1);
    run_year(member.state, member.site, 2);
    EXPECT_EQ(seen, (std::vector<std::pair<int, int>>{{0, start}, {1, start + 1}, {2, start + 2}}));
}

TEST(RunYear, WoundsTreesThatRealRocksHitAndNoOthers) {
    forest::TreeId hit{};
    const SimulateRocks one_hit = [&](const forest::Stand& stand, std::int32_t) {
        YearFalls falls;
        hit = stand.trees().back().id;
        falls.hits.push_back({0, {.tree = hit, .energy_share = 0.5, .rock_diameter_m = 0.3}});
        return falls;
    };
    for (const double share : {0.0, 1.0}) {
        Member member{one_hit, share};
        run_start(member.state, member.site);
        std::vector<forest::TreeId> wounded;
        for (const forest::Wound& wound : member.state.stand.wounds()) {
            wounded.push_back(wound.tree);
        }
        EXPECT_EQ(wounded, share > 0.0 ? std::vector{hit} : std::vector<forest::TreeId>{}) << share;
    }
}

TEST(RunYear, ReportsGrowthAndTheYearsWarmth) {
    Member member{[](const forest::Stand&, std::int32_t) { return YearFalls{}; }};
    const YearOutcome first = run_year(member.state, member.site, 1);
    EXPECT_GT(first.growth.volume_increment_m3, 0.0);
    // Months of the sample climate: mean 6.2 degC in 2001, each year 0.1 K warmer; patches lie near 500 m.
    const YearOutcome second = run_year(member.state, member.site, 2);
    EXPECT_NEAR(second.mean_temperature_degc - first.mean_temperature_degc, 0.1, 1e-9);
}

}  // namespace
}  // namespace coupling::exchange::run_year_test
