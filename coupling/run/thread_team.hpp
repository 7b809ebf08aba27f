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

    void serve();
    bool take_one();

    std::atomic<Ticket> ticket_{numbers};
    std::atomic<std::uint64_t> count_{0};
    std::atomic<const std::function<void(std::size_t)>*> work_{nullptr};
    std::atomic<std::uint64_t> done_{0};
    std::atomic<bool> ends_{false};
    std::mutex failing_;
    std::exception_ptr failure_;
    std::vector<std::jthread> helpers_;
};

}  // namespace coupling
