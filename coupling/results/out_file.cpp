#include "coupling/results/out_file.hpp"

#include <cerrno>
#include <system_error>
#include <utility>

#include "config/errors/input_error.hpp"

namespace coupling {
namespace {

constexpr std::size_t buffer_bytes = 1 << 18;

}  // namespace

OutFile::OutFile(std::filesystem::path file, Begin begin) : file_{std::move(file)}, buffer_(buffer_bytes) {
    stream_.rdbuf()->pubsetbuf(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    errno = 0;
    stream_.open(file_, std::ios::binary | (begin == Begin::anew ? std::ios::trunc : std::ios::app));
    if (!stream_) {
        fail("cannot be opened for writing");
    }
}

void OutFile::check() {
    if (!stream_) {
        fail("cannot be written");
    }
}

void OutFile::close() {
    check();
    errno = 0;
    stream_.close();
    if (!stream_) {
        fail("cannot be written");
    }
}

void OutFile::fail(const std::string& what) const {
    const int reason = errno;
    const std::string because = reason == 0 ? "" : ": " + std::generic_category().message(reason);
    config::fail(config::ExitCode::file, {.file = file_.string()}, what + because);
}

WrittenFile write_table(const std::filesystem::path& folder, const std::string& name, std::string sentence,
                        const std::function<void(std::ostream&)>& fill) {
    OutFile file{folder / "tables" / name};
    fill(file.stream());
    file.close();
    return {"tables/" + name, std::move(sentence)};
}

void make_folder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) {
        config::fail(config::ExitCode::file, {.file = folder.string()}, "cannot be made: " + error.message());
    }
}

void delete_entry(const std::filesystem::path& entry) {
    std::error_code error;
    std::filesystem::remove_all(entry, error);
    if (error) {
        config::fail(config::ExitCode::file, {entry.string()}, "cannot be deleted: " + error.message());
    }
}

}  // namespace coupling
