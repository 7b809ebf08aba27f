#include "coupling/run/short_run.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "config/errors/input_error.hpp"
#include "coupling/results/disk/byte_archive.hpp"
#include "coupling/results/figures/read_summary.hpp"
#include "tests/coupling/results/small_run.hpp"

namespace coupling::short_run_test {
namespace {

namespace fs = std::filesystem;
using small_runs::put;
using small_runs::TestFolder;
using small_runs::text_of;

std::ptrdiff_t entries_in(const fs::path& folder) {
    return std::distance(fs::directory_iterator{folder}, fs::directory_iterator{});
}

/// The number of a process that has ended.
pid_t ended_process() {
    const pid_t process = fork();
    if (process == 0) {
        _exit(0);
    }
    waitpid(process, nullptr, 0);
    return process;
}

/// The temporary name that another process gives.
fs::path temporary_of(const fs::path& file, pid_t process) {
    std::string name = temporary_beside(file).string();
    const std::string own = "." + std::to_string(getpid()) + ".";
    return name.replace(name.rfind(own), own.size(), "." + std::to_string(process) + ".");
}

ShortSummary summary() {
    return {.kind = "net try", .run = Json::object(), .figures = {}, .inputs = {}, .warnings = {}};
}

const std::vector<TableLayout>& layouts() {
    static const std::vector<TableLayout> all{{"one.csv", "a row", {{"n", "-", "a number", "simulated"}}}};
    return all;
}

/// Writes files of these names and publishes them.
void publish(const fs::path& folder, const std::vector<std::string>& names) {
    ShortRun results{folder};
    for (const std::string& name : names) {
        results.add(name, "what it holds", [&](std::ostream& out) { out << "of " << name; });
    }
    results.publish(summary(), layouts());
}

bool is_refused(const fs::path& folder, bool overwrite) {
    try {
        ShortRun::look_at(folder, "net try", {"one.csv", "two.csv"}, overwrite);
    } catch (const config::InputError& error) {
        EXPECT_EQ(error.code(), config::ExitCode::settings);
        return true;
    }
    return false;
}

TEST(ShortRun, PutsAllFilesInTheirPlaceWithDictionaryAndSummary) {
    const TestFolder test;
    const fs::path folder = test.path() / "new";
    {
        ShortRun results{folder};
        results.add("one.csv", "the first", [](std::ostream& out) { out << "1"; });
        results.add("two.csv", "the second", [](std::ostream& out) { out << "2"; });
        EXPECT_FALSE(fs::exists(folder / "one.csv"));
        results.publish(summary(), layouts());
    }
    EXPECT_EQ(text_of(folder / "one.csv"), "1");
    EXPECT_EQ(text_of(folder / "two.csv"), "2");
    EXPECT_EQ(entries_in(folder), 4);
    const std::vector<std::string> listed =
        files_in_summary(text_of(folder / "summary.json"), "summary.json");
    EXPECT_EQ(listed,
              (std::vector<std::string>{"one.csv", "two.csv", "data_dictionary.csv", "summary.json"}));
}

TEST(ShortRun, LeavesNothingWithoutBeingPublished) {
    const TestFolder test;
    {
        ShortRun results{test.path() / "new"};
        results.add("one.csv", "the first", [](std::ostream& out) { out << "1"; });
    }
    EXPECT_EQ(entries_in(test.path()), 0);
}

TEST(ShortRun, ReplacesItsOwnFilesOnlyAndAllOfThem) {
    const TestFolder test;
    const fs::path folder = test.path() / "mine";
    EXPECT_FALSE(is_refused(folder, false));
    publish(folder, {"one.csv", "two.csv"});
    EXPECT_TRUE(is_refused(folder, false));
    EXPECT_FALSE(is_refused(folder, true));
    put(folder / "notes.txt", "the user's");
    publish(folder, {"one.csv"});
    EXPECT_FALSE(fs::exists(folder / "two.csv")) << "of the run before";
    EXPECT_EQ(text_of(folder / "notes.txt"), "the user's");
    put(folder / "two.csv", "the user's");
    EXPECT_TRUE(is_refused(folder, true));
    EXPECT_TRUE(is_refused(folder / "notes.txt", true));
    put(test.path() / "run" / "summary.json", R"({"run": {"kind": "today"}, "files": []})");
    EXPECT_TRUE(is_refused(test.path() / "run", true)) << "results of a run are not those of this command";
}

TEST(ShortRun, FinishesWhatWasOnItsWayAndDeletesWhatWasNot) {
    const TestFolder test;
    publish(test.path(), {"one.csv", "two.csv"});
    const fs::path whole = test.path() / "whole";
    publish(whole, {"one.csv"});
    put(whole / "one.csv", "new");
    fs::rename(whole, test.path() / ".staged_whole");  // as a kill before the first move leaves it
    const fs::path left = temporary_of(test.path() / ".staged", ended_process());
    const fs::path at_work = temporary_of(test.path() / ".staged", getppid());
    put(left / "half.csv", "ha");
    put(at_work / "half.csv", "ha");
    EXPECT_FALSE(is_refused(test.path(), true));
    EXPECT_EQ(text_of(test.path() / "one.csv"), "new");
    EXPECT_FALSE(fs::exists(test.path() / "two.csv"));
    EXPECT_FALSE(fs::exists(left));
    EXPECT_TRUE(fs::exists(at_work)) << "another process is at work there";
    EXPECT_EQ(entries_in(test.path()), 4) << "one.csv, dictionary, summary, what another process writes";
}

TEST(ShortRun, LosesNoFileWhereverAMoveWasCutShort) {
    const std::vector<std::string> names{"data_dictionary.csv", "one.csv", "three.csv"};
    for (std::size_t moved = 0; moved <= names.size(); ++moved) {
        const TestFolder test;
        publish(test.path(), {"one.csv", "three.csv", "two.csv"});
        const fs::path whole = test.path() / "whole";
        publish(whole, {"one.csv", "three.csv"});
        put(whole / "one.csv", "new");
        fs::rename(whole, test.path() / ".staged_whole");
        for (std::size_t i = 0; i < moved; ++i) {
            fs::rename(test.path() / ".staged_whole" / names[i], test.path() / names[i]);
        }
        EXPECT_FALSE(is_refused(test.path(), true));
        EXPECT_EQ(text_of(test.path() / "one.csv"), "new") << moved << " moved";
        EXPECT_TRUE(fs::exists(test.path() / "three.csv")) << moved << " moved";
        EXPECT_TRUE(fs::exists(test.path() / "data_dictionary.csv")) << moved << " moved";
        EXPECT_FALSE(fs::exists(test.path() / "two.csv")) << moved << " moved";
    }
}

TEST(ShortRun, DeletesNothingOutsideItsFolder) {
    const TestFolder test;
    const fs::path folder = test.path() / "mine";
    publish(folder, {"one.csv"});
    put(test.path() / "other.csv", "the user's");
    std::string text = text_of(folder / "summary.json");
    text.replace(text.find("one.csv"), 7, "../other.csv");
    put(folder / "summary.json", text);
    publish(folder, {"two.csv"});
    EXPECT_EQ(text_of(test.path() / "other.csv"), "the user's");
}

}  // namespace
}  // namespace coupling::short_run_test
