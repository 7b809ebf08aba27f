#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <string_view>

#include "coupling/inputs/own_files/table_count.hpp"
#include "coupling/results/disk/checksum.hpp"

namespace coupling {

/// A file of a run's results and one sentence on what it holds.
struct WrittenFile {
    std::string path;  ///< relative to the folder of the results, with slashes
    std::string sentence;
    std::optional<TableEnd> end{};  ///< of a table, as its writer counted
};

/// Tables that were written elsewhere and move to the results when these are whole.
struct StreamedTables {
    std::span<const WrittenFile> files;
    std::filesystem::path folder;  ///< where they lie now

    /// Of a table by the name of its file; nothing if it is none of these.
    [[nodiscard]] std::optional<TableEnd> end_of(std::string_view name) const;
};

/// A file being written: opened, filled, closed and checked.
///
/// A file that cannot be opened or filled (folder missing, no permission, disk full) throws
/// config::InputError (file) naming it. `close` reports whether the system took all bytes; without it the
/// file counts as unfinished. `sync` reports whether they have reached the disk.
class OutFile {
public:
    enum class Begin { empty, at_end };  ///< at_end: goes on with a file that is there
    explicit OutFile(std::filesystem::path file, Begin begin = Begin::empty);
    ~OutFile();
    OutFile(const OutFile&) = delete;
    OutFile& operator=(const OutFile&) = delete;

    [[nodiscard]] std::ostream& stream() { return stream_; }
    [[nodiscard]] const std::filesystem::path& file() const { return file_; }

    /// From now on bytes and rows of a table are counted, going on from those that the file holds.
    void count_table(const TableEnd& so_far);
    void count_table();
    /// From now on a checksum of all bytes is kept, going on from the sum of those that the file holds.
    void keep_sum(const Checksum& so_far);

    /// Throws if anything written so far was lost: to stop a long run early.
    void check();
    /// Hands everything written so far to the system. Afterwards, and after `close`,
    /// `sum` and `end` are those of the whole file.
    void flush();
    [[nodiscard]] std::uint64_t sum() const;
    /// Nothing unless the table is counted.
    [[nodiscard]] std::optional<TableEnd> end() const;
    /// Flushes and returns once everything written so far is on the disk.
    void sync();
    void close();

private:
    class Buffer;
    [[noreturn]] void fail(const std::string& what) const;

    std::filesystem::path file_;
    std::unique_ptr<Buffer> buffer_;
    std::ostream stream_;
};

/// Writes tables/NAME of a folder, which has to exist. Throws config::InputError (file) as OutFile does.
WrittenFile write_table(const std::filesystem::path& folder, const std::string& name, std::string sentence,
                        const std::function<void(std::ostream&)>& fill);

/// Makes a folder and those above it. Throws config::InputError (file) naming it.
void make_folder(const std::filesystem::path& folder);

/// Deletes a file or a folder with all in it. Throws config::InputError (file) naming it.
void delete_entry(const std::filesystem::path& entry);

}  // namespace coupling
