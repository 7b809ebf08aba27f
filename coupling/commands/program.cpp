#include "coupling/commands/program.hpp"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <optional>

#include "config/errors/brief.hpp"
#include "config/errors/input_error.hpp"
#include "config/errors/warnings.hpp"
#include "config/text/joined.hpp"
#include "coupling/collapse/collapse_run.hpp"
#include "coupling/commands/check.hpp"
#include "coupling/commands/command_line.hpp"
#include "coupling/commands/completion.hpp"
#include "coupling/commands/help.hpp"
#include "coupling/commands/info.hpp"
#include "coupling/commands/init.hpp"
#include "coupling/commands/run_assessment.hpp"
#include "coupling/commands/validate.hpp"
#include "coupling/compare/compare.hpp"
#include "coupling/nets/net_place.hpp"
#include "coupling/nets/net_try.hpp"
#include "coupling/pack/pack.hpp"
#include "coupling/pack/run_folder.hpp"
#include "coupling/pack/verify.hpp"
#include "coupling/run/messages.hpp"
#include "coupling/run/ranks.hpp"
#include "coupling/stopping/stopping_table.hpp"
#include "coupling/vary/vary.hpp"
#include "coupling/version.hpp"

namespace coupling {
namespace {

using config::ExitCode;
using config::joined;

int code(ExitCode exit_code) {
    return static_cast<int>(exit_code);
}

int init(const CommandLine& line) {
    MadeProject made;
    if (!line.given.dem.empty()) {
        made = write_from_files(line.argument, line.given);
    } else if (!line.rockyfor3d.empty()) {
        made = write_from_rockyfor3d(line.argument, line.rockyfor3d);
    } else {
        write_example(line.argument, line.example);
    }
    const std::string scenario = (line.argument / "scenario.ini").string();
    std::cout << scenario << '\n';
    if (!line.quiet) {
        for (const std::string& remark : made.remarks) {
            std::cerr << "- " << remark << '\n';
        }
    }
    print_warnings(made.warnings, line.verbose);
    if (!line.quiet) {
        const bool is_collapse = line.example.starts_with("collapse");
        std::cerr << "next: bannwald " << (is_collapse ? "collapse " : "run ") << scenario << '\n';
    }
    return code(ExitCode::done);
}

int check(const CommandLine& line) {
    config::Warnings warnings;
    const auto print = [&] { print_warnings(warnings, line.verbose); };
    try {
        check_scenario(line, warnings, std::cout);
    } catch (...) {
        print();
        throw;
    }
    print();
    return code(ExitCode::done);
}

int run(const CommandLine& line, RankGroup& ranks) {
    if (collapse::is_collapse(line.argument)) {
        config::fail(ExitCode::settings, {line.argument.string()},
                     "section [collapse], a rock mass that breaks up", "a scenario without it",
                     joined("bannwald collapse ", line.argument.string()));
    }
    return run_assessment({.scenario = line.argument,
                           .overrides = line.overrides,
                           .out = line.out,
                           .threads = line.threads,
                           .overwrite = line.overwrite,
                           .quiet = line.quiet || !ranks.first(),
                           .verbose = line.verbose,
                           .shard = line.shard,
                           .shards = line.folders},
                          ranks);
}

int stopping_table(const CommandLine& line) {
    StoppingTableRequest request{.recipe = line.argument,
                                 .out = line.out,
                                 .names = line.surface_names,
                                 .plan = {},
                                 .pictures = line.pictures,
                                 .overwrite = line.overwrite,
                                 .quiet = line.quiet};
    request.plan.diameters_m = line.diameters_m.empty() ? usual_diameters_m() : line.diameters_m;
    request.plan.throws = line.throws.value_or(request.plan.throws);
    request.plan.surfaces = line.surfaces.value_or(request.plan.surfaces);
    request.plan.seed = line.seed.value_or(request.plan.seed);
    request.plan.threads = line.threads;
    return make_stopping_table(request, std::cout);
}

int pack_run(const CommandLine& line) {
    pack::pack_run({.run = line.argument,
                    .scenario = line.scenario,
                    .out = line.out,
                    .settings = line.overrides,
                    .citation = {line.title, line.creators, line.licence, line.date},
                    .overwrite = line.overwrite,
                    .quiet = line.quiet},
                   std::cout);
    return code(ExitCode::done);
}

/// Repeats the run of an archive and compares its files.
int rerun(const CommandLine& line, const pack::VerifiedArchive& archive) {
    const std::filesystem::path folder =
        line.out.empty() ? std::filesystem::path{line.argument}.replace_extension().concat("-rerun")
                         : line.out;
    const std::string_view command = pack::kind_of(archive.run.kind, line.argument.string()).command;
    pack::unpack_inputs(line.argument, archive, folder);
    RankGroup alone{RankGroup::Alone{}};
    const RunRequest request{.scenario = folder / archive.run.scenario,
                             .overrides = archive.run.overrides,
                             .out = folder / "results",
                             .threads = line.threads,
                             .quiet = true,
                             .inputs_within = folder / "inputs"};
    const int result =
        command == "collapse" ? collapse::run_collapse(request) : run_assessment(request, alone);
    if (result != code(ExitCode::done)) {
        return result;
    }
    const std::vector<std::string> differences = pack::differences_from(archive, folder / "results");
    for (const std::string& difference : differences) {
        std::cerr << "bannwald: " << difference << '\n';
    }
    std::cout << (differences.empty()
                      ? "The repeated run made the same bytes in every file: "
                      : joined("The repeated run differs in ", counted(differences.size(), "file"), ": "))
              << (folder / "results").string() << '\n';
    if (!differences.empty()) {
        std::cerr << "bannwald: the archive was made by version " << archive.run.version << ' '
                  << archive.run.commit << ", this is " << version() << ' ' << commit() << '\n';
    }
    return code(differences.empty() ? ExitCode::done : ExitCode::validation);
}

int verify(const CommandLine& line) {
    const pack::VerifiedArchive archive = pack::verify_archive(line.argument);
    if (!line.quiet) {
        std::cout << line.argument.string() << ": " << archive.files.size()
                  << " files, all with the bytes of their SHA-256; made by Bannwald " << archive.run.version
                  << (archive.run.commit.empty() ? "" : joined(" (", archive.run.commit, ")")) << '\n';
    }
    return line.rerun ? rerun(line, archive) : code(ExitCode::done);
}

int carry_out(const CommandLine& line, RankGroup& ranks) {
    if (line.command == "run") {
        return run(line, ranks);
    }
    if (!ranks.first()) {
        return code(ExitCode::done);  // only runs are shared: the first rank does anything else
    }
    if (line.command == "init") {
        return init(line);
    }
    if (line.command == "check") {
        return check(line);
    }
    if (line.command == "merge") {
        RankGroup alone{RankGroup::Alone{}};
        return run(line, alone);
    }
    if (line.command == "validate") {
        return validate_cases(line, std::cout);
    }
    if (line.command == "stopping-table") {
        return stopping_table(line);
    }
    if (line.command == "compare") {
        compare::compare_runs({.folders = line.folders,
                               .out = line.out,
                               .page = line.page,
                               .language = line.language,
                               .overwrite = line.overwrite,
                               .quiet = line.quiet},
                              std::cout);
        return code(ExitCode::done);
    }
    if (line.command == "vary") {
        return vary::vary_scenario({.scenario = line.argument,
                                    .factors = line.factors,
                                    .overrides = line.overrides,
                                    .out = line.out,
                                    .threads = line.threads,
                                    .overwrite = line.overwrite,
                                    .quiet = line.quiet},
                                   std::cout);
    }
    if (line.command == "collapse") {
        return collapse::run_collapse({.scenario = line.argument,
                                       .overrides = line.overrides,
                                       .out = line.out,
                                       .threads = line.threads,
                                       .overwrite = line.overwrite,
                                       .quiet = line.quiet,
                                       .verbose = line.verbose});
    }
    if (line.command == "pack") {
        return pack_run(line);
    }
    if (line.command == "verify") {
        return verify(line);
    }
    if (line.command == "net" && line.action == "place") {
        place_nets({.run = line.argument,
                    .nets = line.nets,
                    .out = line.out,
                    .distances_m = line.distances_m,
                    .azimuth_deg = line.azimuth_deg,
                    .overwrite = line.overwrite,
                    .quiet = line.quiet},
                   std::cout);
        return code(ExitCode::done);
    }
    if (line.command == "net") {
        try_nets({.run = line.argument,
                  .nets = line.nets,
                  .out = line.out,
                  .overwrite = line.overwrite,
                  .quiet = line.quiet},
                 std::cout);
        return code(ExitCode::done);
    }
    if (line.command == "completion") {
        write_completion(line.argument.string(), std::cout);
        return code(ExitCode::done);
    }
    if (line.command == "info") {
        write_info(line.argument.string(), line.table, std::cout);
    } else if (line.command == "version") {
        write_version(std::cout);
    } else if (line.command == "help-all") {
        write_help_all(std::cout, line.section);
    } else {
        write_help(std::cout, line.help_for);
    }
    return code(ExitCode::done);
}

/// Of many problems of a kind the first and their number, all of them with --verbose.
void print_problems(const config::InputError& error, const std::vector<std::string>& arguments) {
    const bool verbose = std::any_of(arguments.begin(), arguments.end(), [](const std::string& word) {
        return word == "-v" || word == "--verbose";
    });
    if (!verbose) {
        for (const config::BriefMessage& message : config::brief(error.problems())) {
            std::cerr << "bannwald: " << config::to_string(message) << '\n';
        }
        return;
    }
    for (const config::Problem& problem : error.problems()) {
        std::cerr << "bannwald: " << config::to_string(problem) << '\n';
    }
}

}  // namespace

int run_program(const std::vector<std::string>& arguments) {
    std::optional<RankGroup> ranks;
    // Of several ranks that fail one prints why; then all leave together.
    const auto speaks = [&] { return !ranks || ranks->fail(true); };
    int result = code(ExitCode::done);
    try {
        ranks.emplace();
        result = carry_out(parse_command_line(arguments), *ranks);
        std::cout.flush();
        if (!std::cout) {
            std::cerr << "bannwald: cannot write to the standard output\n";
            result = code(ExitCode::file);
        }
    } catch (const FailedElsewhere&) {
        ranks->fail(false);
    } catch (const config::InputError& error) {
        if (speaks()) {
            print_problems(error, arguments);
            result = code(error.code());
        }
    } catch (const std::filesystem::filesystem_error& error) {
        if (speaks()) {
            const std::string name = error.path1().empty() ? "the current folder" : error.path1().string();
            std::cerr << "bannwald: " << name << ": found a name that the file system refuses ("
                      << error.code().message()
                      << "), expected one that can be read and written; check its length, its links and your "
                         "permissions\n";
            result = code(ExitCode::file);
        }
    } catch (const std::exception& error) {
        if (speaks()) {
            const bool memory = dynamic_cast<const std::bad_alloc*>(&error) != nullptr;
            std::cerr << (memory ? "bannwald: not enough memory; `bannwald check` prints how much a run takes"
                                 : joined("bannwald: a fault of the program: ", error.what()))
                      << '\n';
            result = code(ExitCode::internal);
        }
    }
    return ranks ? ranks->leave_with(result) : result;
}

}  // namespace coupling
