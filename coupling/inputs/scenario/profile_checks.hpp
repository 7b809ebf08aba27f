#pragma once

#include <string>

#include "config/errors/input_error.hpp"

namespace coupling {
struct Scenario;
}

namespace coupling::profile {

/// Rocks of a run along a profile whose scenario does not say how many: as many as in Rammer et al. 2010.
inline constexpr std::uint64_t usual_rocks = 10'000;

/// Whether a setting has no meaning along a profile: maps, trees, targets, whatever turns rocks sideways.
bool plays_no_part(const std::string& key);

/// Adds a problem for every setting that was given although it has no meaning: those of maps, trees and
/// deviation along a profile, [profile] without one.
void check_settings(const Scenario& scenario, config::Problems& problems);

/// Sets what turns rocks sideways to 0, where settings are listed too.
void turn_deviation_off(Scenario& scenario);

}  // namespace coupling::profile
