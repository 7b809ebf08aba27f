#include "coupling/compare/compare.hpp"

#include "config/errors/input_error.hpp"
#include "coupling/compare/finished_run.hpp"
#include "coupling/compare/side_by_side.hpp"
#include "coupling/results/out_file.hpp"

namespace coupling::compare {

void compare_runs(const CompareRequest& request, std::ostream& screen) {
    if (!request.out.empty() && !request.overwrite && std::filesystem::exists(request.out)) {
        config::fail(config::ExitCode::settings, {request.out.string()},
                     "a file of this name is there already",
                     "another name by --out, or --overwrite to replace it");
    }
    std::vector<FinishedRun> runs;
    for (const std::filesystem::path& folder : request.folders) {
        runs.push_back(read_finished_run(folder));
    }
    const SideBySide comparison = side_by_side(runs);
    if (!request.out.empty()) {
        OutFile file{request.out};
        write_csv(file.stream(), runs, comparison);
        file.close();
    }
    if (!request.quiet) {
        write_screen(screen, runs, comparison);
    }
}

}  // namespace coupling::compare
