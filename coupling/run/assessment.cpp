#include "coupling/run/assessment.hpp"

#include <cstdio>
#include <optional>

#include "config/errors/input_error.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/finish.hpp"
#include "coupling/run/interrupt.hpp"
#include "coupling/run/messages.hpp"
#include "coupling/run/writing_progress.hpp"

namespace coupling {
namespace {

/// On all ranks the answer of the first one, which keeps the folder.
bool was_completed(const OutputFolder* folder, bool quiet, RankGroup& ranks) {
    const std::uint64_t here = folder != nullptr && folder->was_completed() ? 1 : 0;
    if (here == 1 && !quiet) {
        print_completed(*folder);
    }
    return ranks.from_first({here}).front() == 1;
}

void write_and_print(RunSteps& steps, const RunPlace& place, OutputFolder& folder) {
    const bool quiet = place.request.quiet;
    const std::vector<WrittenFile> files = publish_results(
        folder, place.scenario, quiet, [&](const std::filesystem::path& staging, const WriteWatch& watch) {
            return steps.write(staging, watch);
        });
    if (!quiet) {
        steps.print_figures();
        print_files(folder.path(), files, place.request.verbose);
    }
}

}  // namespace

int complete_run(RunSteps& steps, const RunPlace& place, RankGroup& ranks) {
    const InterruptGuard guard;
    const bool is_shard = place.request.shard.count > 1;
    std::optional<OutputFolder> kept;
    if (ranks.first()) {
        kept.emplace(place.out, place.settings_hash, place.request.overwrite,
                     is_shard ? FolderLock::Use::shared : FolderLock::Use::alone);
    }
    OutputFolder* const folder = kept ? &*kept : nullptr;
    try {
        if (was_completed(folder, place.request.quiet, ranks)) {
            return static_cast<int>(config::ExitCode::done);
        }
        ranks.begin_work();
        steps.simulate(folder);
        if (folder != nullptr && !is_shard) {
            write_and_print(steps, place, *folder);
        }
        ranks.meet();
    } catch (const Interrupted&) {
        // While the folder is still there for the others.
        if (ranks.fail(true)) {
            std::fprintf(
                stderr, "bannwald: interrupted; %s%s\n", steps.after_interruption(place.out).c_str(),
                place.request.overwrite ? " (without --overwrite, which starts from the beginning)" : "");
        }
        return static_cast<int>(config::ExitCode::interrupted);
    } catch (const FailedElsewhere&) {
        ranks.fail(false);
        throw;
    } catch (...) {
        ranks.fail(true);
        throw;
    }
    return static_cast<int>(config::ExitCode::done);
}

std::vector<WrittenFile> publish_results(
    OutputFolder& folder, const Scenario& scenario, bool quiet,
    const std::function<std::vector<WrittenFile>(const std::filesystem::path&, const WriteWatch&)>& write) {
    make_folder(folder.staging() / "tables");
    std::vector<WrittenFile> files;
    {
        WritingProgress progress{quiet};
        const WriteWatch watch = progress.watch();
        files = write(folder.staging(), watch);
        watch("the last file");
    }
    turn_tables_into_excel(folder.staging(), scenario);
    folder.publish();
    return files;
}

int between_warnings(const RunRequest& request, const config::Warnings& warnings, const RankGroup& ranks,
                     const std::function<int()>& work, const InputNames* names) {
    if (!request.quiet) {
        print_warnings(warnings, request.verbose, names);
    }
    const int code = work();
    if (code == static_cast<int>(config::ExitCode::done) && ranks.first()) {
        repeat_warnings(warnings, request.verbose, names);
    }
    return code;
}

}  // namespace coupling
