#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace fuzz {

/// What reading one input may take [choice]. The inputs are small (mutate.hpp), most of them some kilobytes.
inline constexpr int longest_cpu_seconds = 20;
inline constexpr int longest_wait_seconds = 600;  ///< for what computes nothing and never ends
inline constexpr std::size_t most_bytes = std::size_t{512} << 20U;  ///< of memory that is really used

/// Watches what is read: a crash, a fault found by a sanitizer or an endless reading ends the process after
/// the line that `begin` was given last, which says how to repeat it.
class Watch {
public:
    Watch();
    /// An input begins. `how_to_repeat` is printed if it ends the process.
    void begin(const std::string& how_to_repeat);
    /// It ended.
    void end();
    [[nodiscard]] double cpu_seconds() const { return cpu_seconds_; }       ///< of the last input
    [[nodiscard]] std::size_t grown_bytes() const { return grown_bytes_; }  ///< by it, at most

private:
    double begun_s_ = 0.0;
    std::size_t begun_bytes_ = 0;
    double cpu_seconds_ = 0.0;
    std::size_t grown_bytes_ = 0;
};

}  // namespace fuzz
