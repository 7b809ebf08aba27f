#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <sstream>
#include <string>

#include "tests/coupling/inputs/sample_project.hpp"

namespace coupling {

/// How a call of the program ended.
struct Outcome {
    int code = -1;
    std::string out;
    std::string err;
};

/// The warnings on the screen about files, without those of a survey whose cells of 5 m lean walls: these are
/// limits of real terrains.
inline std::string warnings_of_files(const Outcome& outcome) {
    std::istringstream lines{outcome.err};
    std::string warnings;
    for (std::string line; std::getline(lines, line);) {
        const bool is_limit = line.find("walls rise within one or two cells of 5 m") != std::string::npos;
        warnings += is_limit || line.find("warning") == std::string::npos ? "" : line + "\n";
    }
    return warnings;
}

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

/// Starts a call of the program, sends it a signal once a file is there (wildcards allowed) and ends with its
/// exit code. No time is given: a busy machine may take any.
inline std::string interrupted_once(const std::string& file, const std::string& arguments,
                                    const std::string& signal = "INT") {
    return "\"$bannwald\" " + arguments + " &\nwhile kill -0 $! 2>/dev/null && ! ls " + file +
           " >/dev/null 2>&1; do sleep 0.01; done\nkill -" + signal + " $!\nwait $!\n";
}

/// The same, in a fresh folder again and again until the program was interrupted before it was through: ends
/// with its code 75 then. A machine may be faster than a signal, but not twenty times.
inline std::string interrupted_for_certain(const std::string& folder, const std::string& file,
                                           const std::string& arguments) {
    return "for i in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20; do\nrm -rf " + folder + "\n" +
           interrupted_once(file, arguments) + "[ $? -eq 75 ] && exit 75\ndone\nexit 1\n";
}

/// The same once the program answers signals at all, before it reads anything: once it catches SIGTERM, which
/// the shell that starts it does not.
inline std::string interrupted_at_once(const std::string& arguments) {
    return "\"$bannwald\" " + arguments +
           " &\nwhile kill -0 $! 2>/dev/null && ! grep -q 'SigCgt:.*[4567cdef]...$' /proc/$!/status; do :; "
           "done\n"
           "kill -INT $!\nwait $!\n";
}

}  // namespace coupling
