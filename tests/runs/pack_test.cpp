// Archives of finished runs, through the program.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "config/text/sha256.hpp"
#include "coupling/results/pack/zip_file.hpp"
#include "tests/runs/program.hpp"

namespace coupling::pack_runs_test {
namespace {

/// A finished run of today with settings given on the command line.
void run_in(const SampleProject& project) {
    const Outcome run = call(project,
                             "run scenario.ini --quiet --set release.rocks=200 --set "
                             "'release.diameter_m=0.5' --seed 7");
    ASSERT_EQ(run.code, 0) << run.err;
}

TEST(Pack, HoldsInputsResultsCommandAndChecksums) {
    const SampleProject project;
    run_in(project);
    const Outcome packed =
        call(project, "pack out --creator 'A. Forester' --licence CC-BY-4.0 --date 2026-05-31");
    ASSERT_EQ(packed.code, 0) << packed.err;
    const pack::ZipReader zip{project.file("out.zip")};
    for (const char* name : {"inputs/scenario.ini", "inputs/dem.asc", "results/report.html",
                             "results/summary.json", "results/tables/protection.csv", "README.md", "run.json",
                             "ro-crate-metadata.json", "datacite.json"}) {
        EXPECT_TRUE(zip.has(name)) << name;
        EXPECT_NE(zip.text("manifest-sha256.txt", 1U << 20U)
                      .find(config::sha256_of(zip.text(name, 1U << 24U)) + "  " + name + "\n"),
                  std::string::npos)
            << name;
    }
    EXPECT_EQ(zip.text("results/report.html", 1U << 24U), project.read("out/report.html"));
    EXPECT_NE(zip.text("run.json", 1U << 16U)
                  .find("bannwald run inputs/scenario.ini --set run.seed=7 --set release.rocks=200"),
              std::string::npos)
        << zip.text("run.json", 1U << 16U);
    const std::string datacite = zip.text("datacite.json", 1U << 16U);
    EXPECT_NE(datacite.find("\"name\": \"A. Forester\""), std::string::npos);
    EXPECT_NE(datacite.find("\"publicationYear\": \"2026\""), std::string::npos);
    const std::string crate = zip.text("ro-crate-metadata.json", 1U << 20U);
    EXPECT_NE(crate.find("https://w3id.org/ro/crate/1.1"), std::string::npos);
    EXPECT_NE(crate.find("\"CreateAction\""), std::string::npos);
}

TEST(Pack, GivesTheSameBytesInAnyTimeZone) {
    const SampleProject project;
    run_in(project);
    ASSERT_EQ(shell(project,
                    "TZ=UTC \"$bannwald\" pack out --out a.zip -q && TZ=Asia/Tokyo \"$bannwald\" pack out "
                    "--out b.zip -q\n")
                  .code,
              0);
    EXPECT_EQ(project.read("a.zip"), project.read("b.zip"));
}

TEST(Pack, RepeatsTheRunToTheLastByte) {
    const SampleProject project;
    run_in(project);
    ASSERT_EQ(call(project, "pack out -q").code, 0);
    const Outcome verified = call(project, "verify out.zip --rerun");
    EXPECT_EQ(verified.code, 0) << verified.out << verified.err;
    EXPECT_NE(verified.out.find("same bytes in every file"), std::string::npos);
}

TEST(Pack, RefusesInputsAndSettingsThatChangedSinceTheRun) {
    const SampleProject project;
    run_in(project);
    const std::string scenario = project.read("scenario.ini");
    project.write("scenario.ini", scenario + "\n[output]\npercentiles = no\n");
    const Outcome settings = call(project, "pack out");
    EXPECT_EQ(settings.code, 2);
    EXPECT_NE(settings.err.find("percentiles"), std::string::npos) << settings.err;
    project.write("scenario.ini", scenario);
    project.write("dem.asc", project.read("dem.asc") + "\n");
    const Outcome inputs = call(project, "pack out");
    EXPECT_EQ(inputs.code, 4);
    EXPECT_NE(inputs.err.find("dem.asc: found a file that changed since the run"), std::string::npos)
        << inputs.err;
    EXPECT_FALSE(std::filesystem::exists(project.file("out.zip")));
    EXPECT_EQ(call(project, "pack .").code, 3) << "no finished run";
}

TEST(Verify, NamesWhatIsDamagedMissingOrAdded) {
    const SampleProject project;
    const std::string good = config::sha256_of("good\n");
    const auto archive = [&](const std::string& name, const std::string& manifest, const std::string& text) {
        pack::ZipWriter zip{project.file(name)};
        zip.add_text("manifest-sha256.txt", manifest);
        zip.add_text("run.json", text);
        zip.close();
        return call(project, "verify " + name);
    };
    const Outcome other = archive("other.zip", good + "  run.json\n", "bad\n");
    EXPECT_EQ(other.code, 4);
    EXPECT_NE(other.err.find("run.json: found other bytes"), std::string::npos) << other.err;
    const Outcome missing = archive("missing.zip", good + "  run.json\n" + good + "  a.csv\n", "good\n");
    EXPECT_EQ(missing.code, 4);
    EXPECT_NE(missing.err.find("a.csv: found no such entry"), std::string::npos) << missing.err;
    const Outcome added = archive("added.zip", "", "good\n");
    EXPECT_NE(added.err.find("an entry without checksum"), std::string::npos) << added.err;
    const Outcome no_list = archive("list.zip", "abc  run.json\n", "good\n");
    EXPECT_NE(no_list.err.find("manifest-sha256.txt:1"), std::string::npos) << no_list.err;
    project.write("text.zip", "no zip file");
    EXPECT_EQ(call(project, "verify text.zip").code, 4);
    EXPECT_EQ(call(project, "verify none.zip").code, 3);
}

TEST(Verify, NeverUnpacksOutsideOfItsFolder) {
    for (const char* name : {"../a", "/etc/a", "a/../../b", "C:a", "a\\b", ""}) {
        EXPECT_FALSE(pack::is_safe_name(name)) << name;
    }
    EXPECT_TRUE(pack::is_safe_name("inputs/a b/dem.asc"));
    const SampleProject project;
    {
        pack::ZipWriter zip{project.file("evil.zip")};
        zip.add_text("../evil.txt", "out");
        zip.close();
    }
    const Outcome evil = call(project, "verify evil.zip --rerun");
    EXPECT_EQ(evil.code, 4);
    EXPECT_NE(evil.err.find("'../evil.txt'"), std::string::npos) << evil.err;
}

}  // namespace
}  // namespace coupling::pack_runs_test
