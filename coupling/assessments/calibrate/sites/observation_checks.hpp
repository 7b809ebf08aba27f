#pragma once

#include "config/errors/warnings.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/inputs/site.hpp"

namespace coupling::calibrate {

/// What cannot have been observed, or is too little to tell much: warnings. Throws InputError (data) where
/// most of a kind cannot be.
void check_observations(const Scenario& scenario, const Site& site, config::Warnings& warnings);

}  // namespace coupling::calibrate
