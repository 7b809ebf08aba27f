#include "coupling/run/messages.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string_view>
#include <utility>

#include "config/errors/brief.hpp"

namespace coupling {
namespace {

/// What people look at first, in all kinds of runs.
constexpr std::array<std::string_view, 13> worth_opening{"report.html",
                                                         "results.qlr",
                                                         "tables/protection.csv",
                                                         "tables/targets.csv",
                                                         "tables/stations.csv",
                                                         "tables/decision.csv",
                                                         "tables/regimes_by_year.csv",
                                                         "tables/stands.csv",
                                                         "tables/regime_differences.csv",
                                                         "tables/climate_differences.csv",
                                                         "tables/data_dictionary.csv",
                                                         "rasters/forest/E_95.asc",
                                                         "summary.json"};

/// A sentence in which files elsewhere are named by their paths from the working directory, as errors name
/// them: results call them outside/NAME.
std::string with_paths(std::string sentence, const InputNames& names) {
    const std::string prefix = outside_folder;
    for (std::size_t at = sentence.find(prefix); at != std::string::npos; at = sentence.find(prefix, at)) {
        const std::size_t slash = sentence.find_first_not_of("_0123456789", at + prefix.size());
        const bool begins = at == 0 || sentence[at - 1] == ' ' || sentence[at - 1] == '\'';
        if (!begins || slash == std::string::npos || sentence[slash] != '/') {
            at += prefix.size();
            continue;
        }
        const std::size_t end = std::min(sentence.find_first_of(" :,;)'", slash), sentence.size());
        const std::string path = names.path_of(sentence.substr(at, end - at));
        sentence.replace(at, end - at, path);
        at += path.size();
    }
    return sentence;
}

/// Of many of a kind the first and their number; all of them if `verbose`.
void print_messages(const char* kind, std::vector<std::string> sentences, bool verbose,
                    const InputNames* names) {
    for (std::string& sentence : sentences) {
        sentence = names != nullptr ? with_paths(std::move(sentence), *names) : std::move(sentence);
    }
    if (verbose) {
        for (const std::string& sentence : sentences) {
            std::fprintf(stderr, "bannwald: %s: %s\n", kind, sentence.c_str());
        }
        return;
    }
    for (const config::BriefMessage& message : config::brief(sentences)) {
        std::fprintf(stderr, "bannwald: %s: %s\n", kind, config::to_string(message).c_str());
    }
}

}  // namespace

void print_warnings(const config::Warnings& warnings, bool verbose, const InputNames* names) {
    print_messages("warning", warnings.warnings(), verbose, names);
    print_messages("note", warnings.notes(), verbose, names);
}

void repeat_warnings(const config::Warnings& warnings, bool verbose, const InputNames* names) {
    const std::size_t count = warnings.warnings().size();
    const std::size_t notes = warnings.notes().size();
    if (count + notes == 0) {
        return;
    }
    std::fflush(stdout);
    if (count > 0) {
        std::fprintf(stderr, "bannwald: done, with %zu %s:\n", count, count == 1 ? "warning" : "warnings");
        print_messages("warning", warnings.warnings(), verbose, names);
    }
    if (verbose) {
        print_messages("note", warnings.notes(), verbose, names);
    } else if (notes > 0) {
        std::fprintf(stderr, "bannwald: %zu %s on how inputs were understood: report.html lists %s\n", notes,
                     notes == 1 ? "note" : "notes", notes == 1 ? "it" : "them");
    }
}

void print_files(const std::filesystem::path& folder, std::span<const WrittenFile> files, bool verbose) {
    std::printf("Results in %s\n", folder.string().c_str());
    std::size_t shown = 0;
    for (const WrittenFile& file : files) {
        const bool wanted = verbose || std::find(worth_opening.begin(), worth_opening.end(), file.path) !=
                                           worth_opening.end();
        if (wanted) {
            std::printf("  %-32s %s\n", file.path.c_str(), file.sentence.c_str());
            ++shown;
        }
    }
    if (shown < files.size()) {
        std::printf("  and %zu more files; --verbose lists all, report.html links them\n",
                    files.size() - shown);
    }
}

}  // namespace coupling
