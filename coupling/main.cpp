#include "coupling/commands/program.hpp"

int main(int count, char** words) {
    return coupling::run_program({words + 1, words + count});
}
