#include "coupling/run/interrupt.hpp"

#include <unistd.h>

#include <csignal>
#include <string_view>

#include "config/errors/input_error.hpp"

namespace coupling {
namespace {

volatile std::sig_atomic_t interrupted = 0;
int guards = 0;

void remember(int signal) {
    interrupted = 1;
    std::signal(signal, SIG_DFL);
}

/// Calls only what a signal handler may call. SIGTERM comes from a launcher, which sends it to all processes
/// of a run where one of them has already printed why it ends.
void end(int signal) {
    if (signal == SIGINT) {
        constexpr std::string_view sentence = "bannwald: interrupted\n";
        [[maybe_unused]] const auto written = ::write(STDERR_FILENO, sentence.data(), sentence.size());
    }
    _exit(static_cast<int>(config::ExitCode::interrupted));
}

}  // namespace

void end_at_interruptions() {
    std::signal(SIGINT, end);
    std::signal(SIGTERM, end);
}

void fail_at_too_large_files() {
    std::signal(SIGXFSZ, SIG_IGN);
}

InterruptGuard::InterruptGuard() {
    if (guards++ == 0) {
        interrupted = 0;
        former_interrupt_ = std::signal(SIGINT, remember);
        former_terminate_ = std::signal(SIGTERM, remember);
    }
}

InterruptGuard::~InterruptGuard() {
    if (--guards == 0) {
        std::signal(SIGINT, former_interrupt_);
        std::signal(SIGTERM, former_terminate_);
    }
}

bool InterruptGuard::requested() {
    return interrupted != 0;
}

}  // namespace coupling
