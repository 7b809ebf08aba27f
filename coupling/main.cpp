#include <malloc.h>

#include "coupling/program/commands.hpp"
#include "coupling/program/program.hpp"
#include "coupling/run/interrupt.hpp"
#include "validation/engine/command.hpp"

namespace {

void answer_signals() {
    coupling::end_at_interruptions();
    coupling::fail_at_too_large_files();
}

/// Called before the libraries set themselves up, which takes longer than anything else before `main`: a job
/// that is terminated as soon as it starts ends with the exit code of an interruption too.
[[gnu::section(".preinit_array"), gnu::used]] void (*const before_everything)() = answer_signals;

/// A year of the forest takes some megabytes and frees them, thousands of times. The C library would return
/// them to the system each time, and the system would clear their pages again: two thirds of the time of a
/// run of forests.
void keep_freed_memory() {
    constexpr int mebibyte = 1 << 20;
    mallopt(M_MMAP_THRESHOLD, 32 * mebibyte);
    mallopt(M_TRIM_THRESHOLD, 64 * mebibyte);
}

}  // namespace

int main(int count, char** words) {
    keep_freed_memory();
    std::vector<coupling::Command> commands = coupling::commands_of_the_program();
    commands.push_back(coupling::validation::validate_command());
    return coupling::run_program(commands, {words + 1, words + count});
}
