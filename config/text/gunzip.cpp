#include "config/text/gunzip.hpp"

#include <algorithm>
#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#include <optional>

#include "config/errors/input_error.hpp"
#include "config/text/numbers.hpp"

namespace config {

namespace {

constexpr std::size_t piece_bytes = std::size_t{64} << 10U;

/// A byte of gzip holds at most so many bytes of content (RFC 1951: a match of 258 bytes takes two bits).
constexpr std::uint64_t most_bytes_per_packed_byte = 1032;

/// "512 MB".
std::string megabytes(std::uint64_t bytes) {
    const std::uint64_t rounded = std::max<std::uint64_t>((bytes + 500'000) / 1'000'000, 1);
    return std::to_string(rounded) + " MB";
}

[[noreturn]] void refuse_size(const std::string& file, std::uint64_t bound) {
    fail(ExitCode::data, {file}, "a gzip file that holds more than " + megabytes(bound),
         "at most that much, which is what a grid of the size in its header or a packed text may take; check "
         "the file, or unpack it (gunzip) and name the unpacked file");
}

/// Unpacks piece by piece; the bound is asked for once, after the first piece. Room for all of it is reserved
/// then, which takes no memory until it is used: growing would hold two copies at once.
std::string unpacked_in_pieces(std::istream& in, std::uint64_t packed_bytes, const std::string& file,
                               const UnpackedBound& most_bytes) {
    std::string unpacked;
    std::optional<std::uint64_t> bound;
    while (true) {
        const std::size_t before = unpacked.size();
        unpacked.resize(before + piece_bytes);
        in.read(unpacked.data() + before, static_cast<std::streamsize>(piece_bytes));
        unpacked.resize(before + static_cast<std::size_t>(in.gcount()));
        if (!bound) {
            bound = most_bytes(unpacked);
            unpacked.reserve(std::min(*bound, packed_bytes * most_bytes_per_packed_byte) + piece_bytes);
        }
        if (unpacked.size() > *bound) {
            refuse_size(file, *bound);
        }
        if (unpacked.size() < before + piece_bytes) {
            return unpacked;
        }
    }
}

}  // namespace

bool is_gzip(std::string_view bytes) {
    return bytes.starts_with("\x1F\x8B");
}

std::string gunzip(std::string_view bytes, const std::string& file, const UnpackedBound& most_bytes) {
    namespace io = boost::iostreams;
    if (!is_gzip(bytes)) {
        fail(ExitCode::file, {file}, "another beginning", "a gzip file");
    }
    try {
        io::filtering_istream in;
        in.push(io::gzip_decompressor{});
        in.push(io::array_source{bytes.data(), bytes.size()});
        in.exceptions(std::ios::badbit);
        return unpacked_in_pieces(in, bytes.size(), file, most_bytes);
    } catch (const io::gzip_error& error) {
        const bool checksum = error.error() == io::gzip::bad_crc;
        fail(ExitCode::file, {file},
             checksum ? "a gzip file whose content does not match its checksum"
                      : "a gzip file that is cut off or broken",
             "a whole one: copy it again");
    } catch (const std::ios::failure&) {
        fail(ExitCode::file, {file}, "a gzip file that is cut off or broken", "a whole one: copy it again");
    }
}

}  // namespace config
