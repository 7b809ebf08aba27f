#pragma once

#include <optional>

#include "coupling/assessments/decades/members/records.hpp"
#include "forest/site/site.hpp"
#include "forest/stand/species.hpp"
#include "forest/stand/stand.hpp"
#include "forest/year.hpp"

namespace coupling::decades {

/// Writes down what stands now and what the year brought: rows for the forest and its species and, where
/// there are several, for each management unit, with its gaps along the fall line. `report` is missing for
/// the start.
void record_year(const forest::Stand& stand, const forest::SpeciesTable& species, std::int32_t year,
                 const std::optional<forest::YearReport>& report, double mean_temperature_degc,
                 MemberYears& kept);

/// Who left the stand in the running year, by cause, and each tree of at least 7 cm that a rock or its wounds
/// killed, or all with `list_all`. What became of the wood of stems goes into the last row of the years.
void record_losses(const forest::Stand& stand, const forest::SpeciesTable& species, std::int32_t year,
                   bool list_all, MemberYears& kept);

/// Every tree as it stands now.
void record_trees(const forest::Stand& stand, std::int32_t year, MemberYears& kept);
/// Its dead wood, standing and lying.
void record_dead_wood(const forest::Stand& stand, std::int32_t year, MemberYears& kept);

/// Every patch as it is now.
void record_patches(const forest::Stand& stand, const forest::SpeciesTable& species, std::int32_t year,
                    MemberYears& kept);

}  // namespace coupling::decades
