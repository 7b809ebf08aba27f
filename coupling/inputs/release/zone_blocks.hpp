#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "coupling/inputs/reading/reading.hpp"
#include "coupling/inputs/release/release_input.hpp"
#include "coupling/inputs/release/source_start.hpp"
#include "rockfall/release/release.hpp"

namespace coupling {

/// A row of hazard.blocks: the rocks of a release zone that come with a return period.
struct ZoneBlocks {
    double return_period_years = 0.0;
    std::uint32_t zone = all_other_zones;
    SourceStart start;
    config::Place place{};
    std::string fields{};  ///< what of the row the rocks hang on, column by column
};

/// Reads hazard.blocks: return_period_years, zone (empty: all others), one of diameter_m, mass_t and
/// volume_m3, and what else `read_source_start` takes. Throws config::InputError (data) for fields that are
/// none and pairs of period and zone that are there twice; doubts rocks that get smaller with longer return
/// periods.
std::vector<ZoneBlocks> read_zone_blocks(Reading& reading);

/// The return periods of a table, each once, rising.
std::vector<double> return_periods_of(const std::vector<ZoneBlocks>& blocks);

/// Gives the sources the rocks of hazard.return_period_years, zone by zone. Throws config::InputError for a
/// return period that the table lacks (settings) and for shapes with rocks of their own (data); doubts zones
/// of which only the sources or only the table know. The run then uses the rows of that return period alone.
void take_zone_blocks(SourceInput& input, Reading& reading);

/// Which of the starts of the input holds for a zone; `own` without hazard.blocks, nothing for a zone that
/// has no rocks.
std::optional<std::size_t> start_of(const SourceInput& input, std::uint32_t zone, std::size_t own);

/// Doubts zones that got none of the rocks: of few rocks a small zone may get none.
void doubt_zones_without_rocks(const std::vector<rockfall::ReleaseSource>& sources, Reading& reading);

}  // namespace coupling
