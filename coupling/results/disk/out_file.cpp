#include "coupling/results/disk/out_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <memory>
#include <optional>
#include <streambuf>
#include <system_error>
#include <utility>

#include "config/errors/input_error.hpp"
#include "coupling/inputs/own_files/system_calls.hpp"

namespace coupling {
namespace {

constexpr std::size_t out_buffer_bytes = 1 << 18;

}  // namespace

/// Bytes on their way to a file. Keeps the first error: later calls may fail for another reason.
class OutFile::Buffer : public std::streambuf {
public:
    Buffer(const std::filesystem::path& file, Begin begin)
        : waiting_{std::make_unique_for_overwrite<char[]>(out_buffer_bytes)} {
        const int flags = O_WRONLY | O_CREAT | O_CLOEXEC | (begin == Begin::empty ? O_TRUNC : O_APPEND);
        descriptor_ = repeated([&] { return ::open(file.c_str(), flags, 0666); });
        remember_error(descriptor_);
        setp(waiting_.get(), waiting_.get() + out_buffer_bytes);
    }
    ~Buffer() override {
        if (descriptor_ >= 0) {
            write_waiting();  // what is not closed is unfinished anyway: no error is reported here
            ::close(descriptor_);
        }
    }
    Buffer(const Buffer&) = delete;
    Buffer& operator=(const Buffer&) = delete;

    [[nodiscard]] bool is_open() const { return descriptor_ >= 0; }
    [[nodiscard]] int error() const { return error_; }
    [[nodiscard]] const std::optional<Checksum>& kept_sum() const { return sum_; }
    void keep_sum(const Checksum& so_far) { sum_ = so_far; }
    [[nodiscard]] const std::optional<TableCount>& table() const { return table_; }
    void count_table(const TableCount& so_far) { table_ = so_far; }

    bool write_waiting() {
        const char* from = pbase();
        while (error_ == 0 && from < pptr()) {
            const ssize_t count =
                repeated([&] { return ::write(descriptor_, from, static_cast<std::size_t>(pptr() - from)); });
            if (count <= 0) {
                error_ = count < 0 ? errno : EIO;  // a write that takes nothing would never end
                break;
            }
            if (sum_) {
                sum_->add(from, static_cast<std::size_t>(count));
            }
            if (table_) {
                table_->add(from, static_cast<std::size_t>(count));
            }
            from += count;
        }
        setp(waiting_.get(), waiting_.get() + out_buffer_bytes);
        return error_ == 0;
    }
    bool sync_to_disk() {
        if (write_waiting()) {
            remember_error(repeated([&] { return ::fsync(descriptor_); }));
        }
        return error_ == 0;
    }
    bool close() {
        write_waiting();
        if (descriptor_ >= 0) {
            const int result = ::close(std::exchange(descriptor_, -1));
            // Interrupted, yet closed: what is published is synchronised once more, and says what was lost.
            remember_error(result < 0 && errno == EINTR ? 0 : result);
        }
        return error_ == 0;
    }

private:
    void remember_error(int result) {
        if (result < 0 && error_ == 0) {
            error_ = errno;
        }
    }
    int_type overflow(int_type letter) override {
        if (descriptor_ < 0 || !write_waiting()) {
            return traits_type::eof();
        }
        if (!traits_type::eq_int_type(letter, traits_type::eof())) {
            *pptr() = traits_type::to_char_type(letter);
            pbump(1);
        }
        return traits_type::not_eof(letter);
    }
    int sync() override { return descriptor_ >= 0 && write_waiting() ? 0 : -1; }

    /// Not filled with zeros: a run writes hundreds of small files.
    std::unique_ptr<char[]> waiting_;
    std::optional<Checksum> sum_;
    std::optional<TableCount> table_;
    int descriptor_ = -1;
    int error_ = 0;
};

OutFile::OutFile(std::filesystem::path file, Begin begin)
    : file_{std::move(file)}, buffer_{std::make_unique<Buffer>(file_, begin)}, stream_{buffer_.get()} {
    if (!buffer_->is_open()) {
        fail("cannot be opened for writing");
    }
}

OutFile::~OutFile() = default;

void OutFile::count_table() {
    flush();
    buffer_->count_table(TableCount{});
}

void OutFile::count_table(const TableEnd& so_far) {
    flush();
    buffer_->count_table(TableCount{so_far});
}

void OutFile::keep_sum(const Checksum& so_far) {
    flush();
    buffer_->keep_sum(so_far);
}

void OutFile::check() {
    if (!stream_) {
        fail("cannot be written");
    }
}

void OutFile::flush() {
    stream_.flush();
    check();
}

std::uint64_t OutFile::sum() const {
    return buffer_->kept_sum().value_or(Checksum{}).value();
}

std::optional<TableEnd> OutFile::end() const {
    return buffer_->table() ? std::optional{buffer_->table()->end()} : std::nullopt;
}

void OutFile::sync() {
    check();
    if (!buffer_->sync_to_disk()) {
        fail("cannot be written to the disk");
    }
}

void OutFile::close() {
    check();
    if (!buffer_->close()) {
        fail("cannot be written");
    }
}

void OutFile::fail(const std::string& what) const {
    const int reason = buffer_->error();
    const std::string because = reason == 0 ? "" : ": " + std::generic_category().message(reason);
    config::fail(config::ExitCode::file, {.file = file_.string()}, what + because);
}

std::optional<TableEnd> StreamedTables::end_of(std::string_view name) const {
    const auto found = std::find_if(files.begin(), files.end(), [&](const WrittenFile& file) {
        return std::filesystem::path{file.path}.filename() == name;
    });
    return found == files.end() ? std::nullopt : found->end;
}

WrittenFile write_table(const std::filesystem::path& folder, const std::string& name, std::string sentence,
                        const std::function<void(std::ostream&)>& fill) {
    OutFile file{folder / "tables" / name};
    file.count_table();
    fill(file.stream());
    file.close();
    return {"tables/" + name, std::move(sentence), file.end()};
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
