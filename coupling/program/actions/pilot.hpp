#pragma once

#include <functional>

#include "coupling/inputs/site.hpp"

namespace coupling {

struct Scenario;

/// CPU time of this process [s].
double process_cpu_s();

/// CPU time of a rock, over the bare slope and, where stems or logs stand, through them [s]: measured on some
/// rocks spread over all of them, with the laws and obstacles of the run. Takes about a second. The rocks are
/// those of the run and change nothing in it. 0 without rocks.
///
/// The time of a rock varies: some lie down at once, others roll on for minutes. The mean of so many rocks
/// is good to a factor of two. `clock_s` gives the CPU time.
double pilot_seconds_per_rock(const Scenario& scenario, const Site& site,
                              const std::function<double()>& clock_s = process_cpu_s);

}  // namespace coupling
