#pragma once

#include <omp.h>

#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <optional>
#include <vector>

#include "coupling/run/first_error.hpp"
#include "coupling/run/interrupt.hpp"

namespace coupling {

/// How long work ended.
enum class [[nodiscard]] Ended{done, interrupted};

/// Pieces 0, 1, 2 …, taken by any thread and handed on in their order.
///
/// A thread that is ahead sleeps until its turn instead of looking for it all the time: on a busy machine it
/// would keep the thread from running that everybody waits for.
class Turns {
public:
    explicit Turns(std::size_t pieces) : pieces_{pieces} {}

    /// The next piece that nobody has; nothing once all are taken or no more are wanted.
    [[nodiscard]] std::optional<std::size_t> take() {
        const std::lock_guard lock{mutex_};
        return next_ == pieces_ ? std::nullopt : std::optional{next_++};
    }
    /// Waits until all pieces before were handed on. False if that will never be: one of them failed.
    [[nodiscard]] bool wait_for(std::size_t piece) {
        std::unique_lock lock{mutex_};
        turn_.wait(lock, [&] { return failed_ || handed_on_ == piece; });
        return !failed_;
    }
    void pass_on() {
        const std::lock_guard lock{mutex_};
        ++handed_on_;
        turn_.notify_all();
    }
    /// What is taken is still handed on.
    void take_no_more() {
        const std::lock_guard lock{mutex_};
        pieces_ = next_;
    }
    void fail() {
        const std::lock_guard lock{mutex_};
        pieces_ = next_;
        failed_ = true;
        turn_.notify_all();
    }
    /// Once all threads are through.
    [[nodiscard]] std::size_t handed_on() const { return handed_on_; }

private:
    std::size_t pieces_;
    std::size_t next_ = 0;
    std::size_t handed_on_ = 0;
    bool failed_ = false;
    std::mutex mutex_;
    std::condition_variable turn_;
};

/// Lets each worker do pieces of the work on a thread of its own: `work` (worker, piece) on all threads at
/// once, `hand_on` (worker, piece) on one at a time and in the order of the pieces. A worker hands a piece on
/// before it begins another, so that no more results wait than there are workers.
///
/// Returns how many pieces were handed on: all, or after an interruption the first ones. Pieces that were
/// begun are handed on in any case, so that workers hold nothing of others. Rethrows the first exception.
template <class Worker, class Work, class HandOn>
std::size_t in_order(std::size_t pieces, std::vector<Worker>& workers, const Work& work,
                     const HandOn& hand_on) {
    Turns turns{pieces};
    FirstError error;
#pragma omp parallel num_threads(static_cast <int>(workers.size()))
    {
        Worker& worker = workers[static_cast<std::size_t>(omp_get_thread_num())];
        while (true) {
            if (InterruptGuard::requested()) {
                turns.take_no_more();
            }
            const auto piece = turns.take();
            if (!piece) {
                break;
            }
            error.guard([&] {
                work(worker, *piece);
                if (turns.wait_for(*piece)) {
                    hand_on(worker, *piece);
                    turns.pass_on();
                }
            });
            if (error.any()) {
                turns.fail();
            }
        }
    }
    error.rethrow();
    return turns.handed_on();
}

}  // namespace coupling
