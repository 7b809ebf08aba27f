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
    for (auto& footprint : footprints_) {
        footprint =
            std::make_unique<Footprint>(assessment.slope.terrain, assessment.map_frame, assessment.targets);
    }
}

void Worker::run(const Chunk& chunk, ChunkRows& rows, FedCells* fed, std::span<std::uint8_t> gone) {
    each_start(assessment_, chunk, rows, [&](const RockStart& start) {
        fall_over(Cover::bare, start, rows, fed, {});
        if (!assessment_.only_bare()) {
            fall_over(Cover::forest, start, rows, fed, gone);
            const auto bare = footprints_[static_cast<std::size_t>(Cover::bare)]->arrivals();
            const auto forest = footprints_[static_cast<std::size_t>(Cover::forest)]->arrivals();
            for (auto of_bare = bare.begin(), of_forest = forest.begin();
                 of_bare != bare.end() && of_forest != forest.end();) {
                if (of_bare->target == of_forest->target) {
                    ++tally_.targets[of_bare->target].reached_both;
                    ++of_bare;
                    ++of_forest;
                } else {
                    ++(of_bare->target < of_forest->target ? of_bare : of_forest);
                }
            }
        }
    });
}

void Worker::fall_over(Cover cover, const RockStart& start, ChunkRows& rows, FedCells* fed,
                       std::span<std::uint8_t> gone) {
    Footprint& footprint = *footprints_[static_cast<std::size_t>(cover)];
    footprint.begin(start, assessment_.keeps_path(start.id));
    const Obstacles obstacles = assessment_.obstacles(cover, gone);
    const config::StreamKey key{assessment_.seed, assessment_.replicate, assessment_.year, start.id};
    footprint.finish(fall(assessment_.slope, obstacles, assessment_.law, key, start, scratch_, footprint));
    count(cover, rows, fed, start);
}

void Worker::count(Cover cover, ChunkRows& rows, FedCells* fed, const RockStart& start) {
    const auto c = static_cast<std::size_t>(cover);
    enter_fall(*footprints_[c], cover, assessment_, start, tally_, rows, fed, histograms_[c]);
}

}  // namespace rockfall
