#include "coupling/run/fall_rocks.hpp"

#include <cassert>

#include "rockfall/one_slope.hpp"

namespace coupling {
namespace {

/// A worker and the rows of the chunk that it has under way.
template <class AnyWorker>
struct Busy {
    std::unique_ptr<AnyWorker> worker;
    rockfall::ChunkRows rows = {};
    rockfall::FedCells* fed = nullptr;
};

/// Lets each worker fall chunks on a thread of its own by `run` (busy worker, chunk).
template <class AnyWorker, class Run>
std::size_t fall_by(std::vector<Busy<AnyWorker>>& workers, const rockfall::Assessment& assessment,
                    std::span<const rockfall::Chunk> chunks, SourcesUnderWay& under_way, const RowSink& sink,
                    const Run& run) {
    return in_order(
        chunks.size(), workers,
        [&](Busy<AnyWorker>& busy, std::size_t i) {
            busy.rows.clear();
            busy.fed = under_way.of(chunks[i]);
            run(busy, chunks[i]);
        },
        [&](Busy<AnyWorker>& busy, std::size_t i) {
            sink(busy.rows);
            if (chunks[i].last_piece) {
                busy.worker->add_fed(*busy.fed, assessment.sources[chunks[i].first_source].rocks);
                under_way.forget(chunks[i].first_source);
            }
        });
}

template <class AnyWorker>
void add_up(std::vector<Busy<AnyWorker>>& workers, rockfall::EnsembleTally& total) {
    for (auto& busy : workers) {
        total.add(busy.worker->tally());
        busy.worker.reset();
    }
}

}  // namespace

rockfall::FedCells* SourcesUnderWay::of(const rockfall::Chunk& chunk) {
    if (chunk.whole_sources) {
        return nullptr;
    }
    const std::lock_guard lock{mutex_};
    auto& fed = fed_[chunk.first_source];
    if (!fed) {
        fed = std::make_unique<rockfall::FedCells>(cells_);
    }
    return fed.get();
}

void SourcesUnderWay::forget(std::uint32_t source) {
    const std::lock_guard lock{mutex_};
    fed_.erase(source);
}

SourcesUnderWay::Begun SourcesUnderWay::begun() const {
    assert(fed_.size() <= 1);
    return fed_.empty() ? Begun{} : Begun{fed_.begin()->first, fed_.begin()->second->marks()};
}

void SourcesUnderWay::take_up(const Begun& begun) {
    fed_.clear();
    if (!begun.marks.empty()) {
        fed_[begun.source] = std::make_unique<rockfall::FedCells>(begun.marks);
    }
}

std::size_t fall_rocks(const rockfall::Assessment& assessment, std::span<const rockfall::Chunk> chunks,
                       SourcesUnderWay& under_way,
                       std::array<rockfall::CellHistograms*, rockfall::covers> histograms,
                       std::span<std::uint8_t> gone, int threads, rockfall::EnsembleTally& total,
                       const RowSink& sink) {
    const bool one_after_the_other = !gone.empty();
    std::vector<Busy<rockfall::Worker>> workers;
    for (int i = 0; i < (one_after_the_other ? 1 : threads); ++i) {
        workers.push_back({std::make_unique<rockfall::Worker>(assessment, histograms)});
    }
    const std::size_t fallen = fall_by(workers, assessment, chunks, under_way, sink,
                                       [&](Busy<rockfall::Worker>& busy, const rockfall::Chunk& chunk) {
                                           busy.worker->run(chunk, busy.rows, busy.fed, gone);
                                       });
    add_up(workers, total);
    return fallen;
}

Ended fall_rocks_over(rockfall::Cover cover, const rockfall::Assessment& assessment,
                      std::span<const rockfall::Chunk> chunks, int threads, rockfall::EnsembleTally& total,
                      const RowSink& sink) {
    std::vector<Busy<rockfall::OneSlopeWorker>> workers;
    for (int i = 0; i < threads; ++i) {
        workers.push_back({std::make_unique<rockfall::OneSlopeWorker>(assessment, cover)});
    }
    SourcesUnderWay under_way{assessment.map_frame.size()};
    const std::size_t fallen =
        fall_by(workers, assessment, chunks, under_way, sink,
                [](Busy<rockfall::OneSlopeWorker>& busy, const rockfall::Chunk& chunk) {
                    busy.worker->run(chunk, busy.rows, busy.fed);
                });
    add_up(workers, total);
    return fallen == chunks.size() ? Ended::done : Ended::interrupted;
}

}  // namespace coupling
