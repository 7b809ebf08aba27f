#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/table/schema.hpp"
#include "config/table/table.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "rockfall/release/release.hpp"

namespace coupling {

/// What a row of release.source_shapes says of its own rocks. What it leaves out is as the scenario says.
struct SourceStart {
    std::optional<std::uint32_t> blocks;            ///< how many rocks; none: shared out with all others
    std::shared_ptr<const rockfall::StartLaw> law;  ///< null: all as the scenario says
};

/// What a row of release.source_shapes or hazard.blocks says: a place or a return period, and its rocks.
struct SourceRow {
    config::Shape shape;
    double return_period_years = 0.0;
    std::optional<std::uint32_t> zone;
    std::optional<std::uint32_t> blocks;
    std::optional<double> speed_mps, azimuth_deg, fall_height_m;
    std::optional<double> diameter_m, mass_t, volume_m3, density_kgpm3;
    std::string shape_name, shape_file;
    std::optional<double> side_a_m, side_b_m, side_c_m, sides_scatter;

    [[nodiscard]] bool has_size() const { return diameter_m || mass_t || volume_m3; }
};

const config::Schema<SourceRow>& source_shape_columns();
const config::Schema<SourceRow>& zone_block_columns();

/// The rocks of a row. Adds a problem where two of its fields contradict each other.
SourceStart read_source_start(const config::Read<SourceRow>& row, const Reading& reading,
                              config::RowProblems& wrong);

/// Gives each source its rocks: those of a row with `blocks` by that number, all others by release.rocks or
/// release.rocks_per_source; numbers all rocks. `rows` says which of `starts` holds for each source. Refuses
/// more rocks than a run can number.
void share_rocks(std::vector<rockfall::ReleaseSource>& sources, std::span<const std::size_t> rows,
                 std::span<const SourceStart> starts, Reading& reading);

}  // namespace coupling
