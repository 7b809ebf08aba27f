#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <string>

#include "tests/coupling/inputs/sample_project.hpp"

namespace coupling {

/// How a call of the program ended.
struct Outcome {
    int code = -1;
    std::string out;
    std::string err;
};

/// Calls the program in the folder of a project; `arguments` as in a shell.
inline Outcome call(const SampleProject& project, const std::string& arguments) {
    const SampleProject captured;  // elsewhere, so that nothing appears in the project
    const std::string command = "cd '" + project.folder().string() + "' && '" BANNWALD_PROGRAM "' " +
                                arguments + " > '" + captured.file("out").string() + "' 2> '" +
                                captured.file("err").string() + "'";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, captured.read("out"), captured.read("err")};
}

}  // namespace coupling
