#include "coupling/assessments/decades/tables/profile_tables.hpp"

#include <gtest/gtest.h>

namespace coupling::decades::profile_tables_test {
namespace {

const forest::TargetProfile profile = *forest::target_profile(0.5);

/// A stand of thick stems with its longest gap.
void add(MemberYears& member, std::int32_t year, std::uint32_t unit, std::uint32_t patches, double stems_pha,
         double gap_m) {
    forest::StandFigures figures;
    figures.stems_pha_by_class[forest::dbh_class_of(40.0)] = stems_pha;
    member.stands.push_back({year, unit, all, figures, 0.0});
    member.stands.push_back(
        {year, unit, 0, {}, 0.0});  // of one species: not what is held against the profile
    member.gaps.push_back({year, unit, {.gaps = 1, .patches = patches, .max_m = gap_m}});
}

TEST(ShareMet, WeighsStandsByTheirArea) {
    MemberYears member;
    add(member, 0, all, 40, 320.0, 60.0);
    add(member, 0, 1, 30, 350.0, 15.0);
    add(member, 0, 2, 10, 230.0, 60.0);
    add(member, 1, all, 40, 320.0, 60.0);
    add(member, 1, 1, 30, 290.0, 15.0);
    add(member, 1, 2, 10, 410.0, 25.0);
    const auto shares = share_met(member, profile);
    EXPECT_EQ(shares.size(), 2U);
    EXPECT_DOUBLE_EQ(shares.at(0), 0.75);
    EXPECT_DOUBLE_EQ(shares.at(1), 0.0);
}

TEST(ShareMet, TakesAForestWithoutUnitsAsOneStand) {
    MemberYears member;
    add(member, 0, all, 40, 320.0, 20.0);
    add(member, 1, all, 40, 320.0, 28.0);
    const auto shares = share_met(member, profile);
    EXPECT_DOUBLE_EQ(shares.at(0), 1.0);
    EXPECT_DOUBLE_EQ(shares.at(1), 0.0);
}

}  // namespace
}  // namespace coupling::decades::profile_tables_test
