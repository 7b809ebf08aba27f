#pragma once

#include <functional>

#include "coupling/inputs/site.hpp"

namespace coupling {

struct Scenario;

/// CPU time of this process [s].
double process_cpu_s();

/// What a few rocks of a run show of all of them.
struct PilotFalls {
    double seconds_per_rock = 0.0;  ///< CPU time over all slopes
    double tiles = 0.0;  ///< of CellHistograms, of all slopes together, that all rocks are expected to touch
};

/// Simulates some rocks, spread over all of them, on the bare slope and, where stems or logs stand, through
/// them, with the laws and obstacles of the run. Takes a second at most. The rocks are those of the run and
/// change nothing in it. Nothing without rocks.
///
/// The time of a rock varies: some lie down at once, others roll on for minutes. The mean of so many rocks
/// is good to a factor of two. With each doubling of the rocks tiles grow by a smaller share, as they do in
/// the pilot. `clock_s` gives the CPU time.
PilotFalls pilot_falls(const Scenario& scenario, const Site& site,
                       const std::function<double()>& clock_s = process_cpu_s);

}  // namespace coupling
