#include "tests/faults/trial.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace faults {
namespace {

namespace fs = std::filesystem;

/// A run takes a second; one that has not ended after this time waits for something that does not come.
constexpr std::chrono::seconds patience{300};

std::string bytes_of(const fs::path& file) {
    std::ifstream in{file, std::ios::binary | std::ios::ate};
    std::string bytes(in ? static_cast<std::size_t>(in.tellg()) : 0, '\0');
    in.seekg(0).read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return bytes;
}

/// What `execve` takes: pointers to texts, closed by a null.
std::vector<char*> pointers(std::vector<std::string>& texts) {
    std::vector<char*> list;
    for (std::string& text : texts) {
        list.push_back(text.data());
    }
    list.push_back(nullptr);
    return list;
}

std::vector<std::string> environment_with(const Program& program, const Fault& fault, const fs::path& log) {
    std::vector<std::string> texts{"LD_PRELOAD=" + program.library.string(),
                                   "BANNWALD_FAULT_FOLDER=" + (program.project / "out").string(),
                                   "BANNWALD_FAULT_READ_FOLDER=" + program.project.string(),
                                   "BANNWALD_FAULT_MODE=" + fault.mode,
                                   "BANNWALD_FAULT_AT=" + std::to_string(fault.at),
                                   "BANNWALD_FAULT_LOG=" + log.string()};
    for (char** variable = environ; *variable != nullptr; ++variable) {
        texts.emplace_back(*variable);
    }
    return texts;
}

std::vector<Operation> operations_of(const fs::path& log) {
    std::vector<Operation> operations;
    std::ifstream in{log};
    for (std::string line; std::getline(in, line);) {
        std::istringstream words{line};
        Operation operation;
        std::string outcome;
        std::string path;
        words >> operation.number >> operation.name >> outcome >> std::ws;
        std::getline(words, path);
        operation.disturbed = outcome != "ok";
        operation.path = path;
        operations.push_back(std::move(operation));
    }
    return operations;
}

/// Waits for a process; one that hangs is ended.
void wait_for(pid_t process, Ending& ending) {
    const auto start = std::chrono::steady_clock::now();
    int status = 0;
    while (waitpid(process, &status, WNOHANG) == 0) {
        if (!ending.hung && std::chrono::steady_clock::now() - start > patience) {
            ending.hung = true;
            kill(process, SIGKILL);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds{2});
    }
    ending.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    ending.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}

std::map<fs::path, fs::path> files_below(const fs::path& folder) {
    std::map<fs::path, fs::path> files;
    if (fs::exists(folder)) {
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator{folder}) {
            files[entry.path().lexically_relative(folder)] = entry.path();
        }
    }
    return files;
}

bool same(const fs::path& one, const fs::path& other) {
    return fs::is_directory(one) || fs::is_directory(other)
               ? fs::is_directory(one) == fs::is_directory(other)
               : fs::file_size(one) == fs::file_size(other) && bytes_of(one) == bytes_of(other);
}

}  // namespace

bool counts_reads(const std::string& mode) {
    return mode == "unread" || mode == "eintr" || mode == "count_all";
}

Ending run(const Program& program, const std::vector<std::string>& arguments, const Fault& fault) {
    const fs::path log = program.scratch / "log";
    const fs::path messages = program.scratch / "messages";
    fs::remove(log);
    std::vector<std::string> words{program.program.string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<std::string> environment = environment_with(program, fault, log);
    const std::vector<char*> word_list = pointers(words);
    const std::vector<char*> environment_list = pointers(environment);

    const pid_t process = fork();
    if (process < 0) {
        throw std::runtime_error{"no process can be started"};
    }
    if (process == 0) {
        const int nowhere = open("/dev/null", O_RDWR);
        const int errors = open(messages.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
        if (dup2(nowhere, 0) < 0 || dup2(nowhere, 1) < 0 || dup2(errors, 2) < 0 ||
            chdir(program.project.c_str()) != 0) {
            _exit(127);
        }
        execve(program.program.c_str(), word_list.data(), environment_list.data());
        _exit(127);
    }
    Ending ending;
    wait_for(process, ending);
    ending.messages = bytes_of(messages);
    ending.operations = operations_of(log);
    return ending;
}

std::vector<std::string> differences(const fs::path& expected, const fs::path& found) {
    std::vector<std::string> sentences;
    const std::map<fs::path, fs::path> wanted = files_below(expected);
    const std::map<fs::path, fs::path> there = files_below(found);
    for (const auto& [name, path] : wanted) {
        const auto other = there.find(name);
        if (other == there.end()) {
            sentences.push_back(name.string() + " is missing");
        } else if (!same(path, other->second)) {
            sentences.push_back(name.string() + " differs");
        }
    }
    for (const auto& [name, path] : there) {
        if (!wanted.contains(name)) {
            sentences.push_back(name.string() + " is left over");
        }
    }
    return sentences;
}

}  // namespace faults
