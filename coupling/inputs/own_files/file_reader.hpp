#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace coupling {

/// A file that is read by plain reads, from its beginning to the length that it had when it was opened.
///
/// Not mapped into memory: a page of a mapping that the disk does not give ends the process (SIGBUS). Here a
/// read error, and a file that becomes shorter, throws config::InputError (file) naming the file.
class FileReader {
public:
    explicit FileReader(std::filesystem::path file);
    ~FileReader();
    FileReader(const FileReader&) = delete;
    FileReader& operator=(const FileReader&) = delete;

    [[nodiscard]] const std::filesystem::path& file() const { return file_; }
    [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
    [[nodiscard]] std::uint64_t place() const { return place_; }

    /// Takes the next bytes: as many as wanted, fewer only at the end of the file.
    std::size_t read(char* to, std::size_t count);
    /// Goes on at a place. Requires one within the file.
    void seek(std::uint64_t place);

private:
    [[noreturn]] void fail(const std::string& what) const;
    std::size_t read_from_disk(char* to, std::size_t count);

    std::filesystem::path file_;
    int descriptor_ = -1;
    std::uint64_t bytes_ = 0;
    std::uint64_t place_ = 0;  ///< of the next byte that `read` takes
    std::unique_ptr<char[]> waiting_;
    std::size_t first_ = 0;  ///< of the bytes that wait
    std::size_t last_ = 0;   ///< one past them
};

/// All bytes of a small file. Throws as FileReader.
std::string text_of_file(const std::filesystem::path& file);

}  // namespace coupling
