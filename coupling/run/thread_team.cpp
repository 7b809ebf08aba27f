#include "coupling/run/thread_team.hpp"

#include <utility>

namespace coupling {

ThreadTeam::ThreadTeam(int threads) {
    for (int helper = 1; helper < threads; ++helper) {
        helpers_.emplace_back([this] { serve(); });
    }
}

ThreadTeam::~ThreadTeam() {
    ends_ = true;
    ticket_ += numbers + 1;
    ticket_.notify_all();
}

void ThreadTeam::for_each(std::size_t count, const std::function<void(std::size_t)>& work) {
    // The ticket is closed: its number lies beyond every count until count and work are those of this round.
    const Ticket round = (ticket_.load() | numbers) + 1;
    count_ = count;
    work_ = &work;
    done_ = 0;
    ticket_ = round;
    if (count > 1) {
        ticket_.notify_all();
    }
    while (take_one()) {
    }
    for (std::uint64_t done = done_; done < count; done = done_) {
        done_.wait(done);
    }
    ticket_ = round | numbers;
    if (failure_) {
        std::rethrow_exception(std::exchange(failure_, nullptr));
    }
}

/// Does the work of one number; false if none is left.
bool ThreadTeam::take_one() {
    Ticket ticket = ticket_;
    do {
        if ((ticket & numbers) >= count_) {
            return false;
        }
    } while (!ticket_.compare_exchange_weak(ticket, ticket + 1));
    // The round cannot end before this number is done.
    try {
        (*work_)(static_cast<std::size_t>(ticket & numbers));
    } catch (...) {
        const std::lock_guard lock{failing_};
        if (!failure_) {
            failure_ = std::current_exception();
        }
    }
    if (++done_ == count_) {
        done_.notify_all();
    }
    return true;
}

void ThreadTeam::serve() {
    while (!ends_) {
        const Ticket seen = ticket_;
        if (!take_one()) {
            ticket_.wait(seen);
        }
    }
}

}  // namespace coupling
