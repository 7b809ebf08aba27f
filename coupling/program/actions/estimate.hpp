#pragma once

#include <cstdint>
#include <functional>

#include "coupling/inputs/site.hpp"

namespace coupling {

struct Scenario;

/// What a run takes, estimated before it starts.
struct Estimate {
    std::uint64_t rocks = 0;
    int covers = 1;                      ///< 2: with forest and bare
    std::size_t rock_years = 1;          ///< years with rocks, the start included
    std::uint64_t terrain_bytes = 0;     ///< triangulation, ground types, heights, trees
    std::uint64_t map_bytes = 0;         ///< sums per cell, for every thread
    std::uint64_t percentile_bytes = 0;  ///< at most: if rocks reach every cell
    std::uint64_t forest_bytes = 0;      ///< living trees and what is kept of the years
    std::uint64_t path_bytes = 0;        ///< on disk: net_paths.bin
    double seconds = 0.0;  ///< within a factor of about three; where the model has no known speed, by a pilot

    [[nodiscard]] std::uint64_t bytes() const {
        return terrain_bytes + map_bytes + percentile_bytes + forest_bytes;
    }
};

/// Measures the CPU time of a rock over all slopes [s].
using Pilot = std::function<double(const Scenario&, const Site&)>;

/// `pilot` is asked where the motion model has no known speed.
Estimate estimate_of(const Scenario& scenario, const Site& site, int threads, const Pilot& pilot);

/// Members of a run over years, and those that are still to be simulated.
struct StudySize {
    std::size_t members = 0;
    std::size_t missing = 0;
    std::size_t missing_replicates = 0;  ///< of which a member is missing
};

/// The same for a run over years; rocks are those of a year. Requires a site with a forest.
Estimate estimate_of_years(const Scenario& scenario, const Site& site, const StudySize& study, int threads,
                           const Pilot& pilot);

}  // namespace coupling
