#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "config/errors/warnings.hpp"
#include "coupling/inputs/files/input_names.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/disk/write_watch.hpp"
#include "coupling/run/output_folder.hpp"
#include "coupling/run/ranks.hpp"
#include "coupling/run/run_request.hpp"

namespace coupling {

/// What a kind of run does between its inputs, which are read, and its results, which are whole. The rest is
/// the same for all kinds (`complete_run`).
class RunSteps {
public:
    RunSteps() = default;
    RunSteps(const RunSteps&) = delete;
    RunSteps& operator=(const RunSteps&) = delete;
    virtual ~RunSteps() = default;

    /// Simulates what the folder does not keep yet, and keeps parts there. All ranks do this; only the first
    /// has a folder, others get nullptr. Throws Interrupted.
    virtual void simulate(const OutputFolder* folder) = 0;
    /// Writes all results, of all ranks and shards, into a folder that is there, with `tables` in it. Throws
    /// Interrupted.
    virtual std::vector<WrittenFile> write(const std::filesystem::path& folder, const WriteWatch& watch) = 0;
    /// Figures of the results to stdout.
    virtual void print_figures() const = 0;
    /// What an interruption leaves and how to go on, in words.
    [[nodiscard]] virtual std::string after_interruption(const std::filesystem::path& out) const = 0;
};

/// Where the results of a run go, and what it is a run of.
struct RunPlace {
    const RunRequest& request;
    const Scenario& scenario;
    std::filesystem::path out;
    std::string settings_hash;
};

/// A run from the lock of its folder to results in their place: goes on from what is kept there, simulates,
/// writes, publishes, prints. Returns the exit code: done or interrupted. A shard ends with its parts. Throws
/// config::InputError, of folders and disks, and what the steps throw.
int complete_run(RunSteps& steps, const RunPlace& place, RankGroup& ranks);

/// Writes results aside by `write` and puts them in their place once they are whole. Throws Interrupted and
/// config::InputError (file).
std::vector<WrittenFile> publish_results(
    OutputFolder& folder, const Scenario& scenario, bool quiet,
    const std::function<std::vector<WrittenFile>(const std::filesystem::path&, const WriteWatch&)>& write);

/// Prints the warnings of the inputs, does the work, and repeats all warnings if it is done. Returns the exit
/// code of the work.
int between_warnings(const RunRequest& request, const config::Warnings& warnings, const RankGroup& ranks,
                     const std::function<int()>& work, const InputNames* names = nullptr);

}  // namespace coupling
