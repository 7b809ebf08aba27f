#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "coupling/run/in_order.hpp"
#include "rockfall/ensemble.hpp"
#include "rockfall/tally/jump_log.hpp"

namespace coupling {

/// One rock, followed from release to rest.
struct WatchedFall {
    bool started = false;  ///< false: its place lies outside the terrain; nothing else is filled
    rockfall::RockRecord record;
    std::vector<rockfall::Arrival> arrivals;  ///< target by target
    std::vector<rockfall::TreeHitRecord> tree_hits;
    std::vector<rockfall::Jump> jumps;
    std::vector<rockfall::CellVisit> visits;  ///< cells of assessment.map_frame that it passed
    std::vector<rockfall::PathPoint> path;    ///< of every assessment.path_every-th rock
};

using WatchedFallSink = std::function<void(const WatchedFall&)>;

/// Lets all rocks of the assessment's sources fall over one slope, on several threads, and hands each fall to
/// the sink in rock order. For ensembles of which every jump is wanted; maps come from fall_rocks().
///
/// Cover::forest meets the assessment's stems, Cover::bare does not. Ends soon after an interruption, with
/// part of the falls handed on. Exceptions of the sink are passed on. `gone` marks stems that no longer stand
/// (empty: all stand); where broken trees fall, falls enter theirs, so that it needs one thread then.
Ended watch_falls(const rockfall::Assessment& assessment, rockfall::Cover cover, int threads,
                  const WatchedFallSink& sink, std::span<std::uint8_t> gone = {});

}  // namespace coupling
