#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <stdexcept>

#include "config/text/language.hpp"
#include "coupling/inputs/formats/json_library.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/writing_language.hpp"
#include "tests/coupling/assessments/profile/profile_project.hpp"
#include "tests/runs/nets.hpp"
#include "tests/runs/program.hpp"
#include "tests/runs/years.hpp"

namespace coupling::several_models_test {
namespace {

constexpr const char* two_models = "run scenario.ini --set release.rocks=2000 --motion picus,pir3d --out out";

Json summary(const SampleProject& project, const std::string& folder) {
    return Json::parse(project.read(folder + "/summary.json"));
}

/// The value that a summary.json has of a row of models.csv; null for what it does not know.
Json value_in(const Json& summary, const config::Table& models, std::size_t row) {
    const std::string about = models.text(row, "about");
    const std::string quantity = models.text(row, "quantity");
    const std::string statistic = models.text(row, "statistic");
    const std::string cover = models.text(row, "cover");
    if (about == "slope") {
        const Json& slope = summary.at("slopes").at(cover);
        return quantity == "left_terrain_percent" ? slope.at("left_terrain").at("percent")
                                                  : slope.at(quantity).at(statistic);
    }
    for (const Json& target : summary.at("targets")) {
        if (target.at("id") != models.text(row, "id")) {
            continue;
        }
        if (quantity == "protection_percent") {
            const Json& protection = target.at("protection");
            return protection.is_null() || protection.at("too_few_rocks") ? Json{}
                                                                          : protection.at("effect_percent");
        }
        return quantity == "reached_percent" ? target.at(cover).at("reached").at("percent")
                                             : target.at(cover).at(quantity).at(statistic);
    }
    throw std::runtime_error{"no target " + models.text(row, "id")};
}

/// The row of nets.csv of a net on a slope.
std::string field_of_net(const SampleProject& project, const std::string& folder, const std::string& net,
                         const std::string& cover, const std::string& column) {
    const config::Table nets = table(project, folder + "/tables/nets.csv");
    for (std::size_t row = 0; row < nets.rows(); ++row) {
        if (nets.text(row, "net") == net && nets.text(row, "cover") == cover) {
            return nets.text(row, column);
        }
    }
    throw std::runtime_error{"no net " + net};
}

bool is_on_page(const std::string& statistic) {
    return statistic.empty() || statistic == "mean" || statistic == "p50" || statistic == "p90" ||
           statistic == "p95" || statistic == "p99";
}

TEST(RunOfSeveralModels, ShowsEachFigureOfEachModelsOwnSummary) {
    const SampleProject project;
    add_nets(project);
    const Outcome outcome = call(project, two_models);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const std::string page = project.read("out/report.html");
    const config::Table models = table(project, "out/models.csv");
    const std::map<std::string, Json> summaries{{"picus", summary(project, "out/picus")},
                                                {"pir3d", summary(project, "out/pir3d")}};
    std::map<std::string, std::size_t> known;  // by what figures are about
    const report::WritingLanguage english{config::Language::en};
    for (std::size_t row = 0; row < models.rows(); ++row) {
        const std::string& model = models.text(row, "model");
        const std::string& text = models.text(row, "value");
        const std::string what = model + ' ' + models.text(row, "about") + ' ' +
                                 models.text(row, "quantity") + ' ' + models.text(row, "statistic") + ' ' +
                                 models.text(row, "cover");
        if (models.text(row, "about") == "net") {
            std::string column = models.text(row, "quantity");
            column = models.text(row, "statistic") == "p95"
                         ? column.substr(0, column.rfind('_')) + "_95" + column.substr(column.rfind('_'))
                         : column;
            const std::string field = field_of_net(project, "out/" + model, models.text(row, "id"),
                                                   models.text(row, "cover"), column);
            ASSERT_EQ(text.empty(), field.empty() || field == "none") << what;
            if (!text.empty()) {
                EXPECT_EQ(number(models, row, "value"), std::stod(field)) << what;
            }
        } else {
            const Json of_run = value_in(summaries.at(model), models, row);
            ASSERT_EQ(text.empty(), of_run.is_null()) << what;
            if (!text.empty()) {
                EXPECT_EQ(number(models, row, "value"), of_run.get<double>()) << what;
            }
        }
        if (text.empty()) {
            continue;
        }
        ++known[models.text(row, "about")];
        if (is_on_page(models.text(row, "statistic")) && models.text(row, "quantity") != "design_class") {
            EXPECT_NE(page.find("<td>" + report::three_digits(number(models, row, "value"))),
                      std::string::npos)
                << what << ' ' << text;
        }
    }
    EXPECT_GT(known["target"], 60U);
    EXPECT_GT(known["slope"], 40U);
    EXPECT_GT(known["net"], 10U);
}

TEST(RunOfSeveralModels, SaysTheRangeOfItsTable) {
    const SampleProject project;
    ASSERT_EQ(call(project, two_models).code, 0);
    const std::string page = project.read("out/report.html");
    const config::Table models = table(project, "out/models.csv");
    const config::Table ranges = table(project, "out/model_ranges.csv");
    const report::WritingLanguage english{config::Language::en};
    std::size_t sentences = 0;
    for (std::size_t row = 0; row < ranges.rows(); ++row) {
        // The range again from the rows of the models.
        double low = INFINITY;
        double high = -INFINITY;
        std::map<double, std::string> model_with;
        for (std::size_t other = 0; other < models.rows(); ++other) {
            const bool same = [&] {
                for (const char* column : {"about", "id", "cover", "quantity", "statistic"}) {
                    if (models.text(other, column) != ranges.text(row, column)) {
                        return false;
                    }
                }
                return !models.text(other, "value").empty();
            }();
            if (same) {
                const double value = number(models, other, "value");
                low = std::min(low, value);
                high = std::max(high, value);
                model_with.emplace(value, models.text(other, "model"));
            }
        }
        ASSERT_EQ(number(ranges, row, "lowest"), low);
        ASSERT_EQ(number(ranges, row, "highest"), high);
        EXPECT_EQ(ranges.text(row, "lowest_model"), model_with.at(low));
        EXPECT_EQ(ranges.text(row, "highest_model"), model_with.at(high));
        const std::string& quantity = ranges.text(row, "quantity");
        if (quantity == "energy_kj" && ranges.text(row, "statistic") == "p95" &&
            ranges.text(row, "cover") == "forest" && ranges.text(row, "id") == "road") {
            const std::string sentence = "do not exceed: <b>" + report::three_digits(low) + " kJ (" +
                                         model_with.at(low) + ") to " + report::three_digits(high) + " kJ (" +
                                         model_with.at(high) + ")</b>.";
            EXPECT_NE(page.find(sentence), std::string::npos) << sentence;
            const bool disagree = ranges.text(row, "models_disagree") == "yes";
            EXPECT_EQ(page.find("</b>. <b>The models disagree</b>", page.find(sentence)) ==
                          page.find(sentence) + sentence.size() - 5,
                      disagree)
                << sentence;
            EXPECT_NE(page.find("Energies of these models do not count the same"), std::string::npos);
            EXPECT_NE(page.find("Judged best on “energy”, by criteria of field cases: " +
                                ranges.text(row, "judged_best")),
                      std::string::npos);
            ++sentences;
        }
    }
    EXPECT_EQ(sentences, 1U);
    EXPECT_NE(page.find("Which model for what"), std::string::npos);
    EXPECT_NE(page.find("criteria met: "), std::string::npos);
    EXPECT_NE(page.find("not judged"), std::string::npos);
}

TEST(RunOfSeveralModels, WritesForEachWhatItWritesAlone) {
    const SampleProject project;
    const Outcome outcome = shell(
        project,
        "set -e\n\"$bannwald\" run scenario.ini --quiet --set release.rocks=300 --motion picus,pir3d "
        "--threads 2\n"
        "for model in picus pir3d; do\n"
        "  \"$bannwald\" run scenario.ini --quiet --set release.rocks=300 --motion $model --out $model\n"
        "  diff -r $model out/$model\ndone\n"
        // The whole folder again on another number of threads.
        "mv out first\n"
        "\"$bannwald\" run scenario.ini --quiet --set release.rocks=300 --motion picus,pir3d --threads 5\n"
        "diff -r first out\n");
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    for (const char* file : {"models.csv", "model_ranges.csv", "data_dictionary.csv", "results.gpkg",
                             "summary.json", "report.html", "comparison/report.html"}) {
        EXPECT_TRUE(std::filesystem::exists(project.file("out") / file)) << file;
    }
    EXPECT_EQ(summary(project, "out").at("run").at("models"), (Json{"picus", "pir3d"}));
}

TEST(RunOfSeveralModels, GoesOnWithWhatIsNotFinished) {
    const SampleProject project;
    ASSERT_EQ(call(project, two_models).code, 0);
    const std::string page = project.read("out/report.html");
    const Outcome again = call(project, two_models);
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_NE(again.out.find("picus: finished before"), std::string::npos) << again.out;
    EXPECT_NE(again.out.find("pir3d: finished before"), std::string::npos);
    EXPECT_EQ(project.read("out/report.html"), page);
    // Other rocks are another run: its results are not taken for this one's.
    const Outcome other = call(project, std::string{two_models} + " --seed 2");
    EXPECT_EQ(other.code, 2);
    EXPECT_NE(other.err.find("--overwrite"), std::string::npos) << other.err;
    ASSERT_EQ(call(project, std::string{two_models} + " --seed 2 --overwrite").code, 0);
}

TEST(RunOfSeveralModels, RefusesWhatIsInTheWayBeforeAnyRockFalls) {
    const SampleProject project;
    ASSERT_EQ(call(project, "run scenario.ini --quiet --motion pir3d --out out/pir3d").code, 0);
    const Outcome other = call(project, two_models);
    EXPECT_EQ(other.code, 2);
    EXPECT_NE(other.err.find("out/pir3d: found finished results of other settings or inputs"),
              std::string::npos)
        << other.err;
    EXPECT_FALSE(std::filesystem::exists(project.file("out/picus")));
    // A plain run in the folder, and a table of the user.
    ASSERT_EQ(call(project, "run scenario.ini --quiet --out plain").code, 0);
    const Outcome plain = call(project, "run scenario.ini --motion picus,pir3d --out plain --overwrite");
    EXPECT_EQ(plain.code, 2);
    EXPECT_NE(plain.err.find("results of another command or run"), std::string::npos) << plain.err;
    std::filesystem::create_directory(project.file("mine"));
    project.write("mine/models.csv", "my,own\n");
    EXPECT_EQ(call(project, "run scenario.ini --motion picus,pir3d --out mine --overwrite").code, 2);
    EXPECT_EQ(project.read("mine/models.csv"), "my,own\n");
}

TEST(RunOfSeveralModels, ContinuesTheModelThatWasInterrupted) {
    const SampleProject project;
    const std::string run =
        "run scenario.ini --quiet --threads 2 --set trees.file= --set output.rock_table=no "
        "--set output.sample_paths=0 --set run.rocks_per_part=20000 --set release.rocks=100000 "
        "--motion picus,classical --out ";
    const Outcome stopped =
        shell(project, interrupted_once("out/classical/parts/checkpoint.part", run + "out"));
    ASSERT_EQ(stopped.code, 75) << stopped.err;
    EXPECT_TRUE(std::filesystem::exists(project.file("out/picus/report.html")));
    EXPECT_TRUE(std::filesystem::exists(project.file("out/classical/parts/checkpoint.part")));
    EXPECT_FALSE(std::filesystem::exists(project.file("out/report.html")));
    const Outcome outcome =
        shell(project, "set -e\n\"$bannwald\" " + run + "out\nmv out halves\n\"$bannwald\" " + run +
                           "out\ndiff -r halves out\n");
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
}

TEST(RunOfSeveralModels, PutsLevelsAndReturnPeriodsOfAHazardMapSideBySide) {
    const SampleProject project;
    add_nets(project);
    project.write("blocks.csv", "return_period_years,zone,diameter_m\n30,1,0.5\n300,1,1.2\n");
    project.replace("scenario.ini", "diameter_m = 0.5\n", "");
    project.replace("scenario.ini", "[targets]", "[hazard]\nblocks = blocks.csv\n[targets]");
    const Outcome outcome =
        call(project, "run scenario.ini --set release.rocks=400 --motion picus,classical --out out");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const config::Table levels = table(project, "out/model_levels.csv");
    ASSERT_EQ(levels.rows(), 2U * 2U * 2U);  // targets, slopes, models
    const std::string page = project.read("out/report.html");
    std::size_t found = 0;
    for (std::size_t row = 0; row < levels.rows(); ++row) {
        const Json map = summary(project, "out/" + levels.text(row, "model") + "/hazard");
        for (const Json& target : map.at("targets")) {
            if (target.at("id") == levels.text(row, "target_id")) {
                EXPECT_EQ(target.at(levels.text(row, "cover")).at("level"), levels.text(row, "level"));
                EXPECT_NE(page.find(levels.text(row, "level") + " (" + levels.text(row, "model") + ")"),
                          std::string::npos);
                ++found;
            }
        }
    }
    EXPECT_EQ(found, levels.rows());
    const config::Table models = table(project, "out/models.csv");
    for (std::size_t row = 0; row < models.rows(); ++row) {
        if (models.text(row, "quantity") == "reached_percent" && models.text(row, "about") == "target") {
            const Json of_run = summary(project, "out/" + models.text(row, "model") + "/return_period_" +
                                                     models.text(row, "return_period_years"));
            EXPECT_EQ(number(models, row, "value"), value_in(of_run, models, row).get<double>());
        }
    }
    EXPECT_NE(page.find("design energy"), std::string::npos);
    EXPECT_TRUE(std::filesystem::exists(project.file("out/comparison/return_period_300/report.html")));
    const Outcome again =
        call(project, "run scenario.ini --set release.rocks=400 --motion picus,classical --out out");
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_NE(again.out.find("return period of 300 years: finished before"), std::string::npos) << again.out;
    EXPECT_EQ(project.read("out/report.html"), page);
}

TEST(RunOfSeveralModels, SpeaksTheLanguageOfTheScenario) {
    const SampleProject project;
    const std::string run = "run scenario.ini --quiet --set release.rocks=300 --motion picus,pir3d ";
    ASSERT_EQ(call(project, run + "--out en").code, 0);
    const config::Table plain = table(project, "en/models.csv");
    for (const auto& [language, words] :
         {std::pair{"de", "Welches Modell wofür"}, std::pair{"fr", "Quel modèle pour quoi"},
          std::pair{"it", "Quale modello per che cosa"}}) {
        const Outcome outcome = call(
            project, run + "--set report.language=" + language + " --set output.csv=excel --out " + language);
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_NE(project.read(std::string{language} + "/report.html").find(words), std::string::npos);
        // The same figures, read from tables for Excel and written as such.
        const config::Table excel = table(project, std::string{language} + "/models.csv");
        ASSERT_EQ(excel.rows(), plain.rows());
        for (std::size_t row = 0; row < plain.rows(); ++row) {
            EXPECT_EQ(excel.text(row, "value"), plain.text(row, "value"));
        }
    }
}

TEST(RunOfSeveralModels, ComparesRunsAlongAProfileInAFolder) {
    const SampleProject project;
    make_profile_project(project);
    const Outcome outcome = call(project, "run scenario.ini --motion picus,classical --out out");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(project.read("out/comparison/report.html").find("Which model for what"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(project.file("out/report.html")));
}

TEST(CheckOfSeveralModels, AddsTheirTimesAndTakesTheLargestMemory) {
    const SampleProject project;
    const Outcome outcome = call(project, "check scenario.ini --motion picus,pir3d,classical");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    std::size_t at = 0;
    for (const char* words : {"Motion model picus", "Motion model pir3d", "Motion model classical",
                              "All motion models, one after the other", "memory", "time"}) {
        at = outcome.out.find(words, at);
        ASSERT_NE(at, std::string::npos) << words << '\n' << outcome.out;
    }
}

}  // namespace
}  // namespace coupling::several_models_test
