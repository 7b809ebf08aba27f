#include "coupling/assessments/today/write_results.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "config/errors/input_error.hpp"
#include "coupling/assessments/today/rows.hpp"
#include "tests/coupling/results/small_run.hpp"

namespace coupling::write_results_test {
namespace {

using small_runs::SmallRun;
using small_runs::TestFolder;

TEST(WriteResults, ReturnsEveryFileItWroteOnce) {
    SmallRun run;
    run.fall(100);
    const TestFolder folder;
    const std::vector<WrittenFile> files = write_results(run.results(), folder.path(), {});
    std::vector<std::string> named;
    for (const WrittenFile& file : files) {
        EXPECT_TRUE(std::filesystem::is_regular_file(folder.path() / file.path)) << file.path;
        EXPECT_FALSE(file.sentence.empty()) << file.path;
        named.push_back(file.path);
    }
    std::sort(named.begin(), named.end());
    EXPECT_EQ(std::adjacent_find(named.begin(), named.end()), named.end());
    for (const auto& entry : std::filesystem::recursive_directory_iterator{folder.path()}) {
        const std::string ending = entry.path().extension().string();
        if (entry.is_regular_file() && ending != ".prj" && ending != ".qml") {
            const std::string path = std::filesystem::relative(entry.path(), folder.path()).generic_string();
            EXPECT_TRUE(std::binary_search(named.begin(), named.end(), path)) << path;
        }
    }
}

TEST(WriteResults, NamesTablesThatWereStreamedBefore) {
    const SmallRun run;
    const TestFolder folder;
    const TestFolder parts;  // where they lie until all is whole
    OutFile rocks{parts.path() / "rocks.csv"};
    write_header(rocks.stream(), rock_table());
    rocks.close();
    const std::vector<WrittenFile> streamed{{"tables/rocks.csv", "One row a rock."}};
    const std::vector<WrittenFile> files =
        write_results(run.results(), folder.path(), {streamed, parts.path()});
    EXPECT_TRUE(std::any_of(files.begin(), files.end(),
                            [](const WrittenFile& f) { return f.path == "tables/rocks.csv"; }));
    EXPECT_NE(small_runs::text_of(folder.path() / "summary.json").find("One row a rock."), std::string::npos);
    EXPECT_NE(small_runs::text_of(folder.path() / "report.html").find("One row a rock."), std::string::npos);
}

TEST(WriteResults, GivesTheSameBytesFromTheSameRun) {
    const TestFolder first;
    const TestFolder second;
    for (const TestFolder* folder : {&first, &second}) {
        SmallRun run;
        run.fall(100);
        write_results(run.results(), folder->path());
    }
    for (const auto& entry : std::filesystem::recursive_directory_iterator{first.path()}) {
        if (entry.is_regular_file()) {
            const auto other = second.path() / std::filesystem::relative(entry.path(), first.path());
            EXPECT_EQ(small_runs::text_of(entry.path()), small_runs::text_of(other)) << other;
        }
    }
}

TEST(WriteResults, OfABareSlopeWithoutTargetsIsWhole) {
    SmallRun run;
    run.fall(20);
    run.with_forest = false;
    run.site.targets.clear();
    run.tally.targets.clear();
    run.site.trees.clear();
    run.paths.clear();
    const TestFolder folder;
    write_results(run.results(), folder.path());
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "report.html"));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "tables/targets.csv"));
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "results.gpkg"));
}

TEST(WriteResults, TellsWhichFileCannotBeWritten) {
    const SmallRun run;
    const TestFolder folder;
    std::filesystem::create_directories(folder.path() / "summary.json");  // a folder in its place
    try {
        write_results(run.results(), folder.path());
        FAIL() << "written";
    } catch (const config::InputError& error) {
        EXPECT_EQ(error.code(), config::ExitCode::file);
        EXPECT_NE(std::string{error.what()}.find("summary.json"), std::string::npos);
    }
}

}  // namespace
}  // namespace coupling::write_results_test
