#pragma once

#include <cstdint>
#include <vector>

#include "rockfall/ensemble.hpp"

namespace coupling::exchange {

/// The rocks of a year over the bare slope: the same for all regimes.
struct BareYear {
    std::int32_t year = 0;
    rockfall::RunTally run;
    std::vector<rockfall::ArrivalTally> targets;
    std::vector<rockfall::CellSums> cells;  ///< in chosen years only
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
