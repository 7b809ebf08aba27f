#pragma once

#include "coupling/inputs/site.hpp"

namespace coupling {

struct Scenario;

/// CPU time of a rock, over the bare slope and, where stems or logs stand, through them [s]: measured on some
/// rocks spread over all of them, with the laws and obstacles of the run. Takes about a second. The rocks are
/// those of the run and change nothing in it. 0 without rocks.
///
/// The time of a rock varies: some lie down at once, others roll on for minutes. The mean of so many rocks
/// is good to a factor of two.
double pilot_seconds_per_rock(const Scenario& scenario, const Site& site);

}  // namespace coupling
