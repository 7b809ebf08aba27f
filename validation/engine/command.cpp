#include "validation/engine/command.hpp"

#include <omp.h>

#include <algorithm>
#include <iomanip>
#include <iostream>

#include "config/text/joined.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/program/line/arguments.hpp"
#include "coupling/run/interrupt.hpp"
#include "coupling/run/short_run.hpp"
#include "validation/engine/case/coverage.hpp"
#include "validation/engine/forest_cases/shared/comparison.hpp"
#include "validation/engine/kinds/verdict.hpp"
#include "validation/engine/screen.hpp"
#include "validation/engine/slope/falls.hpp"
#include "validation/engine/slope/quantities.hpp"
#include "validation/engine/validate.hpp"
#include "validation/engine/write_results.hpp"
#include "validation/engine/years/years_case.hpp"

namespace coupling::validation {
namespace {

using config::joined;

constexpr const char* validate_help = R"(bannwald validate [CASE...|all] [options]

Lets the rocks of published experiments fall with the settings of the paper (strict) and with ours (default),
prints every figure beside what was observed and published, and says which criteria are met. Cases forest_... hold
parts of the forest model against other programs and tables; they have one set of settings (default).
Ends with exit code 5 if strict or default misses a criterion of any case, with 0 otherwise.
  --list                    the cases, one a line
  --out DIR                 folder of report.html, summary.md and the tables (default: validation-results)
  --overwrite               replaces results that the folder holds
  --cases DIR               cases of this folder instead of the built-in ones
  --profile FILE            takes the place of the profile of the one case named: a surveyed slope
  --draws                   also holds known figures against 90 % bands of rocks alone, and of all that is
                            not known of ground and trees (32 draws by the shipped widths); changes no verdict
  --rocks N                 rocks of the large ensemble; series and moved choices shrink with it. It and settings
                            of rocks change nothing in a case of the forest, which says so
  --set section.key=value   changes a setting of case.ini, [rockfall] or [tree_impact]; again for more. Those of
                            cases of the forest: `bannwald --help-all light`, also years
  --seed N                  the same as --set series.seed=N
  --threads N               threads to use; results do not depend on it (default: all of the machine)
)";

std::vector<CaseFiles> all_cases(const Arguments& arguments) {
    return arguments.has("cases") ? cases_in(arguments.text("cases")) : shipped_cases();
}

void print_list(const std::vector<CaseFiles>& cases, std::ostream& out) {
    for (const CaseFiles& files : cases) {
        out << std::left << std::setw(20) << files.name << ' ' << head_of(files).title << '\n';
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
std::vector<CaseFiles> chosen(const Arguments& arguments, std::vector<CaseFiles> cases) {
    if (arguments.words().empty() || arguments.words() == std::vector<std::string>{"all"}) {
        return cases;
    }
    std::vector<std::string> names;
    for (const CaseFiles& files : cases) {
        names.push_back(files.name);
    }
    std::vector<CaseFiles> wanted;
    for (const std::string& name : arguments.words()) {
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

CaseChanges changes_of(const Arguments& arguments, std::size_t cases) {
    CaseChanges changes;
    changes.overrides = arguments.overrides("series");
    if (const auto rocks = arguments.whole("rocks", 2, 10'000'000)) {
        changes.most_rocks = static_cast<std::uint64_t>(*rocks);
    }
    if (arguments.has("profile")) {
        if (cases != 1) {
            config::fail(config::ExitCode::settings, {}, "--profile with several cases",
                         "the one case whose slope was surveyed");
        }
        changes.profile_file = arguments.text("profile");
        changes.profile_text = open_file(arguments.text("profile"), {}, "a profile").text();
    }
    return changes;
}

std::vector<ValidationCase> read_cases(const Arguments& arguments, const std::vector<CaseFiles>& files) {
    const CaseChanges changes = changes_of(arguments, files.size());
    config::Problems problems;
    std::vector<ValidationCase> cases;
    for (const CaseFiles& one : files) {
        try {
            cases.push_back(read_case(one, changes));
        } catch (const config::InputError& error) {
            problems.add(error);
        }
    }
    problems.throw_if_any();
    return cases;
}

/// Lets the rocks of the cases fall, prints each as it is done, writes all of them at the end.
std::vector<CaseResult> work_through(const Arguments& arguments, const std::vector<ValidationCase>& cases,
                                     std::ostream& out) {
    const ValidateRequest request{arguments.threads() > 0 ? arguments.threads() : omp_get_max_threads(),
                                  arguments.quiet(), arguments.has("draws")};
    const std::filesystem::path folder = arguments.has("out") ? arguments.out() : "validation-results";
    ShortRun::look_at(folder, "validate", result_names(), arguments.overwrite());
    ShortRun to_publish{folder};  // before the work: a folder that cannot be written is known at once
    std::vector<CaseResult> results;
    std::vector<Coverage> coverage;
    for (const ValidationCase& one : cases) {
        results.push_back(validate(one, request));
        print_case(out, results.back());
        out.flush();
        coverage.insert(coverage.end(), results.back().coverage.begin(), results.back().coverage.end());
    }
    if (!coverage.empty()) {
        out << in_words(coverage) << " in all cases\n";
    }
    const std::vector<WrittenFile> written = write_results(results, to_publish);
    if (!arguments.quiet()) {
        out << "Results in " << folder.string() << '\n';
        for (const WrittenFile& file : written) {
            out << "  " << std::left << std::setw(16) << file.path << ' ' << file.sentence << '\n';
        }
    }
    return results;
}

int validate_cases(const Arguments& arguments, const Call& call) {
    std::ostream& out = call.out;
    const std::vector<CaseFiles> files = chosen(arguments, all_cases(arguments));
    if (arguments.has("list")) {
        print_list(files, out);
        return static_cast<int>(config::ExitCode::done);
    }
    const std::vector<ValidationCase> cases = read_cases(arguments, files);
    const InterruptGuard guard;
    try {
        const std::vector<CaseResult> results = work_through(arguments, cases, out);
        const bool missed = std::any_of(results.begin(), results.end(), misses_any);
        return static_cast<int>(missed ? config::ExitCode::validation : config::ExitCode::done);
    } catch (const Interrupted&) {
        std::cerr << "\nbannwald: interrupted; nothing was written\n";
        return static_cast<int>(config::ExitCode::interrupted);
    }
}

std::vector<std::string> case_words() {
    std::vector<std::string> names{"all"};
    for (const CaseFiles& files : shipped_cases()) {
        names.push_back(files.name);
    }
    return names;
}

void write_figures_of_cases(std::ostream& out) {
    out << "\nFigures that a case may observe, publish or set a criterion for; with a stand also "
           "open.FIGURE (bare\nslope) and reduction.FIGURE (1 - forest / open):\n";
    write_quantities(out);
}

/// The settings of each kind of case of the forest, and the section that only its case.ini has.
void use_settings_of_cases(const Command::UseOfSettings& use) {
    forest_cases::Settings settings;
    config::Options of_light;
    forest_cases::declare(of_light, settings, CaseKind::forest_light);
    use(of_light, "light");
    YearsSettings years;
    config::Options of_years;
    declare(of_years, years);
    use(of_years, "years");
}

}  // namespace

Command validate_command() {
    return {
        .name = "validate",
        .overview =
            R"(  bannwald validate [CASE...|all]      holds the model against published experiments and tables
)",
        .help = validate_help,
        .argument = "",
        .options = {set_option(), seed_option(), threads_option(), out_folder_option(), overwrite_option(),
                    option_with_value("cases", {Completion::Names::folders}),
                    option_with_value("profile", {Completion::Names::files}), option_with_value("rocks"),
                    switch_option("draws"), switch_option("list")},
        .completion = {.words = case_words},
        .run = validate_cases,
        .more_help = write_figures_of_cases,
        .own_settings = use_settings_of_cases,
        .own_settings_title = "Settings of case.ini of the forest (bannwald validate)"};
}

}  // namespace coupling::validation
