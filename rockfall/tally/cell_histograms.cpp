#include "rockfall/tally/cell_histograms.hpp"

namespace rockfall {
namespace {

constexpr std::size_t cells_per_tile = histogram_tile_side * histogram_tile_side;
constexpr std::size_t counts_per_tile = cells_per_tile * CellHistograms::bins_per_cell();

std::size_t tiles_along(int cells) {
    return (static_cast<std::size_t>(cells) + histogram_tile_side - 1) / histogram_tile_side;
}

/// Which tile a cell lies in, and which place it has there.
struct TilePlace {
    std::size_t tile;
    std::size_t place;
};

TilePlace place_of(std::size_t cell, std::size_t columns, std::size_t tile_columns) {
    const std::size_t row = cell / columns;
    const std::size_t column = cell % columns;
    return {row / histogram_tile_side * tile_columns + column / histogram_tile_side,
            row % histogram_tile_side * histogram_tile_side + column % histogram_tile_side};
}

}  // namespace

CellHistograms::CellHistograms(const config::GridFrame& frame)
    : frame_{frame},
      tile_columns_{tiles_along(frame.columns)},
      tiles_(tile_columns_ * tiles_along(frame.rows)) {}

CellHistograms::~CellHistograms() {
    for (const std::atomic<Count*>& tile : tiles_) {
        delete[] tile.load();
    }
}

CellHistograms::Count* CellHistograms::tile_for_writing(std::size_t number) {
    Count* tile = tiles_[number].load(std::memory_order_acquire);
    if (tile == nullptr) {
        auto fresh = std::make_unique<Count[]>(counts_per_tile);
        if (tiles_[number].compare_exchange_strong(tile, fresh.get(), std::memory_order_acq_rel)) {
            tile = fresh.release();
        }
    }
    return tile;
}

void CellHistograms::add(const CellVisit& visit) {
    const TilePlace at = place_of(visit.cell, static_cast<std::size_t>(frame_.columns), tile_columns_);
    Count* counts = tile_for_writing(at.tile) + at.place * bins_per_cell();
    const auto count = [&](std::size_t bin) {
        std::atomic_ref<Count>{counts[bin]}.fetch_add(1, std::memory_order_relaxed);
    };
    count(energy_bins.bin_of(visit.energy_j));
    count(energy_bins.count() + speed_bins.bin_of(visit.speed_mps));
    count(energy_bins.count() + speed_bins.count() + height_bins.bin_of(visit.height_m));
}

std::span<const std::uint32_t> CellHistograms::counts_of(std::size_t cell, std::size_t first,
                                                         std::size_t count) const {
    const TilePlace at = place_of(cell, static_cast<std::size_t>(frame_.columns), tile_columns_);
    const Count* tile = tiles_[at.tile].load(std::memory_order_acquire);
    if (tile == nullptr) {
        return {};
    }
    return {tile + at.place * bins_per_cell() + first, count};
}

std::span<const std::uint32_t> CellHistograms::energy(std::size_t cell) const {
    return counts_of(cell, 0, energy_bins.count());
}

std::span<const std::uint32_t> CellHistograms::speed(std::size_t cell) const {
    return counts_of(cell, energy_bins.count(), speed_bins.count());
}

std::span<const std::uint32_t> CellHistograms::height(std::size_t cell) const {
    return counts_of(cell, energy_bins.count() + speed_bins.count(), height_bins.count());
}

std::span<const std::uint32_t> CellHistograms::tile(std::size_t number) const {
    const Count* counts = tiles_[number].load(std::memory_order_acquire);
    return counts == nullptr ? std::span<const Count>{} : std::span<const Count>{counts, counts_per_tile};
}

void CellHistograms::add_tile(std::size_t number, std::span<const std::uint32_t> counts) {
    Count* mine = tile_for_writing(number);
    for (std::size_t i = 0; i < counts.size(); ++i) {
        mine[i] += counts[i];
    }
}

std::size_t CellHistograms::bytes() const {
    std::size_t touched = 0;
    for (const std::atomic<Count*>& tile : tiles_) {
        touched += tile.load() != nullptr ? 1 : 0;
    }
    return touched * counts_per_tile * sizeof(Count) + tiles_.size() * sizeof(void*);
}

std::size_t CellHistograms::largest_bytes(const config::GridFrame& frame) {
    return tiles_along(frame.columns) * tiles_along(frame.rows) *
           (counts_per_tile * sizeof(Count) + sizeof(void*));
}

}  // namespace rockfall
