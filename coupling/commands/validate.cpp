#include "coupling/commands/validate.hpp"

#include <omp.h>

#include <algorithm>
#include <iomanip>
#include <iostream>

#include "config/text/joined.hpp"
#include "coupling/inputs/file_bytes.hpp"
#include "coupling/run/interrupt.hpp"
#include "coupling/validation/falls.hpp"
#include "coupling/validation/result_folder.hpp"
#include "coupling/validation/screen.hpp"
#include "coupling/validation/validate.hpp"
#include "coupling/validation/verdict.hpp"
#include "coupling/validation/write_results.hpp"

namespace coupling {
namespace {

using config::joined;
using validation::CaseFiles;
using validation::CaseResult;
using validation::ValidationCase;

std::vector<CaseFiles> all_cases(const CommandLine& line) {
    return line.cases_folder.empty() ? validation::shipped_cases() : validation::cases_in(line.cases_folder);
}

void print_list(const std::vector<CaseFiles>& cases, std::ostream& out) {
    for (const CaseFiles& files : cases) {
        out << std::left << std::setw(20) << files.name << ' ' << validation::head_of(files).title << '\n';
    }
}

/// "a, b, c".
std::string one_of(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names) {
        list += joined(list.empty() ? "" : ", ", name);
    }
    return list;
}

/// The cases that the user names, in that order.
std::vector<CaseFiles> chosen(const CommandLine& line, std::vector<CaseFiles> cases) {
    if (line.cases.empty() || line.cases == std::vector<std::string>{"all"}) {
        return cases;
    }
    std::vector<std::string> names;
    for (const CaseFiles& files : cases) {
        names.push_back(files.name);
    }
    std::vector<CaseFiles> wanted;
    for (const std::string& name : line.cases) {
        const auto found = std::find(names.begin(), names.end(), name);
        if (found == names.end()) {
            const std::string nearest = config::nearest_word(name, names);
            config::fail(
                config::ExitCode::settings, {}, joined("case ", config::in_quotes(name)),
                nearest.empty() ? joined("one of ", one_of(names), ", or all") : config::in_quotes(nearest));
        }
        wanted.push_back(cases[static_cast<std::size_t>(found - names.begin())]);
    }
    return wanted;
}

validation::CaseChanges changes_of(const CommandLine& line, std::size_t cases) {
    validation::CaseChanges changes;
    changes.overrides = line.overrides;
    changes.most_rocks = line.rocks;
    if (!line.profile.empty()) {
        if (cases != 1) {
            config::fail(config::ExitCode::settings, {}, "--profile with several cases",
                         "the one case whose slope was surveyed");
        }
        changes.profile_file = line.profile.string();
        changes.profile_text = open_file(line.profile, {}, "a profile").text();
    }
    return changes;
}

std::vector<ValidationCase> read_cases(const CommandLine& line, const std::vector<CaseFiles>& files) {
    const validation::CaseChanges changes = changes_of(line, files.size());
    config::Problems problems;
    std::vector<ValidationCase> cases;
    for (const CaseFiles& one : files) {
        try {
            cases.push_back(validation::read_case(one, changes));
        } catch (const config::InputError& error) {
            problems.add(error);
        }
    }
    problems.throw_if_any();
    return cases;
}

/// Lets the rocks of the cases fall, prints each as it is done, writes all of them at the end.
std::vector<CaseResult> work_through(const CommandLine& line, const std::vector<ValidationCase>& cases,
                                     std::ostream& out) {
    const validation::ValidateRequest request{line.threads > 0 ? line.threads : omp_get_max_threads(),
                                              line.quiet};
    validation::ResultFolder folder{line.out.empty() ? "validation-results" : line.out, line.overwrite};
    std::vector<CaseResult> results;
    for (const ValidationCase& one : cases) {
        results.push_back(validation::validate(one, request));
        validation::print_case(out, results.back());
        out.flush();
    }
    const std::vector<WrittenFile> written = validation::write_results(results, folder.staging());
    folder.publish();
    if (!line.quiet) {
        out << "Results in " << folder.path().string() << '\n';
        for (const WrittenFile& file : written) {
            out << "  " << std::left << std::setw(16) << file.path << ' ' << file.sentence << '\n';
        }
    }
    return results;
}

}  // namespace

int validate_cases(const CommandLine& line, std::ostream& out) {
    const std::vector<CaseFiles> files = chosen(line, all_cases(line));
    if (line.list) {
        print_list(files, out);
        return static_cast<int>(config::ExitCode::done);
    }
    const std::vector<ValidationCase> cases = read_cases(line, files);
    const InterruptGuard guard;
    try {
        const std::vector<CaseResult> results = work_through(line, cases, out);
        const bool missed = std::any_of(results.begin(), results.end(), validation::misses_any);
        return static_cast<int>(missed ? config::ExitCode::validation : config::ExitCode::done);
    } catch (const validation::Interrupted&) {
        std::cerr << "\nbannwald: interrupted; nothing was written\n";
        return static_cast<int>(config::ExitCode::interrupted);
    }
}

}  // namespace coupling
