#include "coupling/assessments/hazard/shared_warnings.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace coupling::hazard::shared_warnings_test {
namespace {

std::vector<std::string> shared(const std::vector<std::vector<std::string>>& of_periods) {
    SharedWarnings shared;
    double years = 10.0;
    for (const std::vector<std::string>& sentences : of_periods) {
        config::Warnings warnings;
        for (const std::string& sentence : sentences) {
            warnings.add(sentence);
        }
        shared.add(years, warnings);
        years *= 10.0;
    }
    config::Warnings all;
    shared.add_to(all);
    return all.warnings();
}

TEST(SharedWarnings, StandOnceWithTheirPeriods) {
    EXPECT_EQ(shared({{"walls lean"}, {"walls lean"}, {}}),
              (std::vector<std::string>{"walls lean (return periods: 10, 100)"}));
}

/// None of them is the worst for all: 44 % leave in one period however few in a longer one.
TEST(SharedWarnings, WithOtherFiguresStandForThemselves) {
    EXPECT_EQ(shared({{"44 % leave"}, {"3 % leave"}, {"44 % leave"}}),
              (std::vector<std::string>{"44 % leave (return periods: 10, 1000)",
                                        "3 % leave (return period: 100)"}));
    EXPECT_EQ(shared({{"no rock reaches House 1, House 2"}, {"no rock reaches House 3, House 4"}}).size(),
              2U);
}

/// Rocks that leave the terrain: on each slope the return period that loses most of them.
TEST(SharedWarnings, OfRocksThatLeaveStandOnceForEachSlope) {
    const auto leave = [](const std::string& percent, const std::string& slope) {
        return percent + " % of the rocks leave the terrain " + slope + " (" + percent +
               " % over the edge): more";
    };
    EXPECT_EQ(shared({{leave("5.11", "over the bare slope"), leave("3", "with forest")},
                      {leave("12.4", "over the bare slope")},
                      {leave("5.74", "over the bare slope"), leave("3", "with forest")}}),
              (std::vector<std::string>{leave("12.4", "over the bare slope") + " (return period: 100)",
                                        leave("3", "with forest") + " (return periods: 10, 1000)"}));
}

TEST(SharedWarnings, HaveTheGravestOfTheirEffects) {
    for (const bool is_grave_first : {true, false}) {
        SharedWarnings shared;
        for (const bool is_first : {true, false}) {
            config::Warnings warnings;
            warnings.add("walls lean",
                         is_first == is_grave_first ? config::Effect::answer : config::Effect::detail);
            shared.add(is_first ? 10.0 : 100.0, warnings);
        }
        config::Warnings all;
        shared.add_to(all);
        EXPECT_EQ(all.effects(), std::vector{config::Effect::answer});
    }
}

/// A net is as far from the nearest rock as it is in each period; whether a target is reached the map says.
TEST(SharedWarnings, OfNetsThatNoRockReachesStandOnce) {
    const std::string net = "no rock reaches the net 'N 1': no rock crosses it; check its place";
    EXPECT_EQ(shared({{net + " (the nearest rock passes 3 m from it)"},
                      {net + " (the nearest rock passes 12 m from it)"}}),
              std::vector<std::string>{net + " (return periods: 10, 100)"});
    EXPECT_EQ(shared({{net + " (the nearest rock passes 3 m from it)"}}),
              std::vector<std::string>{net + " (the nearest rock passes 3 m from it) (return period: 10)"});
    EXPECT_TRUE(shared({{"no rock reaches the target 'House': no rock crosses it"}}).empty());
}

/// Two houses are two warnings, in one period and in several.
TEST(SharedWarnings, AboutDifferentThingsStayApart) {
    EXPECT_EQ(
        shared({{"no rock reaches 'House 1'", "no rock reaches 'House 2'"}, {"no rock reaches 'House 2'"}}),
        (std::vector<std::string>{"no rock reaches 'House 1' (return period: 10)",
                                  "no rock reaches 'House 2' (return periods: 10, 100)"}));
    EXPECT_EQ(
        shared({{"3 of 5 zones", "4 of 5 zones"}}),
        (std::vector<std::string>{"3 of 5 zones (return period: 10)", "4 of 5 zones (return period: 10)"}));
    EXPECT_EQ(shared({{"zone 33 has no source"}, {"zone 44 has no source"}}).size(), 2U);
    EXPECT_EQ(shared({{"no rock reaches 'L'Alpe 1'"}, {"no rock reaches 'L'Alpe 2'"}}).size(), 2U);
}

}  // namespace
}  // namespace coupling::hazard::shared_warnings_test
