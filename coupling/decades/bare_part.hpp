#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "coupling/exchange/yearly_rockfall.hpp"

namespace coupling::decades {

/// Writes falls over the bare slope as write_part does those of a member. Throws config::InputError (file).
void write_bare_part(const std::filesystem::path& file, const std::string& hash,
                     std::span<const exchange::BareYear> years);

/// Reads them back. Throws config::InputError (file) if the file is missing, cut off, damaged or of other
/// settings.
std::vector<exchange::BareYear> read_bare_part(const std::filesystem::path& file, const std::string& hash);

}  // namespace coupling::decades
