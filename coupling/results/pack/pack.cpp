#include "coupling/results/pack/pack.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/text/sha256.hpp"
#include "config/text/shell_word.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/results/disk/byte_archive.hpp"
#include "coupling/results/disk/disk.hpp"
#include "coupling/results/disk/leftovers.hpp"
#include "coupling/results/pack/packed_inputs.hpp"
#include "coupling/results/pack/run_folder.hpp"
#include "coupling/results/pack/zip_file.hpp"

namespace coupling::pack {
namespace {

namespace fs = std::filesystem;
using config::ExitCode;
using config::joined;

Repetition repetition_of(const SummaryOfRun& run, const RunKind& kind, const std::string& scenario) {
    std::string command = joined("bannwald ", kind.command, " ", config::shell_word(scenario));
    for (const std::string& override_text : run.overrides) {
        command += joined(" --set ", config::shell_word(override_text));
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

std::string readme(const SummaryOfRun& run, const Repetition& repetition, const Citation& citation,
                   const std::string& page) {
    return joined(
        "# ", citation.title.empty() ? joined("Run of ", run.scenario) : citation.title, "\n\n", "Made by ",
        program_in_words(run), ". `results/", page, "` opens in any browser.\n\n| file | what |\n|---|---|\n",
        "| `inputs/` | scenario and every file that the run read |\n",
        "| `results/` | every file that it wrote |\n",
        "| `run.json` | version, commit, settings given on the command line, the command |\n",
        "| `manifest-sha256.txt` | SHA-256 of every other file: `sha256sum -c manifest-sha256.txt` |\n",
        "| `ro-crate-metadata.json` | description by RO-Crate 1.1 |\n",
        "| `datacite.json` | metadata for a DOI, DataCite schema 4; `(:unkn)` and `(:tba)` are to be filled "
        "in |\n\nTo repeat the run in the unpacked archive:\n\n    ",
        repetition.command, "\n\n`bannwald verify ARCHIVE.zip --rerun` does this and compares every file.\n");
}

/// Results below the folder of the run.
std::vector<PackedFile> results_of(const RunFolder& run) {
    std::vector<PackedFile> results;
    for (const ResultFile& result : run.results) {
        results.push_back(
            packed_file(run.path / result.path, joined("results/", result.path), result.sentence));
    }
    return results;
}

void write_archive(const fs::path& out, const RunFolder& folder, const Citation& citation,
                   const std::vector<PackedFile>& inputs, const std::vector<PackedFile>& results) {
    const SummaryOfRun& run = folder.summary;
    const RunKind& kind = kind_of(run.kind, folder.summary_file.string());
    const Repetition repetition = repetition_of(run, kind, inputs.front().described.file.name);
    const std::string page = joined(kind.folder, kind.folder.empty() ? "" : "/", "report.html");
    std::vector<DescribedFile> of_inputs;
    std::vector<DescribedFile> of_results;
    std::uint64_t bytes = 0;
    for (const PackedFile& input : inputs) {
        of_inputs.push_back(input.described);
        bytes += input.described.bytes;
    }
    for (const PackedFile& result : results) {
        of_results.push_back(result.described);
        bytes += result.described.bytes;
    }
    const std::vector<std::pair<std::string, std::string>> texts{
        {"README.md", readme(run, repetition, citation, page)},
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
    for (const std::vector<PackedFile>* files : {&inputs, &results}) {
        for (const PackedFile& file : *files) {
            listed.push_back(file.described.file);
        }
    }
    zip.add_text(manifest_name, manifest_text(listed));
    for (const auto& [name, text] : texts) {
        zip.add_text(name, text);
    }
    for (const std::vector<PackedFile>* files : {&inputs, &results}) {
        for (const PackedFile& file : *files) {
            if (file.text) {
                zip.add_text(file.described.file.name, *file.text);
            } else {
                zip.add_file(file.described.file.name, file.file);
            }
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
    const RunFolder run = read_run_folder(folder);
    const fs::path out = request.out.empty() ? fs::path{folder.string() + ".zip"} : request.out;
    if (!request.overwrite && path_exists(out)) {
        config::fail(ExitCode::settings, {out.string()}, "an archive that is there", "a new file",
                     "name another one by --out, or add --overwrite");
    }
    const fs::path scenario =
        request.scenario.empty()
            ? fs::absolute(folder).lexically_normal().parent_path() / run.summary.scenario
            : request.scenario;
    if (!is_file(scenario)) {
        config::fail(ExitCode::file, {scenario.string()}, "no such file", "the scenario of the run",
                     "name it by --scenario FILE");
    }
    const std::vector<PackedFile> inputs = packed_inputs(run, scenario, request.settings);
    const std::vector<PackedFile> results = results_of(run);
    Citation citation = request.citation;
    if (citation.date.empty()) {
        citation.date = day_of(run.summary_file);
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
