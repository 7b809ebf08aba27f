#include "coupling/assessments/hazard/shared_warnings.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "config/text/numbers.hpp"
#include "coupling/results/figures/departures.hpp"
#include "coupling/results/text/messages.hpp"
#include "coupling/results/text/writing_language.hpp"

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

/// The warning of a return period of which so many of 1000 rocks leave on the bare slope.
std::vector<std::string> departures(std::uint64_t rocks) {
    config::Warnings warnings;
    warn_of_departures({1000, {{rockfall::RimPart::south, {0.0, 0.0}, rocks}}}, {}, warnings);
    return warnings.warnings();
}

TEST(SharedWarnings, OfRocksThatLeaveAreOneThatNamesTheWorst) {
    EXPECT_EQ(shared({departures(80), departures(440), {}, departures(31)}),
              std::vector<std::string>{departures(440).front() +
                                       " (most with return period: 100; also with: 10, 10000)"});
    EXPECT_EQ(shared({departures(80), departures(80)}),
              std::vector<std::string>{departures(80).front() + " (return periods: 10, 100)"});
    EXPECT_EQ(shared({departures(29), departures(80)}),
              std::vector<std::string>{departures(80).front() + " (return period: 100)"});
    const std::string model =
        "classical: 58 % of the rocks leave the terrain; with classical.friction = "
        "from_rt they slide on over all ground steeper than that friction";
    EXPECT_EQ(shared({{model, departures(440).front()}, departures(500)}).size(), 2U);
}

RC_GTEST_PROP(SharedWarnings, OfRocksThatLeaveNameThePeriodOfTheLargestShareAndAllThatWarn, ()) {
    const auto rocks =
        *rc::gen::container<std::vector<std::uint64_t>>(5, rc::gen::inRange<std::uint64_t>(0, 1001));
    std::vector<std::vector<std::string>> of_periods;
    std::transform(rocks.begin(), rocks.end(), std::back_inserter(of_periods), departures);
    const std::vector<std::string> all = shared(of_periods);
    const auto worst = std::max_element(rocks.begin(), rocks.end());
    const bool any = *worst >= 30;  // departures_to_warn_of
    RC_ASSERT(all.size() == (any ? 1U : 0U));
    if (!any) {
        return;
    }
    RC_ASSERT(all.front().starts_with(departures(*worst).front()));
    const std::string behind = all.front().substr(all.front().rfind(" (")) + ",";
    double years = 10.0;
    for (const std::uint64_t one : rocks) {
        const std::string name = " " + config::to_text(years);
        const bool is_named =
            std::any_of(behind.begin(), behind.end(), [&, at = std::size_t{0}](char) mutable {
                const std::string_view rest = std::string_view{behind}.substr(at++);
                return rest.starts_with(name) &&
                       std::string_view{",;)"}.find(rest[name.size()]) != std::string_view::npos;
            });
        RC_ASSERT(is_named == (one >= 30));
        years *= 10.0;
    }
}

TEST(SharedWarnings, OfRocksThatLeaveAreTranslated) {
    const std::string sentence = shared({departures(80), departures(440)}).front();
    const report::WritingLanguage german{config::Language::de};
    const std::string text = report::translated(sentence).value_or("(none)");
    EXPECT_TRUE(text.ends_with("(am meisten bei Wiederkehrdauer: 100; auch bei: 10)")) << text;
    EXPECT_NE(text.find("verlassen ohne Wald das Gelände"), std::string::npos) << text;
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
