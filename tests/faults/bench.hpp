#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "tests/faults/runs.hpp"
#include "tests/faults/trial.hpp"

namespace faults {

/// What went wrong in one trial, the worst first.
enum Verdict : std::size_t { lost, wrong, hung, unclear, left_over, kinds };

inline constexpr const char* title_of[kinds] = {"lost", "wrong", "hung", "unclear", "left over"};

struct Finding {
    Verdict kind = lost;
    std::string sentence;
};

/// One project of one run, tried again and again.
class Bench {
public:
    /// Makes the reference, without any fault. Throws std::runtime_error if the program fails.
    Bench(const std::filesystem::path& program, const std::filesystem::path& library, const Run& run);

    /// What the program does on the disk where nothing goes wrong, as a fault counts it: what it changes, or
    /// that and what it reads.
    [[nodiscard]] const std::vector<Operation>& operations(const std::string& mode) const {
        return counts_reads(mode) ? all_operations_ : operations_;
    }

    /// Runs with a fault, then the same command without one; compares the results with the reference.
    std::vector<Finding> try_fault(const Fault& fault);

private:
    [[nodiscard]] std::filesystem::path out() const { return project_->file("out"); }
    [[nodiscard]] std::filesystem::path reference() const { return scratch_->file("reference"); }
    Ending start(const Fault& fault) { return faults::run(program_, run_.arguments, fault); }
    void found(Verdict kind, const std::string& sentence) { findings_.push_back({kind, sentence}); }
    void look_at_end(const Ending& ending, const Fault& fault);
    [[nodiscard]] std::string name_of_place(const Fault& fault) const;
    void go_on(const Ending& first);
    void overwrite(const Ending& second);
    void compare(const std::string& after);

    const Run& run_;
    std::unique_ptr<coupling::SampleProject> project_;
    std::unique_ptr<coupling::SampleProject> scratch_;
    Program program_;
    std::vector<Operation> operations_;
    std::vector<Operation> all_operations_;
    std::vector<Finding> findings_;
};

}  // namespace faults
