// The files that the READMEs name: each is where its README says, and each law of a theory table names the
// file that holds it.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace theory_tables_test {
namespace {

namespace fs = std::filesystem;

/// A row of a theory table: a table with the columns `law` and `file`.
struct LawRow {
    std::string law;
    std::string source;  ///< empty where the table has no such column
    std::vector<std::string> files;
};

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(' ');
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// The cells of a line `| a | b |`; empty for any other line. `\|` is a bar within a cell.
std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    if (line.empty() || line.front() != '|') {
        return cells;
    }
    std::string cell;
    for (std::size_t i = 1; i < line.size(); ++i) {
        if (line[i] == '|' && line[i - 1] != '\\') {
            cells.push_back(trimmed(cell));
            cell.clear();
        } else {
            cell += line[i];
        }
    }
    return cells;
}

std::vector<std::string> quoted_words(const std::string& cell) {
    static const std::regex quoted{"`([^`]+)`"};
    std::vector<std::string> words;
    for (std::sregex_iterator match{cell.begin(), cell.end(), quoted}; match != std::sregex_iterator{};
         ++match) {
        words.push_back((*match)[1]);
    }
    return words;
}

std::vector<LawRow> laws_in(std::istream& readme) {
    std::vector<LawRow> laws;
    std::vector<std::string> header;
    std::string line;
    while (std::getline(readme, line)) {
        const std::vector<std::string> cells = cells_of(line);
        if (cells.empty()) {
            header.clear();
            continue;
        }
        if (header.empty()) {
            header = cells;
            continue;
        }
        const auto cell_under = [&](const char* name) {
            const auto at =
                static_cast<std::size_t>(std::find(header.begin(), header.end(), name) - header.begin());
            return at < header.size() && at < cells.size() ? cells[at] : std::string{};
        };
        const bool is_theory = std::count(header.begin(), header.end(), "law") == 1 &&
                               std::count(header.begin(), header.end(), "file") == 1;
        const bool is_rule =
            cells.front().find_first_not_of("-: ") == std::string::npos && !cells.front().empty();
        if (is_theory && !is_rule) {
            laws.push_back({cell_under("law"), cell_under("source"), quoted_words(cell_under("file"))});
        }
    }
    return laws;
}

/// Whether a README's word leads to a file or folder: from the README's folder, from its room, or from the
/// root; a unit may stand without its ending.
bool leads_to_file(const fs::path& folder, const fs::path& room, const std::string& word) {
    const std::array<fs::path, 3> begins{folder, room, fs::path{BANNWALD_SOURCE_DIR}};
    return std::any_of(begins.begin(), begins.end(), [&](const fs::path& begin) {
        return fs::exists(begin / word) || fs::exists(begin / (word + ".hpp")) ||
               fs::exists(begin / (word + ".cpp"));
    });
}

/// Whether a word is a path of the repository: it has a slash or is a source or template. What runs write is
/// none, nor are words with capitals, which stand for names of the reader's choice.
bool is_path(const std::string& word) {
    static const std::regex path{
        R"(([a-z0-9_.-]+/)+([a-z0-9_-]+(\.(cpp|hpp|html|csv))?)?|[a-z0-9_-]+\.(cpp|hpp|html))"};
    static const std::regex of_a_run{
        R"((out|rasters|shapefiles|models|parts|build|inputs/outside\w*)/.*|tables/(.*\.csv)?|report\.html|n/a|\.[a-z].*)"};
    return std::regex_match(word, path) && !std::regex_match(word, of_a_run);
}

/// The paths that a README names; a plain word is one in a column `file`.
std::vector<std::string> paths_in(std::istream& readme) {
    static const std::regex plain{"[a-z0-9_]+"};
    std::vector<std::string> paths;
    std::vector<std::string> header;
    for (std::string line; std::getline(readme, line);) {
        const std::vector<std::string> cells = cells_of(line);
        header = cells.empty() || header.empty() ? cells : header;
        const auto column =
            static_cast<std::size_t>(std::find(header.begin(), header.end(), "file") - header.begin());
        for (const std::string& word : quoted_words(line)) {
            if (is_path(word)) {
                paths.push_back(word);
            }
        }
        for (const std::string& word : quoted_words(column < cells.size() ? cells[column] : "")) {
            if (std::regex_match(word, plain)) {
                paths.push_back(word);
            }
        }
    }
    return paths;
}

