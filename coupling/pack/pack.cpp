#include "coupling/pack/pack.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/text/sha256.hpp"
#include "coupling/inputs/file_bytes.hpp"
#include "coupling/inputs/path_checks.hpp"
#include "coupling/inputs/scenario.hpp"
#include "coupling/pack/stored_file.hpp"
#include "coupling/pack/zip_file.hpp"
#include "coupling/results/disk.hpp"
#include "coupling/results/json.hpp"
#include "coupling/run/byte_archive.hpp"
#include "coupling/run/leftovers.hpp"

namespace coupling::pack {
namespace {

namespace fs = std::filesystem;
using config::ExitCode;
using config::joined;

/// A file on the disk and how it is named in the archive.
struct Packed {
    fs::path file;
    DescribedFile described;
};

Packed packed(const fs::path& file, std::string name, std::string sentence) {
    if (!is_file(file)) {
        config::fail(ExitCode::file, {file.string()}, "no such file", "a file that the run read or wrote");
    }
    StoredFile stored = stored_file(file);
    return {file, {{std::move(name), std::move(stored.sha256)}, stored.bytes, std::move(sentence)}};
}

fs::path clean(const fs::path& path) {
    return fs::absolute(path).lexically_normal();
}

/// The folder above all files: names in the archive count from it.
fs::path common_folder(const std::vector<fs::path>& files) {
    fs::path common = files.front().parent_path();
    for (const fs::path& file : files) {
        while (!common.empty() && *file.lexically_relative(common).begin() == "..") {
            common = common.parent_path();
        }
    }
    return common;
}

/// Settings of the scenario as it is now that differ from those of the run.
void refuse_changed_settings(const SummaryOfRun& run, const fs::path& scenario) {
    const auto now = read_scenario(scenario, run.overrides);
    config::Problems problems;
    for (const Json& setting : json_settings(*now)) {
        const std::string key = setting.at("key").get<std::string>();
        const Json& value = setting.at("value");
        const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
        const auto then = std::find_if(run.settings.begin(), run.settings.end(),
                                       [&](const SummaryOfRun::Setting& each) { return each.key == key; });
        if (then != run.settings.end() && then->value != text) {
            problems.add(ExitCode::settings, now->options->place_of(key),
                         joined(key, " = ", text, ", but the run had ", then->value),
                         "the scenario of the run", "run it again, or name its scenario by --scenario");
        }
    }
    problems.throw_if_any();
}

/// Scenario and inputs, named from the folder above all of them.
std::vector<Packed> inputs_of(const SummaryOfRun& run, const fs::path& scenario) {
    std::vector<fs::path> files{clean(scenario)};
    config::Problems problems;
    for (const SummaryOfRun::Input& input : run.inputs) {
        const fs::path file = clean(scenario.parent_path() / input.file);
        if (fs::path{input.file}.is_absolute()) {
            problems.add(ExitCode::settings, {scenario.string()},
                         joined(input.role, " ", config::in_quotes(input.file), ", a name from the root"),
                         "names that count from the scenario: an archive is used elsewhere",
                         "change the name and run again");
            continue;
        }
        if (open_file(file, {file.string()}, "an input of the run").hash() != input.hash) {
            problems.add(ExitCode::data, {file.string()}, "a file that changed since the run",
                         "the input of the run", "run again");
        }
        if (std::find(files.begin(), files.end(), file) == files.end()) {
            files.push_back(file);
        }
    }
    problems.throw_if_any();
    const fs::path common = common_folder(files);
    std::vector<Packed> inputs;
    for (std::size_t i = 0; i < files.size(); ++i) {
        std::string sentence = "The scenario: settings and names of the inputs.";
        for (const SummaryOfRun::Input& input : run.inputs) {
            if (clean(scenario.parent_path() / input.file) == files[i]) {
                sentence = joined("Input: ", input.role, ".");
            }
        }
        inputs.push_back(packed(files[i],
                                joined("inputs/", files[i].lexically_relative(common).generic_string()),
                                std::move(sentence)));
    }
    return inputs;
}

std::vector<Packed> results_of(const fs::path& run, const std::string& summary) {
    std::vector<Packed> results;
    const Json json = Json::parse(summary);
    for (const Json& entry : json.at("files")) {
        const std::string path = entry.at("path").get<std::string>();
        if (!is_safe_name(path)) {
            config::fail(ExitCode::data, {(run / "summary.json").string()},
                         joined("a result ", config::in_quotes(path)), "files below the folder of the run");
        }
        results.push_back(packed(run / path, joined("results/", path), entry.at("holds").get<std::string>()));
    }
    const auto has_summary = std::any_of(results.begin(), results.end(), [](const Packed& result) {
        return result.described.file.name == "results/summary.json";
    });
    if (!has_summary) {
        results.push_back(packed(run / "summary.json", "results/summary.json", "Figures and settings."));
    }
    return results;
}

/// In quotes where a shell would not take it as it is.
std::string word_of_shell(const std::string& text) {
    constexpr std::string_view plain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_=./,:+-";
    if (text.find_first_not_of(plain) == std::string::npos) {
        return text;
    }
    std::string quoted = "'";
    for (const char c : text) {
        quoted += c == '\'' ? std::string{"'\\''"} : std::string(1, c);
    }
    return quoted + "'";
}

Repetition repetition_of(const SummaryOfRun& run, const std::string& scenario) {
    std::string command = joined("bannwald run ", word_of_shell(scenario));
    for (const std::string& override_text : run.overrides) {
        command += joined(" --set ", word_of_shell(override_text));
    }
    return {scenario, joined(command, " --out again")};
}

std::string day_of(const fs::path& file) {
    const auto ended = std::chrono::file_clock::to_sys(fs::last_write_time(file));
    const std::chrono::year_month_day day{std::chrono::floor<std::chrono::days>(ended)};
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "%04d-%02u-%02u", static_cast<int>(day.year()),
                  static_cast<unsigned>(day.month()), static_cast<unsigned>(day.day()));
    return text.data();
}

std::string readme(const SummaryOfRun& run, const Repetition& repetition, const Citation& citation) {
    return joined(
        "# ", citation.title.empty() ? joined("Run of ", run.scenario) : citation.title, "\n\n",
        "Made by Bannwald ", run.version, run.commit.empty() ? "" : joined(", commit ", run.commit),
        ". `results/report.html` opens in any browser.\n\n| file | what |\n|---|---|\n",
        "| `inputs/` | scenario and every file that the run read |\n",
        "| `results/` | every file that it wrote |\n",
        "| `run.json` | version, commit, settings given on the command line, the command |\n",
        "| `manifest-sha256.txt` | SHA-256 of every other file: `sha256sum -c manifest-sha256.txt` |\n",
        "| `ro-crate-metadata.json` | description by RO-Crate 1.1 |\n",
        "| `datacite.json` | metadata for a DOI, DataCite schema 4; `(:unkn)` and `(:tba)` are to be filled "
        "in |\n\nTo repeat the run in the unpacked archive:\n\n    ",
        repetition.command, "\n\n`bannwald verify ARCHIVE.zip --rerun` does this and compares every file.\n");
}

void write_archive(const fs::path& out, const SummaryOfRun& run, const Citation& citation,
                   const std::vector<Packed>& inputs, const std::vector<Packed>& results) {
    const Repetition repetition = repetition_of(run, inputs.front().described.file.name);
    std::vector<DescribedFile> of_inputs;
    std::vector<DescribedFile> of_results;
    std::uint64_t bytes = 0;
    for (const Packed& input : inputs) {
        of_inputs.push_back(input.described);
        bytes += input.described.bytes;
    }
    for (const Packed& result : results) {
        of_results.push_back(result.described);
        bytes += result.described.bytes;
    }
    const std::vector<std::pair<std::string, std::string>> texts{
        {"README.md", readme(run, repetition, citation)},
        {"datacite.json", datacite(run, citation, inputs.size() + results.size(), bytes)},
        {"ro-crate-metadata.json", ro_crate(run, citation, repetition, of_inputs, of_results)},
        {"run.json", run_json(run, repetition)}};
    std::vector<ListedFile> listed;
    for (const auto& [name, text] : texts) {
        listed.push_back({name, config::sha256_of(text)});
    }
    delete_leftovers_of(out);
    const fs::path temporary = temporary_beside(out);
    ZipWriter zip{temporary};
    for (const std::vector<Packed>* files : {&inputs, &results}) {
        for (const Packed& file : *files) {
            listed.push_back(file.described.file);
        }
    }
    zip.add_text(manifest_name, manifest_text(listed));
    for (const auto& [name, text] : texts) {
        zip.add_text(name, text);
    }
    for (const std::vector<Packed>* files : {&inputs, &results}) {
        for (const Packed& file : *files) {
            zip.add_file(file.described.file.name, file.file);
        }
    }
    zip.close();
    sync_file(temporary);
    move_entry(temporary, out);
}

}  // namespace

