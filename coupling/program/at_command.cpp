#include <algorithm>
#include <cmath>
#include <iomanip>
#include <optional>
#include <sstream>

#include "config/grid/ascii_grid.hpp"
#include "config/table/table.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/program/actions/listing.hpp"
#include "coupling/program/commands.hpp"
#include "coupling/program/line/arguments.hpp"
#include "coupling/results/figures/finished_runs.hpp"
#include "coupling/results/figures/read_summary.hpp"
#include "coupling/run/file_sums.hpp"

namespace coupling {
namespace {

namespace fs = std::filesystem;
using config::ExitCode;
using config::joined;

/// A 99th percentile of fewer rocks is the largest of them.
constexpr int enough_rocks = 100;

constexpr const char* at_help = R"(bannwald at DIR X Y

What the maps of a finished run hold at a place, such as a house: every raster with its value in that cell, unit and
meaning, under each folder (with forest, on the bare slope, a year of a regime, a hazard map). DIR is a folder with a
summary.json and rasters, or the folder of a hazard run: then the hazard map and each return period that it was made
of follow one another. X and Y are metres in the system of the terrain, as QGIS shows them. "-" is no value: no rock passed there,
or fewer than the map asks for.
)";

/// A point of the plane [m].
struct AskedPoint {
    double x_m;
    double y_m;
};

double metres(const std::string& word) {
    const std::optional<double> number = config::parse_number(word);
    if (!number) {
        refuse_usage(config::in_quotes(word),
                     "X and Y in metres, with a point for decimals: 652310 178250.5");
    }
    return *number;
}

/// Whether the folder of a raster is one that the dictionary describes: names in capitals stand for any name,
/// "year_N" for any year.
bool describes(const fs::path& declared, const fs::path& folder) {
    return std::equal(declared.begin(), declared.end(), folder.begin(), folder.end(),
                      [](const fs::path& pattern, const fs::path& part) {
                          const std::string word = pattern.string();
                          const bool is_any = std::all_of(word.begin(), word.end(), [](char letter) {
                              return (letter >= 'A' && letter <= 'Z') || letter == '_';
                          });
                          return is_any || (word == "year_N" && part.string().starts_with("year_")) ||
                                 pattern == part;
                      });
}

/// Unit and meaning of a raster; empty where the results do not say.
struct Meaning {
    std::string unit;
    std::string text;
};

Meaning meaning_of(const config::Table* dictionary, const fs::path& raster) {
    for (std::size_t row = 0; dictionary != nullptr && row < dictionary->rows(); ++row) {
        if (dictionary->text(row, "raster") == raster.stem() &&
            describes(dictionary->text(row, "folder"), raster.parent_path())) {
            const std::string unit = dictionary->text(row, "unit");
            return {unit == "-" ? "" : unit, dictionary->text(row, "meaning")};
        }
    }
    return {};
}

/// The value of a raster at a place; NaN where it knows none. Throws InputError (data) beside the raster.
double value_at(const fs::path& run, const std::string& raster, AskedPoint at) {
    refuse_changed(run, raster);
    const std::string file = (run / raster).string();
    const config::Raster<double> grid =
        config::read_ascii_grid(open_file(run / raster, {file}, "a raster of the results").text(), file);
    if (!grid.frame.covers(at.x_m, at.y_m)) {
        config::fail(
            ExitCode::data, {file},
            joined("no cell at ", config::to_text(at.x_m), " ", config::to_text(at.y_m)),
            joined("X from ", config::to_text(grid.frame.x_west_m), " to ",
                   config::to_text(grid.frame.x_east_m()), ", Y from ", config::to_text(grid.frame.y_south_m),
                   " to ", config::to_text(grid.frame.y_north_m())),
            "write the coordinates in the system of the terrain");
    }
    return grid.at(grid.frame.cell_at(at.x_m, at.y_m));
}

/// At most four digits that mean something, whole numbers as they are.
std::string in_words(double value) {
    if (std::isnan(value)) {
        return "-";
    }
    std::ostringstream text;
    text << std::setprecision(4) << value;
    constexpr double four_digits = 9999.5;
    return std::abs(value) < four_digits ? text.str() : config::to_text(std::round(value));
}

/// Prints the rasters of one folder.
void describe(const fs::path& run, const std::vector<fs::path>& rasters, const config::Table* dictionary,
              AskedPoint at, std::ostream& out) {
    std::optional<double> passages;
    std::optional<double> level;
    for (const fs::path& raster : rasters) {
        const Meaning meaning = meaning_of(dictionary, raster);
        const double value = value_at(run, raster.string(), at);
        passages = raster.stem() == "Nr_passages" ? value : passages;
        level = raster.stem() == "Hazard_level" ? value : level;
        const std::string unit = meaning.unit.empty() || std::isnan(value) ? "" : joined(" ", meaning.unit);
        std::ostringstream line;
        line << "  " << std::left << std::setw(24) << raster.stem().string() << ' ' << std::setw(14)
             << joined(in_words(value), unit);
        out << joined(line.str(), meaning.text.empty() ? "" : joined(" ", meaning.text)) << '\n';
    }
    if (level && std::isnan(*level)) {
        out << "  no level: no rock of any return period passed this cell, or of the rocks from the sources "
               "above it a smaller share than hazard.least_reach_percent\n";
    }
    const bool counts = rasters.front().parent_path().filename() != "difference";
    if (counts && passages && *passages < enough_rocks) {
        out << "  few rocks: " << in_words(*passages)
            << " passed this cell; the 95th percentile of fewer than 20 is about the largest of them, the "
               "98th of fewer than 50, the 99th of fewer than 100\n";
    }
}

/// The rasters that a run wrote, by folder, in the order of its summary.
std::vector<std::vector<fs::path>> rasters_of(const fs::path& run) {
    const fs::path summary = run / "summary.json";
    if (!is_file(summary)) {
        config::fail(ExitCode::file, {summary.string()}, "no such file", "the summary of a finished run",
                     name_a_finished_run(run));
    }
    std::vector<std::vector<fs::path>> folders;
    const FileBytes bytes = open_file(summary, {summary.string()}, "the summary of a run");
    for (const fs::path path : files_in_summary(bytes.text(), summary.string())) {
        const bool is_ours = path.is_relative() && *path.begin() == "rasters" &&
                             std::find(path.begin(), path.end(), "..") == path.end();
        if (!is_ours || path.extension() != ".asc") {
            continue;
        }
        const auto same = std::find_if(folders.begin(), folders.end(), [&](const auto& folder) {
            return folder.front().parent_path() == path.parent_path();
        });
        same == folders.end() ? folders.push_back({path}) : same->push_back(path);
    }
    if (folders.empty()) {
        config::fail(ExitCode::data, {summary.string()}, "no rasters", "a run that writes maps",
                     "name the folder of a run with maps");
    }
    return folders;
}

/// Whether a folder holds a hazard map and the return periods that it was made of.
bool is_hazard_run(const fs::path& folder) {
    return !is_file(folder / "summary.json") && is_file(folder / "hazard" / "summary.json");
}

/// The hazard map and the return periods that it was made of. What else stands in the folder, such as a
/// return period that hazard.blocks no longer has, is no part of this run.
std::vector<fs::path> runs_of_map(const fs::path& folder) {
    const fs::path map = folder / "hazard";
    const fs::path summary = map / "summary.json";
    std::vector<fs::path> runs{map};
    const FileBytes bytes = open_file(summary, {summary.string()}, "the summary of a run");
    for (const std::string& period : period_folders_in_summary(bytes.text(), summary.string())) {
        runs.push_back(folder / fs::path{period}.filename());
    }
    return runs;
}

/// Prints all folders of rasters of a run, each under a name from `below`.
void describe_run(const fs::path& run, const fs::path& below, AskedPoint at, std::ostream& out) {
    const std::vector<std::vector<fs::path>> folders = rasters_of(run);
    std::optional<config::Table> dictionary;
    const std::string name_of_dictionary = "tables/raster_dictionary.csv";
    if (const fs::path file = run / name_of_dictionary; is_file(file)) {
        refuse_changed(run, name_of_dictionary);
        dictionary = config::Table::read(open_file(file, {file.string()}, "a table of the results").text(),
                                         file.string());
    }
    for (const std::vector<fs::path>& rasters : folders) {
        out << (below / rasters.front().parent_path()).string() << '\n';
        describe(run, rasters, dictionary ? &*dictionary : nullptr, at, out);
    }
}

int describe_place(const Arguments& arguments, const Call& call) {
    const std::vector<std::string>& words = arguments.words();
    if (words.size() != 3) {
        refuse_usage("`bannwald at` with " + std::to_string(words.size()) + " words",
                     "the folder of a finished run, X and Y");
    }
    const fs::path folder = words[0];
    const AskedPoint at{metres(words[1]), metres(words[2])};
    std::ostringstream out;  // the whole answer or none
    if (is_hazard_run(folder)) {
        for (const fs::path& run : runs_of_map(folder)) {
            describe_run(run, run.filename(), at, out);
        }
    } else {
        describe_run(folder, "", at, out);
    }
    call.out << out.str();
    return static_cast<int>(ExitCode::done);
}

}  // namespace

Command at_command() {
    return {.name = "at",
            .overview =
                R"(  bannwald at DIR X Y                  what the maps of a finished run hold at a place
)",
            .help = at_help,
            .argument = {},
            .options = {},
            .completion = {.names = Completion::Names::folders},
            .run = describe_place};
}

}  // namespace coupling
