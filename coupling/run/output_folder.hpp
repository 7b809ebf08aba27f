#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "coupling/run/folder_lock.hpp"

namespace coupling {

/// What a folder holds of a run, as seen without changing it.
enum class FolderState {
    nothing,          ///< no results: empty, missing or with parts of an unfinished run
    being_published,  ///< whole results that a killed run did not finish to put in their place
    finished,         ///< whole results of these settings
    incomplete,       ///< results of these settings of which files are missing or have changed
    other_settings,   ///< results of other settings, inputs or version
};

/// The folder of a run's results, from empty over parts to whole.
///
///     out/members/…     members of runs over years, kept for the next run: no result is made without them
///     out/.bannwald     the mark: a run keeps this folder, and with which settings; locked while one works
///     there out/parts/…       while the run goes on: the last checkpoint and the tables so far
///     out/.writing/…    results being written; worth nothing until they are whole
///     out/.complete/…   whole results on their way to their place: a start after a kill moves the rest
///     out/…             results, with their .checksums; summary.json comes last
///     out/.deleted/…    what is being deleted
///
/// Each step is one rename, and what it needs is on the disk before. So a kill at any moment leaves a folder
/// from which the same command goes on, or in which it only puts whole results in their place. A run that
/// ends before its first finished part leaves nothing behind.
class OutputFolder {
public:
    /// Looks at what is there and puts whole results in their place that a killed run left. Throws
    /// config::InputError (settings) for another run at work there, and for finished results or parts of
    /// other settings unless `overwrite`; then they are deleted. A folder with `tables`, `rasters` or the
    /// like that no run wrote is refused in any case. `use`: shared by the shards of one run.
    OutputFolder(std::filesystem::path folder, const std::string& settings_hash, bool overwrite,
                 FolderLock::Use use = FolderLock::Use::alone);
    ~OutputFolder();
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return folder_; }
    /// The results of these settings were whole and are now in their place: nothing is left to do.
    [[nodiscard]] bool was_completed() const { return was_completed_; }
    [[nodiscard]] bool has_parts() const { return has_parts_; }  ///< of the same settings, at the start
    [[nodiscard]] std::filesystem::path parts() const { return parts_of(folder_); }
    [[nodiscard]] std::filesystem::path checkpoint() const { return checkpoint_of(parts()); }
    [[nodiscard]] std::filesystem::path staging() const { return folder_ / ".writing"; }

    /// The same of a folder that another process keeps.
    static std::filesystem::path parts_of(const std::filesystem::path& folder) { return folder / "parts"; }
    static std::filesystem::path members_of(const std::filesystem::path& folder) {
        return folder / "members";
    }
    static std::filesystem::path checkpoint_of(const std::filesystem::path& parts) {
        return parts / "checkpoint.part";
    }

    /// What a folder holds. Results count as finished with every file that their summary.json lists, as it
    /// was when they were published (file_sums.hpp).
    static FolderState state_of(const std::filesystem::path& folder, const std::string& settings_hash);
    /// A file of finished results that is missing or has changed, in words: "report.html is missing"; "" if
    /// there is none.
    static std::string damage(const std::filesystem::path& folder);

    /// Throws config::InputError (settings) for a folder in which something lies under the name of a result
    /// that no run wrote, and for a file.
    static void refuse_foreign(const std::filesystem::path& folder);

    /// Moves whole results from the staging folder to their place and deletes the parts. Returns once they
    /// are on the disk. Throws config::InputError (file); nothing is lost then: the same command goes on.
    void publish();

private:
    void prepare(const std::string& settings_hash, bool overwrite);
    void join(const std::string& settings_hash, bool overwrite);
    void refuse_results_and_other_parts(const std::string& settings_hash);
    void take_over(const std::string& settings_hash);
    void move_results_to_their_place();
    void set_aside_results();
    void set_aside(const std::filesystem::path& name);
    void delete_set_aside();
    void tidy_up() noexcept;
    [[nodiscard]] std::filesystem::path complete() const { return folder_ / ".complete"; }
    [[nodiscard]] std::filesystem::path deleted() const { return folder_ / ".deleted"; }

    std::filesystem::path folder_;
    bool existed_ = false;
    std::optional<FolderLock> lock_;  ///< of the mark
    bool has_parts_ = false;
    bool was_completed_ = false;
};

/// Prints that the results of an earlier start are in their place now.
void print_completed(const OutputFolder& folder);

}  // namespace coupling
