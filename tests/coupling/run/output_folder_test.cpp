#include "coupling/run/output_folder.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <optional>

#include "config/errors/input_error.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/run/checkpoint.hpp"
#include "coupling/run/file_sums.hpp"
#include "tests/coupling/results/small_run.hpp"

namespace coupling::output_folder_test {
namespace {

namespace fs = std::filesystem;
using small_runs::put;
using small_runs::TestFolder;
using small_runs::text_of;

constexpr const char* this_run = "0123456789abcdef";
constexpr const char* other_run = "fedcba9876543210";

constexpr const char* small_summary =
    R"({"files": [{"path": "report.html"}, {"path": "tables/rocks.csv"}, {"path": "summary.json"}]})";

/// What a run has when its rocks have fallen: parts, and results that are whole in the staging folder.
void write_whole_results(const OutputFolder& folder) {
    write_marker(folder.checkpoint(), this_run);
    put(folder.parts() / "rocks.csv", "all rocks\n");
    put(folder.staging() / "report.html", "a page\n");
    put(folder.staging() / "summary.json", small_summary);
    put(folder.staging() / "tables/rocks.csv", "all rocks\n");
    put(folder.staging() / "rasters/bare/E_95.asc", "a map\n");
}

std::map<std::string, std::string> files_below(const fs::path& folder) {
    std::map<std::string, std::string> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator{folder}) {
        if (!entry.is_directory()) {
            files[fs::relative(entry.path(), folder).generic_string()] = text_of(entry.path());
        }
    }
    return files;
}

std::map<std::string, std::string> published() {
    const TestFolder test;
    OutputFolder folder{test.path() / "out", this_run, false};
    write_whole_results(folder);
    folder.publish();
    return files_below(test.path() / "out");
}

/// Which message, and which code, a start in a folder gives.
std::string refusal(const fs::path& out, const std::string& hash, bool overwrite = false) {
    try {
        const OutputFolder folder{out, hash, overwrite};
        return "";
    } catch (const config::InputError& error) {
        return std::to_string(static_cast<int>(error.code())) + " " + error.what();
    }
}

TEST(OutputFolderKept, PublishesWholeResultsAndNothingElse) {
    const auto files = published();
    EXPECT_EQ(files.size(), 6U);
    EXPECT_EQ(files.count(".bannwald"), 1U);
    EXPECT_EQ(files.count(name_of_sums), 1U);
    EXPECT_EQ(files.at("tables/rocks.csv"), "all rocks\n");
}

/// What a kill leaves after so many of the entries were moved; then parts go, then the empty .complete.
void kill_while_publishing(const fs::path& out, std::size_t moved) {
    {
        OutputFolder folder{out, this_run, false};
        write_whole_results(folder);
        write_sums(folder.staging());
        fs::rename(folder.staging(), out / ".complete");
    }
    const std::vector<std::function<void()>> steps{
        [&] { fs::rename(out / ".complete/.checksums", out / ".checksums"); },
        [&] { fs::rename(out / ".complete/rasters", out / "rasters"); },
        [&] { fs::rename(out / ".complete/report.html", out / "report.html"); },
        [&] { fs::rename(out / ".complete/tables", out / "tables"); },
        [&] { fs::rename(out / ".complete/summary.json", out / "summary.json"); },
        [&] { fs::create_directory(out / ".deleted"); },
        [&] { fs::rename(out / "parts", out / ".deleted/parts"); },
        [&] { fs::remove(out / ".deleted/parts/checkpoint.part"); },
        [&] { fs::remove_all(out / ".deleted"); }};
    ASSERT_LE(moved, steps.size());
    for (std::size_t i = 0; i < moved; ++i) {
        steps[i]();
    }
}

TEST(OutputFolderKept, RollsPublishingForwardFromAnyOfItsSteps) {
    const auto expected = published();
    for (std::size_t moved = 0; moved <= 9; ++moved) {
        const TestFolder test;
        const fs::path out = test.path() / "out";
        kill_while_publishing(out, moved);
        EXPECT_EQ(OutputFolder::state_of(out, this_run), FolderState::being_published) << moved;
        {
            const OutputFolder folder{out, this_run, false};
            EXPECT_TRUE(folder.was_completed()) << moved;
        }
        EXPECT_EQ(files_below(out), expected) << moved;
        EXPECT_EQ(OutputFolder::state_of(out, this_run), FolderState::finished) << moved;
        EXPECT_EQ(refusal(out, this_run).substr(0, 2), "2 ") << moved;
    }
}

TEST(OutputFolderKept, PutsWholeResultsInTheirPlaceBeforeItRefusesOtherSettings) {
    const TestFolder test;
    const fs::path out = test.path() / "out";
    kill_while_publishing(out, 2);
    EXPECT_NE(refusal(out, other_run).find("finished results"), std::string::npos);
    EXPECT_EQ(files_below(out), published());
}

TEST(OutputFolderKept, OverwritesWhateverAKillLeft) {
    for (std::size_t moved = 0; moved <= 9; ++moved) {
        const TestFolder test;
        const fs::path out = test.path() / "out";
        kill_while_publishing(out, moved);
        {
            const OutputFolder folder{out, other_run, true};
            EXPECT_FALSE(folder.was_completed());
            EXPECT_FALSE(folder.has_parts());
            const auto files = files_below(out);
            EXPECT_EQ(files.size(), 1U) << moved;
            EXPECT_NE(files.at(".bannwald").find(other_run), std::string::npos);
        }
        EXPECT_FALSE(fs::exists(out / ".bannwald")) << "nothing was finished";
    }
}

TEST(OutputFolderKept, NeverShowsHalfDeletedResultsAsFinished) {
    // A kill after --overwrite has set the first entries aside: the next start sees no results and clears the
    // rest.
    const TestFolder test;
    const fs::path out = test.path() / "out";
    {
        OutputFolder folder{out, this_run, false};
        write_whole_results(folder);
        folder.publish();
    }
    fs::create_directory(out / ".deleted");
    fs::rename(out / "summary.json", out / ".deleted/summary.json");
    fs::rename(out / "tables", out / ".deleted/tables");
    EXPECT_EQ(OutputFolder::state_of(out, this_run), FolderState::nothing);
    const OutputFolder folder{out, other_run, false};
    EXPECT_EQ(files_below(out).size(), 1U) << "only the mark";
}

TEST(OutputFolderKept, KeepsEverythingWhenPublishingFails) {
    const TestFolder test;
    const fs::path out = test.path() / "out";
    {
        OutputFolder folder{out, this_run, false};
        write_whole_results(folder);
        put(out / ".deleted", "in the way of a folder");
        EXPECT_THROW(folder.publish(), config::InputError);
    }
    EXPECT_EQ(OutputFolder::state_of(out, this_run), FolderState::being_published);
    { EXPECT_TRUE((OutputFolder{out, this_run, false}.was_completed())); }
    EXPECT_EQ(files_below(out), published());
}

TEST(OutputFolderKept, KeepsPartsWhenWritingFails) {
    const TestFolder test;
    const fs::path out = test.path() / "out";
    {
        const OutputFolder folder{out, this_run, false};
        write_whole_results(folder);  // and then an exception
    }
    EXPECT_FALSE(fs::exists(out / ".writing"));
    const OutputFolder folder{out, this_run, false};
    EXPECT_TRUE(folder.has_parts());
    EXPECT_EQ(text_of(folder.parts() / "rocks.csv"), "all rocks\n");
}

TEST(OutputFolderKept, LeavesNothingOfARunWithoutParts) {
    const TestFolder test;
    {
        const OutputFolder folder{test.path() / "out", this_run, false};
        put(folder.parts() / "rocks.csv", "some rocks\n");
        put(folder.staging() / "report.html", "a page\n");
    }
    EXPECT_FALSE(fs::exists(test.path() / "out"));
}

TEST(OutputFolderKept, RefusesAFolderInWhichARunIsAtWork) {
    const TestFolder test;
    const fs::path out = test.path() / "out";
    const OutputFolder first{out, this_run, false};
    for (const bool overwrite : {false, true}) {
        const std::string message = refusal(out, this_run, overwrite);
        EXPECT_EQ(message.substr(0, 2), "2 ") << message;
        EXPECT_NE(message.find("another run of bannwald works in this output folder"), std::string::npos);
    }
    EXPECT_TRUE(fs::exists(first.parts()));
}

TEST(OutputFolderKept, LetsShardsOfTheSameRunInAndNoOthers) {
    const TestFolder test;
    const fs::path out = test.path() / "out";
    std::optional<OutputFolder> first{std::in_place, out, this_run, false, FolderLock::Use::shared};
    std::optional<OutputFolder> second{std::in_place, out, this_run, false, FolderLock::Use::shared};
    EXPECT_THROW((OutputFolder{out, other_run, false, FolderLock::Use::shared}), config::InputError);
    EXPECT_THROW((OutputFolder{out, this_run, true, FolderLock::Use::shared}), config::InputError);
    EXPECT_NE(refusal(out, this_run), "");
    second.reset();  // has nothing, but must not delete what the first may be writing
    EXPECT_TRUE(fs::exists(first->parts()));
    first.reset();
    EXPECT_FALSE(fs::exists(out));
}

TEST(OutputFolderKept, CountsResultsWithoutAListedFileAsIncomplete) {
    const TestFolder test;
    const fs::path out = test.path() / "out";
    {
        OutputFolder folder{out, this_run, false};
        write_whole_results(folder);
        folder.publish();
    }
    EXPECT_EQ(OutputFolder::state_of(out, other_run), FolderState::other_settings);
    fs::remove(out / "report.html");
    EXPECT_EQ(OutputFolder::state_of(out, this_run), FolderState::incomplete);
    EXPECT_EQ(OutputFolder::damage(out), "report.html is missing");
    EXPECT_NE(refusal(out, this_run).find("results of which report.html is missing"), std::string::npos);
    put(out / "report.html", "another page\n");
    EXPECT_EQ(OutputFolder::damage(out), "report.html has changed");
    EXPECT_EQ(OutputFolder::state_of(out, this_run), FolderState::incomplete);
    put(out / "report.html", "a page\n");
    EXPECT_EQ(OutputFolder::damage(out), "");
    fs::remove(out / ".checksums");
    EXPECT_EQ(OutputFolder::state_of(out, this_run), FolderState::incomplete);
    put(out / "summary.json", "{ half a summ");
    EXPECT_EQ(OutputFolder::damage(out), "summary.json has changed");
}

TEST(OutputFolderKept, DoesNotFollowAMarkThatIsALink) {
    const TestFolder test;
    const fs::path out = test.path() / "out";
    put(test.path() / "mine", "my own work\n");
    put(out / "tables/trees.csv", "mine too\n");
    fs::create_symlink("../mine", out / ".bannwald");
    for (const bool overwrite : {false, true}) {
        EXPECT_EQ(refusal(out, this_run, overwrite).substr(0, 2), "3 ");
        EXPECT_EQ(text_of(test.path() / "mine"), "my own work\n");
        EXPECT_EQ(text_of(out / "tables/trees.csv"), "mine too\n");
    }
}

TEST(OutputFolderKept, AnswersPathsThatCannotBe) {
    const TestFolder test;
    EXPECT_EQ(refusal(test.path() / std::string(300, 'x'), this_run).substr(0, 2), "3 ");
    fs::create_symlink("circle", test.path() / "circle");
    EXPECT_EQ(refusal(test.path() / "circle", this_run).substr(0, 2), "3 ");
}

}  // namespace
}  // namespace coupling::output_folder_test
