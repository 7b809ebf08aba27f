#pragma once

namespace coupling {

/// Thrown from within long work to end it: the user asked for that. What was finished before stays.
struct Interrupted {};

/// From now on Ctrl-C and a request to terminate end the program at once with the exit code of an
/// interruption, Ctrl-C with a sentence: where nothing lies half-written, nothing has to be tidied up.
void end_at_interruptions();

/// From now on a write beyond the largest file that is allowed (`ulimit -f`) fails as on a full disk, instead
/// of ending the program without a word.
void fail_at_too_large_files();

/// Turns Ctrl-C and a request to terminate into a flag that long work looks at.
///
/// Made before anything is written. A second Ctrl-C ends the program. Guards may be nested: the flag stays
/// for the outer ones. Restores the former handlers at the end of its life.
class InterruptGuard {
public:
    InterruptGuard();
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;

    [[nodiscard]] static bool requested();

private:
    using Handler = void (*)(int);
    Handler former_interrupt_ = nullptr;
    Handler former_terminate_ = nullptr;
};

}  // namespace coupling
