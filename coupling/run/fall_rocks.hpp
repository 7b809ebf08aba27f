#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "coupling/run/in_order.hpp"
#include "rockfall/ensemble.hpp"

namespace coupling {

/// Receives the rows of each chunk in rock order.
using RowSink = std::function<void(const rockfall::ChunkRows&)>;

/// Sources that are cut into pieces and of which pieces are under way, with the cells that they have fed so
/// far. Between two calls of fall_rocks() there is at most one.
class SourcesUnderWay {
public:
    explicit SourcesUnderWay(std::size_t cells) : cells_{cells} {}

    /// Null for a chunk of whole sources.
    [[nodiscard]] rockfall::FedCells* of(const rockfall::Chunk& chunk);
    void forget(std::uint32_t source);

    /// A source and the marks of its cells; marks are empty where no source is under way.
    struct Begun {
        std::uint32_t source = 0;
        std::vector<std::uint8_t> marks;
    };
    [[nodiscard]] Begun begun() const;
    void take_up(const Begun& begun);

private:
    std::size_t cells_;
    std::mutex mutex_;
    std::map<std::uint32_t, std::unique_ptr<rockfall::FedCells>> fed_;
};

/// Lets the rocks of `chunks` fall on several threads and adds what they leave to `total`.
///
/// `under_way` holds the source that the chunks before have begun, and then the one that these have. Rows
/// reach the sink in chunk order; sums are whole numbers, so nothing depends on the number of threads or on
/// where chunks are parted. With `gone` (a mark per stem, then per log) broken ones go: then one thread does
/// all, in rock order. Returns how many chunks have fallen: all, or after an interruption the first ones,
/// which are whole in `total`, `histograms` and `gone`. Exceptions of the sink are passed on.
std::size_t fall_rocks(const rockfall::Assessment& assessment, std::span<const rockfall::Chunk> chunks,
                       SourcesUnderWay& under_way,
                       std::array<rockfall::CellHistograms*, rockfall::covers> histograms,
                       std::span<std::uint8_t> gone, int threads, rockfall::EnsembleTally& total,
                       const RowSink& sink);

/// The same over one of the two slopes only, with all chunks; no percentiles are kept, nothing breaks for
/// good.
Ended fall_rocks_over(rockfall::Cover cover, const rockfall::Assessment& assessment,
                      std::span<const rockfall::Chunk> chunks, int threads, rockfall::EnsembleTally& total,
                      const RowSink& sink);

}  // namespace coupling
