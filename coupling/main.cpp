#include "coupling/commands/program.hpp"
#include "coupling/run/interrupt.hpp"

namespace {

void answer_signals() {
    coupling::end_at_interruptions();
    coupling::fail_at_too_large_files();
}

/// Called before the libraries set themselves up, which takes longer than anything else before `main`: a job
/// that is terminated as soon as it starts ends with the exit code of an interruption too.
[[gnu::section(".preinit_array"), gnu::used]] void (*const before_everything)() = answer_signals;

}  // namespace

int main(int count, char** words) {
    return coupling::run_program({words + 1, words + count});
}
