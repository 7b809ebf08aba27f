#include "coupling/run/fall_rocks.hpp"

#include <omp.h>

#include <atomic>
#include <map>
#include <mutex>

#include "coupling/run/first_error.hpp"
#include "coupling/run/interrupt.hpp"
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

/// Lets each worker fall chunks on a thread of its own by `run` (worker, chunk, rows, fed cells).
template <class AnyWorker, class Run>
Ended fall_by(std::span<const std::unique_ptr<AnyWorker>> workers, const rockfall::Assessment& assessment,
              std::span<const rockfall::Chunk> chunks, const RowSink& sink, const Run& run) {
    PiecesUnderWay pieces{assessment.map_frame.size()};
    FirstError error;
    std::atomic<bool> interrupted = false;
    const auto count = static_cast<std::int64_t>(chunks.size());
#pragma omp parallel num_threads(static_cast <int>(workers.size()))
    {
        AnyWorker& worker = *workers[static_cast<std::size_t>(omp_get_thread_num())];
        rockfall::ChunkRows rows;
#pragma omp for ordered schedule(dynamic, 1)
        for (std::int64_t i = 0; i < count; ++i) {
            const rockfall::Chunk& chunk = chunks[static_cast<std::size_t>(i)];
            rockfall::FedCells* fed = nullptr;
            rows.clear();
            if (InterruptGuard::requested()) {
                interrupted = true;
            }
            if (!interrupted) {
                error.guard([&] {
                    fed = pieces.of(chunk);
                    run(worker, chunk, rows, fed);
                });
            }
#pragma omp ordered
            {
                if (!interrupted) {
                    error.guard([&] {
                        sink(rows);
                        if (chunk.last_piece) {
                            worker.add_fed(*fed, assessment.sources[chunk.first_source].rocks);
                            pieces.forget(chunk.first_source);
                        }
                    });
                }
            }
        }
    }
    error.rethrow();
    return interrupted ? Ended::interrupted : Ended::done;
}

template <class AnyWorker>
void add_up(std::span<std::unique_ptr<AnyWorker>> workers, rockfall::EnsembleTally& total) {
    for (auto& worker : workers) {
        total.add(worker->tally());
        worker.reset();
    }
}

}  // namespace

Ended fall_rocks(const rockfall::Assessment& assessment, std::span<const rockfall::Chunk> chunks,
                 std::array<rockfall::CellHistograms*, rockfall::covers> histograms,
                 std::span<std::uint8_t> gone, int threads, rockfall::EnsembleTally& total,
                 const RowSink& sink) {
    const bool one_after_the_other = !gone.empty();
    std::vector<std::unique_ptr<rockfall::Worker>> workers;
    for (int i = 0; i < (one_after_the_other ? 1 : threads); ++i) {
        workers.push_back(std::make_unique<rockfall::Worker>(assessment, histograms));
    }
    const Ended ended = fall_by<rockfall::Worker>(
        workers, assessment, chunks, sink,
        [&](rockfall::Worker& worker, const rockfall::Chunk& chunk, rockfall::ChunkRows& rows,
            rockfall::FedCells* fed) { worker.run(chunk, rows, fed, gone); });
    if (ended == Ended::done) {
        add_up<rockfall::Worker>(workers, total);
    }
    return ended;
}

Ended fall_rocks_over(rockfall::Cover cover, const rockfall::Assessment& assessment,
                      std::span<const rockfall::Chunk> chunks, int threads, rockfall::EnsembleTally& total,
                      const RowSink& sink) {
    std::vector<std::unique_ptr<rockfall::OneSlopeWorker>> workers;
    for (int i = 0; i < threads; ++i) {
        workers.push_back(std::make_unique<rockfall::OneSlopeWorker>(assessment, cover));
    }
    const Ended ended = fall_by<rockfall::OneSlopeWorker>(
        workers, assessment, chunks, sink,
        [](rockfall::OneSlopeWorker& worker, const rockfall::Chunk& chunk, rockfall::ChunkRows& rows,
           rockfall::FedCells* fed) { worker.run(chunk, rows, fed); });
    if (ended == Ended::done) {
        add_up<rockfall::OneSlopeWorker>(workers, total);
    }
    return ended;
}

}  // namespace coupling
