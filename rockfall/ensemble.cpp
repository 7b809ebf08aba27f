#include "rockfall/ensemble.hpp"

#include <algorithm>

#include "rockfall/motion/rocks_at_once.hpp"
#include "rockfall/one_slope.hpp"
#include "rockfall/trajectory.hpp"

namespace rockfall {

Obstacles Assessment::obstacles(Cover cover, std::span<std::uint8_t> gone) const {
    const NetIndex* standing = nets == nullptr || nets->empty() ? nullptr : nets;
    if (cover == Cover::bare) {
        return {.nets = standing};
    }
    const std::size_t stems_marked = gone.empty() ? 0 : stems.placed().size();
    return {stems.empty() ? nullptr : &stems, gone.first(stems_marked), log_count() == 0 ? nullptr : logs,
            gone.subspan(stems_marked), standing};
}

std::uint32_t rocks_of_chunk(MotionModel model) {
    return rocks_at_once(model);
}

std::vector<Chunk> plan_chunks(std::span<const ReleaseSource> sources, std::uint32_t most_rocks) {
    std::vector<Chunk> chunks;
    for (std::uint32_t i = 0; i < sources.size(); ++i) {
        const ReleaseSource& source = sources[i];
        const std::uint64_t end = source.first_rock + source.rocks;
        if (source.rocks > most_rocks) {
            for (std::uint64_t first = source.first_rock; first < end; first += most_rocks) {
                const std::uint64_t last = std::min<std::uint64_t>(end, first + most_rocks);
                chunks.push_back({i, i + 1, first, last, false, last == end});
            }
        } else if (!chunks.empty() && chunks.back().whole_sources &&
                   end - chunks.back().first_rock <= most_rocks) {
            chunks.back().last_source = i + 1;
            chunks.back().last_rock = end;
        } else {
            chunks.push_back({i, i + 1, source.first_rock, end, true, false});
        }
    }
    return chunks;
}

void ChunkRows::clear() {
    for (std::size_t c = 0; c < covers; ++c) {
        rocks[c].clear();
        arrivals[c].clear();
        net_crossings[c].clear();
    }
    tree_hits.clear();
    log_hits.clear();
    paths.clear();
    not_started = 0;
}

FedCells::FedCells(std::size_t cells) : cells_{cells}, touched_(covers * cells) {}

FedCells::FedCells(std::span<const std::uint8_t> marks) : FedCells{marks.size() / covers} {
    for (std::size_t i = 0; i < marks.size(); ++i) {
        touched_[i].store(marks[i], std::memory_order_relaxed);
    }
}

std::vector<std::uint8_t> FedCells::marks() const {
    std::vector<std::uint8_t> marks(touched_.size());
    std::transform(touched_.begin(), touched_.end(), marks.begin(),
                   [](const auto& mark) { return mark.load(std::memory_order_relaxed); });
    return marks;
}

void FedCells::add_to(EnsembleTally& tally, std::uint32_t rocks) const {
    for (std::size_t c = 0; c < covers; ++c) {
        for (std::size_t cell = 0; cell < tally.cells[c].cells.size(); ++cell) {
            if (touched_[index(static_cast<Cover>(c), cell)].load(std::memory_order_relaxed) != 0) {
                tally.cells[c].cells[cell].fed_rocks += rocks;
            }
        }
    }
}

Worker::Worker(const Assessment& assessment, std::array<CellHistograms*, covers> histograms)
    : assessment_{assessment},
      histograms_{histograms},
      tally_{assessment.map_frame, assessment.targets.size(), assessment.stems.placed().size(),
             assessment.log_count()} {
    tally_.strata.assign(assessment.draws.size(), StratumTally{assessment.targets.size()});
    for (auto& footprint : footprints_) {
        footprint =
            std::make_unique<Footprint>(assessment.slope.terrain, assessment.map_frame, assessment.targets);
    }
}

namespace {

/// Names each target that two falls both reached; theirs are in rising order.
template <class Both>
void each_reached_by_both(std::span<const TargetArrival> some, std::span<const TargetArrival> others,
                          const Both& both) {
    for (auto a = some.begin(), b = others.begin(); a != some.end() && b != others.end();) {
        if (a->target == b->target) {
            both(a->target);
            ++a;
            ++b;
        } else {
            ++(a->target < b->target ? a : b);
        }
    }
}

}  // namespace

void Worker::run(const Chunk& chunk, ChunkRows& rows, FedCells* fed, std::span<std::uint8_t> gone) {
    FallScratch kept;
    each_start(assessment_, chunk, rows, [&](const RockStart& start) {
        if (assessment_.only_bare()) {
            count(fall_over(Cover::bare, start, {}, nullptr), Cover::bare, start, rows, fed);
            return;
        }
        // A rock that meets nothing in the forest falls the same way on the bare slope.
        BareTwin<Footprint> twin{kept, *footprints_[static_cast<std::size_t>(Cover::bare)]};
        const Footprint& forest = fall_over(Cover::forest, start, gone, &twin);
        const Footprint& bare = twin.end ? twin.observer : forest;
        count(bare, Cover::bare, start, rows, fed);
        count(forest, Cover::forest, start, rows, fed);
        each_reached_by_both(bare.arrivals(), forest.arrivals(), [&](std::uint32_t target) {
            ++tally_.targets[target].reached_both;
            if (!assessment_.draws.empty()) {
                StratumTally& of = tally_.strata[assessment_.stratum_of(start.id)];
                ++of.targets[target].reached_both;
            }
        });
    });
}

const Footprint& Worker::fall_over(Cover cover, const RockStart& start, std::span<std::uint8_t> gone,
                                   BareTwin<Footprint>* twin) {
    Footprint& footprint = *footprints_[static_cast<std::size_t>(cover)];
    footprint.begin(start, assessment_.keeps_path(start.id));
    const Obstacles obstacles = assessment_.obstacles(cover, gone);
    const config::StreamKey key{assessment_.seed, assessment_.replicate, assessment_.year, start.id};
    footprint.finish(fall(assessment_.slope_of(start.id), obstacles, assessment_.law_of(start.id), key, start,
                          scratch_, footprint, twin));
    if (twin != nullptr && twin->end) {
        twin->observer.finish(*twin->end);
    }
    return footprint;
}

void Worker::count(const Footprint& footprint, Cover cover, const RockStart& start, ChunkRows& rows,
                   FedCells* fed) {
    enter_fall(footprint, cover, assessment_, start, tally_, rows, fed,
               histograms_[static_cast<std::size_t>(cover)]);
}

}  // namespace rockfall
