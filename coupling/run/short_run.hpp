#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "coupling/inputs/reading/input_file.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/figures/json.hpp"
#include "coupling/results/tables/table_layout.hpp"

namespace coupling {

/// What a command that keeps no parts says of itself in its summary.json.
struct ShortSummary {
    std::string kind;  ///< "net try", "net place", "vary", "compare", "validate"
    Json run;          ///< what it was asked for
    Json figures;
    std::vector<InputFile> inputs;
    std::vector<std::string> warnings;    ///< and notes, as they stand on the screen
    std::optional<char> excel_decimal{};  ///< decimal sign of tables for Excel; none: plain ones
};

/// The folder of such a command (`net try`, `net place`, `vary`, `compare`, `validate`), whole or not at all.
///
/// Files are written aside in a folder of their own below the one that they belong to, then moved to their
/// place; summary.json, which lists them, comes last. A command that is killed before leaves nothing under a
/// final name; one that is killed while files move is finished by the next one.
class ShortRun {
public:
    /// Before any work: finishes or deletes what killed commands left there. Throws config::InputError
    /// (settings) for a folder with files in it unless `overwrite`, and in any case for results of another
    /// command, and for one of `names` that no summary.json lists: it is the user's.
    static void look_at(const std::filesystem::path& folder, const std::string& kind,
                        std::vector<std::string> names, bool overwrite);

    /// Makes the folder if it is missing. Throws config::InputError (file).
    explicit ShortRun(std::filesystem::path folder);
    /// Deletes what was not published, and the folder if it was missing before.
    ~ShortRun();
    ShortRun(const ShortRun&) = delete;
    ShortRun& operator=(const ShortRun&) = delete;

    /// Where files are to be written; no folders below it.
    [[nodiscard]] const std::filesystem::path& path() const { return stage_; }
    /// Writes one of the files. Throws config::InputError (file).
    void add(const std::string& name, std::string sentence, const std::function<void(std::ostream&)>& fill);
    /// Of one that was written to path().
    void add_written(WrittenFile file) { files_.push_back(std::move(file)); }

    /// What was added so far, and what publish() adds to tables: for a page that lists them all.
    [[nodiscard]] std::vector<WrittenFile> files_with_those_to_come() const;

    /// Adds data_dictionary.csv, every column of the tables that `layouts` declares (no file where it
    /// declares none), and summary.json; moves all files to their place. Those that an earlier summary.json
    /// lists and this one does not are deleted. Returns the files once they are on the disk.
    const std::vector<WrittenFile>& publish(const ShortSummary& summary,
                                            const std::vector<TableLayout>& layouts);

private:
    std::filesystem::path folder_;
    std::filesystem::path stage_;
    bool existed_;
    std::vector<WrittenFile> files_;
};

}  // namespace coupling
