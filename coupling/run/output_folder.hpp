#pragma once

#include <filesystem>
#include <string>

namespace coupling {

/// The folder of a run's results, from empty over parts to whole.
///
///     out/parts/…        while the run goes on: the last checkpoint and the tables so far
///     out/.writing/…     results being written
///     out/…              results, all at once, when they are whole
///
/// A run that ends before its first finished part leaves nothing behind.
class OutputFolder {
public:
    /// Looks at what is there. Finished results, or parts of other settings, throw config::InputError
    /// (settings) unless `overwrite`; then they are deleted. A folder with `tables`, `rasters` or the like
    /// that no run wrote is refused in any case.
    OutputFolder(std::filesystem::path folder, const std::string& settings_hash, bool overwrite);
    ~OutputFolder();
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return folder_; }
    [[nodiscard]] bool has_parts() const { return has_parts_; }  ///< of the same settings, at the start
    [[nodiscard]] std::filesystem::path parts() const { return parts_of(folder_); }
    [[nodiscard]] std::filesystem::path checkpoint() const { return checkpoint_of(parts()); }
    [[nodiscard]] std::filesystem::path staging() const { return folder_ / ".writing"; }

    /// The same of a folder that another process keeps.
    static std::filesystem::path parts_of(const std::filesystem::path& folder) { return folder / "parts"; }
    static std::filesystem::path checkpoint_of(const std::filesystem::path& parts) {
        return parts / "checkpoint.part";
    }

    /// Whether a folder holds finished results of these settings.
    static bool is_finished(const std::filesystem::path& folder, const std::string& settings_hash);

    /// Throws config::InputError (settings) for a folder in which something lies under the name of a result
    /// that no run wrote, and for a file.
    static void refuse_foreign(const std::filesystem::path& folder);

    /// Moves whole results from the staging folder to their place and deletes the parts.
    void publish();

private:
    void delete_results() const;

    std::filesystem::path folder_;
    bool existed_ = false;
    bool has_parts_ = false;
    bool published_ = false;
};

}  // namespace coupling
