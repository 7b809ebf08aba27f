#include "coupling/assessments/compare/compare.hpp"

#include <algorithm>
#include <sstream>
#include <utility>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "coupling/assessments/compare/page/page.hpp"
#include "coupling/assessments/compare/runs/finished_run.hpp"
#include "coupling/assessments/compare/runs/side_by_side.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/run/interrupt.hpp"
#include "coupling/run/short_run.hpp"

namespace coupling::compare {
namespace {

using config::joined;

void look_at_targets(const CompareRequest& request) {
    if (!request.out.empty()) {
        ShortRun::look_at(request.out, "compare", {"compare.csv", "report.html"}, request.overwrite);
    }
    if (!request.page.empty() && !request.overwrite && path_exists(request.page)) {
        config::fail(config::ExitCode::settings, {request.page.string()},
                     "a file of this name is there already",
                     "another name by --page, or --overwrite to replace it");
    }
}

/// Decimal sign of tables for Excel, if the first run wrote such tables.
std::optional<char> excel_decimal(const CompareRequest& request, const SummaryOfRun& first) {
    const auto value_of = [&](std::string_view key) {
        const auto found = std::find_if(first.settings.begin(), first.settings.end(),
                                        [&](const auto& setting) { return setting.key == key; });
        return found == first.settings.end() ? std::string{} : found->value;
    };
    if (value_of("output.csv") != "excel") {
        return std::nullopt;
    }
    return config::decimal_sign(request.language.value_or(
        config::language_of(value_of("report.language")).value_or(config::Language::en)));
}

ShortSummary summary_of(const CompareRequest& request, std::span<const FinishedRun> runs,
                        const SideBySide& comparison) {
    std::vector<std::string> warnings = comparison.not_comparable;
    warnings.insert(warnings.end(), comparison.notes.begin(), comparison.notes.end());
    std::vector<InputFile> inputs;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const std::filesystem::path file = runs[i].folder / "summary.json";
        const FileBytes bytes = open_file(file, {file.string()}, "the summary of a finished run");
        inputs.push_back(
            {joined("run ", comparison.letters[i]), file.string(), bytes.hash(), bytes.stored_bytes()});
    }
    return {.kind = "compare",
            .run = {{"runs", runs.size()}, {"is_comparable", comparison.not_comparable.empty()}},
            .figures = {{"lines", comparison.lines.size()}},
            .inputs = std::move(inputs),
            .warnings = std::move(warnings),
            .excel_decimal = excel_decimal(request, runs.front().summary)};
}

}  // namespace

void compare_runs(const CompareRequest& request, std::ostream& screen) {
    look_at_targets(request);
    std::vector<FinishedRun> runs;
    for (const std::filesystem::path& folder : request.folders) {
        runs.push_back(read_finished_run(folder));
    }
    const SideBySide comparison = side_by_side(runs);
    // Made before any file is: a table that is missing leaves nothing half-written.
    std::ostringstream page;
    if (!request.page.empty() || !request.out.empty()) {
        write_page(page, runs, comparison, request.language);
    }
    const InterruptGuard until_written;
    if (!request.out.empty()) {
        ShortRun results{request.out};
        results.add("compare.csv", "Each figure of each run, and its difference to the first run.",
                    [&](std::ostream& out) { write_csv(out, runs, comparison); });
        results.add("report.html", "The comparison as a page, with distributions and maps side by side.",
                    [&](std::ostream& out) { out << page.str(); });
        results.publish(summary_of(request, runs, comparison), compare_layouts());
    }
    if (!request.page.empty()) {
        OutFile file{request.page};
        file.stream() << page.str();
        file.close();
    }
    if (!request.quiet) {
        write_screen(screen, runs, comparison);
        if (!request.out.empty()) {
            screen << "\nResults in " << request.out.string() << ": compare.csv, report.html\n";
        }
    }
}

}  // namespace coupling::compare
