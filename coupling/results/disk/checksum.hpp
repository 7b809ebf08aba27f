#pragma once

#include <cstddef>
#include <cstdint>

#include "coupling/inputs/own_files/file_reader.hpp"

namespace coupling {

/// Running checksum of bytes: CRC-64/NVME (polynomial 0xAD93D23594C93659, bits reflected).
///
/// Its polynomial is primitive: any two changed bits less than 2^64 - 1 bits apart change the sum, and so
/// does any change within 64 bits in a row. Other damage passes once in 2^64. No protection against malice.
class Checksum {
public:
    Checksum() = default;
    /// Goes on after bytes whose sum is known.
    explicit Checksum(std::uint64_t sum_so_far) : state_{~sum_so_far} {}

    void add(const char* bytes, std::size_t count);
    [[nodiscard]] std::uint64_t value() const { return ~state_; }

private:
    std::uint64_t state_ = ~std::uint64_t{0};
};

/// Of the next bytes of a file. Requires as many; throws as FileReader.
Checksum checksum_of(FileReader& file, std::uint64_t bytes);

}  // namespace coupling
