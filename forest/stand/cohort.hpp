#pragma once

#include <cstdint>

#include "forest/stand/tree.hpp"

namespace forest {

/// Young trees of one species and year on one patch, below 1 cm diameter. They have no places of their own.
struct Cohort {
    PatchId patch{};
    SpeciesId species{};
    Origin origin = Origin::seed;
    std::uint32_t stems = 0;          ///< >= 1
    double height_m = 0.0;            ///< mean, > 0
    std::uint16_t age_years = 0;      ///< 0 in its first year
    std::uint16_t stress_years = 0;   ///< bad years in a row
    std::uint16_t guarded_years = 0;  ///< for which guards around each plant still keep deer off
    bool on_wood = false;             ///< germinated on a rotten log or stump
    bool browsed = false;             ///< deer found it in its last year
};

}  // namespace forest
