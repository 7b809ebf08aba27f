#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "coupling/exchange/regimes/regime.hpp"

namespace coupling {

/// When a row comes to its areas, as far as that is known before a run.
struct PlannedYears {
    /// Of the run, rising: those in which the calendar brings the row, or the row that it follows. With a
    /// condition it does not come in all of them.
    std::vector<int> years{};
    std::string condition{};  ///< what must hold on the area, "from_age_years = 60"; empty: nothing
    bool once = false;        ///< with a condition: once on an area, until that is cleared
    /// The row that it follows, where conditions or dead wood decide when that acts; `years` is then empty.
    std::optional<std::size_t> after{};
};

/// Planned years of a row in the years 0 to `last_year` of a run, on the areas whose turn this is among its
/// entries; without a turn on all of them. Rows on the cuts of another one (where = cuts_of) come to each of
/// those cuts as its own calendar or the years of that row say.
PlannedYears planned_years(const Regime& regime, std::size_t row, std::optional<int> turn, int last_year);

}  // namespace coupling
