#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "coupling/assessments/decades/members/parts.hpp"
#include "coupling/assessments/decades/members/share_out.hpp"
#include "coupling/exchange/yearly_rockfall.hpp"
#include "coupling/run/run_request.hpp"

namespace coupling {
struct Scenario;
}

namespace coupling::decades {

/// Years with rocks, cut into blocks that are made, kept and read together. Depends on the scenario alone.
class YearBlocks {
public:
    explicit YearBlocks(const Scenario& scenario);
    [[nodiscard]] std::size_t count() const { return (years_.size() + years_each - 1) / years_each; }
    [[nodiscard]] std::span<const std::int32_t> years(std::size_t block) const;
    /// Requires a year with rocks.
    [[nodiscard]] std::size_t block_of(std::int32_t year) const;
    [[nodiscard]] bool with_cells(std::int32_t year) const;

    static constexpr std::size_t years_each = 10;

private:
    std::vector<std::int32_t> years_;  ///< rising
    std::vector<int> map_years_;
};

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

/// Lets the rocks of these replicates fall over the bare slope, as far as there are no parts yet, shared with
/// the other ranks and with shards that use the same folder (of which this is `shard`).
void make_bare_falls(const exchange::YearlyRockfall& rocks, const YearBlocks& blocks,
                     std::span<const std::uint32_t> replicates, const Parts& parts, const Shard& shard,
                     const Crew& crew);

}  // namespace coupling::decades
