#include "config/random/stream.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace config::stream_test {
namespace {

constexpr double bits_32 = 4294967296.0;

const StreamKey somebody{.seed = 42, .replicate = 3, .year = 2020, .id = 7};

TEST(RandomStream, GivesThePublishedNumbersOfPhilox) {
    // Random123 1.14, kat_vectors, "philox4x32 10": counter 243f6a88 85a308d3 13198a2e 03707344,
    // key a4093822 299f31d0. The counter is purpose and event, id, id and year, replicate.
    const StreamKey key{.seed = 0x299F31D0A4093822ULL,
                        .replicate = 0x03707344,
                        .year = 0x8A2E,
                        .id = (0x1319ULL << 32) | 0x85A308D3ULL};
    const FourUniforms numbers = RandomStream{key, static_cast<Purpose>(0x24)}.uniforms_of(0x3F6A88);
    const FourUniforms published{0xD16CFE09U / bits_32, 0x94FDCCEBU / bits_32, 0x5001E420U / bits_32,
                                 0x24126EA1U / bits_32};
    EXPECT_EQ(numbers, published);
}

TEST(RandomStream, GivesThePublishedNumbersOfPhiloxAtZero) {
    const FourUniforms numbers = RandomStream{{}, static_cast<Purpose>(0)}.uniforms_of(0);
    const FourUniforms published{0x6627E8D5U / bits_32, 0xE169C58DU / bits_32, 0xBC57AC4CU / bits_32,
                                 0x9B00DBD8U / bits_32};
    EXPECT_EQ(numbers, published);
}

TEST(RandomStream, GivesTheSameNumbersToTheSameIdentity) {
    RandomStream first{somebody, Purpose::release};
    RandomStream second{somebody, Purpose::release};
    for (int i = 0; i < 100; ++i) {
        EXPECT_EQ(first.uniform(), second.uniform());
    }
}

TEST(RandomStream, GivesOtherNumbersToEachOtherIdentity) {
    std::set<FourUniforms> seen;
    std::size_t identities = 0;
    for (const std::uint64_t seed : {1ULL, 2ULL, 1ULL << 32, 1ULL << 63}) {
        for (const std::uint32_t replicate : {0U, 1U, 1U << 31}) {
            for (const int year : {0, 1, 2020, 65535}) {
                for (const std::uint64_t id : {0ULL, 1ULL, 1ULL << 31, 1ULL << 32, 1ULL << 33, 1ULL << 47}) {
                    for (const Purpose purpose :
                         {Purpose::release, Purpose::ground_impact, Purpose::tree_impact, Purpose::rolling,
                          Purpose::stand, Purpose::sampling}) {
                        const StreamKey key{seed, replicate, static_cast<std::uint16_t>(year), id};
                        seen.insert(RandomStream{key, purpose}.uniforms_of(0));
                        ++identities;
                    }
                }
            }
        }
    }
    EXPECT_EQ(seen.size(), identities);
}

TEST(RandomStream, GivesOtherNumbersToEachEvent) {
    const RandomStream stream{somebody, Purpose::ground_impact};
    std::set<FourUniforms> seen;
    for (std::uint32_t event = 0; event < 1000; ++event) {
        seen.insert(stream.uniforms_of(event));
    }
    seen.insert(stream.uniforms_of((1U << 24) - 1));
    EXPECT_EQ(seen.size(), 1001U);
}

TEST(RandomStream, GivesAMillionRocksAMillionFirstNumbers) {
    constexpr std::size_t rocks = 1'000'000;
    std::vector<double> first(rocks);
    for (std::size_t rock = 0; rock < rocks; ++rock) {
        first[rock] = RandomStream{{.seed = 1, .id = rock}, Purpose::release}.uniform();
    }
    std::sort(first.begin(), first.end());
    // Two of 2^53 equally likely numbers agree among a million with a chance of 6e-5.
    EXPECT_EQ(std::adjacent_find(first.begin(), first.end()), first.end());
    EXPECT_GE(first.front(), 0.0);
    EXPECT_LT(first.back(), 1.0);
}

TEST(RandomStream, DoesNotHangOnWhatWasDrawnBefore) {
    RandomStream stream{somebody, Purpose::ground_impact};
    const FourUniforms before = stream.uniforms_of(17);
    stream.uniform();
    EXPECT_EQ(stream.uniforms_of(17), before);
}

TEST(RandomStream, HitsAQuarterOfTheTime) {
    constexpr int draws = 100'000;
    constexpr double p = 0.25;
    RandomStream stream{somebody, Purpose::test};
    int hits = 0;
    for (int i = 0; i < draws; ++i) {
        hits += stream.uniform() < p ? 1 : 0;
    }
    EXPECT_NEAR(static_cast<double>(hits) / draws, p, 4.0 * std::sqrt(p * (1.0 - p) / draws));
}

TEST(RandomStream, GivesUncorrelatedNumbersToAnEvent) {
    constexpr int events = 50'000;
    const RandomStream stream{somebody, Purpose::test};
    double sums[4][4] = {};
    for (std::uint32_t event = 0; event < events; ++event) {
        const FourUniforms u = stream.uniforms_of(event);
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t j = i + 1; j < 4; ++j) {
                sums[i][j] += (u[i] - 0.5) * (u[j] - 0.5);
            }
        }
    }
    // The product of two centred uniforms has the standard deviation 1/12.
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = i + 1; j < 4; ++j) {
            EXPECT_NEAR(sums[i][j] / events, 0.0, 4.0 / 12.0 / std::sqrt(events)) << i << " and " << j;
        }
    }
}

}  // namespace
}  // namespace config::stream_test
