#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "coupling/assessments/decades/members/parts.hpp"
#include "coupling/assessments/decades/members/share_out.hpp"
#include "coupling/assessments/decades/members/year_blocks.hpp"
#include "coupling/exchange/yearly_rockfall.hpp"
#include "coupling/run/run_request.hpp"

namespace coupling::decades {

/// The falls of a replicate over the bare slope, year after year, from their parts. Holds one block.
class BareFalls {
public:
    BareFalls(const YearBlocks& blocks, const Parts& parts, std::uint32_t replicate)
        : blocks_{blocks}, parts_{parts}, replicate_{replicate} {}
    /// Requires a year with rocks whose part was made. Throws config::InputError (file) if it is damaged.
    const exchange::BareYear& at(std::int32_t year);

private:
    const YearBlocks& blocks_;
    const Parts& parts_;
    std::uint32_t replicate_;
    std::vector<exchange::BareYear> held_;
};

/// The years of a replicate that its members are still to simulate.
struct YearsToCome {
    std::uint32_t replicate = 0;
    std::int32_t first = 0;
};

/// Lets the rocks of these years fall over the bare slope, in whole blocks, as far as there are no parts yet,
/// shared with the other ranks and with shards that use the same folder (of which this is `shard`).
void make_bare_falls(const exchange::YearlyRockfall& rocks, const YearBlocks& blocks,
                     std::span<const YearsToCome> replicates, const Parts& parts, const Shard& shard,
                     const Crew& crew);

}  // namespace coupling::decades
