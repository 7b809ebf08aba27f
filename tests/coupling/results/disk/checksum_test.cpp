#include "coupling/results/disk/checksum.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <string>
#include <string_view>

namespace coupling::checksum_test {
namespace {

std::uint64_t checksum_of(std::string_view bytes) {
    Checksum sum;
    sum.add(bytes.data(), bytes.size());
    return sum.value();
}

std::string letters(std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) {
        text += static_cast<char>(i * i + 7 * i);
    }
    return text;
}

void flip(std::string& text, std::size_t bit) {
    text[bit / 8] = static_cast<char>(static_cast<unsigned char>(text[bit / 8]) ^ (1U << (bit % 8)));
}

TEST(Checksum, HasTheCheckValueOfItsCatalogueEntry) {
    EXPECT_EQ(checksum_of("123456789"), 0xAE8B14860A799888ULL);  // CRC-64/NVME
    EXPECT_EQ(checksum_of(""), 0U);
}

TEST(Checksum, DoesNotDependOnHowTheBytesComeInPieces) {
    const std::string text = letters(301);
    for (std::size_t cut = 0; cut <= text.size(); ++cut) {
        Checksum sum;
        sum.add(text.data(), cut);
        Checksum later{sum.value()};
        later.add(text.data() + cut, text.size() - cut);
        EXPECT_EQ(later.value(), checksum_of(text)) << cut;
    }
}

TEST(Checksum, IsTheSameOfBytesOneByOneAndOfMany) {
    // One byte at a time takes the plain table; many take whatever the processor does fastest.
    const std::string text = letters(700);
    for (std::size_t size = 0; size <= text.size(); ++size) {
        Checksum bytewise{size};
        Checksum whole{size};
        for (std::size_t i = 0; i < size; ++i) {
            bytewise.add(text.data() + text.size() - size + i, 1);
        }
        whole.add(text.data() + text.size() - size, size);
        ASSERT_EQ(whole.value(), bytewise.value()) << size;
    }
}

TEST(Checksum, SeesAnyTwoFlippedBits) {
    // The sum is linear: two flips cancel only if two bits change it alike, so all changes must differ.
    const std::string text = letters(4096);
    std::set<std::uint64_t> changes;
    for (std::size_t bit = 0; bit < 8 * text.size(); ++bit) {
        std::string other = text;
        flip(other, bit);
        const std::uint64_t change = checksum_of(other) ^ checksum_of(text);
        EXPECT_NE(change, 0U) << bit;
        EXPECT_TRUE(changes.insert(change).second) << bit;
    }
}

/// Of polynomials over two elements, modulo that of the checksum.
std::uint64_t product(std::uint64_t a, std::uint64_t b) {
    constexpr std::uint64_t polynomial = 0xAD93D23594C93659ULL;
    std::uint64_t sum = 0;
    for (; b != 0; b >>= 1U) {
        sum ^= (b & 1U) != 0 ? a : 0;
        a = (a << 1U) ^ ((a >> 63U) != 0 ? polynomial : 0);
    }
    return sum;
}

std::uint64_t power_of_x(std::uint64_t exponent) {
    std::uint64_t result = 1;
    for (std::uint64_t base = 2; exponent != 0; exponent >>= 1U, base = product(base, base)) {
        result = (exponent & 1U) != 0 ? product(result, base) : result;
    }
    return result;
}

TEST(Checksum, SeesThemInFilesOfAnyLengthBecauseItsPolynomialIsPrimitive) {
    constexpr std::uint64_t order = ~std::uint64_t{0};  // 2^64 - 1 and its prime factors
    constexpr std::array<std::uint64_t, 7> factors{3, 5, 17, 257, 641, 65537, 6700417};
    std::uint64_t all_factors = 1;
    EXPECT_EQ(power_of_x(order), 1U);
    for (const std::uint64_t factor : factors) {
        EXPECT_NE(power_of_x(order / factor), 1U) << factor;
        all_factors *= factor;
    }
    EXPECT_EQ(all_factors, order);
}

}  // namespace
}  // namespace coupling::checksum_test
