#pragma once

#include <filesystem>

namespace coupling {

/// The files of a short command, whole or not at all: written aside in a folder of their own below the one
/// that they belong to, then moved to their place.
///
/// A command that is killed before leaves nothing under a final name; one that is killed while files move is
/// finished by the next one (`tidy`).
class StagedFolder {
public:
    /// Makes the folder if it is missing. Throws config::InputError (file).
    explicit StagedFolder(std::filesystem::path folder);
    /// Deletes what was not published, and the folder if it was missing before.
    ~StagedFolder();
    StagedFolder(const StagedFolder&) = delete;
    StagedFolder& operator=(const StagedFolder&) = delete;

    /// Where the files are to be written; no folders below it.
    [[nodiscard]] const std::filesystem::path& path() const { return stage_; }
    /// Moves the files to their place; files of the same names are replaced. Returns once they are on the
    /// disk.
    void publish();

    /// Finishes or deletes what killed commands left in a folder: before anybody asks what it holds.
    static void tidy(const std::filesystem::path& folder);

private:
    std::filesystem::path folder_;
    std::filesystem::path stage_;
    bool existed_;
};

}  // namespace coupling
