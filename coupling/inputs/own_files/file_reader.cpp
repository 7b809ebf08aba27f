#include "coupling/inputs/own_files/file_reader.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <system_error>
#include <utility>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "coupling/inputs/own_files/system_calls.hpp"

namespace coupling {
namespace {

using config::joined;

/// Part files are read number by number; larger pieces go straight to where they are wanted.
constexpr std::size_t waiting_bytes = std::size_t{1} << 16U;

std::string last_reason() {
    return std::generic_category().message(errno);
}

}  // namespace

FileReader::FileReader(std::filesystem::path file) : file_{std::move(file)} {
    descriptor_ = repeated([&] { return ::open(file_.c_str(), O_RDONLY | O_CLOEXEC); });
    if (descriptor_ < 0) {
        fail(joined("cannot be opened: ", last_reason()));
    }
    struct stat status {};
    const bool is_known = ::fstat(descriptor_, &status) == 0;
    if (!is_known || S_ISDIR(status.st_mode)) {
        const std::string reason = is_known ? "a folder, no file" : last_reason();
        ::close(std::exchange(descriptor_, -1));
        fail(joined("cannot be read: ", reason));
    }
    bytes_ = static_cast<std::uint64_t>(status.st_size);
}

FileReader::~FileReader() {
    if (descriptor_ >= 0) {
        ::close(descriptor_);
    }
}

std::size_t FileReader::read(char* to, std::size_t count) {
    count = static_cast<std::size_t>(std::min<std::uint64_t>(count, bytes_ - place_));
    for (std::size_t done = 0; done < count;) {
        if (first_ < last_) {
            const std::size_t taken = std::min(count - done, last_ - first_);
            std::memcpy(to + done, waiting_.get() + first_, taken);
            first_ += taken;
            done += taken;
        } else if (count - done >= waiting_bytes) {
            done += read_from_disk(to + done, count - done);
        } else {
            if (!waiting_) {
                waiting_ = std::make_unique_for_overwrite<char[]>(waiting_bytes);
            }
            first_ = 0;
            last_ = read_from_disk(waiting_.get(), waiting_bytes);
        }
    }
    place_ += count;
    return count;
}

/// At least one byte.
std::size_t FileReader::read_from_disk(char* to, std::size_t count) {
    const ssize_t got = repeated([&] { return ::read(descriptor_, to, count); });
    if (got < 0) {
        fail(joined("cannot be read: ", last_reason()));
    }
    if (got == 0) {
        fail(joined("ends before the ", std::to_string(bytes_), " bytes that it had when it was opened"));
    }
    return static_cast<std::size_t>(got);
}

void FileReader::seek(std::uint64_t place) {
    if (::lseek(descriptor_, static_cast<off_t>(place), SEEK_SET) < 0) {
        fail(joined("cannot be read: ", last_reason()));
    }
    place_ = place;
    first_ = last_ = 0;
}

void FileReader::fail(const std::string& what) const {
    config::fail(config::ExitCode::file, {file_.string()}, what,
                 "a file that can be read to its end; check the disk and run the same command again");
}

std::string text_of_file(const std::filesystem::path& file) {
    FileReader reader{file};
    std::string text(static_cast<std::size_t>(reader.bytes()), '\0');
    reader.read(text.data(), text.size());
    return text;
}

}  // namespace coupling
