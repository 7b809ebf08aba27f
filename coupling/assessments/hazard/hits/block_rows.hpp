#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rockfall/release/release.hpp"

namespace coupling::hazard::hits {

/// A row of hazard.blocks that released rocks in a return period, once each time.
struct BlockRow {
    std::uint64_t rocks = 0;  ///< simulated
    double diameter_m = 0.0;  ///< mean of its rocks
};

/// Which row of hazard.blocks each rock of a return period belongs to.
class BlockRows {
public:
    /// @param sources  of the return period, in the order of their rocks; they have to live as long
    /// @param common   the start of sources without one of their own
    BlockRows(const std::vector<rockfall::ReleaseSource>& sources, const rockfall::StartLaw& common);

    /// Rows with rocks, in the order of the sources.
    [[nodiscard]] const std::vector<BlockRow>& rows() const { return rows_; }
    /// The row of a rock, by its number. Throws std::out_of_range for a number that no source has.
    [[nodiscard]] std::size_t row_of(std::uint64_t rock) const;
    /// Of the row with the fewest rocks.
    [[nodiscard]] double fewest_rocks() const;

private:
    const std::vector<rockfall::ReleaseSource>& sources_;
    std::vector<BlockRow> rows_;
    std::vector<std::size_t> row_of_source_;
};

}  // namespace coupling::hazard::hits
