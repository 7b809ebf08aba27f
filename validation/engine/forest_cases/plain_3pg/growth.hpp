#pragma once

#include "validation/engine/forest_cases/plain_3pg/stand.hpp"

namespace coupling::validation::forest_cases::plain_3pg {

/// Ages of the species at the end of a month, and what depends on age alone.
void grow_older(Stand& stand, const Inputs& inputs, YearMonth when);

/// Puts in the species that are planted this month, or have been before the first; true if any was.
bool plant(Stand& stand, const Inputs& inputs, YearMonth when);

/// Leaves go out or fall this month; true if any did. Light of the month of leaf-out falls on the leaves of
/// last year.
bool turn_leaves(Stand& stand, const Inputs& inputs, int month);

/// Modifiers that climate and age set.
void climate_modifiers(Stand& stand, const Inputs& inputs, const ClimateMonth& month);

/// Modifiers that the stand itself has a part in: deficit within the canopy, soil water, nutrition, and their
/// joint effect.
void limit_production(Stand& stand, const Inputs& inputs, const ClimateMonth& month,
                      const Settings& settings);

/// Gross and net production of absorbed light, before the water is known.
void produce(Stand& stand, const Inputs& inputs);

/// Production goes to foliage, stem and roots; litter falls.
void allocate(Stand& stand, const Inputs& inputs, int month);

/// Volumes and their change.
void measure_growth(Stand& stand, const Inputs& inputs);

}  // namespace coupling::validation::forest_cases::plain_3pg
