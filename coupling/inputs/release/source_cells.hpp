#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "coupling/inputs/release/release_input.hpp"
#include "rockfall/release/release.hpp"

namespace coupling {

/// Sources and, for each, which of the starts of the input is its own.
struct Placed {
    std::vector<rockfall::ReleaseSource> sources;
    std::vector<std::size_t> rows;

    void add(rockfall::ReleaseSource source, std::size_t start, const SourceInput& input) {
        source.own_start = input.starts[start].law;
        sources.push_back(std::move(source));
        rows.push_back(start);
    }
};

/// Sources as cells of the heights: of a grid, within polygons, or wherever it is steep; with
/// release.steeper_than_deg only the steeper ones. Counts what is left out into warnings and problems.
Placed place_cells(const SourceInput& input, const HeightInput& heights, const rockfall::Terrain& terrain,
                   Reading& reading);

}  // namespace coupling
