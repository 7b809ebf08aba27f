#pragma once

#include <cstdint>
#include <vector>

#include "coupling/exchange/regimes/apply.hpp"

namespace coupling {

/// An intervention and the areas it comes to in a year, as places in Regime::areas_of; of a row that acts on
/// the cuts of another as places in RegimeState::cuts.
struct Due {
    std::size_t intervention = 0;
    std::vector<std::size_t> areas;
};

/// An area of a Due.
const Area& area_at(const Regime& regime, const RegimeState& state, std::size_t intervention,
                    std::size_t place);

/// Rows that act on cuts without cutting come after the trees of the year are marked; those that act where
/// wood was salvaged this year, after that.
enum class DueRows : std::uint8_t { all, before_marking, after_marking, after_salvage };

/// What is due in a year, in the order of the rows: by the calendar or by years after another row, where the
/// conditions hold. Nothing is listed that comes to no area.
std::vector<Due> due_in(const Regime& regime, int year, const forest::Stand& stand,
                        const forest::SpeciesTable& species, const RegimeState& state,
                        DueRows rows = DueRows::all);

/// Age of an area: years since its clear cut, before the first one the mean age of the 100 thickest stems per
/// hectare, 0 without trees.
double age_of(const forest::Stand& stand, std::span<const std::size_t> trees, double area_ha,
              std::optional<int> years_since_clearing);

/// The same of an area of an intervention, by what the state remembers of it. `trees`: those of the area.
double age_of(const Regime& regime, int year, const forest::Stand& stand, const RegimeState& state,
              std::size_t intervention, const Area& area, std::span<const std::size_t> trees);

/// Writes visits, and clearings by clear cuts, into the state.
void remember(const Regime& regime, int year, const std::vector<Due>& done, RegimeState& state);

}  // namespace coupling
