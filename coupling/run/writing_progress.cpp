#include "coupling/run/writing_progress.hpp"

#include <unistd.h>

#include <cstdio>

#include "config/text/joined.hpp"
#include "coupling/run/interrupt.hpp"

namespace coupling {
namespace {

using config::joined;

constexpr std::chrono::milliseconds between_redraws{200};
constexpr std::chrono::seconds between_log_lines{10};

}  // namespace

WritingProgress::WritingProgress(bool quiet)
    : quiet_{quiet}, terminal_{isatty(STDERR_FILENO) != 0}, said_{std::chrono::steady_clock::now()} {}

WritingProgress::~WritingProgress() {
    clear_line();
}

WriteWatch WritingProgress::watch() {
    return WriteWatch{[this](std::string_view what, double share) { report(what, share); }};
}

void WritingProgress::report(std::string_view what, double share) {
    if (InterruptGuard::requested()) {
        throw Interrupted{};
    }
    const auto now = std::chrono::steady_clock::now();
    const bool due = terminal_ ? now - said_ > between_redraws : now - said_ > between_log_lines;
    if (quiet_ || !due) {
        return;
    }
    said_ = now;
    clear_line();
    const int percent = static_cast<int>(100.0 * share);
    const std::string line = joined("writing results: ", std::string{what},
                                    percent > 0 ? joined(", ", std::to_string(percent), " %") : "");
    std::fprintf(stderr, "%s%s", line.c_str(), terminal_ ? "" : "\n");
    shown_letters_ = line.size();
}

void WritingProgress::clear_line() {
    if (terminal_ && shown_letters_ > 0) {
        std::fprintf(stderr, "\r%*s\r", static_cast<int>(shown_letters_), "");
        shown_letters_ = 0;
    }
}

}  // namespace coupling
