#include "coupling/assessments/compare/compare.hpp"

#include <sstream>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "coupling/assessments/compare/page/page.hpp"
#include "coupling/assessments/compare/runs/finished_run.hpp"
#include "coupling/assessments/compare/runs/side_by_side.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/run/interrupt.hpp"

namespace coupling::compare {
namespace {

using config::joined;

void refuse_existing(const std::filesystem::path& file, const char* option, bool overwrite) {
    if (!file.empty() && !overwrite && path_exists(file)) {
        config::fail(config::ExitCode::settings, {file.string()}, "a file of this name is there already",
                     joined("another name by ", option, ", or --overwrite to replace it"));
    }
}

}  // namespace

void compare_runs(const CompareRequest& request, std::ostream& screen) {
    refuse_existing(request.out, "--out", request.overwrite);
    refuse_existing(request.page, "--page", request.overwrite);
    std::vector<FinishedRun> runs;
    for (const std::filesystem::path& folder : request.folders) {
        runs.push_back(read_finished_run(folder));
    }
    const SideBySide comparison = side_by_side(runs);
    // Made before any file is: a table that is missing leaves nothing half-written.
    std::ostringstream page;
    if (!request.page.empty()) {
        write_page(page, runs, comparison, request.language);
    }
    const InterruptGuard until_written;
    if (!request.out.empty()) {
        OutFile file{request.out};
        write_csv(file.stream(), runs, comparison);
        file.close();
    }
    if (!request.page.empty()) {
        OutFile file{request.page};
        file.stream() << page.str();
        file.close();
    }
    if (!request.quiet) {
        write_screen(screen, runs, comparison);
    }
}

}  // namespace coupling::compare