/// Calls `look` with the folder of each README of a room.
template <class Look>
void for_each_readme(const fs::path& room, Look look) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator{room}) {
        const bool of_packages = entry.path().string().find("node_modules") != std::string::npos;
        if (entry.path().filename() == "README.md" && !of_packages) {
            look(entry.path().parent_path());
        }
    }
}

constexpr std::array rooms_with_readmes{"config", "rockfall", "forest", "coupling", "validation"};

TEST(Readmes, NameFilesWithTheirFolders) {
    std::size_t checked = 0;
    for (const char* name : rooms_with_readmes) {
        const fs::path room = fs::path{BANNWALD_SOURCE_DIR} / name;
        for_each_readme(room, [&](const fs::path& folder) {
            std::ifstream readme{folder / "README.md"};
            for (const std::string& path : paths_in(readme)) {
                ++checked;
                EXPECT_TRUE(leads_to_file(folder, room, path))
                    << folder / "README.md"
                    << ": no file `" << path << "` from this folder, from its room or from the root";
            }
        });
    }
    EXPECT_GT(checked, 500U);
}

TEST(TheoryTables, NameAFileThatExistsForEachLaw) {
    for (const std::string name : rooms_with_readmes) {
        const fs::path room = fs::path{BANNWALD_SOURCE_DIR} / name;
        std::size_t laws = 0;
        for_each_readme(room, [&](const fs::path& folder) {
            std::ifstream readme{folder / "README.md"};
            for (const LawRow& row : laws_in(readme)) {
                ++laws;
                EXPECT_FALSE(row.files.empty()) << folder << ": no file holds '" << row.law << "'";
                for (const std::string& file : row.files) {
                    EXPECT_TRUE(leads_to_file(folder, room, file))
                        << folder << ": no file `" << file << "`, named for '" << row.law << "'";
                }
            }
        });
        if (name == "rockfall" || name == "forest") {
            EXPECT_GT(laws, 10U) << name << " has no theory table: columns `law` and `file`";
        }
    }
}

TEST(TheoryTables, AreReadByTheirColumns) {
    std::istringstream readme{
        "| what | file |\n|---|---|\n| no theory | `nowhere` |\n\n"
        "| law | equation | source | file |\n|---|---|---|---|\n"
        "| rolling | a \\| b | [choice] | `laws/rolling`, `leaving.hpp` |\n| lost | | | |\n"};
    const std::vector<LawRow> laws = laws_in(readme);
    ASSERT_EQ(laws.size(), 2U);
    EXPECT_EQ(laws[0].law, "rolling");
    EXPECT_EQ(laws[0].source, "[choice]");
    EXPECT_EQ(laws[0].files, (std::vector<std::string>{"laws/rolling", "leaving.hpp"}));
    EXPECT_TRUE(laws[1].files.empty());
}

TEST(Readmes, AreReadByTheirPaths) {
    std::istringstream readme{
        "See `laws/rolling`, `fall.hpp`, `rolling`, `tables/runs.csv`, `out/`, `NAME/law.hpp` and `wkt`.\n\n"
        "| question | file |\n|---|---|\n| `what` | `season`, `report.html` |\n"};
    EXPECT_EQ(paths_in(readme), (std::vector<std::string>{"laws/rolling", "fall.hpp", "season"}));
    const fs::path root{BANNWALD_SOURCE_DIR};
    const auto leads = [&](const char* word) {
        return leads_to_file(root / "rockfall/motion", root / "rockfall", word);
    };
    EXPECT_TRUE(leads("fall.hpp"));
    EXPECT_TRUE(leads("laws/rolling"));
    EXPECT_TRUE(leads("obstacles/nets/"));
    EXPECT_TRUE(leads("forest/year.hpp"));
    EXPECT_FALSE(leads("rolling"));
    EXPECT_FALSE(leads("motion/rolling"));
}

}  // namespace
}  // namespace theory_tables_test
