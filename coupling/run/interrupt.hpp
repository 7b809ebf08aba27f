#pragma once

namespace coupling {

/// Turns Ctrl-C and a request to terminate into a flag that long work looks at.
///
/// A second Ctrl-C ends the program at once. Restores the former handlers at the end of its life.
class InterruptGuard {
public:
    InterruptGuard();
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;

    [[nodiscard]] static bool requested();

private:
    using Handler = void (*)(int);
    Handler former_interrupt_;
    Handler former_terminate_;
};

}  // namespace coupling
