#include "coupling/assessments/decades/members/share_out.hpp"

#include <algorithm>
#include <mutex>

#include "coupling/exchange/yearly_rockfall.hpp"
#include "coupling/run/first_error.hpp"
#include "coupling/run/interrupt.hpp"
#include "coupling/run/progress.hpp"

namespace coupling::decades {

void share_out(const Crew& crew, const Pieces& pieces, const DoPiece& work) {
    Progress progress{pieces.doing, pieces.steps, 0, crew.quiet};
    std::mutex progress_mutex;
    const auto report = [&](std::uint64_t steps) {
        const std::uint64_t all_steps = crew.ranks.report(steps);
        const std::lock_guard lock{progress_mutex};
        progress.add(all_steps);
    };
    const auto step_done = [&] {
        report(1);
        if (InterruptGuard::requested()) {
            throw Interrupted{};
        }
        if (crew.ranks.stopped()) {
            throw FailedElsewhere{};
        }
    };
    const auto ranks = static_cast<std::size_t>(crew.ranks.count());
    const int share = static_cast<int>((pieces.count + ranks - 1) / ranks);
    const int at_once = std::max(1, std::min(crew.threads, share));
    const int threads_each = at_once > 1 ? 1 : crew.threads;
    FirstError error;
#pragma omp parallel num_threads(at_once)
    for (bool more = true; more && !error.any();) {
        error.guard([&] {
            const std::uint64_t piece = crew.ranks.next(pieces.kind);
            more = piece < pieces.count;
            if (more) {
                work(piece, threads_each, step_done);
            }
        });
    }
    error.rethrow();
    crew.ranks.meet([&] { report(0); });
    progress.finish();
}

}  // namespace coupling::decades
