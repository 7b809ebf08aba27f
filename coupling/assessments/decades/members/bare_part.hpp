#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "coupling/exchange/yearly_rockfall.hpp"

namespace coupling::decades {

/// Years over the bare slope that are made, kept and read together: which ones.
struct BarePlace {
    std::uint32_t replicate = 0;
    std::uint64_t block = 0;
    friend bool operator==(const BarePlace&, const BarePlace&) = default;
};

/// Writes falls over the bare slope as write_part does those of a member. Throws config::InputError (file).
void write_bare_part(const std::filesystem::path& file, const std::string& hash, const BarePlace& place,
                     std::span<const exchange::BareYear> years);

/// Reads them back. Throws config::InputError (file) if the file is missing, cut off, damaged, of other
/// settings or of another place.
std::vector<exchange::BareYear> read_bare_part(const std::filesystem::path& file, const std::string& hash,
                                               const BarePlace& place);

}  // namespace coupling::decades
