#pragma once

#include <span>
#include <vector>

#include "rockfall/ensemble.hpp"
#include "tests/benchmarks/counters.hpp"
#include "tests/benchmarks/scene.hpp"

namespace benchmarks {

/// Bare falls of which only the end counts.
Totals fall_bare(const rockfall::Slope& slope, std::span<const rockfall::ReleaseSource> sources,
                 const rockfall::FallLaw& law, const rockfall::StemIndex* stems = nullptr);

/// What `rockfall::Worker` does for one of its two covers: falls with maps and a record of each rock.
///
/// The worker itself always falls each rock on the bare slope too, and its time says little about the forest.
class OneCover {
public:
    OneCover(const rockfall::Slope& slope, const rockfall::FallLaw& law, const rockfall::StemIndex* stems,
             const config::GridFrame& frame, rockfall::CellHistograms* histograms);

    Totals fall(std::span<const rockfall::ReleaseSource> sources);
    [[nodiscard]] const rockfall::CellTally& cells() const { return cells_; }

private:
    void count(const rockfall::ReleaseSource& source);

    const rockfall::Slope& slope_;
    const rockfall::FallLaw& law_;
    rockfall::Obstacles obstacles_;
    rockfall::StartLaw start_;
    rockfall::CellHistograms* histograms_;
    rockfall::Footprint footprint_;
    rockfall::FallScratch scratch_;
    rockfall::CellTally cells_;
    rockfall::RunTally run_;
    std::vector<rockfall::RockRecord> records_;
    std::vector<rockfall::TreeHitRecord> tree_hits_;
};

}  // namespace benchmarks
