#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "coupling/run/in_order.hpp"
#include "rockfall/ensemble.hpp"

namespace coupling {

/// Receives the rows of each chunk in rock order.
using RowSink = std::function<void(const rockfall::ChunkRows&)>;

/// Lets the rocks of `chunks` fall on several threads and adds what they leave to `total`.
///
/// The chunks must hold whole sources between them. Rows reach the sink in chunk order; sums are whole
/// numbers, so nothing depends on the number of threads. With `gone` (a mark per stem, then per log) broken
/// ones go: then one thread does all, in rock order. When interrupted, `total` is left as it was. Exceptions
/// of the sink are passed on.
Ended fall_rocks(const rockfall::Assessment& assessment, std::span<const rockfall::Chunk> chunks,
                 std::array<rockfall::CellHistograms*, rockfall::covers> histograms,
                 std::span<std::uint8_t> gone, int threads, rockfall::EnsembleTally& total,
                 const RowSink& sink);

/// The same over one of the two slopes only; no percentiles are kept, nothing breaks for good.
Ended fall_rocks_over(rockfall::Cover cover, const rockfall::Assessment& assessment,
                      std::span<const rockfall::Chunk> chunks, int threads, rockfall::EnsembleTally& total,
                      const RowSink& sink);

}  // namespace coupling
