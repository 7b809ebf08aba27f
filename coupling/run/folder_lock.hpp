#pragma once

#include <filesystem>
#include <string>

namespace coupling {

/// A file of a folder that is locked while a run works there (flock). The lock ends with the process, however
/// that ends; the file stays unless it is removed.
///
/// `alone` allows nobody else. `shared` allows others that share: it begins alone if nobody else is there, so
/// that the folder can be prepared, until `share` lets others in. On disks without locks every lock is
/// granted.
class FolderLock {
public:
    enum class Use { alone, shared };

    /// Makes the file if it is missing. Throws config::InputError: (settings) if another run works there,
    /// (file) if the file cannot be opened or is no plain file; a symbolic link is not followed.
    FolderLock(std::filesystem::path file, Use use);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

    [[nodiscard]] bool made_file() const { return made_file_; }  ///< it was missing
    [[nodiscard]] bool is_alone() const { return is_alone_; }
    /// Lets others in. Throws as the constructor if a run that wants to be alone was quicker.
    void share();
    /// Whether nobody else is there; then nobody can come. Throws nothing.
    bool try_alone() noexcept;

    /// What the file holds.
    [[nodiscard]] std::string text() const;
    /// Replaces it; returns once it is on the disk. Requires is_alone().
    void write_text(const std::string& text);
    /// Deletes the file. Requires is_alone(). Reports no error.
    void remove_file() noexcept;

private:
    enum class Answer { granted, in_use };
    Answer ask(int operation) const;
    void open();
    [[nodiscard]] bool still_has_its_name() const;
    [[noreturn]] void refuse() const;
    [[noreturn]] void fail_for(const char* what, int reason) const;

    std::filesystem::path file_;
    int descriptor_ = -1;
    bool made_file_ = false;
    bool is_alone_ = false;
};

}  // namespace coupling
