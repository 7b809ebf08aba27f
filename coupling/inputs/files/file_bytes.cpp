#include "coupling/inputs/files/file_bytes.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "config/grid/ascii_grid.hpp"
#include "config/text/gunzip.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/inputs/formats/file_kinds.hpp"
#include "coupling/inputs/own_files/file_reader.hpp"

namespace coupling {

namespace {

constexpr const char* a_folder = "a folder,";

/// Why a file cannot be opened for reading, "" if it can.
std::string reason_against(const std::filesystem::path& path) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (status.type() == std::filesystem::file_type::not_found) {
        return "no file";
    }
    if (error) {
        return error.message() + ":";
    }
    if (status.type() == std::filesystem::file_type::directory) {
        return a_folder;
    }
    if (access(path.c_str(), R_OK) != 0) {
        return std::string{std::strerror(errno)} + ":";
    }
    return status.type() == std::filesystem::file_type::regular ? "" : "no ordinary file:";
}

/// The most that a packed file may unpack to. A grid says by its header how large it is; above 2 GiB [choice]
/// it has to be unpacked first, as packed text is held in memory.
std::uint64_t unpacked_bound(std::string_view beginning) {
    constexpr std::uint64_t most_of_grid = std::uint64_t{2} << 30U;
    const auto of_grid = config::most_grid_bytes(beginning);
    return of_grid ? std::min(*of_grid, most_of_grid) : config::most_unpacked_bytes;
}

}  // namespace

std::uint64_t fnv1a(std::string_view bytes) {
    std::uint64_t hash = 0xCBF29CE484222325ULL;
    for (const char c : bytes) {
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3ULL;
    }
    return hash;
}

std::string FileBytes::hash() const {
    return hash_text(stored_);
}

std::string hash_text(std::string_view bytes) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::uint64_t value = fnv1a(bytes);
    std::string text(16, '0');
    for (auto digit = text.rbegin(); digit != text.rend(); ++digit, value >>= 4U) {
        *digit = digits[value & 0xFU];
    }
    return text;
}

void check_readable(const std::filesystem::path& path, const config::Place& asked_at,
                    std::string_view expected) {
    const std::string reason = reason_against(path);
    const formats::FileKind* kind = formats::folder_kind(path.string());
    if (reason == a_folder && kind != nullptr) {
        config::fail(config::ExitCode::file, asked_at,
                     std::string{kind->name}.append(", ").append(path_in_quotes(path)), std::string{expected},
                     std::string{kind->way_out});
    }
    if (!reason.empty()) {
        config::fail(config::ExitCode::file, asked_at, reason + " " + path_in_quotes(path),
                     std::string{expected}, advice_on_missing(path));
    }
}

FileBytes open_file(const std::filesystem::path& path, const config::Place& asked_at,
                    std::string_view expected) {
    check_readable(path, asked_at, expected);
    FileReader in{path};
    FileBytes bytes;
    const auto stored = std::make_shared_for_overwrite<char[]>(static_cast<std::size_t>(in.bytes()));
    bytes.stored_ = {stored.get(), in.read(stored.get(), static_cast<std::size_t>(in.bytes()))};
    bytes.memory_ = stored;
    bytes.is_packed_ = config::is_gzip(bytes.stored_);
    if (bytes.is_packed_) {
        bytes.unpacked_ = config::gunzip(bytes.stored_, path.string(), unpacked_bound);
    }
    return bytes;
}

}  // namespace coupling
