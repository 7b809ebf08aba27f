#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/table/table.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "rockfall/release/release.hpp"

namespace coupling {

/// What a row of release.source_shapes says of its own rocks. What it leaves out is as the scenario says.
struct SourceStart {
    std::optional<std::uint32_t> blocks;            ///< how many rocks; none: shared out with all others
    std::shared_ptr<const rockfall::StartLaw> law;  ///< null: all as the scenario says
};

/// Reads the columns `blocks`, `speed_mps`, `azimuth_deg`, `fall_height_m`, `diameter_m`, `mass_t`,
/// `volume_m3` and `density_kgpm3` of a row, each of which may be missing or empty. Adds a problem where a
/// value is out of range or where two of them contradict each other.
SourceStart read_source_start(const config::Table& table, std::size_t row, const Scenario& scenario,
                              config::Problems& problems);

/// Those columns and `zone`.
std::vector<std::string> start_columns();

/// Gives each source its rocks: those of a row with `blocks` by that number, all others by release.rocks or
/// release.rocks_per_source; numbers all rocks. `rows` says which of `starts` holds for each source. Refuses
/// more rocks than a run can number.
void share_rocks(std::vector<rockfall::ReleaseSource>& sources, std::span<const std::size_t> rows,
                 std::span<const SourceStart> starts, Reading& reading);

}  // namespace coupling
