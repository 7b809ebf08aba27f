#include "coupling/run/progress.hpp"

#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace coupling {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_between(Clock::time_point from, Clock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
}

/// To the minute where hours are left, to the second where minutes are.
std::string time_in_words(double seconds) {
    const long whole_s = std::lround(seconds);
    if (whole_s < 60) {
        return std::to_string(whole_s) + " s";
    }
    const long minutes = whole_s / 60;
    const bool hours = minutes >= 60;
    const std::string small = std::to_string(hours ? minutes % 60 : whole_s % 60);
    return std::to_string(hours ? minutes / 60 : minutes) + (hours ? " h " : " min ") + small +
           (hours ? " min" : " s");
}

}  // namespace

Progress::Progress(std::string what, std::uint64_t total, std::uint64_t done_before, bool quiet)
    : what_{std::move(what)},
      total_{total},
      done_{done_before},
      done_before_{done_before},
      quiet_{quiet},
      terminal_{isatty(STDERR_FILENO) != 0},
      began_{Clock::now()},
      said_{began_} {}

double Progress::seconds() const {
    return seconds_between(began_, Clock::now());
}

void Progress::add(std::uint64_t more) {
    done_ += more;
    if (quiet_ || total_ == 0) {
        return;
    }
    const std::uint64_t tenths = 10 * done_ / total_;
    constexpr double redraw_s = 0.2;
    const bool due = terminal_ ? seconds_between(said_, Clock::now()) > redraw_s : tenths > tenths_said_;
    if (due) {
        tenths_said_ = tenths;
        said_ = Clock::now();
        say(false);
    }
}

void Progress::finish() {
    if (!quiet_ && terminal_ && total_ > 0) {
        say(true);
    }
}

void Progress::say(bool last) {
    const double elapsed_s = seconds();
    const double rate = elapsed_s > 0.0 ? static_cast<double>(done_ - done_before_) / elapsed_s : 0.0;
    const std::uint64_t left = total_ > done_ ? total_ - done_ : 0;
    const double left_s = rate > 0.0 ? static_cast<double>(left) / rate : 0.0;
    std::fprintf(stderr, "%s%s: %3.0f %%, %llu of %llu, %.*f per second, %s%s%s", terminal_ ? "\r" : "",
                 what_.c_str(), 100.0 * static_cast<double>(done_) / static_cast<double>(total_),
                 static_cast<unsigned long long>(done_), static_cast<unsigned long long>(total_),
                 rate < 10.0 ? 1 : 0, rate, time_in_words(last ? elapsed_s : left_s).c_str(),
                 last ? " in all" : " left", terminal_ ? (last ? "   \n" : "   ") : "\n");
}

}  // namespace coupling
