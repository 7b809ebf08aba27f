#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "rockfall/draws/fall_draw.hpp"
#include "rockfall/draws/strata.hpp"
#include "rockfall/motion/bare_twin.hpp"
#include "rockfall/motion/fall.hpp"
#include "rockfall/release/release.hpp"
#include "rockfall/tally/cell_histograms.hpp"
#include "rockfall/tally/ensemble_tally.hpp"
#include "rockfall/tally/footprint.hpp"

namespace rockfall {

/// Everything that the falls of an ensemble share and none of them changes.
struct Assessment {
    const Slope& slope;
    const StemIndex& stems;
    std::span<const ReleaseSource> sources;  ///< allotted
    std::span<const Target> targets;
    StartLaw start;
    FallLaw law;
    config::GridFrame map_frame;  ///< in coordinates of the terrain; without cells nobody reads maps
    std::uint64_t seed = 0;
    std::uint32_t replicate = 0;
    std::uint16_t year = 0;
    std::uint64_t path_every = 0;  ///< each rock whose number this divides keeps its path; 0: none
    std::span<const std::uint64_t> path_rocks{};  ///< these keep theirs too; rising
    /// The rocks of each source are shared out among so many repeats, by turns; at most 64, 0: none.
    std::uint32_t repeats = 0;
    bool spread = false;  ///< whether cells keep how far draws move their figures; requires `draws` by strata
    std::span<const std::uint64_t> release_weights{};  ///< by source, for CellReleases; empty: not counted
    CellReach release_reach{};                         ///< the square in which rocks count for CellReleases
    const std::vector<bool>* only_rocks = nullptr;     ///< marks of those that fall; null: all
    const LogIndex* logs = nullptr;
    const NetIndex* nets = nullptr;  ///< they are works, not forest: they stand on the bare slope too
    /// Laws and grounds of each stratum of rocks, a power of two; empty: those above for all rocks.
    std::span<const FallDraw> draws{};

    [[nodiscard]] bool lets_fall(std::uint64_t rock) const {
        return only_rocks == nullptr || (*only_rocks)[rock];
    }
    [[nodiscard]] bool keeps_path(std::uint64_t rock) const {
        return (path_every > 0 && rock % path_every == 0) ||
               std::binary_search(path_rocks.begin(), path_rocks.end(), rock);
    }
    [[nodiscard]] std::uint32_t stratum_of(std::uint64_t rock) const {
        return rockfall::stratum_of(rock, static_cast<std::uint32_t>(draws.size()), seed);
    }
    /// How a rock falls: by its own draw, the same with and without forest.
    [[nodiscard]] const FallLaw& law_of(std::uint64_t rock) const {
        return draws.empty() ? law : draws[stratum_of(rock)].law;
    }
    /// The start of a rock of a source; nothing if its place lies outside the terrain.
    [[nodiscard]] std::optional<RockStart> start_of_rock(std::uint32_t source,
                                                         const config::StreamKey& key) const {
        return start_of(slope, sources[source], source, start, key,
                        draws.empty() ? 1.0 : draws[stratum_of(key.id)].block_size);
    }
    [[nodiscard]] SlopeView slope_of(std::uint64_t rock) const {
        return draws.empty() ? SlopeView{slope} : SlopeView{slope, draws[stratum_of(rock)].types};
    }
    /// Neither stems nor logs: only the bare slope is assessed.
    [[nodiscard]] bool only_bare() const { return stems.empty() && log_count() == 0; }
    [[nodiscard]] std::size_t log_count() const { return logs == nullptr ? 0 : logs->count(); }
    /// What is in the way. `gone`: a mark per stem, then one per log, or empty.
    [[nodiscard]] Obstacles obstacles(Cover cover, std::span<std::uint8_t> gone) const;
};

/// A run of rocks that one worker falls without being interrupted.
struct Chunk {
    std::uint32_t first_source;
    std::uint32_t last_source;  ///< one past
    std::uint64_t first_rock;
    std::uint64_t last_rock;  ///< one past
    bool whole_sources;       ///< false: a piece of one source with many rocks
    bool last_piece;          ///< of such a source
};

/// Cuts the rocks into chunks of whole sources; a source with more rocks than `most_rocks` is cut into
/// pieces. The cut depends on the sources alone.
std::vector<Chunk> plan_chunks(std::span<const ReleaseSource> sources, std::uint32_t most_rocks = 1024);

/// Rocks of a chunk under a motion model: some tenths of a second of work.
std::uint32_t rocks_of_chunk(MotionModel model);

/// A sampled path.
struct PathRecord {
    std::uint64_t rock;
    Cover cover;
    std::vector<PathPoint> points;
    std::vector<Eigen::Vector3f> shape_m{};  ///< vertices of its hull in principal axes; none: a ball
    float diameter_m = 0.0F;
};

/// A rock at a target that it reached.
struct ArrivalRecord {
    std::uint64_t rock;
    std::uint32_t target;
    Arrival arrival;
};

/// What a chunk hands over rock by rock, in rock order; everything else goes into the tallies.
struct ChunkRows {
    std::array<std::vector<RockRecord>, covers> rocks;               ///< forest is empty without obstacles
    std::array<std::vector<ArrivalRecord>, covers> arrivals;         ///< rock by rock, target by target
    std::vector<std::pair<std::uint64_t, TreeHitRecord>> tree_hits;  ///< (rock, hit)
    std::vector<std::pair<std::uint64_t, LogHitRecord>> log_hits;    ///< (rock, hit)
    std::array<std::vector<std::pair<std::uint64_t, NetCrossingRecord>>, covers>
        net_crossings;  ///< (rock, crossing)
    std::vector<PathRecord> paths;
    std::uint64_t not_started = 0;  ///< rocks whose place lies outside the terrain

