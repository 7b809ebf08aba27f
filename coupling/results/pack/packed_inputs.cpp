#include "coupling/results/pack/packed_inputs.hpp"

#include <algorithm>
#include <set>
#include <sstream>
#include <utility>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/text/sha256.hpp"
#include "coupling/inputs/collapse_settings.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/inputs/formats/read_file.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/figures/json.hpp"
#include "coupling/results/pack/stored_file.hpp"
#include "coupling/results/pack/zip_file.hpp"
#include "coupling/results/text/scenario_names.hpp"

namespace coupling::pack {
namespace {

namespace fs = std::filesystem;
using config::ExitCode;
using config::joined;

/// Settings of the scenario as it is now that differ from those of the run.
void refuse_changed_settings(const SummaryOfRun& run, const Scenario& now) {
    config::Problems problems;
    for (const Json& setting : json_settings(now)) {
        const std::string key = setting.at("key").get<std::string>();
        const Json& value = setting.at("value");
        const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
        const auto then = std::find_if(run.settings.begin(), run.settings.end(),
                                       [&](const SummaryOfRun::Setting& each) { return each.key == key; });
        if (then != run.settings.end() && then->value != text) {
            problems.add(ExitCode::settings, now.options->place_of(key),
                         joined(key, " = ", text, ", but the run had ", then->value),
                         "the scenario of the run", "run it again, or name its scenario by --scenario");
        }
    }
    problems.throw_if_any();
}

/// A name without what distinguishes the parts of one data set: "outside/dem" of outside/dem.asc.gz and
/// outside/dem.prj.
std::string stem_of(const std::string& shown) {
    const fs::path file{formats::split_layer_name(shown).file};
    const std::string name = file.filename().string();
    return (file.parent_path() / name.substr(0, name.find('.', 1))).generic_string();
}

/// Stems of the files that the settings name: all else is named in tables, which are packed as they are.
std::set<std::string> stems_of_settings(const Scenario& scenario) {
    std::set<std::string> stems;
    for (const config::ParameterRow& row : scenario.shown_settings()) {
        for (const std::string& name : files_in(row)) {
            stems.insert(stem_of(name));
        }
    }
    return stems;
}

/// Whether settings name a file, or the folder that it lies in.
bool is_named(const std::string& shown, const std::set<std::string>& stems) {
    return stems.contains(stem_of(shown)) ||
           stems.contains(stem_of(fs::path{shown}.parent_path().generic_string()));
}

bool is_outside(const std::string& shown) {
    return shown.starts_with(outside_folder) && shown.find('/') != std::string::npos &&
           shown.find_first_not_of("_0123456789", std::string_view{outside_folder}.size()) == shown.find('/');
}

/// The inputs of a run on the disk, compared with what the run read.
class Collector {
public:
    Collector(const Scenario& scenario, const fs::path& file)
        : scenario_{scenario}, folder_{file.parent_path()}, stems_{stems_of_settings(scenario)} {}

