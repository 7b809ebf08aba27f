#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>

#include "tests/runs/calibrations.hpp"

namespace coupling::calibrate_runs_test {
namespace {

/// Stops of a run of the sample project with known factors: of every so many rocks one.
class CalibratedProject : public SampleProject {
public:
    CalibratedProject() {
        simulate_truth(*this, "", "set,weight,losses,stopping\n1,1,1.5,0.3\n");
        write_stops(*this, "");
        write("scenario.ini", read("scenario.ini") + "[observed]\nstops = stops.csv\n");
    }
};

TEST(Calibrations, LeaveSetsThatRunsTake) {
    const CalibratedProject project;
    const Outcome outcome = call(project, "calibrate scenario.ini " + few_sets);
    ASSERT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    const config::Table sample = written_table(project, "calibration/tables/posterior.csv");
    ASSERT_EQ(sample.rows(), 60U);
    double sum = 0.0;
    for (std::size_t row = 0; row < sample.rows(); ++row) {
        sum += std::stod(sample.text(row, "weight"));
    }
    EXPECT_NEAR(sum, 1.0, 1e-9);
    const std::string page = project.read("calibration/report.html");
    EXPECT_NE(page.find("alibrated.</b>"), std::string::npos);
    const std::size_t learned_at = page.find("What was learned</h2>");
    ASSERT_NE(learned_at, std::string::npos);
    // Parameters of which no more is known than chance shows are said to be such.
    const config::Table parameters = written_table(project, "calibration/tables/parameters.csv");
    for (std::size_t row = 0; row < parameters.rows(); ++row) {
        const double by_chance = std::stod(parameters.text(row, "learned_by_chance"));
        const bool is_beyond = std::stod(parameters.text(row, "learned")) > by_chance;
        const std::size_t line = outcome.out.find("  " + parameters.text(row, "parameter") + ": factor");
        ASSERT_NE(line, std::string::npos) << outcome.out;
        const std::string words = outcome.out.substr(line, outcome.out.find('\n', line) - line);
        EXPECT_EQ(words.find("% learned") != std::string::npos, is_beyond) << words;
        EXPECT_EQ(words.find("too few sets") != std::string::npos, by_chance == 1.0) << words;
        const std::size_t begun = page.find("<tr><td>" + std::to_string(row + 1) + "</td>", learned_at);
        ASSERT_NE(begun, std::string::npos);
        const std::string cells = page.substr(begun, page.find("</tr>", begun) - begun);
        const bool is_none = cells.find("not distinguishable from chance") != std::string::npos ||
                             cells.find("the range is wider than before") != std::string::npos ||
                             cells.find("too few sets") != std::string::npos;
        EXPECT_EQ(is_none, !is_beyond) << cells;
    }
    // Nor do so few sets show pairs that hardly go together.
    double squares = 0.0;
    for (std::size_t row = 0; row < sample.rows(); ++row) {
        squares += std::stod(sample.text(row, "weight")) * std::stod(sample.text(row, "weight"));
    }
    const std::string summary = project.read("calibration/summary.json");
    const std::string key = "\"followed_by_regression\": ";
    const std::size_t followed_at = summary.find(key);
    ASSERT_NE(followed_at, std::string::npos);
    const double followed = std::stod(summary.substr(followed_at + key.size()));
    const double worth_naming = std::max(0.3, 3.0 * std::sqrt(squares / (1.0 - followed)));
    for (std::size_t row = 0; row < parameters.rows(); ++row) {
        const double correlation = std::stod(parameters.text(row, "correlation"));
        std::ostringstream shown;
        shown.precision(2);
        shown << std::fixed << (correlation < 0.0 ? "\u2212" : "") << std::abs(correlation);
        const bool is_named = page.find(" (" + shown.str() + ")</td>") != std::string::npos;
        EXPECT_EQ(is_named, std::abs(correlation) >= worth_naming) << shown.str();
    }
    const Outcome run = call(project, "run calibration/calibrated.ini --out calibrated");
    ASSERT_EQ(run.code, 0) << run.err;
    const config::Table draws = written_table(project, "calibrated/tables/parameter_draws.csv");
    std::map<std::string, bool> is_in_sample;
    for (std::size_t row = 0; row < sample.rows(); ++row) {
        std::ostringstream factor;
        factor.precision(6);
        factor << std::fixed << std::stod(sample.text(row, "losses"));
        is_in_sample[factor.str()] = true;
    }
    int of_losses = 0;
    for (std::size_t row = 0; row < draws.rows(); ++row) {
        if (draws.text(row, "parameter") == "losses") {
            ++of_losses;
            EXPECT_TRUE(is_in_sample[draws.text(row, "factor")]) << draws.text(row, "factor");
        }
    }
    EXPECT_GT(of_losses, 10);
}

/// A fifth of the stops is held out: means of so few scatter more, whatever falls, and curves of few more
/// than those of all rocks of a set. A 5 % quantile of 300 normal trials has a standard error of
/// sqrt(0.05 x 0.95 / 300) / 0.103 = 0.122 deviations, the difference of both quantiles, which correlate by
/// 1/19, 0.168; four of these are 0.20 of the 3.29 between them. Shares of few are steps of one observation.
TEST(Calibrations, PredictAsManyAsWereObserved) {
    const CalibratedProject project;
    ASSERT_EQ(call(project, "calibrate scenario.ini " + few_sets).code, 0);
    const config::Table seen = written_table(project, "calibration/tables/observations.csv");
    std::map<std::string, double> before_m;
    std::map<std::string, double> count;
    for (std::size_t row = 0; row < seen.rows(); ++row) {
        if (seen.text(row, "observation") == "run_out") {
            before_m[seen.text(row, "use")] =
                std::stod(seen.text(row, "before_p95")) - std::stod(seen.text(row, "before_p05"));
            count[seen.text(row, "use")] = std::stod(seen.text(row, "count"));
        }
    }
    EXPECT_GT(before_m["held_out"], before_m["fit"]);
    const double observed = count["fit"] + count["held_out"];
    ASSERT_GT(observed, 20.0);
    const config::Table curves = written_table(project, "calibration/tables/curves.csv");
    const double four_errors =
        4.0 * std::sqrt(2.0 * (1.0 - 1.0 / 19.0) * 0.05 * 0.95 / 300.0) / 0.1031 / (2.0 * 1.645);
    int compared = 0;
    for (std::size_t row = 0; row < curves.rows(); ++row) {
        const double share = std::stod(curves.text(row, "predicted_p50"));
        if (curves.text(row, "observation") == "run_out" && share > 0.3 && share < 0.7) {
            ++compared;
            const double by_chance = 2.0 * 1.645 * std::sqrt(share * (1.0 - share) / observed);
            EXPECT_GT(
                std::stod(curves.text(row, "predicted_p95")) - std::stod(curves.text(row, "predicted_p05")),
                (1.0 - four_errors) * by_chance - 1.0 / observed);
        }
    }
    EXPECT_GT(compared, 0);
}

TEST(Calibrations, AreTheSameBytesOnAnyNumberOfThreads) {
    const CalibratedProject project;
    ASSERT_EQ(call(project, "calibrate scenario.ini --threads 1 --out first " + few_sets).code, 0);
    const Outcome german =
        call(project, "calibrate scenario.ini --out german --set report.language=de " + few_sets);
    ASSERT_EQ(german.code, 0) << german.err;
    const std::string summary = project.read("german/summary.json");
    const std::size_t reason = summary.find("\"reason\": \"") + 11;
    const std::string words = summary.substr(reason, summary.find('"', reason) - reason);
    if (!words.empty()) {
        EXPECT_EQ(project.read("german/report.html").find(words), std::string::npos) << words;
    }
    const Outcome outcome = shell(project, "\"$bannwald\" calibrate scenario.ini --threads 3 --out second " +
                                               few_sets + "&& diff -r -x .bannwald first second\n");
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
}

TEST(Calibrations, GoOnAfterAnInterruptionToTheSameBytes) {
    const CalibratedProject project;
    const std::string slow = few_sets + "--set calibrate.rocks=400 ";
    ASSERT_EQ(call(project, "calibrate scenario.ini --out whole " + slow).code, 0);
    const Outcome stopped =
        shell(project, interrupted_for_certain("parts", "parts/parts/search.part",
                                               "calibrate scenario.ini --out parts " + slow));
    ASSERT_EQ(stopped.code, 75) << stopped.err;
    EXPECT_TRUE(std::filesystem::exists(project.file("parts/parts/search.part"))) << "what was tried is kept";
    const Outcome outcome = shell(project, "\"$bannwald\" calibrate scenario.ini --out parts " + slow +
                                               "&& diff -r -x .bannwald whole parts\n");
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
}

/// Hardly anything that falls here passes two metres at the rim.
TEST(Calibrations, OfWhatNoSetShowsAreNoneAndLeaveNumbers) {
    const SampleProject project;
    project.write("targets.csv",
                  "target_id,name,wkt\n"
                  "hut,hut,\"POLYGON ((1112 2006, 1114 2006, 1114 2008, 1112 2008, 1112 2006))\"\n");
    std::string passages = "target_id,speed_mps\n";
    for (int i = 0; i < 30; ++i) {
        passages += "hut," + std::to_string(10 + i) + "\n";
    }
    project.write("passages.csv", passages);
    const Outcome outcome =
        call(project, "calibrate scenario.ini --set observed.passages=passages.csv " + few_sets);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("Not calibrated."), std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.out.find("nan"), std::string::npos) << outcome.out;
    const config::Table sample = written_table(project, "calibration/tables/posterior.csv");
    for (std::size_t row = 0; row < sample.rows(); ++row) {
        EXPECT_TRUE(std::isfinite(std::stod(sample.text(row, "losses"))));
    }
}

/// The true rocks leave tracks and an outline: no stop, no scar.
TEST(Calibrations, FitToOutlinesJumpsAndSearchedStems) {
    const SampleProject project;
    simulate_truth(project, "", "set,weight,losses,jump_angle\n1,1,1.25,0.85\n",
                   "--set output.impact_table=yes --set output.sample_paths=60");
    write_tracks(project);
    write_outline(project);
    write_searched_stems(project);
    const std::string settings =
        "--set observed.impacts=impacts.csv --set observed.outline=outline.csv "
        "--set observed.trees=searched.csv --set calibrate.rocks=100 ";
    const Outcome outcome = call(project, "calibrate scenario.ini " + few_sets + settings);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const config::Table seen = written_table(project, "calibration/tables/observations.csv");
    std::map<std::string, bool> is_inside;
    for (std::size_t row = 0; row < seen.rows(); ++row) {
        if (seen.text(row, "use") == "fit") {
            is_inside[seen.text(row, "observation")] = seen.text(row, "inside_90") == "yes";
        }
    }
    for (const char* observation : {"jumps", "outline_share", "outline_reach", "tree_dbh", "tree_places"}) {
        ASSERT_TRUE(is_inside.contains(observation)) << observation;
    }
    EXPECT_FALSE(is_inside.contains("tree_scars")) << "how many rocks made them is not known";
    EXPECT_TRUE(is_inside["jumps"]);
    EXPECT_TRUE(is_inside["outline_share"]);
    EXPECT_TRUE(is_inside["outline_reach"]);
    // What soil takes is known as the product of two factors, which trade off.
    const Logarithm product =
        logarithm_of(written_table(project, "calibration/tables/posterior.csv"), {"losses", "losses_on.3"});
    EXPECT_NEAR(product.mean, std::log(1.25), 3.0 * product.deviation);
    EXPECT_LT(product.deviation, 0.8 * std::hypot(0.20, 0.35)) << "nothing was learned";
    const std::string page = project.read("calibration/report.html");
    EXPECT_NE(page.find("Reach of the outline from the sources"), std::string::npos);
    EXPECT_NE(page.find("Lengths of jumps"), std::string::npos);
    EXPECT_EQ(page.find(">nan"), std::string::npos);
    // Its outline is on the map, over stops of the sets.
    EXPECT_NE(page.find("Observed outline over stops of the sets"), std::string::npos);
    const std::size_t outline = page.find("class=\"seen-outline\"");
    ASSERT_NE(outline, std::string::npos);
    EXPECT_NE(page.find("<path", outline), std::string::npos);
}

TEST(Calibrations, SayWhatTheyNeed) {
    const SampleProject project;
    const Outcome nothing = call(project, "calibrate scenario.ini");
    EXPECT_EQ(nothing.code, 2);
    EXPECT_NE(nothing.err.find("nothing to fit to"), std::string::npos) << nothing.err;
    EXPECT_FALSE(std::filesystem::exists(project.file("calibration")));
    project.write("stops.csv", "x_m,y_m\n1060,2050\n1061,2050\n");
    const Outcome few = call(project, "calibrate scenario.ini --set observed.stops=stops.csv");
    EXPECT_EQ(few.code, 4);
    EXPECT_NE(few.err.find("observations to fit to, expected at least 8 of one kind"), std::string::npos)
        << few.err;
    const Outcome exact =
        call(project, "calibrate scenario.ini --set observed.stops=stops.csv --set run.parameter_draws=no");
    EXPECT_EQ(exact.code, 2);
    EXPECT_NE(exact.err.find("run.parameter_draws = no"), std::string::npos) << exact.err;
}

}  // namespace
}  // namespace coupling::calibrate_runs_test
