#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rockfall/ensemble.hpp"

namespace coupling::exchange {

/// A rock at a target that it reached.
struct RockAtTarget {
    float energy_j = 0.0F;  ///< translation and rotation
    float diameter_m = 0.0F;
    friend bool operator==(const RockAtTarget&, const RockAtTarget&) = default;
};
/// By target, each in the order of rocks.
using RocksAtTargets = std::vector<std::vector<RockAtTarget>>;

/// Adds the arrivals of a chunk on a slope. Requires a list for each target.
inline void add_rocks_at_targets(const rockfall::ChunkRows& rows, rockfall::Cover cover, RocksAtTargets& to) {
    auto rock = rows.rocks[static_cast<std::size_t>(cover)].begin();
    for (const rockfall::ArrivalRecord& arrived : rows.arrivals[static_cast<std::size_t>(cover)]) {
        while (rock->rock != arrived.rock) {
            ++rock;
        }
        to[arrived.target].push_back({arrived.arrival.energy_j, rock->diameter_m});
    }
}

/// The rocks of a year over the bare slope: the same for all regimes.
struct BareYear {
    std::int32_t year = 0;
    rockfall::RunTally run;
    std::vector<rockfall::ArrivalTally> targets;
    RocksAtTargets at_targets;
    rockfall::ZeroedList<rockfall::CellSums> cells;  ///< in chosen years only
    /// Which rocks arrived: a bit for each rock and target, targets of a rock side by side.
    std::vector<std::uint64_t> arrived;

    [[nodiscard]] bool has_arrived(std::uint64_t rock, std::size_t target) const {
        const std::uint64_t bit = rock * targets.size() + target;
        return (arrived[bit / 64] >> (bit % 64) & 1U) != 0;
    }
    void mark_arrived(std::uint64_t rock, std::size_t target) {
        const std::uint64_t bit = rock * targets.size() + target;
        arrived[bit / 64] |= std::uint64_t{1} << (bit % 64);
    }
};

}  // namespace coupling::exchange
