#include "coupling/assessments/today/unreached_today.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "coupling/results/figures/unreached.hpp"
#include "tests/coupling/inputs/opened.hpp"

namespace coupling::unreached_today_test {
namespace {

/// The sample with a net, and tallies of a hundred rocks that reached nothing.
struct Unreached {
    Unreached() {
        project.write("nets.csv", "name,height_m,class,wkt\nlow,3,1,\"LINESTRING (1090 2010, 1090 2030)\"\n");
        project.replace("scenario.ini", "[targets]", "[nets]\nfile = nets.csv\n[targets]");
        opened = open(project);
    }
    [[nodiscard]] rockfall::EnsembleTally tally() const {
        rockfall::EnsembleTally total{opened.site->map_frame_on_terrain(), opened.site->targets.size(), 0, 0};
        total.runs[static_cast<std::size_t>(rockfall::Cover::bare)].rocks = 100;
        return total;
    }
    [[nodiscard]] config::Warnings warned(const rockfall::EnsembleTally& total,
                                          const std::vector<NetRow>& crossings) const {
        config::Warnings warnings;
        warn_of_unreached(*opened.site, total, crossings, {}, warnings);
        expect_translated(warnings.all());
        return warnings;
    }

    SampleProject project;
    Opened opened;
};

TEST(UnreachedToday, PutsTheAnswerInQuestionWhereNoTargetIsReached) {
    const Unreached site;
    ASSERT_TRUE(site.opened.site) << site.opened.errors;
    const config::Warnings warnings = site.warned(site.tally(), {});
    // One sentence lists all targets.
    ASSERT_EQ(warnings.warnings().size(), 2U);
    EXPECT_EQ(warnings.effects().front(), config::Effect::answer);
    const std::size_t targets = site.opened.site->targets.size();
    ASSERT_GT(targets, 1U);
    EXPECT_EQ(
        warnings.warnings().front().find("no rock reaches " + std::to_string(targets) + " targets: road"), 0U)
        << warnings.warnings().front();
    EXPECT_EQ(warnings.warnings().back().find("no rock reaches the net 'low': "), 0U);
    EXPECT_NE(warnings.effects().back(), config::Effect::answer);
}

TEST(UnreachedToday, NotesSingleTargetsBesideOthers) {
    const Unreached site;
    ASSERT_TRUE(site.opened.site) << site.opened.errors;
    rockfall::EnsembleTally total = site.tally();
    total.targets[0].by_cover[1].reached = 3;
    NetRow crossing;
    crossing.crossing.net = 0;
    const config::Warnings one = site.warned(total, {crossing});
    EXPECT_TRUE(one.warnings().empty());
    ASSERT_EQ(one.notes().size(), 1U);
    EXPECT_EQ(one.notes()[0].find("no rock reaches the target "), 0U);
    total.targets[1].by_cover[0].reached = 1;
    EXPECT_TRUE(site.warned(total, {crossing}).all().empty());
}

/// Crossings of the first net: of every two rocks one over the bare slope, which it holds up to `held`.
std::vector<NetRow> crossings_of(std::uint64_t rocks, std::uint64_t held) {
    std::vector<NetRow> crossings;
    for (std::uint64_t rock = 0; rock < rocks; ++rock) {
        NetRow row;
        row.rock = rock;
        row.cover = rock % 2 == 0 ? rockfall::Cover::bare : rockfall::Cover::forest;
        row.crossing.net = 0;
        row.crossing.outcome = rock < held ? rockfall::NetOutcome::held : rockfall::NetOutcome::over;
        crossings.push_back(row);
    }
    return crossings;
}

/// A net that holds a quarter of the rocks stands behind the reason, one that holds half is the reason.
TEST(UnreachedToday, NamesTheNetThatHoldsTheRocks) {
    const Unreached site;
    ASSERT_TRUE(site.opened.site) << site.opened.errors;
    const std::string nets =
        ". Nets and works above hold rocks: low; a run without them shows what would arrive "
        "(rocks held over the bare slope, of 100: ";
    const config::Warnings part = site.warned(site.tally(), crossings_of(60, 50));
    ASSERT_EQ(part.warnings().size(), 1U);
    const std::string& sentence = part.warnings().front();
    EXPECT_EQ(
        sentence,
        "no rock reaches 2 targets: road, house. No rock crosses them. Check the places of the targets, "
        "the sources, the rock sizes and the ground types" +
            nets + "25)");
    EXPECT_EQ(part.effects().front(), config::Effect::answer) << "25 of 100 rocks are not all";
    EXPECT_EQ(without_figures_of_unreached(sentence),
              sentence.substr(0, sentence.find(" (rocks held over the bare slope")));

    const config::Warnings most = site.warned(site.tally(), crossings_of(120, 100));
    ASSERT_EQ(most.warnings().size(), 1U);
    EXPECT_EQ(most.warnings().front(), "no rock reaches 2 targets: road, house" + nets + "50)");
    EXPECT_EQ(most.effects().front(), config::Effect::part);
}

/// Three of a million held rocks say nothing of a slope that most rocks leave.
TEST(UnreachedToday, KeepsTheReasonWhereNetsHoldFew) {
    Departures bare;
    bare.rocks = 1'000'000;
    bare.parts = {{rockfall::RimPart::south, Eigen::Vector2d::Zero(), 600'000}};
    coupling::Unreached house{.what = "target", .name = "House", .nearest_m = std::nullopt};
    house.lowest_m = 500.0;
    for (const std::optional<double>& nearest_m : {std::optional<double>{}, std::optional{12.0}}) {
        house.nearest_m = nearest_m;
        config::Warnings warnings;
        warn_of_unreached({house}, bare, StopsBefore::is_usual, warnings, {{"Net", 3, 600.0}}, bare.rocks);
        expect_translated(warnings.all());
        ASSERT_EQ(warnings.warnings().size(), 1U);
        EXPECT_EQ(warnings.effects().front(), config::Effect::answer);
        EXPECT_EQ(warnings.warnings().front(),
                  std::string{"no rock reaches the target 'House': rocks leave the terrain; where they leave "
                              "before it, give a terrain that reaches further; else check its place, the "
                              "sources, the rock sizes and the ground types"} +
                      (nearest_m ? " (the nearest rock passes 12 m from it)" : "") +
                      ". Nets and works above hold rocks: Net; a run without them shows what would arrive "
                      "(rocks held over the bare slope, of 1000000: 3)");
    }
}

/// That all rocks stop before a house is not known: they may run past it.
TEST(UnreachedToday, DoesNotSayThatRocksStopBeforeAHouseThatTheyPass) {
    Departures none;
    none.rocks = 100;
    config::Warnings warnings;
    warn_of_unreached({{.what = "target", .name = "House", .nearest_m = 12.0}}, none, StopsBefore::is_usual,
                      warnings);
    expect_translated(warnings.all());
    EXPECT_EQ(warnings.notes(),
              std::vector<std::string>{"no rock reaches the target 'House': no rock crosses it; check its "
                                       "place, the sources, the rock sizes and the ground types (the nearest "
                                       "rock passes 12 m from it)"});
}

/// A net above one target is below another one, of which it says nothing. All nets above count, also those
/// that are not named.
TEST(UnreachedToday, NamesNetsOnlyAtTargetsBelowThem) {
    Departures none;
    none.rocks = 100;
    std::vector<coupling::Unreached> targets{{.what = "target", .name = "Hut", .nearest_m = std::nullopt},
                                             {.what = "target", .name = "House", .nearest_m = std::nullopt}};
    targets[0].lowest_m = 900.0;
    targets[1].lowest_m = 500.0;
    std::vector<Holder> nets;
    for (int i = 0; i < 6; ++i) {
        nets.push_back({"N" + std::to_string(i), 9, 600.0});
    }
    config::Warnings warnings;
    warn_of_unreached(targets, none, StopsBefore::ends_the_answer, warnings, nets, none.rocks);
    expect_translated(warnings.all());
    ASSERT_EQ(warnings.warnings().size(), 2U);
    EXPECT_EQ(warnings.warnings()[0],
              "no rock reaches the target 'Hut': no rock crosses it; check its place, the sources, the rock "
              "sizes and the ground types");
    EXPECT_EQ(
        warnings.warnings()[1],
        "no rock reaches the target 'House'. Nets and works above hold rocks: N0, N1, N2, N3, N4; a run "
        "without them shows what would arrive (rocks held over the bare slope, of 100: 9, 9, 9, 9, 9)");
    EXPECT_EQ(warnings.effects(), (std::vector{config::Effect::answer, config::Effect::part}))
        << "54 of 100 rocks";
}

TEST(UnreachedToday, TellsTargetsFromNets) {
    for (const char* target :
         {"no rock reaches the target 'a': no rock crosses it", "no rock reaches 12 targets: a, b. No"}) {
        EXPECT_TRUE(is_of_unreached_targets(target)) << target;
    }
    for (const char* other : {"no rock reaches the net 'a': no rock crosses it",
                              "no rock reaches 2 nets: 3 targets: b", "no rock reaches House 1, House 2"}) {
        EXPECT_FALSE(is_of_unreached_targets(other)) << other;
        EXPECT_EQ(without_figures_of_unreached(other), other);
    }
    EXPECT_EQ(without_figures_of_unreached("a slope (the nearest rock passes 3 m from it)"),
              "a slope (the nearest rock passes 3 m from it)");
}

/// Each reason with one, two and 30 targets or nets: one sentence, that every language has, with all names as
/// far as they are listed.
TEST(UnreachedToday, JoinsThoseOfOneReason) {
    Departures few;
    few.rocks = 100;
    Departures many = few;
    many.parts = {{rockfall::RimPart::south, Eigen::Vector2d::Zero(), 60}};
    for (const char* what : {"target", "net"}) {
        for (const Departures& bare : {few, many}) {
            for (const std::size_t count : {1U, 2U, 30U}) {
                for (const bool is_near : {false, true}) {
                    std::vector<coupling::Unreached> list;
                    for (std::size_t i = 0; i < 2 * count; ++i) {
                        list.push_back({.what = what,
                                        .name = "Place " + std::to_string(i),
                                        .source_above = i % 2 == 0,
                                        .nearest_m = is_near ? std::optional{12.0 + static_cast<double>(i)}
                                                             : std::nullopt});
                    }
                    config::Warnings warnings;
                    warn_of_unreached(list, bare, StopsBefore::ends_the_answer, warnings);
                    EXPECT_EQ(warnings.warnings().size(), 2U);
                    expect_translated(warnings.all());
                    for (const std::string& whole : warnings.all()) {
                        expect_translated({std::string{without_figures_of_unreached(whole)}});
                    }
                    if (what == std::string{"target"}) {
                        for (coupling::Unreached& one : list) {
                            one.lowest_m = 500.0;
                        }
                        config::Warnings with_net;
                        warn_of_unreached(list, bare, StopsBefore::ends_the_answer, with_net,
                                          {{"Net", 3, 600.0}}, 100);
                        EXPECT_EQ(with_net.warnings().size(), 2U);
                        expect_translated(with_net.all());
                    }
                    for (std::size_t i = 0; i < std::min<std::size_t>(2 * count, 40); ++i) {
                        const std::string& of_it = warnings.warnings()[i % 2 == 0 ? 1 : 0];
                        EXPECT_NE(of_it.find("Place " + std::to_string(i)), std::string::npos) << of_it;
                    }
                    EXPECT_EQ(warnings.warnings()[0].find("…") != std::string::npos, count > 20);
                }
            }
        }
    }
}

}  // namespace
}  // namespace coupling::unreached_today_test
