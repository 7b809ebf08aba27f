#include "coupling/run/folder_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <system_error>
#include <thread>
#include <utility>

#include "config/errors/input_error.hpp"
#include "coupling/inputs/own_files/system_calls.hpp"

namespace coupling {
namespace {

/// How long those who share wait for one that prepares the folder alone.
constexpr std::chrono::seconds longest_preparation{30};
constexpr std::chrono::milliseconds between_looks{20};

int open_plain(const std::filesystem::path& file, int making) {
    return repeated([&] { return ::open(file.c_str(), O_RDWR | O_NOFOLLOW | O_CLOEXEC | making, 0666); });
}

}  // namespace

FolderLock::FolderLock(std::filesystem::path file, Use use) : file_{std::move(file)} {
    const auto latest = std::chrono::steady_clock::now() + longest_preparation;
    try {
        while (true) {
            open();
            is_alone_ = ask(LOCK_EX) == Answer::granted;
            const bool granted = is_alone_ || (use == Use::shared && ask(LOCK_SH) == Answer::granted);
            // Whoever was here before may have deleted the file: then the lock is one on nothing.
            if (granted && still_has_its_name()) {
                return;
            }
            ::close(std::exchange(descriptor_, -1));
            if (!granted) {
                if (use == Use::alone || std::chrono::steady_clock::now() > latest) {
                    refuse();
                }
                std::this_thread::sleep_for(between_looks);
            }
        }
    } catch (...) {
        if (descriptor_ >= 0) {
            ::close(descriptor_);
        }
        throw;
    }
}

FolderLock::~FolderLock() {
    ::close(descriptor_);
}

void FolderLock::open() {
    descriptor_ = open_plain(file_, 0);
    if (descriptor_ < 0 && errno == ENOENT) {
        descriptor_ = open_plain(file_, O_CREAT | O_EXCL);
        made_file_ = descriptor_ >= 0;
        if (descriptor_ < 0 && errno == EEXIST) {  // another one has made it in the meantime
            descriptor_ = open_plain(file_, 0);
        }
    }
    if (descriptor_ < 0 && errno == ELOOP) {
        config::fail(
            config::ExitCode::file, {file_.string()}, "a symbolic link",
            "a plain file that a run has written; delete the link, or choose another folder by --out");
    }
    if (descriptor_ < 0) {
        fail_for("cannot be opened for writing", errno);
    }
}

FolderLock::Answer FolderLock::ask(int operation) const {
    while (repeated([&] { return ::flock(descriptor_, operation | LOCK_NB); }) != 0) {
        if (errno == EWOULDBLOCK) {
            return Answer::in_use;
        }
        // Disks of clusters that keep no locks.
        if (errno == ENOLCK || errno == ENOSYS || errno == ENOTSUP) {
            return Answer::granted;
        }
        fail_for("cannot be locked", errno);
    }
    return Answer::granted;
}

bool FolderLock::still_has_its_name() const {
    struct stat opened {};
    struct stat named {};
    if (::fstat(descriptor_, &opened) != 0) {
        fail_for("cannot be examined", errno);
    }
    if (::lstat(file_.c_str(), &named) != 0) {
        if (errno == ENOENT) {
            return false;
        }
        fail_for("cannot be examined", errno);
    }
    return opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

void FolderLock::share() {
    is_alone_ = false;
    if (ask(LOCK_SH) == Answer::in_use) {
        refuse();
    }
}

bool FolderLock::try_alone() noexcept {
    if (!is_alone_) {
        is_alone_ = repeated([&] { return ::flock(descriptor_, LOCK_EX | LOCK_NB); }) == 0;
    }
    return is_alone_;
}

std::string FolderLock::text() const {
    std::string text;
    std::array<char, 4096> block{};
    while (true) {
        const ssize_t count = repeated([&] {
            return ::pread(descriptor_, block.data(), block.size(), static_cast<off_t>(text.size()));
        });
        if (count < 0) {
            fail_for("cannot be read", errno);
        }
        if (count == 0) {
            return text;
        }
        text.append(block.data(), static_cast<std::size_t>(count));
    }
}

void FolderLock::write_text(const std::string& text) {
    std::size_t done = 0;
    while (done < text.size()) {
        const ssize_t count = repeated([&] {
            return ::pwrite(descriptor_, text.data() + done, text.size() - done, static_cast<off_t>(done));
        });
        if (count <= 0) {
            fail_for("cannot be written", count < 0 ? errno : EIO);
        }
        done += static_cast<std::size_t>(count);
    }
    if (repeated([&] { return ::ftruncate(descriptor_, static_cast<off_t>(text.size())); }) != 0 ||
        repeated([&] { return ::fsync(descriptor_); }) != 0) {
        fail_for("cannot be written to the disk", errno);
    }
}

void FolderLock::remove_file() noexcept {
    ::unlink(file_.c_str());
}

void FolderLock::refuse() const {
    config::fail(config::ExitCode::settings, {file_.parent_path().string()},
                 "another run of bannwald works in this output folder",
                 "one run in a folder; wait until it has ended, or choose another folder by --out");
}

void FolderLock::fail_for(const char* what, int reason) const {
    config::fail(config::ExitCode::file, {file_.string()},
                 std::string{what} + ": " + std::generic_category().message(reason));
}

}  // namespace coupling
