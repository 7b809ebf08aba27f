// The theory tables of the READMEs: each law names the file that holds it, and that file is there.

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

/// All sources and tables of the program, with a slash before and slashes between.
std::vector<std::string> files_of_rooms() {
    const fs::path root{BANNWALD_SOURCE_DIR};
    std::vector<std::string> files;
    for (const char* room : {"config", "rockfall", "forest", "coupling", "validation"}) {
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator{root / room}) {
            files.push_back("/" + fs::relative(entry.path(), root).generic_string());
        }
    }
    return files;
}

/// Whether a README's word is a file of its room: `motion/rolling`, `rolling.hpp`, `obstacles/nets/`, or a
/// path from the root.
bool is_file_of(const std::string& room, std::string word, const std::vector<std::string>& files) {
    while (!word.empty() && word.back() == '/') {
        word.pop_back();
    }
    return std::any_of(files.begin(), files.end(), [&](const std::string& file) {
        const std::array<std::string, 3> endings{"/" + word, "/" + word + ".hpp", "/" + word + ".cpp"};
        return std::any_of(endings.begin(), endings.end(), [&](const std::string& ending) {
            return file == ending || (file.ends_with(ending) && file.starts_with("/" + room + "/"));
        });
    });
}

TEST(TheoryTables, NameAFileThatExistsForEachLaw) {
    const std::vector<std::string> files = files_of_rooms();
    const fs::path root{BANNWALD_SOURCE_DIR};
    for (const std::string room : {"config", "rockfall", "forest", "coupling", "validation"}) {
        std::size_t laws = 0;
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator{root / room}) {
            if (entry.path().filename() != "README.md") {
                continue;
            }
            const std::string name = fs::relative(entry.path(), root).generic_string();
            std::ifstream readme{entry.path()};
            for (const LawRow& row : laws_in(readme)) {
                ++laws;
                EXPECT_FALSE(row.files.empty()) << name << ": no file holds '" << row.law << "'";
                for (const std::string& file : row.files) {
                    EXPECT_TRUE(is_file_of(room, file, files))
                        << name << ": no file `" << file << "`, named for '" << row.law << "'";
                }
            }
        }
        if (room == "rockfall" || room == "forest") {
            EXPECT_GT(laws, 10U) << room << " has no theory table: columns `law` and `file`";
        }
    }
}

TEST(TheoryTables, AreReadByTheirColumns) {
    std::istringstream readme{
        "| what | file |\n|---|---|\n| no theory | `nowhere` |\n\n"
        "| law | equation | source | file |\n|---|---|---|---|\n"
        "| rolling | a \\| b | [choice] | `motion/rolling`, `leaving.hpp` |\n| lost | | | |\n"};
    const std::vector<LawRow> laws = laws_in(readme);
    ASSERT_EQ(laws.size(), 2U);
    EXPECT_EQ(laws[0].law, "rolling");
    EXPECT_EQ(laws[0].source, "[choice]");
    EXPECT_EQ(laws[0].files, (std::vector<std::string>{"motion/rolling", "leaving.hpp"}));
    EXPECT_TRUE(laws[1].files.empty());
    const std::vector<std::string> files{"/rockfall/motion/rolling.hpp", "/rockfall/obstacles/nets"};
    EXPECT_TRUE(is_file_of("rockfall", "motion/rolling", files));
    EXPECT_TRUE(is_file_of("rockfall", "rolling.hpp", files));
    EXPECT_TRUE(is_file_of("rockfall", "obstacles/nets/", files));
    EXPECT_FALSE(is_file_of("rockfall", "olling", files));
    EXPECT_FALSE(is_file_of("forest", "motion/rolling", files));
    EXPECT_TRUE(is_file_of("forest", "rockfall/motion/rolling.hpp", files));
}

}  // namespace
}  // namespace theory_tables_test
