#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "coupling/assessments/decades/members/member_part.hpp"
#include "coupling/exchange/yearly_rockfall.hpp"

namespace coupling::decades {

/// Years over the bare slope that are made, kept and read together: which ones.
struct BarePlace {
    std::uint32_t replicate = 0;
    std::uint64_t block = 0;
    friend bool operator==(const BarePlace&, const BarePlace&) = default;
};

/// Writes falls over the bare slope as write_part does those of a member. Throws config::InputError (file).
void write_bare_part(const std::filesystem::path& file, const PartMark& mark, const BarePlace& place,
                     std::span<const exchange::BareYear> years);

/// Reads them back, as read_part does. Throws config::InputError (file) also if the file is missing.
std::vector<exchange::BareYear> read_bare_part(const std::filesystem::path& file, const PartMark& wanted,
                                               const BarePlace& place,
                                               const std::string& remedy = own_part_remedy);

}  // namespace coupling::decades
