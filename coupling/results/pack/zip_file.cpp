#include "coupling/results/pack/zip_file.hpp"

#include <zip.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>
#include <utility>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "coupling/inputs/files/path_checks.hpp"

namespace coupling::pack {
namespace {

using config::joined;

/// 1 January 1980, the first date that zip files know: no clock in the bytes.
constexpr zip_uint16_t zip_epoch_date = 1U << 5U | 1U;
/// A plain file of Unix, rw-r--r--.
constexpr zip_uint32_t plain_file = 0100644U << 16U;

std::string opening_error(int code) {
    zip_error_t error;
    zip_error_init_with_code(&error, code);
    std::string text = zip_error_strerror(&error);
    zip_error_fini(&error);
    return text;
}

}  // namespace

struct ZipWriter::Handle {
    zip_t* zip = nullptr;
    std::vector<std::unique_ptr<std::string>> texts{};  ///< until they are packed
};

ZipWriter::ZipWriter(std::filesystem::path file)
    : file_{std::move(file)}, handle_{std::make_unique<Handle>()} {
    int code = 0;
    handle_->zip = zip_open(file_.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &code);
    if (handle_->zip == nullptr) {
        config::fail(config::ExitCode::file, {file_.string()}, opening_error(code),
                     "a file that can be written; choose another one by --out");
    }
}

ZipWriter::~ZipWriter() {
    if (handle_->zip != nullptr) {
        zip_discard(handle_->zip);
    }
}

void ZipWriter::add_text(const std::string& name, std::string text) {
    handle_->texts.push_back(std::make_unique<std::string>(std::move(text)));
    const std::string& kept = *handle_->texts.back();
    zip_source_t* source = zip_source_buffer(handle_->zip, kept.data(), kept.size(), 0);
    const zip_int64_t index =
        source == nullptr ? -1 : zip_file_add(handle_->zip, name.c_str(), source, ZIP_FL_ENC_UTF_8);
    if (index < 0) {
        config::fail(config::ExitCode::file, {file_.string()}, joined(name, ": ", zip_strerror(handle_->zip)),
                     "an entry that can be added");
    }
    const auto place = static_cast<zip_uint64_t>(index);
    zip_file_set_dostime(handle_->zip, place, 0, zip_epoch_date, 0);
    zip_file_set_external_attributes(handle_->zip, place, 0, ZIP_OPSYS_UNIX, plain_file);
    zip_set_file_compression(handle_->zip, place, ZIP_CM_DEFLATE, 6);
}

void ZipWriter::add_file(const std::string& name, const std::filesystem::path& file) {
    zip_source_t* source = zip_source_file(handle_->zip, file.c_str(), 0, -1);
    const zip_int64_t index =
        source == nullptr ? -1 : zip_file_add(handle_->zip, name.c_str(), source, ZIP_FL_ENC_UTF_8);
    if (index < 0) {
        config::fail(config::ExitCode::file, {file.string()}, zip_strerror(handle_->zip),
                     "a file that can be read");
    }
    const auto place = static_cast<zip_uint64_t>(index);
    zip_file_set_dostime(handle_->zip, place, 0, zip_epoch_date, 0);
    zip_file_set_external_attributes(handle_->zip, place, 0, ZIP_OPSYS_UNIX, plain_file);
    zip_set_file_compression(handle_->zip, place, ZIP_CM_DEFLATE, 6);
}

void ZipWriter::close() {
    if (zip_close(handle_->zip) != 0) {
        config::fail(config::ExitCode::file, {file_.string()}, zip_strerror(handle_->zip),
                     "room and permission to write it");
    }
    handle_->zip = nullptr;
}

struct ZipReader::Handle {
    zip_t* zip = nullptr;
};

ZipReader::ZipReader(std::filesystem::path file)
    : file_{std::move(file)}, handle_{std::make_unique<Handle>()} {
    if (!path_exists(file_)) {
        config::fail(config::ExitCode::file, {file_.string()}, "no such file", "an archive of bannwald pack");
    }
    int code = 0;
    handle_->zip = zip_open(file_.c_str(), ZIP_RDONLY | ZIP_CHECKCONS, &code);
    if (handle_->zip == nullptr) {
        const bool unreadable = code == ZIP_ER_OPEN || code == ZIP_ER_READ || code == ZIP_ER_SEEK;
        config::fail(unreadable ? config::ExitCode::file : config::ExitCode::data, {file_.string()},
                     opening_error(code), "a whole zip file, as bannwald pack writes it");
    }
    std::set<std::string> seen;
    const zip_int64_t count = zip_get_num_entries(handle_->zip, 0);
    for (zip_int64_t i = 0; i < count; ++i) {
        const char* name = zip_get_name(handle_->zip, static_cast<zip_uint64_t>(i), 0);
        const std::string text = name == nullptr ? "" : name;
        if (!text.empty() && text.back() == '/') {
            continue;
        }
        if (!is_safe_name(text) || !seen.insert(text).second) {
            // The destructor does not run for an object that was never made.
            zip_discard(std::exchange(handle_->zip, nullptr));
            refuse(joined("an entry ", config::in_quotes(text)), "names inside the archive, each once");
        }
        names_.push_back(text);
    }
}

ZipReader::~ZipReader() {
    if (handle_->zip != nullptr) {
        zip_discard(handle_->zip);
    }
}

void ZipReader::refuse(const std::string& found, const std::string& expected) const {
    config::fail(config::ExitCode::data, {file_.string()}, found, expected);
}

bool ZipReader::has(const std::string& name) const {
    return std::find(names_.begin(), names_.end(), name) != names_.end();
}

void ZipReader::read(const std::string& name, const std::function<void(std::string_view)>& take) const {
    zip_file_t* entry = zip_fopen(handle_->zip, name.c_str(), 0);
    if (entry == nullptr) {
        refuse(joined(config::in_quotes(name), ": ", zip_strerror(handle_->zip)), "an entry of the archive");
    }
    const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> closes{entry, zip_fclose};
    std::array<char, 1 << 16> piece{};
    for (zip_int64_t got = 0; (got = zip_fread(entry, piece.data(), piece.size())) != 0;) {
        if (got < 0) {
            refuse(joined(config::in_quotes(name), ": ", zip_file_strerror(entry)), "an undamaged entry");
        }
        take({piece.data(), static_cast<std::size_t>(got)});
    }
}

std::string ZipReader::text(const std::string& name, std::uint64_t most_bytes) const {
    std::string whole;
    read(name, [&](std::string_view piece) {
        whole += piece;
        if (whole.size() > most_bytes) {
            refuse(joined(config::in_quotes(name), " of more than ", std::to_string(most_bytes), " bytes"),
                   "an archive of bannwald pack");
        }
    });
    return whole;
}

bool is_safe_name(const std::string& name) {
    if (name.empty() || name.front() == '/' || name.find('\\') != std::string::npos ||
        name.find('\n') != std::string::npos || name.find(':') != std::string::npos) {
        return false;
    }
    const std::filesystem::path path{name};
    return std::none_of(path.begin(), path.end(),
                        [](const std::filesystem::path& part) { return part == ".." || part == "."; });
}

}  // namespace coupling::pack
