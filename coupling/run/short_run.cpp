#include "coupling/run/short_run.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/version.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/inputs/own_files/file_reader.hpp"
#include "coupling/results/disk/byte_archive.hpp"
#include "coupling/results/disk/disk.hpp"
#include "coupling/results/disk/leftovers.hpp"
#include "coupling/results/excel_csv.hpp"
#include "coupling/results/figures/read_summary.hpp"
#include "coupling/results/tables/data_dictionary.hpp"

namespace coupling {
namespace {

using config::joined;

namespace fs = std::filesystem;

constexpr const char* staged_name = ".staged";       ///< with machine and process behind it
constexpr const char* whole_name = ".staged_whole";  ///< on the way to its place
constexpr const char* summary_name = "summary.json";
constexpr const char* dictionary_name = "data_dictionary.csv";
constexpr const char* summary_sentence = "Figures, inputs, files and remarks for scripts.";
constexpr const char* dictionary_sentence = "Every column of the tables: unit, meaning, source.";

/// Names of the files that a summary in the folder lists; none without one. Only files of the folder itself:
/// what a changed summary names elsewhere is not ours.
std::set<std::string> listed_in(const fs::path& folder) {
    const fs::path file = folder / summary_name;
    if (!is_there(file)) {
        return {};
    }
    std::set<std::string> names;
    for (std::string& name : files_in_summary(text_of_file(file), file.string())) {
        if (name != ".." && fs::path{name}.filename() == name) {
            names.insert(std::move(name));
        }
    }
    return names;
}

/// Of the command or run that wrote a summary; "" where that is not said.
std::string kind_of(const fs::path& summary) {
    const Json json = Json::parse(text_of_file(summary), nullptr, false);
    const Json run = json.is_object() ? json.value("run", Json{}) : Json{};
    return run.is_object() ? run.value("kind", "") : "";
}

/// From where it is whole to its place; what the new summary does not list any more goes first, the summary
/// comes last. A call that is killed here is repeated: what has moved already is in the new list and stays.
void move_whole(const fs::path& folder) {
    const fs::path whole = folder / whole_name;
    if (const std::set<std::string> fresh = listed_in(whole); !fresh.empty()) {
        for (const std::string& name : listed_in(folder)) {
            if (!fresh.contains(name)) {
                delete_entry(folder / name);
            }
        }
    }
    for (const fs::path& entry : entries_of(whole)) {
        if (entry.filename() != summary_name) {
            move_entry(entry, folder / entry.filename());
        }
    }
    if (is_there(whole / summary_name)) {
        sync_folder(folder);
        move_entry(whole / summary_name, folder / summary_name);
    }
    sync_folder(folder);
    delete_entry(whole);
}

void tidy(const fs::path& folder) {
    if (is_there(folder / whole_name)) {
        move_whole(folder);
    }
    delete_leftovers_of(folder / staged_name);
}

}  // namespace

void ShortRun::look_at(const fs::path& folder, const std::string& kind, std::vector<std::string> names,
                       bool overwrite) {
    if (!path_exists(folder)) {
        return;
    }
    if (!is_folder(folder)) {
        config::fail(config::ExitCode::settings, {folder.string()}, "the output folder is a file",
                     "a folder; choose another one by --out");
    }
    tidy(folder);
    if (!overwrite && !is_empty_folder(folder)) {
        config::fail(config::ExitCode::settings, {folder.string()}, "a folder with files in it",
                     "a new or empty folder, or --overwrite to replace results of this command");
    }
    if (is_there(folder / summary_name) && kind_of(folder / summary_name) != kind) {
        config::fail(config::ExitCode::settings, {folder.string()}, "results of another command or run",
                     "another folder by --out");
    }
    names.emplace_back(dictionary_name);
    const std::set<std::string> own = listed_in(folder);
    for (const std::string& name : names) {
        if (is_there(folder / name) && !own.contains(name)) {
            config::fail(config::ExitCode::settings, {(folder / name).string()},
                         "the output folder holds something of this name that no summary.json lists",
                         "another folder by --out");
        }
    }
}

ShortRun::ShortRun(fs::path folder)
    : folder_{std::move(folder)},
      stage_{temporary_beside(folder_ / staged_name)},
      existed_{path_exists(folder_)} {
    make_folder(folder_);
    tidy(folder_);
    make_folder(stage_);
}

ShortRun::~ShortRun() {
    std::error_code ignored;
    fs::remove_all(stage_, ignored);
    if (!existed_) {
        fs::remove(folder_, ignored);  // removes an empty folder only
    }
}

void ShortRun::add(const std::string& name, std::string sentence,
                   const std::function<void(std::ostream&)>& fill) {
    OutFile file{stage_ / name};
    fill(file.stream());
    file.close();
    files_.push_back({name, std::move(sentence)});
}

std::vector<WrittenFile> ShortRun::files_with_those_to_come() const {
    std::vector<WrittenFile> files = files_;
    files.push_back({dictionary_name, dictionary_sentence});
    files.push_back({summary_name, summary_sentence});
    return files;
}

const std::vector<WrittenFile>& ShortRun::publish(const ShortSummary& summary,
                                                  const std::vector<TableLayout>& layouts) {
    if (!layouts.empty()) {
        add(dictionary_name, dictionary_sentence,
            [&](std::ostream& out) { write_dictionary(out, layouts, "", files_); });
    }
    if (summary.excel_decimal) {
        turn_into_excel_csv(stage_, *summary.excel_decimal);
    }
    files_.push_back({summary_name, summary_sentence});
    OutFile file{stage_ / summary_name};
    Json json{{"program", "Bannwald"}, {"version", config::version()}, {"run", summary.run}};
    json["run"]["kind"] = summary.kind;
    json["figures"] = summary.figures;
    json["warnings"] = summary.warnings;
    write_json_summary(file.stream(), std::move(json), summary.inputs, files_);
    file.close();

    sync_all_below(stage_);
    move_entry(stage_, folder_ / whole_name);
    sync_folder(folder_);
    move_whole(folder_);
    return files_;
}

}  // namespace coupling
