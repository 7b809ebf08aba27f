#include "tests/faults/injector.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>

namespace faults {
namespace {

namespace fs = std::filesystem;

std::string text_of(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
}

Mode mode_of(const std::string& word) {
    const std::map<std::string, Mode> modes{
        {"kill", Mode::kill},     {"tear", Mode::tear},     {"power", Mode::power},
        {"eio", Mode::eio},       {"enospc", Mode::enospc}, {"term", Mode::term},
        {"unread", Mode::unread}, {"eintr", Mode::eintr},   {"count_all", Mode::count_all}};
    const auto found = modes.find(word);
    return found == modes.end() ? Mode::count : found->second;
}

int open_log() {
    const std::string file = text_of("BANNWALD_FAULT_LOG");
    return file.empty() ? -1
                        : static_cast<int>(syscall(SYS_openat, AT_FDCWD, file.c_str(),
                                                   O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644));
}

bool lies_in(const std::string& path, const std::string& folder) {
    return !folder.empty() && (path == folder || (path.starts_with(folder) && path[folder.size()] == '/'));
}

void terminate_softly() {
    syscall(SYS_kill, getpid(), SIGTERM);
}

}  // namespace

Injector& Injector::of_process() {
    static Injector& only = *new Injector;
    return only;
}

Injector::Injector()
    : folder_{text_of("BANNWALD_FAULT_FOLDER")},
      read_folder_{text_of("BANNWALD_FAULT_READ_FOLDER")},
      mode_word_{text_of("BANNWALD_FAULT_MODE")},
      mode_{mode_of(mode_word_)},
      at_{std::atol(text_of("BANNWALD_FAULT_AT").c_str())},
      log_{open_log()} {}

bool Injector::sees(const std::string& path) const {
    return lies_in(path, folder_);
}

bool Injector::disturbs(long number, Kind kind) const {
    switch (mode_) {
        case Mode::count:
        case Mode::count_all:
            return false;
        case Mode::unread:
            return number == at_ && kind == Kind::reads;
        case Mode::tear:
            return number == at_ && kind == Kind::writes;
        case Mode::enospc:
            return number >= at_ && kind != Kind::other;
        default:
            return number == at_;
    }
}

Fate Injector::next(const char* name, Kind kind, const std::string& path) {
    const bool is_read = kind == Kind::reads;
    if (is_read ? !counts_reads() || !lies_in(path, read_folder_) : !sees(path)) {
        return Fate::as_usual;
    }
    const std::lock_guard lock{mutex_};
    const long number = ++count_;
    const bool disturbed = disturbs(number, kind);
    log(number, name, disturbed, path);
    if (!disturbed) {
        return Fate::as_usual;
    }
    if (mode_ == Mode::term) {
        terminate_softly();
        return Fate::as_usual;
    }
    if (mode_ == Mode::power) {
        lose_unsynced();
    }
    if (mode_ == Mode::kill || mode_ == Mode::power) {
        die();
    }
    errno = reason();
    const bool halves = mode_ == Mode::tear || mode_ == Mode::enospc;
    return kind == Kind::writes && number == at_ && halves ? Fate::half : Fate::fails;
}

/// Why an operation fails.
int Injector::reason() const {
    switch (mode_) {
        case Mode::eio:
        case Mode::unread:
            return EIO;
        case Mode::eintr:
            return EINTR;
        default:
            return ENOSPC;
    }
}

void Injector::die() {
    syscall(SYS_kill, getpid(), SIGKILL);
    while (true) {
        pause();
    }
}

void Injector::begin() const {
    if (mode_ == Mode::term && at_ == 0) {
        terminate_softly();
    }
}

void Injector::opened(int descriptor) {
    struct stat status {};
    if (mode_ == Mode::power && fstat(descriptor, &status) == 0) {
        const std::lock_guard lock{mutex_};
        const auto [known, is_new] = safe_bytes_.try_emplace({status.st_dev, status.st_ino}, status.st_size);
        if (!is_new && status.st_size < known->second) {
            known->second = status.st_size;
        }
    }
}

void Injector::synced(int descriptor) {
    struct stat status {};
    if (mode_ == Mode::power && fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode)) {
        const std::lock_guard lock{mutex_};
        safe_bytes_[{status.st_dev, status.st_ino}] = status.st_size;
    }
}

void Injector::forget(const std::string& path) {
    struct stat status {};
    if (mode_ == Mode::power && lstat(path.c_str(), &status) == 0 && status.st_nlink == 1) {
        const std::lock_guard lock{mutex_};
        safe_bytes_.erase({status.st_dev, status.st_ino});
    }
}

void Injector::log(long number, const char* name, bool disturbed, const std::string& path) const {
    const std::string line =
        std::to_string(number) + ' ' + name + ' ' + (disturbed ? mode_word_ : "ok") + ' ' + path + '\n';
    if (log_ >= 0) {
        syscall(SYS_write, log_, line.data(), line.size());
    }
}

void Injector::lose_unsynced() const {
    std::error_code ignored;
    for (fs::recursive_directory_iterator entry{folder_, ignored}, end; entry != end;
         entry.increment(ignored)) {
        struct stat status {};
        if (lstat(entry->path().c_str(), &status) != 0 || !S_ISREG(status.st_mode)) {
            continue;
        }
        const auto known = safe_bytes_.find({status.st_dev, status.st_ino});
        if (known != safe_bytes_.end() && known->second < status.st_size) {
            syscall(SYS_truncate, entry->path().c_str(), known->second);
        }
    }
}

}  // namespace faults
