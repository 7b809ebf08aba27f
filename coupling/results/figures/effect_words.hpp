#pragma once

#include <optional>
#include <string>

#include "coupling/results/figures/figures.hpp"

namespace coupling {

// What a forest does to the energies at a target, in words. Text, not markup.

/// "30", "100", "300", "1000": in columns and keys.
std::string kj_text(std::size_t counted_energy);

/// Rocks per 1000 released, of a share: "156", "24.4", "0.60", "0.077". Two digits below 1, where few rocks
/// stand behind the figure; "–" where it is not known.
std::string rate_per_1000(double share);

/// How an energy of those that still arrive compares with that of all rocks over the bare slope.
struct EnergyRise {
    bool of_mean = false;     ///< of the mean energy, otherwise of the 95 % energy
    double percent = 0.0;     ///< above that over the bare slope
    bool is_certain = false;  ///< the intervals do not overlap; of a mean: not known
    bool has_interval = false;
};

/// The 95 % energy, where it is known on both slopes and not higher the mean. Nothing where a forest raises
/// neither by half a percent, and where fewer rocks arrive than a protection effect needs.
std::optional<EnergyRise> energy_rise(const ArrivalFigures& forest, const ArrivalFigures& bare);

/// "Rocks above 300 kJ per 1000 released fall from 41.2 to 12.0.": with the energy of 300, 100 or 30 kJ, the
/// largest that a few rocks over the bare slope exceed; empty where they exceed none.
std::string change_of_strong_rocks(const ArrivalFigures& forest, const ArrivalFigures& bare);

/// "The 95 % energy of those that still arrive is 23.3 % higher, because .... Rocks above 300 kJ per
/// 1000 released fall from 41.2 to 12.0." Empty where there is no rise. `miri`: the MIRI to name with it.
std::string rise_in_words(const ArrivalFigures& forest, const ArrivalFigures& bare,
                          const std::string& miri = "");

/// BARI, MIRI and ORPI of a target in words. Requires a reduction from enough rocks.
std::string reduction_in_words(const TargetFigures& target);

}  // namespace coupling
