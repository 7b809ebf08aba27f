#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <string>

#include "tests/runs/calibrations.hpp"

namespace coupling::calibrate_sites_test {
namespace {

/// The sample slope, and a flatter one in the folder `other` with the same grounds by other codes. Both have
/// stops of rocks that fell with known factors.
class TwoSites : public SampleProject {
public:
    explicit TwoSites(const std::string& losses = "1.4") {
        std::filesystem::create_directory(file("other"));
        write("other/scenario.ini",
              "[terrain]\ndem = dem.asc\nsurface = surface.asc\nsurface_types = surface_types.csv\n"
              "[trees]\nfile = trees.csv\n"
              "[release]\nsource = source.asc\nrocks_per_source = 5\ndiameter_m = 0.8\n");
        write("other/dem.asc",
              header() + rows([](int column, int) { return std::to_string(500 - 5 * column); }));
        write("other/surface.asc", header() + rows([](int column, int) { return column < 4 ? "12" : "11"; }));
        write("other/surface_types.csv",
              "code,label,r_n,r_t,p_stop,soil\n12,rock,0.40,0.90,0.0005,sound_rock_step_2\n"
              "11,soil,0.30,0.80,0.01,vegetated_soil_step_1\n");
        write("other/source.asc", header() + rows([](int column, int row) {
                                      return column == 1 && row >= 2 && row < 7 ? "1" : "0";
                                  }));
        write("other/trees.csv",
              "tree_id,x_m,y_m,species,dbh_cm,height_m\n1,1050,2050,ABAL,40,25\n2,1066,2042,piab,28,18\n");
        const std::string truth = "set,weight,losses,stopping\n1,1," + losses + ",0.4\n";
        simulate_truth(*this, "", truth);
        write_stops(*this, "");
        simulate_truth(*this, "other/", truth);
        write_stops(*this, "other/");
        for (const std::string folder : {"", "other/"}) {
            write(folder + "scenario.ini", read(folder + "scenario.ini") + "[observed]\nstops = stops.csv\n");
        }
        write("scenario.ini", read("scenario.ini") + "[calibrate]\nsites = other/scenario.ini\n");
    }
};

const std::string few_more_sets =
    "--set calibrate.sets=60 --set calibrate.first_sets=128 --set calibrate.most_sets=1500 "
    "--set calibrate.rocks=60 ";

TEST(CalibrationsOfSites, ShareWhatDescribesGroundAndMotion) {
    const TwoSites project;
    const Outcome outcome = call(project, "calibrate scenario.ini " + few_more_sets);
    ASSERT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    const config::Table here = written_table(project, "calibration/tables/posterior.csv");
    const config::Table there = written_table(project, "calibration/tables/posterior_other.csv");
    ASSERT_EQ(here.rows(), there.rows());
    for (std::size_t row = 0; row < here.rows(); ++row) {
        for (const auto& [name, name_there] :
             std::map<std::string, std::string>{{"set", "set"},
                                                {"weight", "weight"},
                                                {"losses", "losses"},
                                                {"tree_energy", "tree_energy"},
                                                {"losses_on.1", "losses_on.12"},
                                                {"losses_on.3", "losses_on.11"}}) {
            EXPECT_EQ(here.text(row, name), there.text(row, name_there)) << name;
        }
    }
    // Each site is judged for itself, and by the other one.
    const config::Table sites = written_table(project, "calibration/tables/sites.csv");
    ASSERT_EQ(sites.rows(), 2U);
    EXPECT_EQ(sites.text(1, "site"), "other");
    const config::Table transfer = written_table(project, "calibration/tables/transfer.csv");
    ASSERT_EQ(transfer.rows(), 4U) << "stops and run-outs of two sites";
    EXPECT_EQ(transfer.text(3, "observation"), "run_out");
    EXPECT_EQ(transfer.text(3, "site"), "other");
    EXPECT_LT(std::stod(transfer.text(3, "predicted_p05")), std::stod(transfer.text(3, "predicted_p95")));
    const std::string page = project.read("calibration/report.html");
    for (const char* found :
         {"Do the values carry over?", "Fitted to the other sites alone, the sets predict", "Run-out (other)",
          "Observed stops over those of the sets (other)", "id=\"targets_1\"", "href=\"#targets_1\""}) {
        EXPECT_NE(page.find(found), std::string::npos) << found;
    }
    EXPECT_EQ(page.find(">nan"), std::string::npos);
    const std::string summary = project.read("calibration/summary.json");
    EXPECT_NE(summary.find("\"by_other_sites\""), std::string::npos);
    EXPECT_NE(summary.find("\"other/dem.asc\""), std::string::npos) << "inputs of all sites";
    // Runs at each site take its file.
    for (const std::string file : {"calibrated.ini", "calibrated_other.ini"}) {
        const Outcome run =
            call(project, "run calibration/" + file + " --quiet --overwrite --out calibrated");
        ASSERT_EQ(run.code, 0) << file << run.err;
        const config::Table draws = written_table(project, "calibrated/tables/parameter_draws.csv");
        std::string ground;
        for (std::size_t row = 0; row < draws.rows(); ++row) {
            ground +=
                draws.text(row, "parameter") == (file == "calibrated.ini" ? "losses_on.3" : "losses_on.11")
                    ? "x"
                    : "";
        }
        EXPECT_GT(ground.size(), 10U) << file;
    }
}

/// Two truths, the same at both slopes, one at each side of what is known before.
TEST(CalibrationsOfSites, MoveThePosteriorTowardsTheTruth) {
    const auto fitted = [](const std::string& truth) {
        const TwoSites project{truth};
        const Outcome outcome = call(project,
                                     "calibrate scenario.ini --quiet --set calibrate.transfer=no "
                                     "--set calibrate.rocks=60 " +
                                         many_sets);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return logarithm_of(written_table(project, "calibration/tables/posterior.csv"),
                            {"losses", "losses_on.3"});
    };
    const Logarithm few = fitted("0.6");
    const Logarithm many = fitted("1.8");
    EXPECT_GT(many.mean, 4.0 * many.error);
    EXPECT_GT(many.mean - few.mean, 4.0 * std::hypot(many.error, few.error));
}

TEST(CalibrationsOfSites, AreTheSameBytesOnAnyNumberOfThreadsAndAfterInterruptions) {
    const TwoSites project;
    const std::string slow = few_sets + "--set calibrate.rocks=100 ";
    ASSERT_EQ(call(project, "calibrate scenario.ini --threads 1 --out first " + slow).code, 0);
    const Outcome stopped =
        shell(project, interrupted_for_certain("parts", "parts/parts/without_*.part",
                                               "calibrate scenario.ini --out parts " + slow));
    ASSERT_EQ(stopped.code, 75) << stopped.err;
    EXPECT_TRUE(std::filesystem::exists(project.file("parts/parts/search.part"))) << "what was tried is kept";
    const Outcome outcome = shell(project, "\"$bannwald\" calibrate scenario.ini --threads 3 --out parts " +
                                               slow + "&& diff -r -x .bannwald first parts\n");
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    // Another block at the other site makes another run.
    project.write("other/stops.csv", project.read("other/stops.csv") + "1070,2050\n");
    EXPECT_EQ(call(project, "calibrate scenario.ini --out first " + slow).code, 2)
        << "observations of the other site are inputs, too";
}

TEST(CalibrationsOfSites, SayWhereValuesDoNotCarryOver) {
    const TwoSites project;
    // Blocks that rest just below their sources: no ground of the other slope stops them there.
    std::string stops = "x_m,y_m\n";
    for (int i = 0; i < 40; ++i) {
        stops += std::to_string(1017 + i % 6) + "," + std::to_string(2030 + i) + "\n";
    }
    project.write("other/stops.csv", stops);
    const Outcome outcome = call(project, "calibrate scenario.ini " + few_more_sets);
    ASSERT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    const config::Table transfer = written_table(project, "calibration/tables/transfer.csv");
    int judged = 0;
    int refused = 0;
    for (std::size_t row = 0; row < transfer.rows(); ++row) {
        const std::string as_far = transfer.text(row, "site_as_far");
        EXPECT_TRUE(!as_far.empty() || transfer.text(row, "shows_too_few") == "yes");
        if (transfer.text(row, "search_came_close") == "yes" && !as_far.empty()) {
            ++judged;
            refused += std::stod(as_far) < 0.025 ? 1 : 0;
        }
    }
    EXPECT_GT(judged, 0) << project.read("calibration/tables/transfer.csv");
    EXPECT_EQ(refused, judged);
    EXPECT_NE(outcome.out.find("what was observed is not what they predict"), std::string::npos)
        << outcome.out;
    const std::string page = project.read("calibration/report.html");
    EXPECT_NE(page.find("does not hold here"), std::string::npos);
    // What alone is too far away is named beside the verdict of all together.
    int far = 0;
    for (std::size_t row = 0; row < transfer.rows(); ++row) {
        const std::string as_far = transfer.text(row, "as_far");
        const std::string named = "samples of the model: " + transfer.text(row, "site") + ", " +
                                  transfer.text(row, "observation") + " (";
        const bool is_far = !as_far.empty() && std::stod(as_far) < 0.05;
        EXPECT_EQ(outcome.out.find(named) != std::string::npos, is_far) << named << outcome.out;
        far += is_far ? 1 : 0;
    }
    ASSERT_GT(far, 0);
    EXPECT_NE(page.find("Alone further away than 95 % of samples of the model: Stops (other) ("),
              std::string::npos);
    const Outcome alone =
        call(project, "calibrate scenario.ini --out alone --set calibrate.transfer=no " + few_sets);
    ASSERT_EQ(alone.code, 0) << alone.err;
    EXPECT_FALSE(std::filesystem::exists(project.file("alone/tables/transfer.csv")));
}

TEST(CalibrationsOfSites, RefuseWhatCannotBeFittedTogether) {
    const TwoSites project;
    const auto refusal = [&](int code, const std::string& settings = "") {
        const Outcome outcome =
            call(project, "calibrate scenario.ini --quiet --out out " + few_sets + settings);
        EXPECT_EQ(outcome.code, code) << outcome.err;
        EXPECT_FALSE(std::filesystem::exists(project.file("out")));
        return outcome.err;
    };
    const auto expect_in = [](const std::string& text, const std::string& error) {
        EXPECT_NE(error.find(text), std::string::npos) << error;
    };
    expect_in("calibrate.sites, which names no file: 'none.ini'",
              refusal(3, "--set calibrate.sites=none.ini"));
    expect_in("'scenario.ini' twice", refusal(2, "--set calibrate.sites=scenario.ini"));
    expect_in("'other/../other/scenario.ini' twice",
              refusal(2, "--set \"calibrate.sites=other/scenario.ini, other/../other/scenario.ini\""));
    const std::string motion = refusal(2, "--set rockfall.motion=pir3d");
    expect_in("rockfall.motion = picus, but pir3d in", motion);
    expect_in("site other: ", motion);
    // A site is checked as one alone is.
    const std::string scenario = project.read("other/scenario.ini");
    project.write("other/scenario.ini", scenario + "[sea]\nwalrus = 1\n");
    expect_in("site other: ", refusal(2));
    project.write("other/scenario.ini", scenario.substr(0, scenario.find("[observed]")));
    expect_in("nothing to fit to", refusal(2));
    project.write("other/scenario.ini", scenario + "[run]\nyears = 10\n");
    expect_in("run.years above 0", refusal(2));
    project.write("other/scenario.ini", scenario);
    // The same blocks at two sites.
    const std::string stops = project.read("other/stops.csv");
    project.write("other/stops.csv", project.read("stops.csv"));
    expect_in("the observations of site", refusal(2));
    project.write("other/stops.csv", stops);
    // One name for two grounds.
    project.replace("other/surface_types.csv", "11,soil,0.30,0.80", "11,soil,0.30,0.85");
    const std::string ground = refusal(4);
    expect_in("ground type 'soil' with other values than", ground);
    expect_in("r_t 0.85 for 0.8", ground);
    project.replace("other/surface_types.csv", "11,soil,0.30,0.85", "11,scree,0.30,0.85");
    EXPECT_EQ(call(project, "calibrate scenario.ini --quiet --out gravel " + few_sets).code, 0);
    const config::Table parameters = written_table(project, "gravel/tables/parameters.csv");
    std::map<std::string, std::string> site_of;
    for (std::size_t row = 0; row < parameters.rows(); ++row) {
        site_of[parameters.text(row, "ground")] = parameters.text(row, "site");
    }
    EXPECT_EQ(site_of["scree"], "other");
    EXPECT_EQ(site_of["rock"], "");
}

}  // namespace
}  // namespace coupling::calibrate_sites_test
