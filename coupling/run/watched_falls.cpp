#include "coupling/run/watched_falls.hpp"

#include <algorithm>
#include <cassert>

#include "rockfall/trajectory.hpp"

namespace coupling {
namespace {

/// One thread's instruments.
class Watch {
public:
    Watch(const rockfall::Assessment& assessment, rockfall::Cover cover, std::span<std::uint8_t> gone)
        : assessment_{assessment},
          obstacles_{assessment.obstacles(cover, gone)},
          footprint_{assessment.slope.terrain, assessment.map_frame, assessment.targets},
          jumps_{assessment.slope.terrain} {}

    void fall(std::uint64_t rock, std::uint32_t source, WatchedFall& out) {
        const config::StreamKey key{assessment_.seed, assessment_.replicate, assessment_.year, rock};
        const auto start = assessment_.start_of_rock(source, key);
        out.started = start.has_value();
        if (!start) {
            out = {};  // nothing of the rock that used this memory before
            return;
        }
        footprint_.begin(*start, assessment_.keeps_path(rock));
        jumps_.begin();
        rockfall::BothWatch<rockfall::Footprint, rockfall::JumpLog> both{footprint_, jumps_};
        footprint_.finish(rockfall::fall(assessment_.slope_of(rock), obstacles_, assessment_.law_of(rock),
                                         key, *start, scratch_, both));
        out.record = footprint_.record();
        out.arrivals.assign(assessment_.targets.size(), {});
        for (const auto& [target, arrival] : footprint_.arrivals()) {
            out.arrivals[target] = arrival;
        }
        out.tree_hits.assign(footprint_.tree_hits().begin(), footprint_.tree_hits().end());
        out.jumps.assign(jumps_.jumps().begin(), jumps_.jumps().end());
        out.visits.assign(footprint_.visits().begin(), footprint_.visits().end());
        out.path.assign(footprint_.path().begin(), footprint_.path().end());
    }

private:
    const rockfall::Assessment& assessment_;
    rockfall::Obstacles obstacles_;
    rockfall::Footprint footprint_;
    rockfall::JumpLog jumps_;
    rockfall::FallScratch scratch_;
};

}  // namespace

Ended watch_falls(const rockfall::Assessment& assessment, rockfall::Cover cover, int threads,
                  const WatchedFallSink& sink, std::span<std::uint8_t> gone) {
    assert(gone.empty() || threads == 1);
    constexpr std::uint32_t rocks_at_once = 64;
    const std::vector<rockfall::Chunk> chunks = rockfall::plan_chunks(assessment.sources, rocks_at_once);
    struct Busy {
        Watch watch;
        std::vector<WatchedFall> falls;
    };
    std::vector<Busy> workers;
    for (int i = 0; i < threads; ++i) {
        workers.push_back({Watch{assessment, cover, gone}, {}});
    }
    const std::size_t fallen = in_order(
        chunks.size(), workers,
        [&](Busy& busy, std::size_t i) {
            const rockfall::Chunk& chunk = chunks[i];
            busy.falls.resize(chunk.last_rock - chunk.first_rock);
            std::uint32_t source = chunk.first_source;
            for (std::uint64_t rock = chunk.first_rock; rock < chunk.last_rock; ++rock) {
                while (rock >= assessment.sources[source].first_rock + assessment.sources[source].rocks) {
                    ++source;
                }
                busy.watch.fall(rock, source, busy.falls[rock - chunk.first_rock]);
            }
        },
        [&](Busy& busy, std::size_t) { std::for_each(busy.falls.begin(), busy.falls.end(), sink); });
    return fallen == chunks.size() ? Ended::done : Ended::interrupted;
}

}  // namespace coupling
