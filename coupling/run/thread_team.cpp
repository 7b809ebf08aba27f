#include "coupling/run/thread_team.hpp"

#include <utility>

namespace coupling {

ThreadTeam::ThreadTeam(int threads) : shares_(static_cast<std::size_t>(threads)) {
    for (std::size_t helper = 1; helper < shares_.size(); ++helper) {
        helpers_.emplace_back([this, helper] { serve(helper); });
    }
}

ThreadTeam::~ThreadTeam() {
    ends_ = true;
    ++round_;
    round_.notify_all();
}

void ThreadTeam::for_each(std::size_t count, const std::function<void(std::size_t)>& work) {
    // All shares are closed: their number lies beyond every count until count and work are those of this
    // round.
    const std::uint32_t round = round_.load() + 1;
    count_ = count;
    work_ = &work;
    done_ = 0;
    for (std::size_t share = 0; share < shares_.size(); ++share) {
        shares_[share].ticket = Ticket{round} << 32U | begin_of(share, count);
    }
    round_ = round;
    if (count > 1) {
        round_.notify_all();
    }
    take_all(0);
    for (std::uint32_t done = done_; done < count; done = done_) {
        done_.wait(done);
    }
    for (Share& share : shares_) {
        share.ticket = Ticket{round} << 32U | numbers;
    }
    if (failure_) {
        std::rethrow_exception(std::exchange(failure_, nullptr));
    }
}

/// Does the work of one number of a share; false if none is left.
bool ThreadTeam::take_one_of(std::size_t share) {
    std::atomic<Ticket>& next = shares_[share].ticket;
    Ticket ticket = next;
    do {
        if ((ticket & numbers) >= begin_of(share + 1, count_)) {
            return false;
        }
    } while (!next.compare_exchange_weak(ticket, ticket + 1));
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

void ThreadTeam::take_all(std::size_t thread) {
    for (std::size_t k = 0; k < shares_.size(); ++k) {
        while (take_one_of((thread + k) % shares_.size())) {
        }
    }
}

void ThreadTeam::serve(std::size_t thread) {
    for (std::uint32_t seen = round_; !ends_; seen = round_) {
        take_all(thread);
        round_.wait(seen);
    }
}

}  // namespace coupling
