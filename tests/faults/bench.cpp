#include "tests/faults/bench.hpp"

#include <algorithm>
#include <stdexcept>

namespace faults {
namespace {

namespace fs = std::filesystem;

/// Parts that a run has finished: each comes to its place by renaming.
long finished_parts(const std::vector<Operation>& operations, const std::vector<std::string>& names) {
    return std::count_if(operations.begin(), operations.end(), [&](const Operation& operation) {
        return operation.name == "rename" && !operation.disturbed && operation.path.extension() == ".part" &&
               std::any_of(names.begin(), names.end(), [&](const std::string& name) {
                   return operation.path.filename().string().starts_with(name);
               });
    });
}

bool has(const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
}

/// Last line of what the program said.
std::string last_words(const Ending& ending) {
    std::string text = ending.messages;
    while (!text.empty() && text.back() == '\n') {
        text.pop_back();
    }
    return text.substr(text.rfind('\n') + 1);
}

std::string ended_with(const Ending& ending) {
    return (ending.signal != 0 ? "signal " + std::to_string(ending.signal)
                               : "exit " + std::to_string(ending.code)) +
           ", " + last_words(ending);
}

}  // namespace

Bench::Bench(const fs::path& program, const fs::path& library, const Run& run)
    : run_{run},
      project_{run.project()},
      scratch_{std::make_unique<coupling::SampleProject>()},
      program_{program, library, project_->folder(), scratch_->folder()} {
    const Ending whole = start({});
    if (whole.code != 0) {
        throw std::runtime_error{run.name + " fails without any fault: " + ended_with(whole)};
    }
    operations_ = whole.operations;
    fs::rename(out(), reference());
    all_operations_ = start({"count_all", 0}).operations;
}

std::vector<Finding> Bench::try_fault(const Fault& fault) {
    findings_.clear();
    fs::remove_all(out());
    const Ending first = start(fault);
    look_at_end(first, fault);
    if (first.code == 0) {
        compare("the run itself");
    } else {
        go_on(first);
    }
    return findings_;
}

/// A fault is answered with the exit code of a failed file, and with its name.
void Bench::look_at_end(const Ending& ending, const Fault& fault) {
    const bool dies = fault.mode == "kill" || fault.mode == "tear" || fault.mode == "power";
    if (ending.hung) {
        found(hung, "the run with the fault did not end");
    } else if (dies                    ? ending.signal != 9
               : fault.mode == "eintr" ? ending.code != 0
               : fault.mode == "term"  ? ending.code != 75 && ending.code != 0
                                       : ending.code != 3 && ending.code != 0) {
        found(unclear, "the fault was answered with " + ended_with(ending));
    } else if (ending.code == 3 && !has(ending.messages, name_of_place(fault).c_str())) {
        found(unclear, "no file was named: " + ended_with(ending));
    }
}

/// What a message has to name: the file that could not be read, or the folder of the results.
std::string Bench::name_of_place(const Fault& fault) const {
    return fault.mode != "unread"
               ? "out"
               : all_operations_[static_cast<std::size_t>(fault.at - 1)].path.filename().string();
}

/// The same command once more, without a fault.
void Bench::go_on(const Ending& first) {
    const Ending second = start({});
    if (second.hung) {
        found(hung, "the same command did not end");
    } else if (second.code == 2 && has(second.messages, "finished results")) {
        compare("results that count as finished");
    } else if (second.code != 0) {
        found(lost, "the same command ended with " + ended_with(second));
        overwrite(second);
    } else {
        const long parts = finished_parts(operations_, run_.parts);
        const long kept = finished_parts(first.operations, run_.parts);
        const long made = finished_parts(second.operations, run_.parts);
        if (kept + made > parts) {
            found(lost, "of " + std::to_string(kept) + " finished parts " +
                            std::to_string(kept + made - parts) + " were made once more");
        }
        compare("going on");
    }
}

/// What the message advises.
void Bench::overwrite(const Ending& second) {
    if (!has(second.messages, "--overwrite")) {
        found(unclear, "no way out was shown: " + ended_with(second));
        return;
    }
    std::vector<std::string> words = run_.arguments;
    words.emplace_back("--overwrite");
    const Ending third = faults::run(program_, words, {});
    if (third.code != 0) {
        found(unclear, "--overwrite ended with " + ended_with(third));
    } else {
        compare("--overwrite");
    }
}

void Bench::compare(const std::string& after) {
    const std::vector<std::string> list = differences(reference(), out());
    for (const bool extra : {false, true}) {
        const auto is_extra = [](const std::string& text) { return text.ends_with(" is left over"); };
        const auto one = std::find_if(list.begin(), list.end(),
                                      [&](const std::string& text) { return is_extra(text) == extra; });
        if (one != list.end()) {
            const auto others =
                std::count_if(list.begin(), list.end(),
                              [&](const std::string& text) { return is_extra(text) == extra; }) -
                1;
            found(extra ? left_over : wrong,
                  "after " + after + " " + *one +
                      (others > 0 ? " and " + std::to_string(others) + " more" : ""));
        }
    }
}

}  // namespace faults
