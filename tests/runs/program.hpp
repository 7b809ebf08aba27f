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

/// Runs a shell script in the folder of a project; `$bannwald` is the program.
inline Outcome shell(const SampleProject& project, const std::string& script) {
    const SampleProject captured;  // elsewhere, so that nothing appears in the project
    captured.write("script.sh", "bannwald='" BANNWALD_PROGRAM "'\ncd '" + project.folder().string() +
                                    "' || exit 99\n" + script);
    const std::string command = "sh '" + captured.file("script.sh").string() + "' > '" +
                                captured.file("out").string() + "' 2> '" + captured.file("err").string() +
                                "'";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, captured.read("out"), captured.read("err")};
}

/// Calls the program in the folder of a project; `arguments` as in a shell.
inline Outcome call(const SampleProject& project, const std::string& arguments) {
    return shell(project, "\"$bannwald\" " + arguments + "\n");
}

}  // namespace coupling
