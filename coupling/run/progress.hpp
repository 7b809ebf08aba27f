#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace coupling {

/// Tells on stderr how far long work is: one line redrawn on a terminal, a line per tenth in a log.
class Progress {
public:
    /// `done_before` was done by an earlier run. A quiet progress says nothing.
    Progress(std::string what, std::uint64_t total, std::uint64_t done_before, bool quiet);
    void add(std::uint64_t more);
    /// Ends the line on a terminal.
    void finish();
    [[nodiscard]] double seconds() const;

private:
    void say(bool last);

    std::string what_;
    std::uint64_t total_;
    std::uint64_t done_;
    std::uint64_t done_before_;
    bool quiet_;
    bool terminal_;
    std::uint64_t tenths_said_ = 0;
    std::chrono::steady_clock::time_point began_;
    std::chrono::steady_clock::time_point said_;
};

}  // namespace coupling
