#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "config/errors/warnings.hpp"
#include "coupling/assessments/hazard/hazard_plan.hpp"
#include "coupling/assessments/hazard/hazard_results.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/run/folder_lock.hpp"
#include "coupling/run/output_folder.hpp"
#include "coupling/run/run_request.hpp"

namespace coupling::hazard {

/// A return period, opened: its scenario and site, where its results go.
struct Period {
    double return_period_years = 0.0;
    std::unique_ptr<Scenario> scenario;
    Site site;
    std::filesystem::path folder;
};

Period open_period(const RunRequest& request, double years, const std::filesystem::path& out,
                   config::Warnings& warnings);
FolderState state_of(const Period& period);

/// The folder of a hazard run: its lock, and the map in it. The runs of its return periods lock folders of
/// their own. Leaves no folder behind that it did not find and that is empty at the end.
class HazardFolder {
public:
    /// Makes and locks the folder, and looks at it before any rock falls: what would be found wrong after the
    /// falls, and older results that must not lie beside new ones. Shards share the lock. Throws
    /// config::InputError.
    HazardFolder(const RunRequest& request, const HazardPlan& plan, std::filesystem::path out);

    /// Whether all rocks are simulated again: with --overwrite return periods that are finished stay where
    /// others are not.
    [[nodiscard]] bool starts_again() const { return starts_again_; }
    [[nodiscard]] std::filesystem::path map() const { return out_ / map_folder; }
    /// Folders of return periods that hazard.blocks no longer has.
    [[nodiscard]] std::vector<std::string> left_over() const;
    /// An older map stays until the new one is whole. Throws Interrupted, config::InputError (file).
    std::vector<WrittenFile> write_map(const HazardResults& results, bool quiet);

private:
    [[nodiscard]] bool look_at_periods(const RunRequest& request);
    void delete_map() const;

    /// Removed at the end if it is empty and was not found.
    class Made {
    public:
        explicit Made(std::filesystem::path folder);
        ~Made();
        Made(const Made&) = delete;
        Made& operator=(const Made&) = delete;

    private:
        std::filesystem::path folder_;
        bool existed_;
    };
    class Lock {
    public:
        Lock(const std::filesystem::path& out, FolderLock::Use use);
        ~Lock();
        Lock(const Lock&) = delete;
        Lock& operator=(const Lock&) = delete;
        [[nodiscard]] bool is_alone() const { return lock_.is_alone(); }
        void share() { lock_.share(); }

    private:
        FolderLock lock_;
    };

    const HazardPlan& plan_;
    std::filesystem::path out_;
    Made made_;
    std::optional<Lock> lock_;
    bool starts_again_ = false;
};

}  // namespace coupling::hazard
