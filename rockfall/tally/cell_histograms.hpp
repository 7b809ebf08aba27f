#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "config/grid/raster.hpp"
#include "rockfall/tally/cell_tally.hpp"
#include "rockfall/tally/log_bins.hpp"

namespace rockfall {

/// Distributions of energy, speed and height for every cell that a rock passed.
///
/// Whole counts in logarithmic bins, kept in tiles of 4 x 4 cells that come into being when first touched.
/// `add` may be called from several threads at once: counts are atomic and their sum does not depend on
/// order.
class CellHistograms {
public:
    explicit CellHistograms(const config::GridFrame& frame);
    CellHistograms(const CellHistograms&) = delete;
    CellHistograms& operator=(const CellHistograms&) = delete;
    ~CellHistograms();

    void add(const CellVisit& visit);

    /// Counts of one cell, empty if nothing passed.
    [[nodiscard]] std::span<const std::uint32_t> energy(std::size_t cell) const;
    [[nodiscard]] std::span<const std::uint32_t> speed(std::size_t cell) const;
    [[nodiscard]] std::span<const std::uint32_t> height(std::size_t cell) const;

    /// All counts of a tile (16 cells of bins_per_cell numbers), empty if untouched; to store and add up
    /// tiles.
    [[nodiscard]] std::size_t tiles() const { return tiles_.size(); }
    [[nodiscard]] std::span<const std::uint32_t> tile(std::size_t number) const;
    void add_tile(std::size_t number, std::span<const std::uint32_t> counts);

    [[nodiscard]] std::size_t bytes() const;
    static constexpr std::size_t bins_per_cell();
    /// Bytes if rocks reach every cell: what `check` prints.
    static std::size_t largest_bytes(const config::GridFrame& frame);

private:
    using Count = std::uint32_t;
    [[nodiscard]] std::span<const Count> counts_of(std::size_t cell, std::size_t first,
                                                   std::size_t count) const;
    Count* tile_for_writing(std::size_t number);

    config::GridFrame frame_;
    std::size_t tile_columns_;
    std::vector<std::atomic<Count*>> tiles_;
};

inline constexpr std::size_t histogram_tile_side = 4;

constexpr std::size_t CellHistograms::bins_per_cell() {
    return energy_bins.count() + speed_bins.count() + height_bins.count();
}

}  // namespace rockfall
