// Lets every operation on the disk go wrong, one after the other, and looks whether the same command then
// goes on to the same results. See tests/README.md.

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "tests/faults/bench.hpp"

namespace faults {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> all_modes{"kill", "power", "tear", "eio", "enospc", "term", "unread", "eintr"};

struct Options {
    fs::path program;
    fs::path library;
    std::vector<std::string> runs;
    std::vector<std::string> modes = all_modes;
    long every = 1;
    long points =
        0;  ///< > 0: so many operations of each run and fault, spread evenly; the next four are ignored
    long from = 1;   ///< the first of these operations
    long at = 0;     ///< > 0: this operation only
    std::string on;  ///< operations on files whose names begin so
    unsigned jobs = std::max(1U, std::thread::hardware_concurrency());
    bool list = false;
};

bool is_write(const Operation& operation) {
    return operation.name.find("write") != std::string::npos || operation.name == "sendfile" ||
           operation.name == "copy_file_range";
}

bool needs_space(const Operation& operation) {
    return is_write(operation) || operation.name == "open" || operation.name == "openat" ||
           operation.name == "fopen" || operation.name == "creat" || operation.name == "mkdir" ||
           operation.name == "link" || operation.name == "symlink" || operation.name == "posix_fallocate";
}

/// Opening a file for reading, and each read of it.
bool is_read(const Operation& operation) {
    return operation.name.find("read") != std::string::npos || operation.name == "opendir";
}

/// What a signal can interrupt on a disk of a network: not what concerns names and folders alone. Streams of
/// the C library (fopen) are those of other libraries.
bool can_be_interrupted(const Operation& operation) {
    return is_write(operation) ||
           (is_read(operation) && operation.name != "opendir" && operation.name != "fopen_read") ||
           operation.name == "open" || operation.name == "openat" || operation.name == "fsync" ||
           operation.name == "fdatasync" || operation.name == "ftruncate";
}

bool applies(const std::string& mode, const Operation& operation) {
    return mode == "tear"     ? is_write(operation)
           : mode == "unread" ? is_read(operation)
           : mode == "eintr"  ? can_be_interrupted(operation)
                              : mode != "enospc" || needs_space(operation);
}

/// So many operations for each fault, spread evenly over those that it applies to. Each fault meets other
/// operations than the others do.
std::vector<Fault> spread_faults(const Options& options, const Bench& bench) {
    std::vector<Fault> faults;
    for (std::size_t i = 0; i < options.modes.size(); ++i) {
        std::vector<long> met;
        for (const Operation& operation : bench.operations(options.modes[i])) {
            if (applies(options.modes[i], operation)) {
                met.push_back(operation.number);
            }
        }
        const std::size_t step =
            std::max<std::size_t>(1, met.size() / static_cast<std::size_t>(options.points));
        for (std::size_t at = step * (i + 1) / (options.modes.size() + 1); at < met.size(); at += step) {
            faults.push_back({options.modes[i], met[at]});
        }
    }
    return faults;
}

/// The faults of all selected operations.
std::vector<Fault> selected_faults(const Options& options, const Bench& bench) {
    std::vector<Fault> faults;
    for (const std::string& mode : options.modes) {
        bool after_fsync = false;
        for (const Operation& operation : bench.operations(mode)) {
            const bool wanted =
                (options.at > 0 ? operation.number == options.at : operation.number % options.every == 0) &&
                operation.number >= options.from &&
                operation.path.filename().string().starts_with(options.on);
            // An fsync changes nothing that a killed process leaves: the kill before it was the same.
            const bool again =
                mode == "kill" && after_fsync && options.every == 1 && options.at == 0 && options.on.empty();
            if (wanted && applies(mode, operation) && !again) {
                faults.push_back({mode, operation.number});
            }
            after_fsync = operation.name == "fsync" || operation.name == "fdatasync";
        }
    }
    return faults;
}

std::vector<Fault> faults_of(const Options& options, const Bench& bench) {
    std::vector<Fault> faults =
        options.points > 0 ? spread_faults(options, bench) : selected_faults(options, bench);
    if (options.at == 0 &&
        std::find(options.modes.begin(), options.modes.end(), "term") != options.modes.end()) {
        faults.insert(faults.begin(), {"term", 0});
    }
    return faults;
}

std::string place_of(const Fault& fault, const Bench& bench) {
    if (fault.at == 0) {
        return "at the start";
    }
    const Operation& operation = bench.operations(fault.mode)[static_cast<std::size_t>(fault.at - 1)];
    return std::to_string(fault.at) + " (" + operation.name + ' ' + operation.path.filename().string() + ")";
}

/// Tries all faults of a run on several benches; returns what was found, by kind.
std::array<long, kinds> drive(const Options& options, const Run& run) {
    std::vector<std::unique_ptr<Bench>> benches;
    benches.push_back(std::make_unique<Bench>(options.program, options.library, run));
    const Bench& first = *benches.front();
    if (options.list) {
        for (const Operation& operation : first.operations(options.modes.front())) {
            std::cout << operation.number << ' ' << operation.name << ' ' << operation.path.string() << '\n';
        }
        return {};
    }
    const std::vector<Fault> faults = faults_of(options, first);
    while (benches.size() < std::min<std::size_t>(options.jobs, faults.size())) {
        benches.push_back(std::make_unique<Bench>(options.program, options.library, run));
    }
    std::array<long, kinds> sums{};
    std::atomic<std::size_t> next{0};
    std::mutex speaking;
    std::size_t tried = 0;
    std::vector<std::jthread> threads;
    for (const auto& bench : benches) {
        threads.emplace_back([&, own = bench.get()] {
            for (std::size_t i = next++; i < faults.size(); i = next++) {
                const std::vector<Finding> findings = own->try_fault(faults[i]);
                const std::lock_guard lock{speaking};
                if (++tried % 100 == 0) {
                    std::cerr << run.name << ": " << tried << " of " << faults.size() << " faults"
                              << std::endl;
                }
                for (const Finding& finding : findings) {
                    ++sums[finding.kind];
                    std::cout << run.name << ' ' << faults[i].mode << ' ' << place_of(faults[i], first)
                              << ": " << title_of[finding.kind] << ": " << finding.sentence << std::endl;
                }
            }
        });
    }
    threads.clear();
    std::printf("%-8s %5zu operations, %5zu with reads, %5zu faults:", run.name.c_str(),
                first.operations("eio").size(), first.operations("unread").size(), faults.size());
    for (std::size_t kind = 0; kind < kinds; ++kind) {
        std::printf(" %ld %s%s", sums[kind], title_of[kind], kind + 1 < kinds ? "," : "\n");
    }
    std::fflush(stdout);
    return sums;
}

std::vector<std::string> list_of(const std::string& text) {
    std::vector<std::string> words;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        words.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return words;
}

constexpr const char* usage =
    "fault_driver PROGRAM LIBRARY [--runs static,years,hazard,nets] [--modes "
    "kill,power,tear,eio,enospc,term,unread,eintr]\n"
    "             [--every K | --points N | --at N] [--from N] [--on NAME] [--jobs N] [--list]\n";

Options options_of(const std::vector<std::string>& words) {
    if (words.size() < 2) {
        throw std::invalid_argument{usage};
    }
    Options options;
    options.program = fs::absolute(words[0]);
    options.library = fs::absolute(words[1]);
    for (std::size_t i = 2; i < words.size(); ++i) {
        if (words[i] == "--list") {
            options.list = true;
            continue;
        }
        if (i + 1 == words.size()) {
            throw std::invalid_argument{usage};
        }
        const std::string& name = words[i];
        const std::string& value = words[++i];
        if (name == "--runs") {
            options.runs = list_of(value);
        } else if (name == "--modes") {
            options.modes = list_of(value);
        } else if (name == "--every") {
            options.every = std::max(1L, std::stol(value));
        } else if (name == "--points") {
            options.points = std::stol(value);
        } else if (name == "--at") {
            options.at = std::stol(value);
        } else if (name == "--from") {
            options.from = std::stol(value);
        } else if (name == "--on") {
            options.on = value;
        } else if (name == "--jobs") {
            options.jobs = static_cast<unsigned>(std::max(1L, std::stol(value)));
        } else {
            throw std::invalid_argument{usage};
        }
    }
    return options;
}

int drive_all(const Options& options) {
    long found = 0;
    for (const Run& run : all_runs()) {
        if (options.runs.empty() ||
            std::find(options.runs.begin(), options.runs.end(), run.name) != options.runs.end()) {
            for (const long sum : drive(options, run)) {
                found += sum;
            }
        }
    }
    return found == 0 ? 0 : 1;
}

}  // namespace
}  // namespace faults

int main(int count, char** words) {
    try {
        return faults::drive_all(faults::options_of({words + 1, words + count}));
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 2;
    }
}
