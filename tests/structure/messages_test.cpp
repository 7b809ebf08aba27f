// What the program warns of can reach a page, which shows it in its own language: each text of a warning has
// a row in coupling/results/text/messages.csv, in four languages with the same placeholders.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "coupling/results/text/catalogue.hpp"

namespace {

namespace message_fs = std::filesystem;

std::string whole_message_file(const message_fs::path& path) {
    std::ifstream in{path};
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

/// The rows of a table of texts: en, de, fr, it.
std::vector<std::vector<std::string>> rows_of_messages(const char* name = "messages.csv") {
    return coupling::report::rows_of_texts(
        whole_message_file(message_fs::path{BANNWALD_SOURCE_DIR} / "coupling/results/text" / name));
}

std::multiset<std::string> placeholders_of(const std::string& text) {
    static const std::regex placeholder{R"(\{(\w+)\})"};
    std::multiset<std::string> names;
    for (std::sregex_iterator at{text.begin(), text.end(), placeholder}; at != std::sregex_iterator{}; ++at) {
        names.insert((*at)[1]);
    }
    return names;
}

TEST(Messages, HaveTheSamePlaceholdersInAllLanguagesAndAreSorted) {
    const auto rows = rows_of_messages();
    ASSERT_GT(rows.size(), 200U);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        ASSERT_EQ(rows[i].size(), 4U) << rows[i][0];
        const auto names = placeholders_of(rows[i][0]);
        EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size()) << rows[i][0];
        for (const std::string& text : rows[i]) {
            EXPECT_FALSE(text.empty()) << rows[i][0];
            EXPECT_EQ(placeholders_of(text), names) << text;
        }
        EXPECT_TRUE(i == 0 || rows[i - 1][0] < rows[i][0]) << rows[i][0];
    }
}

TEST(Messages, AreTranslated) {
    for (const auto& row : rows_of_messages()) {
        if (std::count(row[0].begin(), row[0].end(), ' ') >= 3 && row[0].find("} ({") == std::string::npos) {
            for (std::size_t language = 1; language < row.size(); ++language) {
                EXPECT_NE(row[language], row[0]);
            }
        }
    }
}

TEST(Messages, KeepSignsWithWhatTheyBelongTo) {
    // In French a no-break blank stands before : » and behind «, a narrow one before ; ! ?; in all languages
    // but English a no-break blank before %.
    const std::regex loose{"[0-9}] %"};
    const std::regex loose_in_french{"[^ \xA0\xAF/][;:!?]( |$)| [;:!?%]| »|« |\xC2\xA0[;!?]"};
    for (const auto& row : rows_of_messages()) {
        for (std::size_t language = 1; language < row.size(); ++language) {
            EXPECT_FALSE(std::regex_search(row[language], loose)) << row[language];
        }
        EXPECT_FALSE(std::regex_search(row[2], loose_in_french)) << row[2];
    }
}

/// The end of a literal that begins at `begin`: its closing quote.
std::size_t closing_quote(std::string_view code, std::size_t begin) {
    std::size_t at = begin + 1;
    while (at < code.size() && code[at] != '"') {
        at += code[at] == '\\' ? 2U : 1U;
    }
    return at;
}

/// The texts in a call whose bracket opens at `open`; neighbours are joined as the compiler does.
std::vector<std::string> texts_in_call(std::string_view code, std::size_t open) {
    std::vector<std::string> texts;
    int depth = 0;
    std::size_t last_end = 0;
    for (std::size_t at = open; at < code.size(); ++at) {
        if (code.compare(at, 2, "//") == 0) {
            at = std::min(code.find('\n', at), code.size());
        } else if (code[at] == '\'') {
            at = code.find('\'', at + (code[at + 1] == '\\' ? 3U : 2U));
        } else if (code[at] == '"') {
            const std::size_t end = closing_quote(code, at);
            const std::string_view between =
                texts.empty() ? "," : code.substr(last_end + 1, at - last_end - 1);
            const bool continues = between.find_first_not_of(" \n") == std::string_view::npos;
            const std::string text{code.substr(at + 1, end - at - 1)};
            continues ? texts.back().append(text) : texts.emplace_back(text);
            last_end = end;
            at = end;
        } else {
            depth += code[at] == '(' || code[at] == '{' ? 1 : 0;
            depth -= code[at] == ')' || code[at] == '}' ? 1 : 0;
            if (depth == 0) {
                break;
            }
        }
    }
    return texts;
}

/// Without what surrounds a value: blanks, brackets, signs.
std::string core_of(const std::string& text) {
    constexpr std::string_view around = " ,;:.()[]'%-";
    const std::size_t first = text.find_first_not_of(around);
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(around) + 1 - first);
}

/// Whether a text says something, unlike the key of a setting or the name of a column.
bool says_something(const std::string& text) {
    static const std::regex words{"[A-Za-z]{2,}[,;:]? [A-Za-z]"};
    return std::regex_search(text, words);
}

struct MessageSource {
    std::string name;
    std::string code;
};

