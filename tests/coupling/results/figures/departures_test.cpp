#include "coupling/results/figures/departures.hpp"

#include <gtest/gtest.h>

#include "coupling/results/text/messages.hpp"
#include "coupling/results/text/writing_language.hpp"

namespace coupling::departures_test {
namespace {

using rockfall::RimPart;

Departures some() {
    return {1000,
            {{RimPart::south, Eigen::Vector2d::Zero(), 60},
             {rockfall::hole_part(7), {177'012.4, 376'950.6}, 20},
             {RimPart::west, Eigen::Vector2d::Zero(), 3}}};
}

TEST(Departures, NameTheEdgesAndTheRemedy) {
    const auto sentence = warning_of(some(), "over the bare slope");
    ASSERT_TRUE(sentence);
    EXPECT_EQ(
        *sentence,
        "8.30 % of the rocks leave the terrain over the bare slope (6.00 % over the south edge; 2.00 % into "
        "the hole at 177012, 376951; 0.300 % over the west edge): where they stop is not known, and the "
        "run-out of the others is "
        "too short, as rocks that run far leave first; give a terrain that reaches further on these "
        "sides and fill the holes");
}

TEST(Departures, WarnFromThreePercentOn) {
    EXPECT_FALSE(warning_of({1000, {{RimPart::south, {0.0, 0.0}, 29}}}, "with forest"));
    EXPECT_TRUE(warning_of({1000, {{RimPart::south, {0.0, 0.0}, 30}}}, "with forest"));
    EXPECT_FALSE(warning_of({0, {}}, "with forest"));
}

TEST(Departures, WarnOnceOfTheSlopeOnWhichMoreLeaveAsOfTheAnswer) {
    config::Warnings warnings;
    warnings.add("a part of the input");
    warn_of_departures(some(), {1000, {{RimPart::south, {0.0, 0.0}, 40}}}, warnings);
    warn_of_departures(some(), {1000, {{RimPart::south, {0.0, 0.0}, 40}}}, warnings);
    ASSERT_EQ(warnings.warnings().size(), 2U);
    EXPECT_EQ(warnings.effects().front(), config::Effect::answer);
    EXPECT_NE(warnings.warnings().front().find("over the bare slope"), std::string::npos);
}

TEST(Departures, AreReadBackOutOfTheirWarning) {
    const std::string sentence = *warning_of(some(), "over the bare slope");
    const auto share = departing_share(sentence);
    ASSERT_TRUE(share);
    EXPECT_EQ(share->of_whom, "");
    EXPECT_DOUBLE_EQ(share->percent, 8.3);
    const auto model = departing_share("classical: 58 % of the rocks leave the terrain; more");
    ASSERT_TRUE(model);
    EXPECT_EQ(model->of_whom, "classical: ");
    EXPECT_DOUBLE_EQ(model->percent, 58.0);
    EXPECT_FALSE(departing_share("dem.asc: found 2 holes; rocks that come there leave the terrain"));
    EXPECT_FALSE(departing_share("many % of the rocks leave the terrain"));
}

TEST(Departures, AreTheSameOutOfASummary) {
    const Json summary{{"slopes", {{"bare", {{"rocks", 1000}, {"left_terrain", json_departures(some())}}}}}};
    const Departures read = read_departures(summary.dump(), Cover::bare, "summary.json");
    EXPECT_EQ(in_words(read, "here"), in_words(some(), "here"));
    EXPECT_EQ(read_departures(summary.dump(), Cover::forest, "summary.json").rocks, 0U);
}

TEST(Departures, AddUpWhatIsNotNamed) {
    Departures many{1000, {}};
    for (std::uint32_t hole = 0; hole < 9; ++hole) {
        many.parts.push_back({rockfall::hole_part(hole), {100.0 * hole, 0.0}, 10});
    }
    EXPECT_EQ(named_parts(many).size(), most_parts_named);
    EXPECT_EQ(rocks_of_others(many), 50U);
    EXPECT_NE(in_words(many, "here").find("; 5.00 % elsewhere)"), std::string::npos)
        << in_words(many, "here");
}

TEST(Departures, AreSaidInEveryLanguage) {
    Departures all = some();
    all.parts.push_back({RimPart::north, {0.0, 0.0}, 2});
    all.parts.push_back({RimPart::east, {0.0, 0.0}, 1});
    const Departures sides{1000, {{RimPart::east, {0.0, 0.0}, 50}}};
    const Departures holes{1000, {{rockfall::hole_part(0), {-5.0, 1.0}, 50}}};
    for (const auto language : {config::Language::de, config::Language::fr, config::Language::it}) {
        const report::WritingLanguage writing{language};
        for (const Departures* departures : std::initializer_list<const Departures*>{&all, &sides, &holes}) {
            for (const char* slope : {"over the bare slope", "with forest", "as single blocks"}) {
                EXPECT_TRUE(report::translated(*warning_of(*departures, slope))) << slope;
            }
        }
    }
}

}  // namespace
}  // namespace coupling::departures_test
