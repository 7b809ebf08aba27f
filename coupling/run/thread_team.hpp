#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace coupling {

/// Threads that share short pieces of work, thousands of times a second, and sleep in between.
///
/// Threads of OpenMP spin while they wait: on busy cores they take the time of the one that they wait for.
/// Here a helper without work sleeps until there is some, and nobody waits for a helper that has taken none.
///
/// Each thread takes the numbers of a share of its own, one after the other and the same in each round, so
/// that what it read and wrote in the last one is near it. Then it helps with those of the others.
class ThreadTeam {
public:
    /// The caller of `for_each` and `threads` - 1 helpers. Requires one thread at least.
    explicit ThreadTeam(int threads);
    ~ThreadTeam();
    ThreadTeam(const ThreadTeam&) = delete;
    ThreadTeam& operator=(const ThreadTeam&) = delete;

    /// Calls `work` for each number below `count`, in any order and from several threads; returns when all
    /// are done. Throws the first of what `work` threw. Requires less than 2^32 - 1 numbers, and one caller.
    void for_each(std::size_t count, const std::function<void(std::size_t)>& work);

private:
    /// A round in the upper half, the next number to be taken in the lower one: whoever takes a number takes
    /// it in the round that goes on.
    using Ticket = std::uint64_t;
    static constexpr Ticket numbers = 0xFFFF'FFFFULL;
    /// What one thread takes first: a line of the cache of its own.
    struct alignas(128) Share {
        std::atomic<Ticket> ticket{numbers};
    };

    void serve(std::size_t thread);
    [[nodiscard]] Ticket begin_of(std::size_t share, Ticket count) const {
        return count * share / shares_.size();
    }
    bool take_one_of(std::size_t share);
    void take_all(std::size_t thread);

    std::vector<Share> shares_;
    std::atomic<std::uint32_t> round_{0};
    std::atomic<Ticket> count_{0};
    std::atomic<const std::function<void(std::size_t)>*> work_{nullptr};
    alignas(128) std::atomic<std::uint32_t> done_{0};
    std::atomic<bool> ends_{false};
    std::mutex failing_;
    std::exception_ptr failure_;
    std::vector<std::jthread> helpers_;
};

}  // namespace coupling
