#include "coupling/results/disk/checksum.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <vector>

namespace coupling {
namespace {

constexpr std::uint64_t crc_polynomial_reflected = 0x9A6C9329AC4BC9B5ULL;

/// Bytes that are taken in one step ("slicing"): a table for each.
constexpr std::size_t crc_slices = 16;

using CrcTables = std::array<std::array<std::uint64_t, 256>, crc_slices>;

/// In table k: what a byte does to the sum when k more bytes follow it.
constexpr CrcTables crc_tables_of_all_slices() {
    CrcTables made{};
    for (std::uint64_t byte = 0; byte < 256; ++byte) {
        std::uint64_t sum = byte;
        for (int bit = 0; bit < 8; ++bit) {
            sum = (sum >> 1U) ^ ((sum & 1U) != 0 ? crc_polynomial_reflected : 0);
        }
        made[0][byte] = sum;
    }
    for (std::size_t k = 1; k < crc_slices; ++k) {
        for (std::size_t byte = 0; byte < 256; ++byte) {
            const std::uint64_t before = made[k - 1][byte];
            made[k][byte] = (before >> 8U) ^ made[0][before & 0xFFU];
        }
    }
    return made;
}

constexpr CrcTables crc_tables = crc_tables_of_all_slices();

/// Eight bytes, the first one lowest.
std::uint64_t crc_word_at(const char* bytes) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes, sizeof word);
    return std::endian::native == std::endian::little ? word : __builtin_bswap64(word);
}

/// Of the eight bytes of a word, the last of which is followed by `after` more.
std::uint64_t crc_of_word(std::uint64_t word, std::size_t after) {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < 8; ++i) {
        sum ^= crc_tables[after + 7 - i][(word >> (8 * i)) & 0xFFU];
    }
    return sum;
}

}  // namespace

void Checksum::add(const char* bytes, std::size_t count) {
    std::uint64_t state = state_;
    for (; count >= crc_slices; bytes += crc_slices, count -= crc_slices) {
        state = crc_of_word(crc_word_at(bytes) ^ state, 8) ^ crc_of_word(crc_word_at(bytes + 8), 0);
    }
    for (; count > 0; ++bytes, --count) {
        state = (state >> 8U) ^ crc_tables[0][(state ^ static_cast<unsigned char>(*bytes)) & 0xFFU];
    }
    state_ = state;
}

Checksum checksum_of(FileReader& file, std::uint64_t bytes) {
    Checksum sum;
    std::vector<char> block(
        static_cast<std::size_t>(std::min<std::uint64_t>(bytes, std::uint64_t{1} << 20U)));
    while (bytes > 0) {
        const auto wanted = static_cast<std::size_t>(std::min<std::uint64_t>(bytes, block.size()));
        const std::size_t got = file.read(block.data(), wanted);
        sum.add(block.data(), got);
        bytes -= got;
    }
    return sum;
}

}  // namespace coupling
