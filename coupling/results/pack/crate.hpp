#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "coupling/results/figures/read_summary.hpp"
#include "coupling/results/pack/manifest.hpp"

namespace coupling::pack {

/// What only people know of an archive.
struct Citation {
    std::string title;                  ///< empty: named after the scenario
    std::vector<std::string> creators;  ///< empty: not known
    std::string licence;                ///< SPDX identifier or URL; empty: not stated
    std::string date;                   ///< YYYY-MM-DD
};

/// A file of an archive as its descriptions name it.
struct DescribedFile {
    ListedFile file;
    std::uint64_t bytes = 0;
    std::string sentence;  ///< what it holds
};

/// Name of the scenario inside of the archive and the command that repeats the run there.
struct Repetition {
    std::string scenario;
    std::string command;
};

/// "Bannwald 0.2.0, commit ..., by ..., licence ...", with the address of its source where CITATION.cff has
/// it.
std::string program_in_words(const SummaryOfRun& run);

/// ro-crate-metadata.json by RO-Crate 1.1: the archive as a dataset, its files with SHA-256, the program as
/// instrument of the action that made the results from the inputs. The program stands there with version,
/// commit, authors, licence and source.
std::string ro_crate(const SummaryOfRun& run, const Citation& citation, const Repetition& repetition,
                     const std::vector<DescribedFile>& inputs, const std::vector<DescribedFile>& results);

/// datacite.json by the DataCite metadata schema 4: what a repository asks for before it gives a DOI. What is
/// not known has DataCite's own words for it, (:unkn) and (:tba).
std::string datacite(const SummaryOfRun& run, const Citation& citation, std::uint64_t files,
                     std::uint64_t bytes);

/// run.json: what `bannwald verify` needs to repeat the run.
std::string run_json(const SummaryOfRun& run, const Repetition& repetition);

/// The same read back. Throws config::InputError (data); `file` names the archive.
struct PackedRun {
    std::string version;
    std::string commit;
    std::string kind;  ///< of run, as in summary.json; "today" where an archive of earlier versions has none
    std::string scenario;
    std::vector<std::string> overrides;
};
PackedRun read_run_json(const std::string& text, const std::string& file);

}  // namespace coupling::pack
