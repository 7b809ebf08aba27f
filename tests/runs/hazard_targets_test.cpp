#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <string>
#include <vector>

#include "coupling/assessments/hazard/hazard_matrix.hpp"
#include "coupling/inputs/formats/json_library.hpp"
#include "tests/runs/hazard.hpp"
#include "tests/runs/years.hpp"

namespace coupling::hazard_targets_test {
namespace {

/// The level of each target once more, from the tables and the matrix alone.
TEST(HazardOfTargets, GivesLevelsThatFollowFromTheTables) {
    const SampleProject project;
    add_blocks(project);
    for (const char* rule : {"cadanav", "arrival", "release"}) {
        const std::string out = std::string{"out_"} + rule;
        const Outcome outcome =
            call(project, std::string{quick_hazard} + "--set hazard.rule=" + rule + " --out " + out);
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        const config::Table targets = table(project, out + "/hazard/tables/hazard_targets.csv");
        const config::Table classes = table(project, out + "/hazard/tables/hazard_target_intensities.csv");
        const hazard::Matrix matrix = hazard::Matrix::shipped();
        for (std::size_t row = 0; row < targets.rows(); ++row) {
            const std::string& id = targets.text(row, "target_id");
            const std::string& cover = targets.text(row, "cover");
            std::vector<double> per_year(matrix.intensities(), 0.0);  // of cadanav and arrival: added up
            hazard::Level highest = hazard::Level::none;
            double rocks = 0.0;
            for (std::size_t k = 0; k < classes.rows(); ++k) {
                if (classes.text(k, "target_id") != id || classes.text(k, "cover") != cover ||
                    classes.text(k, "target_return_period_years").empty()) {
                    continue;
                }
                const double from_kj = number(classes, k, "energy_from_kj");
                const double release = number(classes, k, "return_period_years");
                rocks += from_kj == 0.0 ? number(classes, k, "rocks") : 0.0;
                const config::Table of_run =
                    table(project, out + "/return_period_" + classes.text(k, "return_period_years") +
                                       "/tables/targets.csv");
                const std::size_t at = row_of(of_run, id, cover);
                const std::string percentile = of_run.text(at, "energy_95_kj").empty()
                                                   ? of_run.text(at, "energy_max_kj")
                                                   : of_run.text(at, "energy_95_kj");
                const bool by_class = std::string{rule} == "cadanav";
                if (!by_class && from_kj > 0.0) {
                    continue;
                }
                const double energy_kj = by_class ? from_kj : std::stod(percentile);
                const std::size_t intensity = matrix.intensity_of(energy_kj);
                if (std::string{rule} == "release") {
                    highest = std::max(highest, matrix.at(intensity, matrix.frequency_of(release)));
                    continue;
                }
                const double often = 1.0 / number(classes, k, "target_return_period_years");
                for (std::size_t i = by_class ? intensity : 0; i <= intensity; ++i) {
                    per_year[i] += often;
                }
            }
            for (std::size_t i = 0; i < per_year.size(); ++i) {
                if (per_year[i] > 0.0) {
                    highest = std::max(highest, matrix.at(i, matrix.frequency_of(1.0 / per_year[i])));
                }
            }
            EXPECT_EQ(targets.text(row, "level"), hazard::level_name(highest)) << rule << id << cover;
            EXPECT_EQ(number(targets, row, "rocks"), rocks) << rule << id << cover;
            const std::string page = project.read(out + "/hazard/report.html");
            EXPECT_NE(page.find(std::string{hazard::level_name(highest)} + " hazard"), std::string::npos);
        }
    }
}

/// Over slopes and seeds: no rock, no level; and a rock that hits leaves one.
TEST(HazardOfTargets, GivesNoLevelToATargetThatNoRockHits) {
    const SampleProject project;
    add_blocks(project);
    std::string houses = "target_id,name,wkt\n";
    for (int i = 0; i < 24; ++i) {
        const int x = 1040 + 5 * (i % 12);
        const int y = 2008 + 37 * (i / 12);
        houses += "h" + std::to_string(i) + ",House " + std::to_string(i) + ",\"POLYGON ((" +
                  std::to_string(x) + ' ' + std::to_string(y) + ',' + std::to_string(x + 3) + ' ' +
                  std::to_string(y) + ',' + std::to_string(x + 3) + ' ' + std::to_string(y + 3) + ',' +
                  std::to_string(x) + ' ' + std::to_string(y) + "))\"\n";
    }
    project.write("houses.csv", houses);
    int hit = 0;
    int free = 0;
    for (const char* seed : {"1", "2", "3"}) {
        const std::string out = std::string{"out"} + seed;
        const Outcome outcome = call(project,
                                     "run scenario.ini --quiet --set release.rocks=40 --set "
                                     "targets.file=houses.csv --seed " +
                                         std::string{seed} + " --out " + out);
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        const config::Table targets = table(project, out + "/hazard/tables/hazard_targets.csv");
        for (std::size_t row = 0; row < targets.rows(); ++row) {
            double reached = 0.0;
            for (const char* years : {"10", "30", "100", "300"}) {
                const config::Table of_run =
                    table(project, out + "/return_period_" + years + "/tables/targets.csv");
                reached +=
                    number(of_run, row_of(of_run, targets.text(row, "target_id"), targets.text(row, "cover")),
                           "reached");
            }
            EXPECT_EQ(number(targets, row, "rocks"), reached);
            EXPECT_EQ(targets.text(row, "level") == "none", reached == 0.0) << targets.text(row, "target_id");
            EXPECT_EQ(targets.text(row, "compared_level") == "none", reached == 0.0);
            hit += reached > 0.0 ? 1 : 0;
            free += reached > 0.0 ? 0 : 1;
        }
        const std::string page = project.read(out + "/hazard/report.html");
        EXPECT_NE(page.find(" of 24 targets."), std::string::npos);
    }
    EXPECT_GT(hit, 10);
    EXPECT_GT(free, 10);
}

/// Two rows of one return period release a rock each: twice as many arrivals as of one row.
TEST(HazardOfTargets, CountsTheReleasesOfEachRow) {
    const SampleProject project;
    add_blocks(project);
    project.write("blocks.csv", "return_period_years,zone,diameter_m,blocks\n30,1,0.5,300\n30,2,0.5,100\n");
    project.write(
        "lines.csv",
        "zone,wkt\n1,\"LINESTRING (1025 2035, 1025 2050)\"\n2,\"LINESTRING (1025 2052, 1025 2065)\"\n");
    project.replace("scenario.ini", "source = source.asc", "source_shapes = lines.csv");
    ASSERT_EQ(call(project, "run scenario.ini --quiet --out out").code, 0);
    const config::Table zones = table(project, "out/return_period_30/tables/by_zone.csv");
    double per_release = 0.0;
    for (std::size_t row = 0; row < zones.rows(); ++row) {
        if (zones.text(row, "cover") == "bare" && zones.text(row, "target_id") == "road") {
            per_release += number(zones, row, "reached") / number(zones, row, "rocks");
        }
    }
    ASSERT_GT(per_release, 0.0);
    const config::Table arrivals = table(project, "out/hazard/tables/hazard_arrivals.csv");
    for (std::size_t row = 0; row < arrivals.rows(); ++row) {
        if (arrivals.text(row, "target_id") == "road") {
            EXPECT_NEAR(number(arrivals, row, "arrival_period_bare_years"), 30.0 / per_release, 0.01);
        }
    }
}

/// Rocks of 1.2 m beside a house: the side is enough, for the table of arrivals, the shares and the levels
/// alike.
TEST(HazardOfTargets, CountsRocksWhoseSideTouchesAHouse) {
    const SampleProject project;
    add_blocks(project);
    ASSERT_EQ(call(project, std::string{quick_hazard} + "--set trees.file= --out out").code, 0);
    const config::Table arrivals = table(project, "out/return_period_300/tables/arrivals.csv");
    std::size_t all = 0;
    std::size_t by_side = 0;
    for (std::size_t row = 0; row < arrivals.rows(); ++row) {
        if (arrivals.text(row, "target_id") != "house") {
            continue;
        }
        ++all;
        if (arrivals.text(row, "by_side") == "yes") {
            ++by_side;
            // The house has its walls at 1090 and 1100, 2040 and 2050.
            const double x_m = number(arrivals, row, "x_m");
            const double y_m = number(arrivals, row, "y_m");
            const double off_m =
                std::hypot(x_m - std::clamp(x_m, 1090.0, 1100.0), y_m - std::clamp(y_m, 2040.0, 2050.0));
            EXPECT_NEAR(off_m, 0.6, 0.01) << x_m << ' ' << y_m;
        }
    }
    EXPECT_GT(by_side, 0U);
    EXPECT_LT(by_side, all / 2);
    const config::Table targets = table(project, "out/return_period_300/tables/targets.csv");
    EXPECT_EQ(number(targets, row_of(targets, "house", "bare"), "reached"), static_cast<double>(all));
    const config::Table classes = table(project, "out/hazard/tables/hazard_target_intensities.csv");
    bool found = false;
    for (std::size_t row = 0; row < classes.rows(); ++row) {
        if (classes.text(row, "target_id") == "house" &&
            number(classes, row, "return_period_years") == 300.0 &&
            number(classes, row, "energy_from_kj") == 0.0) {
            found = true;
            EXPECT_EQ(number(classes, row, "rocks"), static_cast<double>(all));
        }
    }
    EXPECT_TRUE(found);
}

/// What an energy rests on is counted once more from the tables of the return periods: of fewer rocks than
/// its percentile needs it is the largest, and table, page, summary, terminal and warnings say so.
TEST(HazardOfTargets, SayWhereAPercentileIsTheLargestOfFewRocks) {
    const SampleProject project;
    add_blocks(project);
    const Outcome outcome =
        call(project,
             "run scenario.ini --set release.rocks=30 --set hazard.rule=release --set hazard.energy=90 "
             "--out out");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const config::Table targets = table(project, "out/hazard/tables/hazard_targets.csv");
    const std::string page = project.read("out/hazard/report.html");
    const std::string summary = project.read("out/hazard/summary.json");
    int few = 0;
    int enough = 0;
    for (std::size_t row = 0; row < targets.rows(); ++row) {
        if (targets.text(row, "level") == "none") {
            EXPECT_EQ(targets.text(row, "energy_rocks"), "0");
            EXPECT_EQ(targets.text(row, "energy_is"), "");
            continue;
        }
        const config::Table of_run =
            table(project, "out/return_period_" + targets.text(row, "release_return_period_years") +
                               "/tables/targets.csv");
        const std::size_t at = row_of(of_run, targets.text(row, "target_id"), targets.text(row, "cover"));
        const double rocks = number(of_run, at, "reached");
        EXPECT_EQ(number(targets, row, "energy_rocks"), rocks);
        const bool is_largest = rocks < 10.0;
        EXPECT_EQ(targets.text(row, "energy_is"), is_largest ? "largest" : "hazard.energy");
        EXPECT_NEAR(number(targets, row, "energy_kj"),
                    number(of_run, at, is_largest ? "energy_max_kj" : "energy_90_kj"), 0.001);
        EXPECT_GE(number(targets, row, "highest_energy_kj"), number(targets, row, "energy_kj"));
        const std::string count = targets.text(row, "energy_rocks");
        const std::string of_few = count == "1" ? "of the only rock" : "largest of " + count + " rocks";
        EXPECT_EQ(page.find("<br/><b>" + of_few + "</b>") != std::string::npos, is_largest) << of_few;
        EXPECT_EQ(
            page.find(count == "1" ? "energy of the only rock: "
                                   : "largest energy of only " + count + " rocks: ") != std::string::npos,
            is_largest);
        const std::string on_screen = (count == "1" ? "(by the energy of the only rock"
                                                    : "(by the largest energy of only " + count + " rocks") +
                                      " of the return period of " +
                                      targets.text(row, "release_return_period_years") + " years)";
        EXPECT_EQ(outcome.out.find(on_screen) != std::string::npos, is_largest) << outcome.out;
        (is_largest ? few : enough) += 1;
    }
    ASSERT_GT(few, 0);
    ASSERT_GT(enough, 0);
    EXPECT_NE(page.find("90th percentile of the energies: needs at least 10 rocks; fewer hit in "
                        "these return periods: "),
              std::string::npos);
    EXPECT_NE(summary.find("\"energy_is\": \"largest\""), std::string::npos);
    for (const std::string& text : {outcome.err, summary}) {
        EXPECT_NE(text.find(" may be too low or too high, at "), std::string::npos);
        EXPECT_NE(text.find(" targets (rocks that hit, in brackets their return period"), std::string::npos)
            << text;
        EXPECT_NE(text.find("the 90th percentile needs at least 10; of fewer"), std::string::npos);
    }
    // With many rocks the percentile is known.
    const Outcome other = call(project, "run scenario.ini --set release.rocks=3000 --out other");
    ASSERT_EQ(other.code, 0) << other.err;
    EXPECT_EQ(other.err.find("may be too low"), std::string::npos) << other.err;
    EXPECT_EQ(project.read("other/hazard/report.html").find("level may be too low"), std::string::npos);
}

/// By `cadanav` a level rests on the rocks of its class: where these are fewer than 20, card, warning,
/// terminal and summary say so, with their number as in the table of the classes.
TEST(HazardOfTargets, SayWhereTooFewRocksOfAClassGiveALevel) {
    const SampleProject project;
    add_blocks(project);
    int few = 0;
    int enough = 0;
    for (const char* rocks_of_run : {"30", "400"}) {
        const std::string out = std::string{"out_"} + rocks_of_run;
        const Outcome outcome =
            call(project, std::string{"run scenario.ini --set hazard.rule=cadanav --out "} + out +
                              " --set release.rocks=" + rocks_of_run);
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        const config::Table targets = table(project, out + "/hazard/tables/hazard_targets.csv");
        const config::Table classes = table(project, out + "/hazard/tables/hazard_target_intensities.csv");
        const std::string page = project.read(out + "/hazard/report.html");
        const Json summary = Json::parse(project.read(out + "/hazard/summary.json"));
        for (std::size_t row = 0; row < targets.rows(); ++row) {
            const std::string& id = targets.text(row, "target_id");
            const std::string& cover = targets.text(row, "cover");
            // Each return period has one row of blocks: its rocks weigh the same.
            double weights = 0.0;
            double squares = 0.0;
            int counted = 0;
            for (std::size_t k = 0; k < classes.rows(); ++k) {
                if (classes.text(k, "target_id") == id && classes.text(k, "cover") == cover &&
                    classes.text(k, "intensity") == targets.text(row, "intensity")) {
                    const double weight = 1.0 / number(classes, k, "return_period_years");
                    weights += weight * number(classes, k, "rocks");
                    squares += weight * weight * number(classes, k, "rocks");
                    counted += static_cast<int>(number(classes, k, "rocks"));
                }
            }
            const std::string rocks = counted > 0 ? std::to_string(counted) : "";
            const bool is_few = counted > 0 && static_cast<int>(1.000001 * weights * weights / squares) < 20;
            const auto in_summary = std::find_if(summary.at("targets").begin(), summary.at("targets").end(),
                                                 [&](const Json& target) { return target.at("id") == id; });
            ASSERT_NE(in_summary, summary.at("targets").end());
            EXPECT_EQ(in_summary->at(cover).at("rests_on_few_rocks").get<bool>(), is_few) << id << cover;
            if (rocks.empty()) {
                continue;
            }
            const std::string years = targets.text(row, "release_return_period_years");
            EXPECT_EQ(outcome.out.find("(by only " + rocks + (rocks == "1" ? " rock" : " rocks") +
                                       " of its class, most often of the return period of " + years +
                                       " years)") != std::string::npos,
                      is_few)
                << id << cover << outcome.out;
            const std::string slope = cover == "bare" ? "on the bare slope" : "with forest";
            for (const std::string& text : {outcome.err, summary.at("warnings").dump()}) {
                const std::size_t begin = text.find("levels " + slope + " may be too low or too high, at ");
                const std::string warning =
                    begin == std::string::npos
                        ? ""
                        : text.substr(begin, text.find(": how often they hit", begin) - begin);
                EXPECT_EQ(warning.find(targets.text(row, "name") + " – " + rocks + " (" + years + ")") !=
                              std::string::npos,
                          is_few)
                    << id << cover << text;
            }
            const std::size_t card = page.find("<h3>" + targets.text(row, "name") + "</h3>");
            ASSERT_NE(card, std::string::npos);
            const std::string on_card = page.substr(card, page.find("</section>", card) - card);
            const std::string count = (cover == "bare" ? "bare slope: " : "with forest: ") + rocks;
            EXPECT_EQ(on_card.find(count + ",") != std::string::npos ||
                          on_card.find(count + ")") != std::string::npos,
                      is_few)
                << count << " in " << on_card;
            (is_few ? few : enough) += 1;
        }
    }
    EXPECT_GT(few, 0);
    EXPECT_GT(enough, 0);
}

/// Each count of too few rocks names its return period and slope, and page, warnings and tables of the return
/// periods have the same counts: all of them and no others.
TEST(HazardOfTargets, NamePeriodAndSlopeOfTooFewRocks) {
    const SampleProject project;
    add_blocks(project);
    const Outcome outcome =
        call(project,
             "run scenario.ini --set release.rocks=40 --set hazard.rule=release --set hazard.energy=90 "
             "--out out");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const std::string page = project.read("out/hazard/report.html");
    const std::string summary = project.read("out/hazard/summary.json");
    const config::Table targets = table(project, "out/hazard/tables/hazard_targets.csv");
    int few = 0;
    for (std::size_t row = 0; row < targets.rows(); ++row) {
        const bool bare = targets.text(row, "cover") == "bare";
        std::string in_warning;
        for (const char* years : {"10", "30", "100", "300"}) {
            const config::Table of_run =
                table(project, std::string{"out/return_period_"} + years + "/tables/targets.csv");
            const std::string rocks = of_run.text(
                row_of(of_run, targets.text(row, "target_id"), targets.text(row, "cover")), "reached");
            const bool is_few = std::stoi(rocks) > 0 && std::stoi(rocks) < 10;
            const std::string on_card =
                std::string{years} + " years " + (bare ? "bare slope" : "with forest") + ": " + rocks;
            const std::size_t card = page.find("<h3>" + targets.text(row, "name") + "</h3>");
            ASSERT_NE(card, std::string::npos);
            const std::string text = page.substr(card, page.find("</section>", card) - card);
            EXPECT_EQ(text.find(on_card + ",") != std::string::npos ||
                          text.find(on_card + ".") != std::string::npos,
                      is_few)
                << on_card << " in " << text;
            if (is_few) {
                in_warning += (in_warning.empty() ? "" : ", ") + rocks + " (" + years + ")";
                ++few;
            }
        }
        const std::string named = targets.text(row, "name") + " – " + in_warning;
        for (const std::string& text : {outcome.err, summary}) {
            const std::size_t begin =
                text.find(bare ? "levels on the bare slope may be" : "levels with forest may be");
            const std::string warning =
                begin == std::string::npos ? "" : text.substr(begin, text.find(": the 90th", begin) - begin);
            EXPECT_EQ(warning.find(named + " /") != std::string::npos ||
                          warning.find(named + ")") != std::string::npos,
                      !in_warning.empty())
                << named << " in " << warning;
        }
    }
    EXPECT_GT(few, 2);
}

/// The first screen, the terminal and the table say alike where the rule for comparison gives another level.
TEST(HazardOfTargets, SayFirstWhereAnotherRuleGivesAnotherLevel) {
    const SampleProject project;
    add_blocks(project);
    std::size_t others = 0;
    for (const char* rule : {"release", "cadanav", "arrival"}) {
        const std::string out = std::string{"out_"} + rule;
        const Outcome outcome =
            call(project, std::string{"run scenario.ini --set release.rocks=400 --set hazard.rule="} + rule +
                              " --out " + out);
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        const std::string page = project.read(out + "/hazard/report.html");
        const std::string first_screen = page.substr(0, page.find("What decides it"));
        const config::Table targets = table(project, out + "/hazard/tables/hazard_targets.csv");
        std::set<std::string> differ;
        for (std::size_t row = 0; row < targets.rows(); ++row) {
            const auto number_of = [&](const char* column) {
                return std::find(hazard::level_names.begin(), hazard::level_names.end(),
                                 targets.text(row, column)) -
                       hazard::level_names.begin();
            };
            const auto steps = number_of("compared_level") - number_of("level");
            EXPECT_EQ(targets.text(row, "compared_steps"), std::to_string(steps));
            if (steps == 0) {
                continue;
            }
            differ.insert(targets.text(row, "name"));
            const std::string words = std::to_string(std::abs(steps)) +
                                      (std::abs(steps) == 1 ? " step " : " steps ") +
                                      (steps < 0 ? "lower" : "higher") + " at ";
            const std::size_t at = first_screen.find(words);
            ASSERT_NE(at, std::string::npos) << words << first_screen;
            EXPECT_NE(first_screen.find(targets.text(row, "name"), at), std::string::npos);
        }
        others += differ.size();
        const std::string with =
            "By the rule " + targets.text(0, "compared_rule") + ", for comparison, the level is ";
        EXPECT_NE(
            first_screen.find(with + (differ.empty() ? "the same at all targets"
                                                     : "another one at " + std::to_string(differ.size()) +
                                                           " of 2 targets")),
            std::string::npos)
            << first_screen;
        EXPECT_NE(outcome.out.find("hazard.rule " + targets.text(0, "compared_rule") + ", for comparison"),
                  std::string::npos)
            << outcome.out;
    }
    EXPECT_GT(others, 0U) << "nothing to show";
}

/// Without targets it is said of the map.
TEST(HazardOfTargets, SayOfAMapWithoutTargetsWhereAnotherRuleGivesAnotherLevel) {
    const SampleProject project;
    add_blocks(project);
    ASSERT_EQ(call(project, std::string{quick_hazard} + "--set targets.file= --out out").code, 0);
    const std::string page = project.read("out/hazard/report.html");
    EXPECT_NE(page.find("By the rule cadanav, for comparison, the level is another one on "),
              std::string::npos);
}

}  // namespace
}  // namespace coupling::hazard_targets_test
