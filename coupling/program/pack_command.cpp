#include <iostream>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/version.hpp"
#include "coupling/assessments/collapse/collapse_run.hpp"
#include "coupling/inputs/tables/words.hpp"
#include "coupling/program/actions/run_assessment.hpp"
#include "coupling/program/commands.hpp"
#include "coupling/program/line/arguments.hpp"
#include "coupling/results/pack/pack.hpp"
#include "coupling/results/pack/run_folder.hpp"
#include "coupling/results/pack/verify.hpp"

namespace coupling {
namespace {

constexpr const char* pack_help = R"(bannwald pack DIR [options]

Puts a finished run into a zip file that can be cited and repeated: scenario, all inputs, all results, version and
commit of the program, the command, SHA-256 of every file, descriptions by RO-Crate 1.1 and DataCite 4. Inputs and
settings have to be those of the run still. The same folder gives the same bytes. Inputs from outside of the folder
of the scenario come into the folder `outside` of the archive, and the packed scenario names them there.
  --out FILE                the archive (default: DIR.zip)
  --scenario FILE           the scenario of the run (default: the file of its name beside DIR)
  --set section.key=value   where the run got a file from outside of the project folder by --set: the same again,
                            as results hold no paths
  --title TEXT              what the archive is called
  --creator NAME            who made it; again for more
  --licence NAME            of inputs and results, such as CC-BY-4.0
  --date YYYY-MM-DD         when it was made (default: the day on which the run ended)
  --overwrite               replaces an archive of that name
)";

constexpr const char* verify_help = R"(bannwald verify FILE.zip [options]

Reads every file of an archive of `bannwald pack` and compares its SHA-256 with the list in the archive. Ends with
exit code 4 if anything is damaged, missing or added.
  --rerun                   repeats the run with this program and compares every file of its results; ends with exit
                            code 5 if one differs, with 4 if the run would read a file outside of the archive
  --out DIR                 folder of the repeated run (default: FILE-rerun); stays
)";

using config::ExitCode;
using config::joined;

int code(ExitCode exit_code) {
    return static_cast<int>(exit_code);
}

std::string day_of(const std::string& date) {
    const bool is_date = date.size() == 10 && date[4] == '-' && date[7] == '-' &&
                         config::parse_whole(date.substr(0, 4)) && config::parse_whole(date.substr(5, 2)) &&
                         config::parse_whole(date.substr(8, 2));
    if (!date.empty() && !is_date) {
        refuse_usage("--date " + config::in_quotes(date), "a day such as 2026-05-31");
    }
    return date;
}

int pack_folder(const Arguments& arguments, const Call& call) {
    pack::pack_run({.run = arguments.only_word(),
                    .scenario = arguments.text("scenario"),
                    .out = arguments.out(),
                    .settings = arguments.overrides(),
                    .citation = {arguments.text("title"), arguments.texts("creator"),
                                 arguments.text("licence"), day_of(arguments.text("date"))},
                    .overwrite = arguments.overwrite(),
                    .quiet = arguments.quiet()},
                   call.out);
    return code(ExitCode::done);
}

/// Repeats the run of an archive and compares its files.
int rerun(const Arguments& arguments, const pack::VerifiedArchive& archive, std::ostream& out) {
    const std::filesystem::path file = arguments.only_word();
    const std::filesystem::path folder =
        arguments.has("out") ? arguments.out()
                             : std::filesystem::path{file}.replace_extension().concat("-rerun");
    const std::string_view command = pack::kind_of(archive.run.kind, file.string()).command;
    pack::unpack_inputs(file, archive, folder);
    RankGroup alone{RankGroup::Alone{}};
    const RunRequest request{.scenario = folder / archive.run.scenario,
                             .overrides = archive.run.overrides,
                             .out = folder / "results",
                             .threads = arguments.threads(),
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
    out << (differences.empty()
                ? "The repeated run made the same bytes in every file: "
                : joined("The repeated run differs in ", counted(differences.size(), "file"), ": "))
        << (folder / "results").string() << '\n';
    if (!differences.empty()) {
        std::cerr << "bannwald: the archive was made by version " << archive.run.version << ' '
                  << archive.run.commit << ", this is " << config::version() << ' ' << config::commit()
                  << '\n';
    }
    return code(differences.empty() ? ExitCode::done : ExitCode::validation);
}

int verify(const Arguments& arguments, const Call& call) {
    const std::string file = arguments.only_word();
    const pack::VerifiedArchive archive = pack::verify_archive(file);
    if (!arguments.quiet()) {
        call.out << file << ": " << archive.files.size()
                 << " files, all with the bytes of their SHA-256; made by Bannwald " << archive.run.version
                 << (archive.run.commit.empty() ? "" : joined(" (", archive.run.commit, ")")) << '\n';
    }
    return arguments.has("rerun") ? rerun(arguments, archive, call.out) : code(ExitCode::done);
}

}  // namespace

Command pack_command() {
    return {
        .name = "pack",
        .overview =
            R"(  bannwald pack DIR                    makes an archive of a finished run that can be cited and repeated
)",
        .help = pack_help,
        .argument = "the folder of a run",
        .options = {set_option(),
                    option_with_value("scenario", {Completion::Names::files}),
                    option_with_value("title"),
                    {.name = "creator", .may_come_again = true},
                    option_with_value("licence"),
                    option_with_value("date"),
                    option_with_value("out", {Completion::Names::files}),
                    overwrite_option()},
        .completion = {Completion::Names::folders},
        .run = pack_folder};
}

Command verify_command() {
    return {
        .name = "verify",
        .overview =
            R"(  bannwald verify FILE.zip             checks such an archive; --rerun repeats the run and compares
)",
        .help = std::string{verify_help} + help_of_threads,
        .argument = "an archive",
        .options = {switch_option("rerun"), out_folder_option(), threads_option()},
        .completion = {Completion::Names::files},
        .run = verify};
}

}  // namespace coupling
