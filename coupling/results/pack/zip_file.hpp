#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

// The one seam over libzip.

namespace coupling::pack {

/// A zip file being written: the same entries in the same order give the same bytes, on any day and in any
/// time zone.
class ZipWriter {
public:
    /// Throws config::InputError (file) if it cannot be made.
    explicit ZipWriter(std::filesystem::path file);
    ~ZipWriter();
    ZipWriter(const ZipWriter&) = delete;
    ZipWriter& operator=(const ZipWriter&) = delete;

    void add_text(const std::string& name, std::string text);
    /// The file has to stay as it is until `close`.
    void add_file(const std::string& name, const std::filesystem::path& file);
    /// Packs all entries. Throws config::InputError (file).
    void close();

private:
    struct Handle;
    std::filesystem::path file_;
    std::unique_ptr<Handle> handle_;
};

/// A zip file that is there. Its content is read in pieces and never trusted.
class ZipReader {
public:
    /// Throws config::InputError: (file) for a file that is missing or unreadable, (data) for what is no zip
    /// file, for names that leave its folder and for names that come twice.
    explicit ZipReader(std::filesystem::path file);
    ~ZipReader();
    ZipReader(const ZipReader&) = delete;
    ZipReader& operator=(const ZipReader&) = delete;

    /// All entries in the order of the file; folders are left out.
    [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
    [[nodiscard]] bool has(const std::string& name) const;
    /// Calls `take` with the pieces of an entry. Throws config::InputError (data) for a damaged one.
    void read(const std::string& name, const std::function<void(std::string_view)>& take) const;
    /// A whole entry of at most so many bytes. Throws config::InputError (data) for a larger one.
    [[nodiscard]] std::string text(const std::string& name, std::uint64_t most_bytes) const;

private:
    struct Handle;
    [[noreturn]] void refuse(const std::string& found, const std::string& expected) const;
    std::filesystem::path file_;
    std::unique_ptr<Handle> handle_;
    std::vector<std::string> names_;
};

/// Whether a name stays inside the folder into which an archive is unpacked.
bool is_safe_name(const std::string& name);

}  // namespace coupling::pack
