#pragma once

#include <filesystem>
#include <fstream>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace coupling {

/// A file of a run's results and one sentence on what it holds.
struct WrittenFile {
    std::string path;  ///< relative to the folder of the results, with slashes
    std::string sentence;
};

/// A file being written: opened, filled, closed and checked.
///
/// A file that cannot be opened or filled (folder missing, no permission, disk full) throws
/// config::InputError (file) naming it. Only `close` can tell that all bytes have reached the disk; without
/// it the file counts as unfinished.
class OutFile {
public:
    enum class Begin { anew, at_end };  ///< at_end: goes on with a file that is there
    explicit OutFile(std::filesystem::path file, Begin begin = Begin::anew);
    OutFile(const OutFile&) = delete;
    OutFile& operator=(const OutFile&) = delete;

    [[nodiscard]] std::ostream& stream() { return stream_; }
    [[nodiscard]] const std::filesystem::path& file() const { return file_; }

    /// Throws if anything written so far was lost: to stop a long run early.
    void check();
    void close();

private:
    [[noreturn]] void fail(const std::string& what) const;

    std::filesystem::path file_;
    std::vector<char> buffer_;
    std::ofstream stream_;
};

/// Writes tables/NAME of a folder, which has to exist. Throws config::InputError (file) as OutFile does.
WrittenFile write_table(const std::filesystem::path& folder, const std::string& name, std::string sentence,
                        const std::function<void(std::ostream&)>& fill);

/// Makes a folder and those above it. Throws config::InputError (file) naming it.
void make_folder(const std::filesystem::path& folder);

/// Deletes a file or a folder with all in it. Throws config::InputError (file) naming it.
void delete_entry(const std::filesystem::path& entry);

}  // namespace coupling
