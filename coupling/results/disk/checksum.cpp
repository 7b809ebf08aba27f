#include "coupling/results/disk/checksum.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <vector>
#if defined(__x86_64__) && defined(__GNUC__)
#include <wmmintrin.h>
#endif

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

/// The sum of a sum and bytes: 16 of them at once, a table for each.
std::uint64_t crc_by_tables(std::uint64_t state, const char* bytes, std::size_t count) {
    for (; count >= crc_slices; bytes += crc_slices, count -= crc_slices) {
        state = crc_of_word(crc_word_at(bytes) ^ state, 8) ^ crc_of_word(crc_word_at(bytes + 8), 0);
    }
    for (; count > 0; ++bytes, --count) {
        state = (state >> 8U) ^ crc_tables[0][(state ^ static_cast<unsigned char>(*bytes)) & 0xFFU];
    }
    return state;
}

#if defined(__x86_64__) && defined(__GNUC__)

/// x to a power modulo the polynomial, its bits in the order of the sums: the highest power lowest.
constexpr std::uint64_t crc_power_of_x(int power) {
    std::uint64_t bits = std::uint64_t{1} << 63U;
    for (int i = 0; i < power; ++i) {
        bits = (bits >> 1U) ^ ((bits & 1U) != 0 ? crc_polynomial_reflected : 0);
    }
    return bits;
}

/// The same sum by products without carries, which processors of the last ten years have: 16 bytes that are
/// followed by 16 more are worth their 8 first ones times x^192 and their 8 last ones times x^128. A product
/// of bits in this order comes out one place too low, hence the powers less one.
__attribute__((target("pclmul"))) std::uint64_t crc_by_products(std::uint64_t state, const char* bytes,
                                                                std::size_t count) {
    if (count < 2 * crc_slices) {
        return crc_by_tables(state, bytes, count);
    }
    const auto load = [](const char* from) __attribute__((always_inline)) {
        return _mm_loadu_si128(reinterpret_cast<const __m128i*>(from));
    };
    const __m128i powers = _mm_set_epi64x(static_cast<long long>(crc_power_of_x(127)),
                                          static_cast<long long>(crc_power_of_x(191)));
    __m128i held = _mm_xor_si128(load(bytes), _mm_set_epi64x(0, static_cast<long long>(state)));
    for (bytes += crc_slices, count -= crc_slices; count >= crc_slices;
         bytes += crc_slices, count -= crc_slices) {
        held = _mm_xor_si128(load(bytes), _mm_xor_si128(_mm_clmulepi64_si128(held, powers, 0x00),
                                                        _mm_clmulepi64_si128(held, powers, 0x11)));
    }
    std::array<char, crc_slices> last{};
    _mm_storeu_si128(reinterpret_cast<__m128i*>(last.data()), held);
    return crc_by_tables(crc_by_tables(0, last.data(), last.size()), bytes, count);
}

std::uint64_t crc_after(std::uint64_t state, const char* bytes, std::size_t count) {
    static const bool has_products = __builtin_cpu_supports("pclmul") != 0;
    return has_products ? crc_by_products(state, bytes, count) : crc_by_tables(state, bytes, count);
}

#else

std::uint64_t crc_after(std::uint64_t state, const char* bytes, std::size_t count) {
    return crc_by_tables(state, bytes, count);
}

#endif

}  // namespace

void Checksum::add(const char* bytes, std::size_t count) {
    state_ = crc_after(state_, bytes, count);
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
