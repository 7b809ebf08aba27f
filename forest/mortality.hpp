#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "forest/species.hpp"
#include "forest/stand.hpp"

namespace forest {

/// How background deaths depend on age.
enum class AgeLaw : std::uint8_t {
    small_and_rising,  ///< 0.15 % a year and a hazard that rises with the cube of age [choice]: disturbances
                       ///< are explicit
    gap_model,  ///< the same chance at any age, such that few reach the greatest age (JABOWA, ForClim, iLand)
};

/// Deaths by age and by stress.
struct MortalityLaw {
    AgeLaw age = AgeLaw::small_and_rising;
    double least_growth_cm = 0.03;  ///< diameter growth below which a year is bad
    double least_relative_growth =
        0.1;                      ///< the same, relative to the mean of its species in the production unit
    std::uint64_t bad_years = 3;  ///< in a row, after which a tree may die of it
    double stress_death = 0.02;   ///< probability a year then, most tolerant species [choice]
    double stress_death_by_class =
        0.015;               ///< added to it with each step of the light-response class (1-9) [choice]
    bool background = true;  ///< whether trees die of age
    bool stress = true;      ///< whether trees die of stress
};

/// Probability to die of age within a year [0, 1].
double background_death(const Mortality& species, double age_years, AgeLaw law);

/// Probability to die of stress within a year, after `bad_years` in a row [0, 1].
double stress_death(const Light& species, const MortalityLaw& law);

/// Bad years in a row of every tree after a year's growth. `production_unit` names the unit of each tree,
/// from 0 to `units` - 1: in it a tree is compared with its own species.
std::vector<std::uint16_t> stress_years_after(const Stand& stand, const MortalityLaw& law,
                                              std::span<const std::uint32_t> production_unit,
                                              std::size_t units);

/// Deaths by age and by stress in the stand's current year. One random number a stem decides, keyed by tree
/// and year.
std::vector<Removal> natural_deaths(const Stand& stand, const SpeciesTable& species, const MortalityLaw& law,
                                    std::uint64_t seed, std::uint32_t replicate);

}  // namespace forest
