#include "coupling/run/interrupt.hpp"

#include <csignal>

namespace coupling {
namespace {

volatile std::sig_atomic_t interrupted = 0;

void remember(int signal) {
    interrupted = 1;
    std::signal(signal, SIG_DFL);
}

}  // namespace

InterruptGuard::InterruptGuard()
    : former_interrupt_{std::signal(SIGINT, remember)}, former_terminate_{std::signal(SIGTERM, remember)} {
    interrupted = 0;
}

InterruptGuard::~InterruptGuard() {
    std::signal(SIGINT, former_interrupt_);
    std::signal(SIGTERM, former_terminate_);
}

bool InterruptGuard::requested() {
    return interrupted != 0;
}

}  // namespace coupling
