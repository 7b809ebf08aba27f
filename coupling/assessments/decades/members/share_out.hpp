#pragma once

#include <cstdint>
#include <functional>

#include "coupling/run/ranks.hpp"

namespace coupling::decades {

/// Those who do the work of a run: this process with its threads, and the other ranks.
struct Crew {
    RankGroup& ranks;
    int threads = 1;
    bool quiet = false;  ///< no progress is shown
};

/// Work that comes in pieces.
struct Pieces {
    RankGroup::Work kind;
    const char* doing;        ///< for the progress, such as "simulating years"
    std::size_t count = 0;    ///< the same for all ranks
    std::uint64_t steps = 0;  ///< of all pieces together
};

/// Does a piece on so many threads; `step_done` may throw to end it.
using DoPiece = std::function<void(std::size_t piece, int threads, const std::function<void()>& step_done)>;

/// Does all pieces, shared with the other ranks: several at a time, or one after the other on all threads
/// where there are fewer pieces than threads. Ends when all ranks are through. Throws Interrupted,
/// FailedElsewhere, and what the work throws.
void share_out(const Crew& crew, const Pieces& pieces, const DoPiece& work);

}  // namespace coupling::decades
