#pragma once

#include "rockfall/ensemble.hpp"

namespace rockfall {

/// Enters a finished fall over one slope into tallies and rows. `fed` as in Worker::run; `histograms` may be
/// null.
void enter_fall(const Footprint& footprint, Cover cover, const Assessment& assessment, const RockStart& start,
                EnsembleTally& tally, ChunkRows& rows, FedCells* fed, CellHistograms* histograms);

/// Falls the rocks of a chunk, one after the other, each through `fall_one`; counts those that cannot start.
template <class FallOne>
void each_start(const Assessment& assessment, const Chunk& chunk, ChunkRows& rows, const FallOne& fall_one) {
    std::uint32_t source = chunk.first_source;
    for (std::uint64_t rock = chunk.first_rock; rock < chunk.last_rock; ++rock) {
        while (rock >= assessment.sources[source].first_rock + assessment.sources[source].rocks) {
            ++source;
        }
        if (!assessment.lets_fall(rock)) {
            continue;
        }
        const config::StreamKey key{assessment.seed, assessment.replicate, assessment.year, rock};
        const std::optional<RockStart> start = assessment.start_of_rock(source, key);
        if (start) {
            fall_one(*start);
        } else {
            ++rows.not_started;
        }
    }
}

/// As Worker, over one of the two slopes only: where what falls over the other is known already. The rocks
/// are the same.
class OneSlopeWorker {
public:
    OneSlopeWorker(const Assessment& assessment, Cover cover);

    /// Falls the rocks of a chunk. `fed` is needed for pieces of a source, and only then.
    void run(const Chunk& chunk, ChunkRows& rows, FedCells* fed);

    [[nodiscard]] const EnsembleTally& tally() const { return tally_; }
    void add_fed(const FedCells& fed, std::uint32_t rocks) { fed.add_to(tally_, rocks); }

private:
    const Assessment& assessment_;
    Cover cover_;
    EnsembleTally tally_;
    Footprint footprint_;
    FallScratch scratch_;
};

}  // namespace rockfall
