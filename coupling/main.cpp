#include "coupling/commands/program.hpp"
#include "coupling/run/interrupt.hpp"

int main(int count, char** words) {
    coupling::end_at_interruptions();
    return coupling::run_program({words + 1, words + count});
}
