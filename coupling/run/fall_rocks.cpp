#include "coupling/run/fall_rocks.hpp"

#include <map>
#include <mutex>

#include "rockfall/one_slope.hpp"

namespace coupling {
namespace {

/// The cells fed by each source that is cut into pieces, while its pieces are under way.
class PiecesUnderWay {
public:
    explicit PiecesUnderWay(std::size_t cells) : cells_{cells} {}
    rockfall::FedCells* of(const rockfall::Chunk& chunk) {
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
    void forget(std::uint32_t source) {
        const std::lock_guard lock{mutex_};
        fed_.erase(source);
    }

private:
    std::size_t cells_;
    std::mutex mutex_;
    std::map<std::uint32_t, std::unique_ptr<rockfall::FedCells>> fed_;
};

/// A worker and the rows of the chunk that it has under way.
template <class AnyWorker>
struct Busy {
    std::unique_ptr<AnyWorker> worker;
    rockfall::ChunkRows rows = {};
    rockfall::FedCells* fed = nullptr;
};

/// Lets each worker fall chunks on a thread of its own by `run` (busy worker, chunk).
template <class AnyWorker, class Run>
Ended fall_by(std::vector<Busy<AnyWorker>>& workers, const rockfall::Assessment& assessment,
              std::span<const rockfall::Chunk> chunks, const RowSink& sink, const Run& run) {
    PiecesUnderWay pieces{assessment.map_frame.size()};
    return in_order(
        chunks.size(), workers,
        [&](Busy<AnyWorker>& busy, std::size_t i) {
            busy.rows.clear();
            busy.fed = pieces.of(chunks[i]);
            run(busy, chunks[i]);
        },
        [&](Busy<AnyWorker>& busy, std::size_t i) {
            sink(busy.rows);
            if (chunks[i].last_piece) {
                busy.worker->add_fed(*busy.fed, assessment.sources[chunks[i].first_source].rocks);
                pieces.forget(chunks[i].first_source);
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

Ended fall_rocks(const rockfall::Assessment& assessment, std::span<const rockfall::Chunk> chunks,
                 std::array<rockfall::CellHistograms*, rockfall::covers> histograms,
                 std::span<std::uint8_t> gone, int threads, rockfall::EnsembleTally& total,
                 const RowSink& sink) {
    const bool one_after_the_other = !gone.empty();
    std::vector<Busy<rockfall::Worker>> workers;
    for (int i = 0; i < (one_after_the_other ? 1 : threads); ++i) {
        workers.push_back({std::make_unique<rockfall::Worker>(assessment, histograms)});
    }
    const Ended ended = fall_by(workers, assessment, chunks, sink,
                                [&](Busy<rockfall::Worker>& busy, const rockfall::Chunk& chunk) {
                                    busy.worker->run(chunk, busy.rows, busy.fed, gone);
                                });
    if (ended == Ended::done) {
        add_up(workers, total);
    }
    return ended;
}

Ended fall_rocks_over(rockfall::Cover cover, const rockfall::Assessment& assessment,
                      std::span<const rockfall::Chunk> chunks, int threads, rockfall::EnsembleTally& total,
                      const RowSink& sink) {
    std::vector<Busy<rockfall::OneSlopeWorker>> workers;
    for (int i = 0; i < threads; ++i) {
        workers.push_back({std::make_unique<rockfall::OneSlopeWorker>(assessment, cover)});
    }
    const Ended ended = fall_by(workers, assessment, chunks, sink,
                                [](Busy<rockfall::OneSlopeWorker>& busy, const rockfall::Chunk& chunk) {
                                    busy.worker->run(chunk, busy.rows, busy.fed);
                                });
    if (ended == Ended::done) {
        add_up(workers, total);
    }
    return ended;
}

}  // namespace coupling
