#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "forest/deaths/canopy_deaths.hpp"
#include "forest/deaths/drought_deaths.hpp"
#include "forest/deaths/suppression_deaths.hpp"
#include "forest/stand/species.hpp"
#include "forest/stand/stand.hpp"

namespace forest {

/// How background deaths depend on age.
enum class AgeLaw : std::uint8_t {
    rising,     ///< with size and with the cube of age (forest/deaths/canopy_deaths.hpp)
    gap_model,  ///< the same chance at any age, such that few reach the greatest age (JABOWA, ForClim, iLand)
};

/// Deaths by age and by stress.
struct MortalityLaw {
    AgeLaw age = AgeLaw::rising;
    CanopyDeaths canopy{};
    DroughtDeaths drought{};
    SuppressionDeaths suppression{};
    double least_growth_cm = 0.03;  ///< diameter growth below which a year is bad
    double least_relative_growth =
        0.1;  ///< the same, relative to the mean of its species in the production unit, most tolerant species
    double least_relative_growth_by_class =
        0.01;                     ///< added to it with each step of the light-response class (1-9) [choice]
    std::uint64_t bad_years = 3;  ///< in a row, after which a tree may die of it
    double stress_death = 0.04;   ///< probability a year then, most tolerant species [choice]
    double stress_death_by_class =
        0.015;               ///< added to it with each step of the light-response class (1-9) [choice]
    double all = 1.0;        ///< factor on deaths by age, size, stress and shade [-]
    bool background = true;  ///< whether trees die of age
    bool stress = true;      ///< whether trees die of stress
};

/// Probability to die of age or size within a year [0, 1]. `storms`: whether they are simulated.
double background_death(const Species& species, double dbh_cm, double age_years, const CanopyPlace& place,
                        const MortalityLaw& law, bool storms);

/// Probability to die of stress within a year, after `bad_years` in a row [0, 1].
double stress_death(const Light& species, const MortalityLaw& law);

/// Bad years in a row of every tree after a year's growth. `production_unit` names the unit of each tree,
/// from 0 to `units` - 1: in it a tree is compared with its own species. Light-demanding species are stressed
/// at a greater share of the mean growth.
std::vector<std::uint16_t> stress_years_after(const Stand& stand, const SpeciesTable& species,
                                              const MortalityLaw& law,
                                              std::span<const std::uint32_t> production_unit,
                                              std::size_t units);

/// Deaths by age and size, by stress and shade, and by drought in the stand's current year, with the
/// neighbours that thick trees take along. One random number a stem decides, keyed by tree and year.
/// `storms`: whether they are simulated. `places`: that of each tree; empty = usual ones. `of_drought`:
/// probability of each tree to die of the year's drought; empty = none.
std::vector<Removal> natural_deaths(const Stand& stand, const SpeciesTable& species, const MortalityLaw& law,
                                    bool storms, std::span<const CanopyPlace> places,
                                    std::span<const double> of_drought, std::uint64_t seed,
                                    std::uint32_t replicate);

}  // namespace forest
