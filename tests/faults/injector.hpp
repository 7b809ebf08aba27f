#pragma once

#include <sys/types.h>

#include <map>
#include <mutex>
#include <string>
#include <utility>

namespace faults {

/// How things go wrong; see disk_faults.cpp.
enum class Mode { count, count_all, kill, tear, power, eio, enospc, term, unread, eintr };

/// What happens to one operation.
enum class Fate { as_usual, half, fails };

/// What an operation does: only some of them need space, only a write can be torn, a read changes nothing.
enum class Kind { other, makes, writes, reads };

/// Counts the operations of this process below a folder and decides what happens to each.
class Injector {
public:
    /// From the environment. Lives as long as the process: files may be closed after everything else.
    static Injector& of_process();

    [[nodiscard]] bool sees(const std::string& path) const;
    /// Reads are counted for the faults that concern them only: the numbers of changes stay what they are.
    [[nodiscard]] bool counts_reads() const {
        return mode_ == Mode::count_all || mode_ == Mode::unread || mode_ == Mode::eintr;
    }

    /// The next operation, on a path. Where it fails, errno says why. Does not return where the process dies.
    Fate next(const char* name, Kind kind, const std::string& path);

    [[nodiscard]] bool tears() const { return mode_ == Mode::tear; }
    [[noreturn]] static void die();

    /// Asks the process to terminate if that is wanted before its first operation.
    void begin() const;

    /// A file was opened for writing: until the next fsync only what it holds now is safe.
    void opened(int descriptor);
    /// What a file holds now is safe.
    void synced(int descriptor);
    /// A file is about to be deleted: a new one may get its number.
    void forget(const std::string& path);

private:
    /// Device and inode.
    using Identity = std::pair<dev_t, ino_t>;

    Injector();
    [[nodiscard]] bool disturbs(long number, Kind kind) const;
    void log(long number, const char* name, bool disturbed, const std::string& path) const;
    void lose_unsynced() const;

    [[nodiscard]] int reason() const;

    std::string folder_;
    std::string read_folder_;
    std::string mode_word_;
    Mode mode_;
    long at_;
    int log_;
    std::mutex mutex_;
    long count_ = 0;
    std::map<Identity, off_t> safe_bytes_;
};

}  // namespace faults
