#include "coupling/assessments/decades/members/bare_falls.hpp"

#include <algorithm>

namespace coupling::decades {

const exchange::BareYear& BareFalls::at(std::int32_t year) {
    const auto held = [&] {
        return std::find_if(held_.begin(), held_.end(),
                            [&](const exchange::BareYear& bare) { return bare.year == year; });
    };
    auto found = held();
    if (found == held_.end()) {
        held_ = parts_.read_bare(replicate_, blocks_.block_of(year));
        found = held();
    }
    return *found;
}

void make_bare_falls(const exchange::YearlyRockfall& rocks, const YearBlocks& blocks,
                     std::span<const YearsToCome> replicates, const Parts& parts, const Shard& shard,
                     const Crew& crew) {
    std::vector<std::uint64_t> missing;
    if (crew.ranks.first()) {
        for (const auto& [replicate, first_year] : replicates) {
            for (std::size_t block = 0; block < blocks.count(); ++block) {
                if (blocks.years(block).back() >= first_year && !parts.has_bare(replicate, block)) {
                    missing.push_back(replicate * blocks.count() + block);
                }
            }
        }
        // Shards that work side by side begin at different places.
        const std::size_t first = missing.size() * (shard.number - 1) / shard.count;
        std::rotate(missing.begin(), missing.begin() + static_cast<std::ptrdiff_t>(first), missing.end());
    }
    missing = crew.ranks.from_first(std::move(missing));
    std::size_t years = 0;
    for (const std::uint64_t piece : missing) {
        years += blocks.years(piece % blocks.count()).size();
    }
    share_out(
        crew, {RankGroup::Work::bare_slope, "falling over the bare slope", missing.size(), years},
        [&](std::size_t i, int threads, const std::function<void()>& step_done) {
            const auto replicate = static_cast<std::uint32_t>(missing[i] / blocks.count());
            const std::size_t block = missing[i] % blocks.count();
            if (!parts.has_bare(replicate, block)) {  // by another shard in the meantime
                std::vector<exchange::BareYear> bare;
                for (const std::int32_t year : blocks.years(block)) {
                    bare.push_back(rocks.simulate_bare(replicate, year, blocks.with_cells(year), threads));
                    step_done();
                }
                parts.keep_bare(replicate, block, bare);
            }
        });
}

}  // namespace coupling::decades