    void clear();
};

/// Cells that any piece of a source with many rocks has fed so far.
class FedCells {
public:
    explicit FedCells(std::size_t cells);
    /// Goes on from the marks of another, which must be of as many cells.
    explicit FedCells(std::span<const std::uint8_t> marks);
    void mark(Cover cover, std::size_t cell) {
        touched_[index(cover, cell)].store(1, std::memory_order_relaxed);
    }
    /// A mark for each cell, first of the slope with forest.
    [[nodiscard]] std::vector<std::uint8_t> marks() const;
    /// Adds the source's rocks to each cell it feeds. After its last piece only.
    void add_to(EnsembleTally& tally, std::uint32_t rocks) const;

private:
    [[nodiscard]] std::size_t index(Cover cover, std::size_t cell) const {
        return static_cast<std::size_t>(cover) * cells_ + cell;
    }
    std::size_t cells_;
    std::vector<std::atomic<std::uint8_t>> touched_;
};

/// Simulates rocks, one after the other, each over the slope with forest and logs and over the bare slope
/// with the same random numbers. Both falls are one until the first stem or log and are simulated once so
/// far. One worker per thread; workers share only the assessment and the histograms.
class Worker {
public:
    /// `histograms` may hold null pointers: then no percentiles are kept.
    Worker(const Assessment& assessment, std::array<CellHistograms*, covers> histograms);

    /// Falls the rocks of a chunk. `fed` is needed for pieces of a source, and only then. `gone` marks broken
    /// stems, then broken logs (empty: none breaks for good).
    void run(const Chunk& chunk, ChunkRows& rows, FedCells* fed, std::span<std::uint8_t> gone);

    [[nodiscard]] const EnsembleTally& tally() const { return tally_; }
    /// Enters what all workers together found that a source with many rocks feeds. After its last piece only.
    void add_fed(const FedCells& fed, std::uint32_t rocks) { fed.add_to(tally_, rocks); }

private:
    /// Over the slope with forest the twin falls over the bare one.
    const Footprint& fall_over(Cover cover, const RockStart& start, std::span<std::uint8_t> gone,
                               BareTwin<Footprint>* twin);
    void count(const Footprint& footprint, Cover cover, const RockStart& start, ChunkRows& rows,
               FedCells* fed);

    const Assessment& assessment_;
    std::array<CellHistograms*, covers> histograms_;
    EnsembleTally tally_;
    std::array<std::unique_ptr<Footprint>, covers> footprints_;
    FallScratch scratch_;
};

}  // namespace rockfall
