#pragma once

#include <cstdint>
#include <functional>

#include "coupling/inputs/site.hpp"
#include "coupling/program/actions/pilot.hpp"

namespace coupling {

struct Scenario;

/// What a run takes, estimated before it starts.
struct Estimate {
    std::uint64_t rocks = 0;
    int covers = 1;                 ///< 2: with forest and bare
    std::size_t rock_years = 1;     ///< years with rocks, the start included
    std::uint64_t input_bytes = 0;  ///< the program with what it read: terrain, trees
    std::uint64_t map_bytes = 0;    ///< sums of the cells that rocks are expected to reach, for every thread
    std::uint64_t percentile_bytes = 0;  ///< of the cells that rocks are expected to reach
    std::uint64_t forest_bytes = 0;      ///< living trees and what is kept of the years
    std::uint64_t result_bytes = 0;      ///< while results are written
    std::uint64_t path_bytes = 0;        ///< on disk: net_paths.bin
    std::uint64_t raster_bytes = 0;      ///< on disk: grids of today, as text
    double read_seconds = 0.0;           ///< of CPU, on one thread
    double fall_seconds = 0.0;           ///< on all threads together
    double write_seconds = 0.0;          ///< of CPU, on one thread

    [[nodiscard]] std::uint64_t bytes() const {
        return input_bytes + map_bytes + percentile_bytes + forest_bytes + result_bytes;
    }
    [[nodiscard]] double seconds() const { return read_seconds + fall_seconds + write_seconds; }
};

/// What this process has taken so far, at its largest [bytes].
std::uint64_t resident_bytes();

/// Lets a few rocks of a run fall.
using Pilot = std::function<PilotFalls(const Scenario&, const Site&)>;

/// Memory and time of an assessment of today: by what reading took (`read_seconds`, of CPU) and a pilot.
Estimate estimate_of(const Scenario& scenario, const Site& site, int threads, double read_seconds,
                     const Pilot& pilot);

/// Members of a run over years, and those that are still to be simulated.
struct StudySize {
    std::size_t members = 0;
    std::size_t missing = 0;             ///< of which an earlier run has not left all years
    std::size_t begun = 0;               ///< of these, with its first years left
    std::size_t missing_replicates = 0;  ///< of which a member is missing
    std::uint64_t missing_years = 0;     ///< of all missing members together
};

/// The same for a run over years; rocks are those of a year. Requires a site with a forest.
Estimate estimate_of_years(const Scenario& scenario, const Site& site, const StudySize& study, int threads,
                           const Pilot& pilot);

}  // namespace coupling
