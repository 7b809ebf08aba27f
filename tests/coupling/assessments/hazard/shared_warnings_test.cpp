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

TEST(SharedWarnings, WithOtherFiguresAreThoseOfTheLongestPeriod) {
    EXPECT_EQ(
        shared({{"6.9 % leave"}, {"8.8 % leave"}, {"9 % leave"}}),
        (std::vector<std::string>{"9 % leave (return period: 1000; with other figures also: 10, 100)"}));
    EXPECT_EQ(
        shared({{"6.9 % leave"}, {"8.8 % leave"}, {"8.8 % leave"}}),
        (std::vector<std::string>{"8.8 % leave (return periods: 100, 1000; with other figures also: 10)"}));
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
