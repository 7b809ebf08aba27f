#pragma once

#include <filesystem>
#include <string>

namespace coupling::validation {

/// The folder of a validation's results: written to a place of their own, there all at once.
class ResultFolder {
public:
    /// Looks at what is there and makes sure that it can be written. Results of an earlier validation throw
    /// InputError (settings) unless `overwrite`; files of the same names that no validation wrote always do.
    ResultFolder(std::filesystem::path folder, bool overwrite);
    /// Removes what an unfinished validation leaves.
    ~ResultFolder();
    ResultFolder(const ResultFolder&) = delete;
    ResultFolder& operator=(const ResultFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return folder_; }
    [[nodiscard]] std::filesystem::path staging() const { return folder_ / ".writing"; }

    /// Moves whole results from the staging folder to their place and deletes those of before.
    void publish();

private:
    std::filesystem::path folder_;
    bool existed_ = false;
    bool was_ours_ = false;
    bool published_ = false;
};

}  // namespace coupling::validation
