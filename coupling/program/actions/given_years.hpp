#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "coupling/inputs/systems/extent.hpp"

namespace coupling {

/// What a new project over years is made of, besides its slope.
struct AskedYears {
    std::string climate;      ///< the file, as on the command line
    std::uint32_t years = 0;  ///< 0: as many as usual, which is a guess
    std::string system;       ///< coordinate system of the heights, "" where nobody names one
    std::optional<plausible::Extent> extent{};
    std::optional<double> mean_height_m{};  ///< of the slope
};

/// Parts of a scenario, and what there is to say.
struct GivenYears {
    std::string run;       ///< lines of [run]
    std::string sections;  ///< [forest], [soil], [climate], [regimes], [decision]
    std::vector<std::string> remarks;
};

/// Looks into the climate and makes the sections of a run over years of it. Throws InputError for a climate
/// that cannot be read.
GivenYears given_years(const AskedYears& asked, const std::filesystem::path& folder);

}  // namespace coupling
