#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace config {

/// Running SHA-256 of bytes (FIPS 180-4): the checksum by which archives name their files.
class Sha256 {
public:
    void add(std::string_view bytes);
    /// 64 hexadecimal digits of all bytes so far. Ends the sum: nothing may be added after.
    [[nodiscard]] std::string digits();

private:
    void add_block(const unsigned char* block);

    std::array<std::uint32_t, 8> state_{0x6a09e667U, 0xbb67ae85U, 0x3c6ef372U, 0xa54ff53aU,
                                        0x510e527fU, 0x9b05688cU, 0x1f83d9abU, 0x5be0cd19U};
    std::array<unsigned char, 64> rest_{};
    std::size_t rest_bytes_ = 0;
    std::uint64_t bytes_ = 0;
};

/// Of a whole text.
std::string sha256_of(std::string_view bytes);

}  // namespace config
