#include "config/text/language.hpp"
#include "coupling/assessments/compare/compare.hpp"
#include "coupling/program/commands.hpp"
#include "coupling/program/line/arguments.hpp"

namespace coupling {
namespace {

constexpr const char* compare_help = R"(bannwald compare DIR DIR... [options]

Puts two or more finished runs side by side: today's protection with today's, or years with years. Shows for each
target the share of rocks that the forest stops, how many arrive and with which energy, with intervals; for runs
over years the means over the years and the worst year of each regime. Tells which settings and inputs differ,
whether a difference to the first run is more than chance, and when runs cannot be compared because their terrain,
targets or rocks differ.
  --out DIR                 folder of compare.csv and report.html, with distributions and maps of the runs
  --page FILE               the page alone
  --language de             of the page: en, de, de_CH, fr, fr_CH or it (default: that of the first run)
  --overwrite               replaces a comparison that the folder holds, or that page
  -q, --quiet               nothing on the screen
)";

std::vector<std::string> language_words() {
    return {"en", "de", "fr", "it"};
}

/// Folders of finished runs.
int compare_folders(const Arguments& arguments, const Call& call) {
    const std::vector<std::string>& words = arguments.words();
    if (words.size() < 2) {
        refuse_usage("`bannwald compare` without two folders", "the folders of two finished runs or more");
    }
    std::optional<config::Language> language;
    if (arguments.has("language")) {
        language = config::language_of(arguments.text("language"));
        if (!language) {
            refuse_usage("--language " + config::in_quotes(arguments.text("language")),
                         "en, de, de_CH, fr, fr_CH or it");
        }
        if (!arguments.has("page") && !arguments.has("out")) {
            refuse_usage("--language without --page",
                         "--page FILE or --out DIR, the page to write in that language");
        }
    }
    compare::compare_runs({.folders = {words.begin(), words.end()},
                           .out = arguments.out(),
                           .page = arguments.text("page"),
                           .language = language,
                           .overwrite = arguments.overwrite(),
                           .quiet = arguments.quiet()},
                          call.out);
    return static_cast<int>(config::ExitCode::done);
}

}  // namespace

Command compare_command() {
    return {
        .name = "compare",
        .overview =
            R"(  bannwald compare DIR DIR...          puts finished runs side by side, with which differences are significant
)",
        .help = compare_help,
        .argument = "",
        .options = {out_folder_option(), option_with_value("page", {Completion::Names::files}),
                    option_with_value("language", {.words = language_words}), overwrite_option()},
        .completion = {Completion::Names::folders},
        .run = compare_folders};
}

}  // namespace coupling
