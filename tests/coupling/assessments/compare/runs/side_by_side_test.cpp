#include "coupling/assessments/compare/runs/side_by_side.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "config/errors/input_error.hpp"
#include "coupling/results/text/messages.hpp"
#include "coupling/results/text/writing_language.hpp"

namespace coupling::compare::side_by_side_test {
namespace {

Figure with_interval(double value, double low, double high) {
    return {.key = {"road", "", "protection_percent", "today"},
            .value = value,
            .low = low,
            .high = high,
            .is_interval = true};
}

FinishedRun run_with(const Figure& figure) {
    FinishedRun run;
    run.folder = "out";
    run.summary.kind = "today";
    run.summary.inputs = {{"dem", "dem.asc", "0123456789abcdef"}};
    run.summary.settings = {{"run.seed", "1", ""}, {"release.rocks", "100", ""}};
    run.figures.push_back(figure);
    return run;
}

TEST(OverReplicates, IsStudentsInterval) {
    // Three values 1, 2, 3: standard error 1 / sqrt(3), t of 2 degrees of freedom at 97.5 % is 4.3027.
    const Figure figure = over_replicates({}, {{0, 1.0}, {1, 2.0}, {2, 3.0}});
    EXPECT_DOUBLE_EQ(figure.value, 2.0);
    EXPECT_NEAR(figure.high - 2.0, 4.30265273 / std::sqrt(3.0), 1e-6);
    EXPECT_NEAR(figure.low + figure.high, 4.0, 1e-12);
    EXPECT_TRUE(std::isnan(over_replicates({}, {{0, 5.0}}).low))
        << "one replicate tells nothing of the others";
}

TEST(OverReplicates, OfWhatNoYearKnowsIsNotKnown) {
    const Figure figure = over_replicates({"road", "", "energy_95_kj", "mean over years"}, {});
    EXPECT_TRUE(std::isnan(figure.value)) << "not 0";
    EXPECT_EQ(figure.key.quantity, "energy_95_kj");
}

TEST(Difference, AddsIndependentIntervalsInSquares) {
    // 3, 4, 5: below the value of one and above the value of the other.
    const auto d = difference(with_interval(60.0, 57.0, 64.0), with_interval(50.0, 47.0, 54.0), false);
    ASSERT_TRUE(d);
    EXPECT_DOUBLE_EQ(d->value, 10.0);
    EXPECT_DOUBLE_EQ(d->low, 5.0);
    EXPECT_DOUBLE_EQ(d->high, 15.0);
    EXPECT_TRUE(d->is_more_than_chance());
    EXPECT_FALSE(difference(with_interval(54.0, 51.0, 58.0), with_interval(50.0, 47.0, 54.0), false)
                     ->is_more_than_chance());
}

TEST(Difference, TakesReplicatesOfTheSameSeedAsPairs) {
    // The replicates differ much, the runs nearly always by 1: as pairs that is certain, on their own it is
    // not.
    const Figure first = over_replicates({}, {{0, 10.0}, {1, 20.0}, {2, 30.0}});
    const Figure other = over_replicates({}, {{0, 11.0}, {1, 21.1}, {2, 31.0}});
    EXPECT_TRUE(difference(other, first, true)->is_more_than_chance());
    EXPECT_FALSE(difference(other, first, false)->is_more_than_chance());
}

TEST(Difference, OfOtherReplicatesIsThatOfIndependentRuns) {
    // The same values, but of replicates that are not the same: no pairs.
    const Figure first = over_replicates({}, {{0, 10.0}, {1, 20.0}, {2, 30.0}});
    const Figure other = over_replicates({}, {{0, 11.0}, {1, 21.1}, {3, 31.0}});
    EXPECT_FALSE(difference(other, first, true)->is_more_than_chance());
}

TEST(Difference, ThatIsTheSameInAllReplicatesHasNoInterval) {
    const Figure first = over_replicates({}, {{0, 10.0}, {1, 20.0}, {2, 30.0}});
    const Figure other = over_replicates({}, {{0, 11.0}, {1, 21.0}, {2, 31.0}});
    const auto d = difference(other, first, true);
    EXPECT_EQ(d->value, 1.0);
    EXPECT_FALSE(d->has_interval());
    EXPECT_FALSE(d->is_more_than_chance());
}

TEST(Difference, OfWhatIsNotKnownIsNone) {
    const double unknown = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(
        difference(with_interval(unknown, unknown, unknown), with_interval(50.0, 47.0, 54.0), false));
    const auto d = difference(with_interval(60.0, 57.0, unknown), with_interval(50.0, 47.0, 54.0), false);
    ASSERT_TRUE(d);
    EXPECT_FALSE(d->has_interval());
}

TEST(SideBySide, TellsWhenRunsCannotBeCompared) {
    const std::vector<FinishedRun> same{run_with(with_interval(60.0, 57.0, 64.0)),
                                        run_with(with_interval(50.0, 47.0, 54.0))};
    EXPECT_TRUE(side_by_side(same).not_comparable.empty());

    std::vector<FinishedRun> more_rocks = same;
    more_rocks[1].summary.settings[1].value = "200";
    EXPECT_TRUE(side_by_side(more_rocks).not_comparable.empty()) << "more rocks mean the same";
    EXPECT_EQ(side_by_side(more_rocks).settings.size(), 1U);

    std::vector<FinishedRun> other_terrain = same;
    other_terrain[1].summary.inputs[0].hash = "fedcba9876543210";
    const SideBySide comparison = side_by_side(other_terrain);
    ASSERT_EQ(comparison.not_comparable.size(), 1U);
    EXPECT_NE(comparison.not_comparable[0].find("terrain"), std::string::npos);
    std::ostringstream screen;
    write_screen(screen, other_terrain, comparison);
    EXPECT_NE(screen.str().find("NOT COMPARABLE: the terrains differ"), std::string::npos) << screen.str();
}

/// What is in a file counts, not where it lies or how it is called.
TEST(SideBySide, JudgesInputsByTheirContent) {
    std::vector<FinishedRun> runs{run_with(with_interval(60.0, 57.0, 64.0)),
                                  run_with(with_interval(50.0, 47.0, 54.0))};
    for (FinishedRun& run : runs) {
        run.summary.inputs.push_back({"source", "source.asc", "00000000aaaaaaaa"});
        run.summary.inputs.push_back({"trees", "trees.csv", "00000000bbbbbbbb"});
    }
    runs[0].summary.settings.push_back({"release.source", "source.asc", ""});
    runs[1].summary.settings.push_back({"release.source", "outside/cliff.asc", ""});
    runs[1].summary.inputs[1].file = "outside/cliff.asc";
    runs[1].summary.inputs[2].hash = "00000001bbbbbbbb";
    const SideBySide comparison = side_by_side(runs);
    EXPECT_TRUE(comparison.not_comparable.empty()) << comparison.not_comparable[0];
    EXPECT_TRUE(comparison.settings.empty()) << comparison.settings[0].what;
    EXPECT_EQ(comparison.same_inputs, (std::vector<std::string>{"dem", "source"}));
    ASSERT_EQ(comparison.inputs.size(), 1U);
    EXPECT_EQ(comparison.inputs[0].what, "trees");
    EXPECT_EQ(comparison.inputs[0].values,
              (std::vector<std::string>{"trees.csv (00000000)", "trees.csv (00000001)"}));
    std::ostringstream screen;
    write_screen(screen, runs, comparison);
    EXPECT_NE(screen.str().find("Inputs with the same content: dem, source\n"), std::string::npos)
        << screen.str();

    runs[1].summary.inputs[1].hash = "00000002aaaaaaaa";
    ASSERT_EQ(side_by_side(runs).not_comparable.size(), 1U);
    const report::WritingLanguage german{config::Language::de};
    EXPECT_EQ(report::message_text(side_by_side(runs).not_comparable[0]),
              "die Ausbruchstellen unterscheiden sich (Ausbruchstellen: A source.asc, B outside/cliff.asc)");
}

TEST(SideBySide, TellsOfOtherYearsWithRocksAndOfOtherMotionModels) {
    std::vector<FinishedRun> runs{run_with(with_interval(60.0, 57.0, 64.0)),
                                  run_with(with_interval(50.0, 47.0, 54.0))};
    runs[0].summary.settings.push_back({"run.rockfall_every", "1", ""});
    runs[1].summary.settings.push_back({"run.rockfall_every", "5", ""});
    ASSERT_EQ(side_by_side(runs).not_comparable.size(), 1U);
    EXPECT_NE(side_by_side(runs).not_comparable[0].find("different years"), std::string::npos);

    runs[1].summary.settings.back().value = "1";
    runs[0].summary.settings.push_back({"rockfall.motion", "picus", ""});
    runs[1].summary.settings.push_back({"rockfall.motion", "pir3d", ""});
    EXPECT_TRUE(side_by_side(runs).not_comparable.empty());
    ASSERT_EQ(side_by_side(runs).notes.size(), 1U);
    EXPECT_NE(side_by_side(runs).notes[0].find("the motion models differ"), std::string::npos);
    EXPECT_NE(side_by_side(runs).notes[0].find(
                  "energies of picus count translation and rotation, of pir3d translation alone"),
              std::string::npos);
    {
        const report::WritingLanguage german{config::Language::de};
        EXPECT_EQ(report::message_text(side_by_side(runs).notes[0]),
                  "die Bewegungsmodelle unterscheiden sich (A picus, B pir3d): Energien von picus zählen "
                  "Translation und Rotation, von pir3d nur Translation");
    }

    runs[1].summary.settings.back().value = "rigid";
    EXPECT_NE(side_by_side(runs).notes[0].find("energies of all count translation and rotation"),
              std::string::npos);
    const report::WritingLanguage german{config::Language::de};
    EXPECT_NE(report::message_text(side_by_side(runs).notes[0])
                  .find("Energien zählen überall Translation und Rotation"),
              std::string::npos);
}

TEST(SideBySide, TakesShapesOfBlocksForPartOfTheModel) {
    std::vector<FinishedRun> runs{run_with(with_interval(60.0, 57.0, 64.0)),
                                  run_with(with_interval(50.0, 47.0, 54.0))};
    runs[0].summary.settings.push_back({"release.shape", "cube", ""});
    runs[1].summary.settings.push_back({"release.shape", "plate", ""});
    const SideBySide comparison = side_by_side(runs);
    EXPECT_TRUE(comparison.not_comparable.empty());
    ASSERT_EQ(comparison.notes.size(), 1U);
    EXPECT_EQ(comparison.notes[0], "the blocks differ (release.shape: A cube, B plate)");
    EXPECT_EQ(comparison.names[1], "B plate");
}

TEST(SideBySide, RefusesRunsOfDifferentKinds) {
    std::vector<FinishedRun> runs{run_with(with_interval(60.0, 57.0, 64.0)),
                                  run_with(with_interval(50.0, 47.0, 54.0))};
    runs[1].summary.kind = "years";
    EXPECT_THROW(side_by_side(runs), config::InputError);
}

TEST(SideBySide, ShowsFiguresThatOnlyOneRunHas) {
    std::vector<FinishedRun> runs{run_with(with_interval(60.0, 57.0, 64.0)),
                                  run_with(with_interval(50.0, 47.0, 54.0))};
    runs[1].figures[0].key.target = "house";
    const SideBySide comparison = side_by_side(runs);
    ASSERT_EQ(comparison.lines.size(), 2U);
    EXPECT_FALSE(comparison.lines[0].figures[1]);
    EXPECT_FALSE(comparison.lines[1].differences[1]);
    std::ostringstream table;
    write_csv(table, runs, comparison);
    EXPECT_NE(table.str().find("\nB,out,house,,,protection_percent,today,,50.0000,47.0000,54.0000,,,,,\n"),
              std::string::npos)
        << table.str();
}

TEST(SideBySide, SaysWhyAFigureIsMissingOnTheScreenAndInTheTable) {
    std::vector<FinishedRun> runs{run_with(with_interval(60.0, 57.0, 64.0)),
                                  run_with(with_interval(50.0, 47.0, 54.0))};
    runs[1].figures[0] = {.key = runs[0].figures[0].key, .why_none = "only 2 rocks arrive"};
    const SideBySide comparison = side_by_side(runs);
    EXPECT_FALSE(comparison.lines[0].differences[1]);
    std::ostringstream screen;
    write_screen(screen, runs, comparison);
    EXPECT_NE(screen.str().find("too few rocks"), std::string::npos) << screen.str();
    EXPECT_NE(screen.str().find("B, road: only 2 rocks arrive"), std::string::npos) << screen.str();
    std::ostringstream table;
    write_csv(table, runs, comparison);
    EXPECT_NE(table.str().find("\nB,out,road,,,protection_percent,today,,,,,,,,,only 2 rocks arrive\n"),
              std::string::npos)
        << table.str();
}

}  // namespace
}  // namespace coupling::compare::side_by_side_test