void pack_run(const PackRequest& request, std::ostream& screen) {
    fs::path folder = request.run.lexically_normal();
    if (!folder.has_filename()) {
        folder = folder.parent_path();
    }
    const fs::path summary_file = folder / "summary.json";
    if (!is_file(summary_file)) {
        config::fail(ExitCode::file, {folder.string()}, "no summary.json", "the folder of a finished run",
                     "run the scenario first");
    }
    const fs::path out = request.out.empty() ? fs::path{folder.string() + ".zip"} : request.out;
    if (!request.overwrite && path_exists(out)) {
        config::fail(ExitCode::settings, {out.string()}, "an archive that is there", "a new file",
                     "name another one by --out, or add --overwrite");
    }
    const FileBytes bytes = open_file(summary_file, {summary_file.string()}, "the summary of a run");
    const SummaryOfRun run = read_summary(bytes.text(), summary_file.string());
    const fs::path scenario =
        request.scenario.empty() ? clean(folder).parent_path() / run.scenario : request.scenario;
    if (!is_file(scenario)) {
        config::fail(ExitCode::file, {scenario.string()}, "no such file", "the scenario of the run",
                     "name it by --scenario FILE");
    }
    refuse_changed_settings(run, scenario);
    const std::vector<Packed> inputs = inputs_of(run, scenario);
    const std::vector<Packed> results = results_of(folder, std::string{bytes.text()});
    Citation citation = request.citation;
    if (citation.date.empty()) {
        citation.date = day_of(summary_file);
    }
    write_archive(out, run, citation, inputs, results);
    if (!request.quiet) {
        screen << "Archive " << out.string() << ": " << inputs.size() << " inputs, " << results.size()
               << " results, checksums, RO-Crate and DataCite descriptions\n";
        if (citation.creators.empty() || citation.licence.empty()) {
            screen << "To be filled in before it is published:"
                   << (citation.creators.empty() ? " --creator NAME" : "")
                   << (citation.licence.empty() ? " --licence NAME" : "") << '\n';
        }
    }
}

}  // namespace coupling::pack
