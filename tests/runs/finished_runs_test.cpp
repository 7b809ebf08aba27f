// What people do with finished runs: compare them, read them with R and Python, let the shell complete.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/coupling/results/markup_checks.hpp"
#include "tests/runs/years.hpp"

namespace coupling::finished_runs_test {
namespace {

namespace fs = std::filesystem;

/// Two runs of today, `thin` with fewer trees than `dense`, and one over other terrain.
void run_today(const SampleProject& project) {
    std::string dense = "tree_id,x_m,y_m,species,dbh_cm,height_m\n";
    for (int i = 0; i < 200; ++i) {
        dense += std::to_string(i + 1) + "," + std::to_string(1040 + i % 20 * 3) + "," +
                 std::to_string(2020 + i / 20 * 6) + ",PIAB,40,25\n";
    }
    project.write("dense.csv", dense);
    const std::string run = "run scenario.ini --quiet --set release.rocks_per_source=500 ";
    ASSERT_EQ(call(project, run + "--out thin").code, 0);
    ASSERT_EQ(call(project, run + "--set trees.file=dense.csv --out dense").code, 0);
}

TEST(Compare, TellsMoreForestFromLess) {
    const SampleProject project;
    run_today(project);
    const Outcome outcome = call(project, "compare thin dense --out compared");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out.find("NOT COMPARABLE"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("Inputs that differ\n  trees "), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("B dense.csv"), std::string::npos) << outcome.out;
    const config::Table compared = table(project, "compared/compare.csv");
    bool found = false;
    for (std::size_t row = 0; row < compared.rows(); ++row) {
        if (compared.text(row, "run") == "B" && compared.text(row, "target_id") == "road" &&
            compared.text(row, "quantity") == "protection_percent") {
            found = true;
            EXPECT_EQ(compared.text(row, "more_than_chance"), "yes");
            EXPECT_GT(number(compared, row, "difference"), 0.0);
        }
    }
    EXPECT_TRUE(found);
    const Outcome again = call(project, "compare thin dense --out compared");
    EXPECT_EQ(again.code, 2) << "a comparison is not written over";
    for (const char* name : {"compared/report.html", "compared/data_dictionary.csv"}) {
        EXPECT_FALSE(project.read(name).empty()) << name;
    }
    const std::string summary = project.read("compared/summary.json");
    for (const char* part :
         {"\"kind\": \"compare\"", "thin/summary.json", "dense/summary.json", "compare.csv"}) {
        EXPECT_NE(summary.find(part), std::string::npos) << part << summary;
    }
    EXPECT_EQ(call(project, "compare thin thin dense --quiet --out compared --overwrite").out, "");
}

TEST(Compare, DrawsRunsOfTodayOnOnePage) {
    const SampleProject project;
    run_today(project);
    ASSERT_EQ(call(project, "compare thin dense --quiet --page compared.html").code, 0);
    const std::string page = project.read("compared.html");
    EXPECT_EQ(text_checks::markup_fault(page), "");
    for (const char* part : {"<h2>Main figures</h2>", "Energy exceeded, road, with forest",
                             "Run-out exceeded, bare slope", "B: Reach probability", "B − A"}) {
        EXPECT_NE(page.find(part), std::string::npos) << part;
    }
    EXPECT_EQ(call(project, "compare thin dense --quiet --page compared.html").code, 2)
        << "a page of somebody is not written over";
    // The runs are English; the page need not be.
    ASSERT_EQ(call(project, "compare thin dense --quiet --page verglichen.html --language de").code, 0);
    const std::string german = project.read("verglichen.html");
    EXPECT_EQ(text_checks::markup_fault(german), "");
    EXPECT_NE(german.find("<html lang=\"de\""), std::string::npos);
    EXPECT_EQ(german.find("<h2>Main figures</h2>"), std::string::npos);
    const Outcome unknown = call(project, "compare thin dense --page x.html --language rm");
    EXPECT_EQ(unknown.code, 2);
    EXPECT_NE(unknown.err.find("--language 'rm', expected en, de, de_CH, fr, fr_CH or it"), std::string::npos)
        << unknown.err;
    EXPECT_EQ(call(project, "compare thin dense --language de").code, 2) << "the screen speaks English";
    project.remove("dense/tables/run_out.csv");
    const Outcome broken = call(project, "compare thin dense --quiet --page other.html");
    EXPECT_EQ(broken.code, 3) << broken.err;
    EXPECT_NE(broken.err.find("run_out.csv"), std::string::npos) << broken.err;
    EXPECT_FALSE(std::filesystem::exists(project.file("other.html")));
}

TEST(Compare, NamesAColumnThatADamagedTableLacks) {
    const SampleProject project;
    const std::string run = "run scenario.ini --quiet --set release.rocks_per_source=20 ";
    ASSERT_EQ(call(project, run + "--out whole").code, 0);
    ASSERT_EQ(call(project, run + "--out damaged").code, 0);
    project.replace("damaged/tables/targets.csv", "above_1000_kj_high_per_1000", "abo_000_kj_high_per_1000");
    const Outcome changed = call(project, "compare whole damaged");
    EXPECT_EQ(changed.code, 4) << changed.err;
    EXPECT_NE(changed.err.find("targets.csv: found a file that changed since its run"), std::string::npos)
        << changed.err;
    // Runs of earlier versions have no checksums.
    project.remove("damaged/.checksums");
    const Outcome outcome = call(project, "compare whole damaged");
    EXPECT_EQ(outcome.code, 4) << outcome.err;
    EXPECT_NE(outcome.err.find("targets.csv: no column 'above_1000_kj_high_per_1000'"), std::string::npos)
        << outcome.err;
}

TEST(Compare, NamesMotionModelsAndPutsNetsSideBySide) {
    const SampleProject project;
    project.write("nets.csv", "name,height_m,class,wkt\nA,4,5,\"LINESTRING (1090 2020, 1090 2080)\"\n");
    for (const char* model : {"picus", "pir3d"}) {
        const std::string name{model};
        ASSERT_EQ(call(project,
                       "run scenario.ini --quiet --set release.rocks_per_source=100 --set "
                       "nets.file=nets.csv --set rockfall.motion=" +
                           name + " --out " + name)
                      .code,
                  0);
    }
    const Outcome outcome = call(project, "compare picus pir3d --page models.html");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    for (const char* part : {"A picus", "B pir3d", "net A", "held_percent", "design_height_m"}) {
        EXPECT_NE(outcome.out.find(part), std::string::npos) << part << '\n' << outcome.out;
    }
    const std::string page = project.read("models.html");
    EXPECT_EQ(text_checks::markup_fault(page), "");
    for (const char* part : {"<dt>A picus</dt>", ">A</text>", "Rocks that a net holds: net A"}) {
        EXPECT_NE(page.find(part), std::string::npos) << part;
    }
}

TEST(Compare, DrawsRunsOverYearsOnOnePage) {
    const ForestProject project;
    const std::string run = "run scenario.ini --quiet --set run.years=2 --set run.replicates=2 ";
    ASSERT_EQ(call(project, run + "--out a").code, 0);
    ASSERT_EQ(call(project, run + "--seed 7 --out b").code, 0);
    ASSERT_EQ(call(project, "compare a b --quiet --page compared.html").code, 0);
    const std::string page = project.read("compared.html");
    EXPECT_EQ(text_checks::markup_fault(page), "");
    EXPECT_NE(page.find("<h2>Over the years</h2>"), std::string::npos);
    EXPECT_EQ(page.find("<h2>Distributions</h2>"), std::string::npos);
}

TEST(Compare, SaysWhatFoldersLack) {
    const SampleProject project;
    EXPECT_EQ(call(project, "compare thin").code, 2);
    const Outcome gone = call(project, "compare thin dense");
    EXPECT_EQ(gone.code, 3);
    EXPECT_NE(gone.err.find("thin: found no such folder"), std::string::npos) << gone.err;
    const Outcome no_run = shell(project, "mkdir a && \"$bannwald\" compare a a\n");
    EXPECT_EQ(no_run.code, 3);
    EXPECT_NE(no_run.err.find("no results in this folder"), std::string::npos) << no_run.err;
    project.write("a/summary.json", "{\"program\": \"Other\"}\n");
    EXPECT_EQ(call(project, "compare a a").code, 4);
    project.write("a/summary.json", "not json");
    EXPECT_EQ(call(project, "compare a a").code, 4);
}

/// Runs a script of coupling/docs on a run of today and one over years.
void expect_read(const std::string& program, const std::string& script, bool draws) {
    const ForestProject project;
    if (shell(project, "command -v " + program + " > /dev/null\n").code != 0) {
        GTEST_SKIP() << program << " is not installed";
    }
    ASSERT_EQ(call(project, std::string{four_members} + "--set run.years=2 --out years").code, 0);
    ASSERT_EQ(
        call(project, "run scenario.ini --quiet --set release.rocks=500 --set run.years=0 --out today").code,
        0);
    for (const std::string out : {"today", "years"}) {
        const std::string picture = out + ".pdf";
        const Outcome read = shell(project, program + " '" BANNWALD_SOURCE_DIR "/coupling/docs/" + script +
                                                "' " + out + " " + picture + "\n");
        EXPECT_EQ(read.code, 0) << read.err;
        EXPECT_NE(read.out.find("protection effect"), std::string::npos) << read.out;
        EXPECT_NE(read.out.find("road"), std::string::npos) << read.out;
        const bool drawn = fs::exists(project.file(picture)) && fs::file_size(project.file(picture)) > 1000;
        EXPECT_TRUE(drawn || (!draws && read.out.find("nothing is drawn") != std::string::npos)) << read.out;
    }
    const Outcome nothing =
        shell(project, program + " '" BANNWALD_SOURCE_DIR "/coupling/docs/" + script + "' no_run\n");
    EXPECT_NE(nothing.code, 0);
}

TEST(Scripts, ReadARunWithR) {
    expect_read("Rscript", "read_run.R", true);
}

TEST(Scripts, ReadARunWithPython) {
    expect_read("python3", "read_run.py", false);
}

/// What the shell offers after some words; the last one is being typed.
std::string offered(const SampleProject& project, const std::string& words) {
    project.write(
        "complete.bash",
        "source completion.sh\nCOMP_WORDS=(" + words +
            ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_bannwald\nprintf '%s\\n' \"${COMPREPLY[@]}\"\n");
    const Outcome outcome = shell(project, "bash complete.bash\n");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return outcome.out;
}

TEST(Completion, OffersCommandsOptionsSettingsAndFiles) {
    const SampleProject project;
    if (shell(project, "command -v bash > /dev/null\n").code != 0) {
        GTEST_SKIP() << "bash is not installed";
    }
    ASSERT_EQ(shell(project, "\"$bannwald\" completion bash > completion.sh\n").code, 0);
    EXPECT_EQ(shell(project, "bash -c 'source ./completion.sh; complete -p bannwald'\n").out,
              "complete -F _bannwald bannwald\n");
    EXPECT_EQ(offered(project, "bannwald ch"), "check\n");
    EXPECT_EQ(offered(project, "bannwald comp"), "compare\ncompletion\n");
    EXPECT_EQ(offered(project, "bannwald init new --example reg"), "regimes-small\nregimes\n");
    EXPECT_EQ(offered(project, "bannwald run scenario.ini --ov"), "--overwrite\n");
    EXPECT_EQ(offered(project, "bannwald run scen"), "scenario.ini\n");
    EXPECT_EQ(offered(project, "bannwald run scenario.ini --set release.rocks_per"),
              "release.rocks_per_source=\n");
    EXPECT_EQ(offered(project, "bannwald info tree_res"), "tree_resistance\n");
    EXPECT_EQ(offered(project, "bannwald validate vauj").find("vaujany"), 0U);
    EXPECT_EQ(call(project, "completion tcsh").code, 2);
}

}  // namespace
}  // namespace coupling::finished_runs_test
