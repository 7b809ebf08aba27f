#pragma once

#include <chrono>
#include <string>
#include <string_view>

#include "coupling/results/disk/write_watch.hpp"

namespace coupling {

/// Shows on stderr what is being written: one line redrawn on a terminal, a line every ten seconds in a log.
class WritingProgress {
public:
    /// A quiet progress shows nothing.
    explicit WritingProgress(bool quiet);
    ~WritingProgress();
    WritingProgress(const WritingProgress&) = delete;
    WritingProgress& operator=(const WritingProgress&) = delete;

    /// For the writers, as long as this object lives. Calls of it throw Interrupted once an
    /// interruption was asked for (InterruptGuard).
    [[nodiscard]] WriteWatch watch();

private:
    void report(std::string_view what, double share);
    void clear_line();

    bool quiet_;
    bool terminal_;
    std::size_t shown_letters_ = 0;
    std::chrono::steady_clock::time_point said_;
};

}  // namespace coupling
