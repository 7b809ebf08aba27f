// Habits of the documents: lines that fit a screen, a root README that is read in minutes.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace {

namespace readme_fs = std::filesystem;

constexpr std::size_t widest_line = 100;

std::vector<readme_fs::path> documents() {
    const readme_fs::path root{BANNWALD_SOURCE_DIR};
    std::vector<readme_fs::path> found{root / "README.md", root / "CONTRIBUTING.md", root / "CHANGELOG.md"};
    for (const std::string room : {"config", "rockfall", "forest", "coupling", "tests", "validation"}) {
        for (const auto& entry : readme_fs::recursive_directory_iterator{root / room}) {
            const bool of_packages = entry.path().string().find("node_modules") != std::string::npos;
            if (entry.path().extension() == ".md" && !of_packages) {
                found.push_back(entry.path());
            }
        }
    }
    return found;
}

/// Characters of a line in UTF-8.
std::size_t characters(const std::string& line) {
    return static_cast<std::size_t>(std::count_if(
        line.begin(), line.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

/// Lines of prose that are too wide: no tables, pictures, code, nor what the program writes.
std::vector<std::string> wide_lines(const readme_fs::path& document) {
    std::ifstream in{document};
    std::vector<std::string> wide;
    bool is_code = false;
    bool is_written = false;
    for (std::string line; std::getline(in, line);) {
        is_written = (is_written || line.starts_with("<!-- written by")) && !line.starts_with("<!-- end of");
        is_code = line.starts_with("```") ? !is_code : is_code;
        const bool is_prose = !is_code && !is_written && !line.starts_with("|") && !line.starts_with("![") &&
                              !line.starts_with("    ");
        if (is_prose && characters(line) > widest_line) {
            wide.push_back(line);
        }
    }
    return wide;
}

TEST(Readmes, HaveLinesOfAtMostAHundredCharacters) {
    EXPECT_GT(documents().size(), 30U);
    for (const readme_fs::path& document : documents()) {
        EXPECT_EQ(wide_lines(document), std::vector<std::string>{}) << document;
    }
}

TEST(Readmes, OfTheRootHaveAtMostTwoHundredLinesAndASmallPicture) {
    const readme_fs::path root{BANNWALD_SOURCE_DIR};
    std::ifstream in{root / "README.md"};
    const std::string text{std::istreambuf_iterator<char>{in}, {}};
    EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 200);
    const std::string picture = "coupling/docs/page.png";
    EXPECT_NE(text.find("](" + picture + ")"), std::string::npos);
    EXPECT_LT(readme_fs::file_size(root / picture), 200'000U);
}

}  // namespace