    void add(const SummaryOfRun::Input& input) {
        const std::string path = scenario_.names->path_of(input.file);
        const fs::path file = path == input.file ? folder_ / input.file : fs::path{path};
        if (is_outside(input.file) && !is_file(folder_ / input.file) && !is_named(input.file, stems_)) {
            problems_.add(ExitCode::settings, {scenario_.file.string()},
                          joined(input.role, ": ", path_in_quotes(input.file),
                                 ", named in a table by a path outside of the project folder"),
                          "a file inside of it: an archive changes no table",
                          "copy the file into the project folder, name it there and run again");
            return;
        }
        if (is_outside(input.file) && !is_file(file)) {
            problems_.add(ExitCode::settings, {scenario_.file.string()},
                          joined(input.role, ": ", path_in_quotes(input.file),
                                 ", named on the command line of the run by a path outside of the project "
                                 "folder"),
                          "that path again", "add it, such as --set trees.file=PATH");
            return;
        }
        // Of some files a run uses only some rows or columns, whose hash it keeps under a role such as
        // "return_periods, rows of 30 years": the file has another one.
        const bool is_part =
            input.role.find(", rows of ") != std::string::npos || input.role.ends_with(", places and names");
        const FileBytes bytes = open_file(file, {file.string()}, "an input of the run");
        if (!is_part && bytes.hash() != input.hash) {
            problems_.add(ExitCode::data, {file.string()}, "a file that changed since the run",
                          "the input of the run", "run again");
        }
        if (names_.insert(input.file).second) {
            packed_.push_back(
                packed_file(file, joined("inputs/", input.file), joined("Input: ", input.role, ".")));
        }
    }
    std::vector<PackedFile> done() {
        problems_.throw_if_any();
        return std::move(packed_);
    }

private:
    const Scenario& scenario_;
    fs::path folder_;
    std::set<std::string> stems_;
    std::set<std::string> names_;
    std::vector<PackedFile> packed_;
    config::Problems problems_;
};

/// Replaces the value that stands at a place of a text, counted in characters of UTF-8 from 1.
void replace_at(std::vector<std::string>& lines, const config::Place& place, const std::string& value,
                const std::string& by) {
    std::string& line = lines.at(place.line - 1);
    const std::size_t at = line.find(value, line.find('=') + 1);
    if (at == std::string::npos) {
        config::fail(ExitCode::settings, place,
                     joined("the file ", config::in_quotes(value), ", written with quotes"),
                     "a name without quotes inside of it: the archive has to change it", "rename the file");
    }
    line.replace(at, value.size(), by);
}

/// Those of the run, those of the same key replaced.
std::vector<std::string> with_settings(std::vector<std::string> overrides,
                                       const std::vector<std::string>& settings) {
    for (const std::string& setting : settings) {
        const std::string key = setting.substr(0, setting.find('=') + 1);
        std::erase_if(overrides, [&](const std::string& other) { return other.starts_with(key); });
        overrides.push_back(setting);
    }
    return overrides;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::size_t begin = 0;
    for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', begin)) {
        lines.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    lines.push_back(text.substr(begin));
    return lines;
}

}  // namespace

PackedFile packed_file(const fs::path& file, std::string name, std::string sentence) {
    if (!is_file(file)) {
        config::fail(ExitCode::file, {file.string()}, "no such file", "a file that the run read or wrote");
    }
    if (!is_safe_name(name)) {
        config::fail(ExitCode::settings, {file.string()}, "a name that not every system can unpack",
                     "a name without ':', '\\' and line breaks", "rename the file and run again");
    }
    StoredFile stored = stored_file(file);
    return {file, {{std::move(name), std::move(stored.sha256)}, stored.bytes, std::move(sentence)}};
}

std::string packed_scenario(const std::string& text, const Scenario& read, const RunKind& kind) {
    Scenario written;
    collapse::CollapseSettings of_collapse;
    written.file = read.file;
    written.names = read.names;
    written.options = std::make_shared<config::Options>();
    declare(*written.options, written);
    if (kind.command == "collapse") {
        collapse::declare(*written.options, of_collapse);
    }
    std::istringstream in{text};
    written.options->read(in, read.file.string(), {}, "rockfall.preset");
    const std::vector<config::ParameterRow> as_written = written.options->rows();
    const std::vector<config::ParameterRow> as_packed = written.shown_settings();
    std::vector<std::string> lines = lines_of(text);
    for (std::size_t i = 0; i < as_written.size(); ++i) {
        if (as_packed[i].value_text != as_written[i].value_text &&
            written.options->was_set(as_written[i].key)) {
            replace_at(lines, written.options->place_of(as_written[i].key), as_written[i].value_text,
                       as_packed[i].value_text);
        }
    }
    std::string packed;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        packed += joined(i == 0 ? "" : "\n", lines[i]);
    }
    return packed;
}

std::vector<PackedFile> packed_inputs(const RunFolder& run, const fs::path& scenario,
                                      const std::vector<std::string>& settings) {
    const RunKind& kind = kind_of(run.summary.kind, run.summary_file.string());
    const ReadScenario now = read_scenario_of(kind, scenario, with_settings(run.summary.overrides, settings));
    refuse_changed_settings(run.summary, now.scenario);
    Collector collector{now.scenario, scenario};
    for (const SummaryOfRun::Input& input : run.summary.inputs) {
        collector.add(input);
    }
    std::vector<PackedFile> inputs = collector.done();
    PackedFile packed = packed_file(scenario, joined("inputs/", scenario.filename().string()),
                                    "The scenario: settings and names of the inputs.");
    const FileBytes bytes = open_file(scenario, {scenario.string()}, "the scenario of the run");
    const std::string text{bytes.text()};
    if (std::string changed = packed_scenario(text, now.scenario, kind); changed != text) {
        packed.described.file.sha256 = config::sha256_of(changed);
        packed.described.bytes = changed.size();
        packed.text = std::move(changed);
    }
    inputs.insert(inputs.begin(), std::move(packed));
    if (const FolderNames folders = report::scenario_names(now.scenario); !folders.empty()) {
        PackedFile names;
        names.text = text_of(folders);
        names.described = {{joined("inputs/", folder_names_file), config::sha256_of(*names.text)},
                           names.text->size(),
                           "Folders outside of the project as the scenario of the run named them."};
        inputs.push_back(std::move(names));
    }
    return inputs;
}

}  // namespace coupling::pack