std::vector<MessageSource> sources_that_warn() {
    const message_fs::path root{BANNWALD_SOURCE_DIR};
    std::vector<MessageSource> sources;
    for (const char* room : {"coupling", "forest", "rockfall"}) {
        for (const auto& entry : message_fs::recursive_directory_iterator{root / room}) {
            const std::string name = message_fs::relative(entry.path(), root).generic_string();
            // What a trial of the forest notes is printed, what a conversion notes becomes a README.md.
            const bool is_page = name.find("validation/") == std::string::npos &&
                                 name.find("rockyfor3d/") == std::string::npos;
            if (name.ends_with(".cpp") && is_page) {
                sources.push_back({name, whole_message_file(entry.path())});
            }
        }
    }
    return sources;
}

/// Whether a source has a call, and where the next one from `at` on opens its bracket.
std::size_t bracket_of_call(const std::string& code, std::string_view call, std::size_t at) {
    for (at = code.find(call, at); at != std::string::npos; at = code.find(call, at + 1)) {
        const char before = at == 0 ? ' ' : code[at - 1];
        if (std::isalnum(static_cast<unsigned char>(before)) == 0 && before != '_') {
            return at + call.size() - 1;  // not the end of another name
        }
    }
    return at;
}

constexpr std::array<std::string_view, 13> calls_that_warn{"warn(",
                                                           "note(",
                                                           "warnings.add(",
                                                           "warnings_.add(",
                                                           "warn_of_count(",
                                                           "note_count(",
                                                           "remarks.push_back(",
                                                           "findings.notes.push_back(",
                                                           "findings.warnings.push_back(",
                                                           "delivered.notes.push_back(",
                                                           "delivered.warnings.push_back(",
                                                           "sentences.push_back(",
                                                           "Finding{"};

/// Expects a row for each text in the calls of a source; how many texts there are.
std::size_t expect_rows(const MessageSource& source, std::string_view call, const std::string& table) {
    std::size_t checked = 0;
    for (std::size_t open = bracket_of_call(source.code, call, 0); open != std::string::npos;
         open = bracket_of_call(source.code, call, open)) {
        for (const std::string& text : texts_in_call(source.code, open)) {
            if (says_something(text)) {
                EXPECT_NE(table.find(core_of(text)), std::string::npos)
                    << source.name << ": \"" << text << "\": add a row to messages.csv";
                ++checked;
            }
        }
    }
    return checked;
}

std::string english_messages() {
    std::string table;
    for (const auto& row : rows_of_messages()) {
        table += row[0] + '\n';
    }
    return table;
}

TEST(Messages, HaveARowForEachTextOfAWarning) {
    const std::string table = english_messages();
    std::size_t checked = 0;
    for (const MessageSource& source : sources_that_warn()) {
        for (const std::string_view call : calls_that_warn) {
            checked += expect_rows(source, call, table);
        }
    }
    EXPECT_GT(checked, 150U);
}

TEST(Messages, HaveARowForEachPartThatAWarningLists) {
    // text += joined(...) beside a warning; the program and pages put other texts together so.
    const std::string table = english_messages();
    std::size_t checked = 0;
    for (const MessageSource& source : sources_that_warn()) {
        const bool writes_files = source.name.find("/program/") != std::string::npos ||
                                  source.code.find("</") != std::string::npos ||
                                  source.code.find("/>") != std::string::npos;
        const bool warns =
            std::any_of(calls_that_warn.begin(), calls_that_warn.end(), [&](std::string_view call) {
                return bracket_of_call(source.code, call, 0) != std::string::npos;
            });
        checked += warns && !writes_files ? expect_rows(source, "+= joined(", table) : 0;
    }
    EXPECT_GT(checked, 0U);
}

TEST(Messages, HaveARowForWhatEachFileHolds) {
    std::set<std::string> table;
    for (const auto& row : rows_of_messages()) {
        table.insert(row[0]);
    }
    for (const auto& row : rows_of_messages("pages.csv")) {
        table.insert(row[0]);  // of files that a page lists by itself
    }
    // {"tables/rocks.csv", "Every rock: where it ended."}; a layout of columns has no sentence behind its
    // name.
    const std::regex file{R"re("[\w/]+\.\w+",\s*"([A-Z][^"]*\.)")re"};
    const std::regex seam{R"re("\s*\n\s*")re"};
    std::size_t files = 0;
    for (const MessageSource& source : sources_that_warn()) {
        const std::string code = std::regex_replace(source.code, seam, "");
        for (std::sregex_iterator at{code.begin(), code.end(), file}; at != std::sregex_iterator{}; ++at) {
            EXPECT_TRUE(table.contains((*at)[1]))
                << source.name << ": \"" << (*at)[1] << "\": add a row to messages.csv";
            ++files;
        }
    }
    EXPECT_GT(files, 60U);
}

TEST(Messages, HaveARowForEachRoleOfAnInput) {
    std::set<std::string> table;
    for (const auto& row : rows_of_messages()) {
        table.insert(row[0]);
    }
    // reading.table("trees.file", "trees", ...), or {.role = "trees", ...
    const std::regex role{R"re((?:(?:table|grid|open|table_with)\("[a-z_.]+",\s*|\.role = )"([a-z_ ]+)")re"};
    std::size_t roles = 0;
    for (const MessageSource& source : sources_that_warn()) {
        for (std::sregex_iterator at{source.code.begin(), source.code.end(), role};
             at != std::sregex_iterator{}; ++at) {
            EXPECT_TRUE(table.contains((*at)[1]))
                << source.name << ": \"" << (*at)[1] << "\": add a row to messages.csv";
            ++roles;
        }
    }
    EXPECT_GT(roles, 35U);
}

}  // namespace
