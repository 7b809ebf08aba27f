#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coupling/exchange/regimes/regime.hpp"

namespace coupling {
struct Scenario;
}

namespace coupling::decades {

/// Years in which rocks fall: each `run.rockfall_every`-th from the start, and the last one, so that what is
/// cut at the end is judged too. None without rocks.
std::vector<std::int32_t> rock_years_of(const Scenario& scenario);
bool is_rock_year(std::int32_t year, const Scenario& scenario);

/// Whether a treatment, by its name, fells by plan: not what follows from events, and no work among young
/// trees.
bool is_cut(std::string_view treatment);

/// Whether years with rocks show what a cut costs: those of its own year or of one of the two after it
/// [choice]. Protection is lowest in the first years after a cut and back within a decade.
bool is_judged(std::int32_t cut, std::span<const std::int32_t> rock_years);

/// What regimes plan by the calendar where no rocks show it: a sentence for each regime.
std::vector<std::string> unjudged_plans(std::span<const Regime> regimes, const Scenario& scenario);

}  // namespace coupling::decades
