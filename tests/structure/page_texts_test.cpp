// The texts of the pages stand where they are shown, in English, and in pages.csv with what stands for them
// in the other languages: each has its row, each row is used, and each placeholder gets its value.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "coupling/results/text/catalogue.hpp"

namespace {

namespace page_fs = std::filesystem;
using Names = std::set<std::string>;
using Row = std::vector<std::string>;  // en, de, fr, it

constexpr std::array languages{"en", "de", "fr", "it"};

std::string text_of_page_file(const page_fs::path& path) {
    std::ifstream in{path};
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

const page_fs::path& texts_folder() {
    static const page_fs::path folder = page_fs::path{BANNWALD_SOURCE_DIR} / "coupling/results/text";
    return folder;
}

/// Rows of a table of texts; of scripts.csv without its keys.
std::vector<Row> rows_of(const char* name) {
    std::vector<Row> rows = coupling::report::rows_of_texts(text_of_page_file(texts_folder() / name));
    for (Row& row : rows) {
        row.erase(row.begin(), row.end() - static_cast<std::ptrdiff_t>(languages.size()));
    }
    return rows;
}

const std::vector<Row>& page_rows() {
    static const std::vector<Row> rows = rows_of("pages.csv");
    return rows;
}

/// All rows of all tables of pages.
std::vector<Row> every_row() {
    std::vector<Row> rows = page_rows();
    for (const char* name : {"phrases.csv", "scripts.csv"}) {
        const std::vector<Row> more = rows_of(name);
        rows.insert(rows.end(), more.begin(), more.end());
    }
    return rows;
}

std::multiset<std::string> found_in(const std::string& text, const std::regex& wanted) {
    return {std::sregex_token_iterator{text.begin(), text.end(), wanted}, std::sregex_token_iterator{}};
}

Names fields_in(const std::string& text) {
    static const std::regex placeholder{R"(\{(\w+)\})"};
    Names names;
    for (std::sregex_iterator at{text.begin(), text.end(), placeholder}; at != std::sregex_iterator{}; ++at) {
        names.insert((*at)[1]);
    }
    return names;
}

TEST(PageTexts, HaveTheSamePlaceholdersAndTagsInAllLanguages) {
    static const std::regex tag{"<[^>]*>"};
    ASSERT_GT(page_rows().size(), 800U);
    for (const Row& row : every_row()) {
        for (const std::string& text : row) {
            EXPECT_EQ(fields_in(text), fields_in(row.front())) << text;
            EXPECT_EQ(found_in(text, tag), found_in(row.front(), tag)) << text;
        }
    }
}

TEST(PageTexts, AreWhole) {
    // What other texts would be glued to: their order and grammar differ between languages.
    const std::regex fragment{R"(^[ ,.;:]| $|\{part|_\d\})"};
    for (const Row& row : every_row()) {
        for (const std::string& text : row) {
            EXPECT_FALSE(std::regex_search(text, fragment)) << '"' << text << '"';
        }
    }
}

TEST(PageTexts, AreSortedByTheirEnglishText) {
    EXPECT_TRUE(std::is_sorted(page_rows().begin(), page_rows().end(),
                               [](const Row& a, const Row& b) { return a.front() < b.front(); }));
}

TEST(PageTexts, AreTranslated) {
    // Names, units and words that are the same in two languages are a small part of the sentences.
    std::size_t sentences = 0;
    for (const Row& row : every_row()) {
        if (std::count(row.front().begin(), row.front().end(), ' ') >= 4) {
            ++sentences;
            for (std::size_t i = 1; i < row.size(); ++i) {
                EXPECT_NE(row[i], row.front()) << languages[i];
            }
        }
    }
    EXPECT_GT(sentences, 200U);
}

TEST(PageTexts, KeepSignsWithWhatTheyBelongTo) {
    // In French a no-break blank stands before : » and behind «, a narrow one before ; ! ?; in all languages
    // but English a no-break blank before %.
    const std::regex attributes{"<[^>]*>|&[a-z]+;"};
    const std::regex loose{"[0-9}] %"};
    const std::regex loose_in_french{"[^ \xA0\xAF,\"/][;:!?](?=[ \"])| [;:!?%]| »|« |\xC2\xA0[;!?]"};
    for (const Row& row : every_row()) {
        for (std::size_t i = 1; i < row.size(); ++i) {
            const std::string text = '"' + std::regex_replace(row[i], attributes, "") + '"';
            EXPECT_FALSE(std::regex_search(text, loose)) << languages[i] << ": " << text;
            EXPECT_FALSE(languages[i] == std::string{"fr"} && std::regex_search(text, loose_in_french))
                << text;
        }
    }
}

struct PageSource {
    std::string name;
    std::string code;
};

/// Sources of the program and its validation whose name matches a pattern.
std::vector<PageSource> page_sources(const std::string& pattern) {
    const page_fs::path root{BANNWALD_SOURCE_DIR};
    const std::regex wanted{pattern};
    std::vector<PageSource> found;
    for (const char* room : {"coupling", "validation/engine"}) {
        for (const auto& entry : page_fs::recursive_directory_iterator{root / room}) {
            const std::string name = page_fs::relative(entry.path(), root).generic_string();
            if (std::regex_search(name, wanted)) {
                found.push_back({name, text_of_page_file(entry.path())});
            }
        }
    }
    return found;
}

struct Literal {
    std::size_t begin;  ///< its first quote
    std::size_t end;    ///< behind the last one
    std::string text;
};

/// The literal that begins with a quote at `begin`, with those that follow it at once: the compiler joins
/// them.
Literal literal_at(std::string_view code, std::size_t begin) {
    Literal literal{begin, begin, {}};
    for (std::size_t at = begin; at < code.size() && code[at] == '"';
         at = std::min(code.find_first_not_of(" \n", literal.end), code.size())) {
        for (++at; at < code.size() && code[at] != '"'; ++at) {
            at += code[at] == '\\' ? 1U : 0U;
            literal.text += code[at - 1] == '\\' && code[at] == 'n' ? '\n' : code[at];
        }
        literal.end = at + 1;
    }
    return literal;
}

std::vector<Literal> literals_of(std::string_view code) {
    std::vector<Literal> literals;
    for (std::size_t at = 0; at < code.size(); ++at) {
        if (code.compare(at, 2, "//") == 0 || (code[at] == '#' && (at == 0 || code[at - 1] == '\n'))) {
            at = std::min(code.find('\n', at), code.size());
        } else if (code[at] == '\'' && at > 0 &&
                   std::isalnum(static_cast<unsigned char>(code[at - 1])) == 0) {
            at = code.find('\'', at + (code[at + 1] == '\\' ? 3U : 2U));
        } else if (code[at] == '"') {
            literals.push_back(literal_at(code, at));
            at = literals.back().end - 1;
        }
    }
    return literals;
}

/// Text between tags of HTML; of a literal that begins or ends within a tag only what is outside.
std::string outside_of_tags(std::string text) {
    const std::size_t close = text.find('>');
    if (close != std::string::npos && close < text.find('<')) {
        text.erase(0, close + 1);
    }
    text = std::regex_replace(text, std::regex{"<[^>]*>"}, " ");
    return text.substr(0, text.find('<'));
}

Names english_texts() {
    Names texts;
    for (const Row& row : page_rows()) {
        texts.insert(coupling::report::with_many(row.front()));
    }
    return texts;
}

/// Sentences and labels of a template of a page (coupling/results/templates/page_template.hpp).
std::vector<std::string> units_of(const std::string& page_template) {
    static const std::regex unit{R"(\{\{#t\}\}([\s\S]*?)\{\{/t\}\})"};
    std::vector<std::string> units;
    for (std::sregex_iterator at{page_template.begin(), page_template.end(), unit};
         at != std::sregex_iterator{}; ++at) {
        units.push_back(std::regex_replace((*at)[1].str(), std::regex{R"(\s*\n\s*)"}, " "));
    }
    return units;
}

TEST(PageTexts, HaveARowForEachUnitOfATemplate) {
    const Names texts = english_texts();
    std::size_t units = 0;
    for (const PageSource& source : page_sources(R"(\.html$)")) {
        for (const std::string& unit : units_of(source.code)) {
            EXPECT_TRUE(texts.contains(unit)) << source.name << ": \"" << unit << "\"";
            ++units;
        }
        // What stands outside of units, tags, fields and names of files is not translated.
        std::string rest = std::regex_replace(source.code, std::regex{R"(\{\{#t\}\}[\s\S]*?\{\{/t\}\})"}, "");
        rest = std::regex_replace(rest, std::regex{R"(\{\{[^}]*\}+|<[^>]*>|\w+\.\w+)"}, "");
        std::smatch found;
        EXPECT_FALSE(std::regex_search(rest, found, std::regex{"[A-Za-z]{3,}"}))
            << source.name << ": " << found.str() << ": no unit";
    }
    EXPECT_GT(units, 50U);
}

/// Names of the fields of a template, in its tags and units.
Names names_in_template(const std::string& page_template) {
    static const std::regex name{R"(\{[#^]?(\w+)\})"};
    Names names;
    for (std::sregex_iterator at{page_template.begin(), page_template.end(), name};
         at != std::sregex_iterator{}; ++at) {
        names.insert((*at)[1]);
    }
    names.erase("t");
    return names;
}

TEST(PageTexts, GetAFieldForEachNameOfATemplate) {
    // Sections that no test shows may name what nothing gives: the program would throw there.
    std::map<std::string, Names> literals_in;
    for (const PageSource& source : page_sources(R"(\.cpp$)")) {
        for (const Literal& literal : literals_of(source.code)) {
            literals_in[page_fs::path{source.name}.parent_path().generic_string()].insert(literal.text);
        }
    }
    for (const PageSource& source : page_sources(R"(\.html$)")) {
        const std::string folder = page_fs::path{source.name}.parent_path().generic_string();
        if (folder.ends_with("results/templates")) {
            continue;  // parts that others include; they throw
        }
        for (const std::string& name : names_in_template(source.code)) {
            EXPECT_TRUE(literals_in[folder].contains(name)) << source.name << ": " << name;
        }
    }
}

TEST(PageTexts, HaveARowForEachSentenceOfAPage) {
    // Two words, or one that joins two values: "(", low, " to ", high, ")".
    const std::regex sentence{
        "[A-Za-z]{2,}[,:;.]? [A-Za-z]{2,}|^[^A-Za-z]*( "
        "(to|of|and|or|with|from|by)|(to|of|and|or|with|from|by) )[^A-Za-z]*$"};
    const std::vector<PageSource> sources = page_sources(
        R"((/report/.*|/page/.*|validation/page\w*|_page|_drawing|net_words|effect_words|few_rocks)\.cpp$)");
    const Names texts = english_texts();
    EXPECT_GT(sources.size(), 50U);
    for (const PageSource& source : sources) {
        for (const Literal& literal : literals_of(source.code)) {
            constexpr std::string_view class_list = "{\"class\", ";
            const std::size_t reach = std::min(literal.begin, class_list.size());
            const std::string ahead = source.code.substr(literal.begin - reach, reach);
            const std::string before = ahead.substr(ahead.size() - std::min<std::size_t>(ahead.size(), 3));
            // Names of figures are compared; rules of CSS and what a page never shows are no sentences.
            const bool is_name = before == "== " || before == "!= ";
            const bool is_css = literal.text.find("@media") != std::string::npos;
            EXPECT_TRUE(is_name || is_css || ahead == class_list || texts.contains(literal.text) ||
                        !std::regex_search(outside_of_tags(literal.text), sentence))
                << source.name << ": \"" << literal.text << "\": give it a row in pages.csv";
        }
    }
}

/// The scripts of pages, as they are written.
std::string code_of_scripts() {
    std::string all;
    const std::string folder = std::string{BANNWALD_SOURCE_DIR} + "/coupling/page_scripts/sources";
    for (const auto& entry : std::filesystem::directory_iterator{folder}) {
        all += text_of_page_file(entry.path());
    }
    return all;
}

TEST(PageTexts, OfScriptsAreInTheirTableAndUsed) {
    const std::string code = code_of_scripts();
    Names keys;
    for (const Row& row :
         coupling::report::rows_of_texts(text_of_page_file(texts_folder() / "scripts.csv"))) {
        EXPECT_TRUE(keys.insert(row.front()).second) << row.front();
        EXPECT_NE(code.find('"' + row.front() + '"'), std::string::npos) << row.front();
    }
    static const std::regex key{"\"(script\\.[a-z_.]+)\""};
    std::size_t used = 0;
    for (std::sregex_iterator at{code.begin(), code.end(), key}; at != std::sregex_iterator{}; ++at) {
        EXPECT_TRUE(keys.contains((*at)[1])) << (*at)[1];
        ++used;
    }
    EXPECT_GT(used, 20U);
    static const std::regex sentence{"[\"`] ?[A-Z][a-z]+ [a-z]+ [^\"`]*[\"`]"};
    std::smatch found;
    EXPECT_FALSE(std::regex_search(code, found, sentence)) << found.str();
}

TEST(PageTexts, LeaveTagsToTemplatesAndElements) {
    // Tags that are left in code: names with an index (R<sub>N</sub>), and files that are searched for tags.
    constexpr std::size_t most_literals = 13;
    static const std::regex tag{R"(</?[a-z][a-z0-9-]*([\s>/]|$))"};
    std::vector<std::string> found;
    for (const PageSource& source : page_sources(R"(\.(cpp|hpp)$)")) {
        for (const Literal& literal : literals_of(source.code)) {
            if (std::regex_search(literal.text, tag)) {
                found.push_back(source.name + ": " + literal.text);
            }
        }
    }
    EXPECT_LE(found.size(), most_literals) << ::testing::PrintToString(found);
}

TEST(PageTexts, AreAllUsed) {
    Names used;
    for (const PageSource& source : page_sources(R"(\.(cpp|hpp)$)")) {
        for (const Literal& literal : literals_of(source.code)) {
            used.insert(literal.text);
        }
    }
    for (const PageSource& source : page_sources(R"(\.html$)")) {
        for (const std::string& unit : units_of(source.code)) {
            used.insert(unit);
        }
    }
    for (const std::string& text : english_texts()) {
        EXPECT_TRUE(used.contains(text)) << text;
    }
}

/// All sources and shipped tables of the rooms that know no pages.
std::string words_of_the_rooms() {
    const page_fs::path root{BANNWALD_SOURCE_DIR};
    std::string all;
    for (const char* room : {"rockfall", "forest", "config", "coupling/examples"}) {
        for (const auto& entry : page_fs::recursive_directory_iterator{root / room}) {
            const std::string ending = entry.path().extension().string();
            if (ending == ".cpp" || ending == ".csv") {
                all += text_of_page_file(entry.path());
            }
        }
    }
    return all;
}

TEST(PageTexts, KnowThePhrasesThatOtherRoomsStillSay) {
    const std::string words = words_of_the_rooms();
    const std::vector<Row> phrases = rows_of("phrases.csv");
    EXPECT_GT(phrases.size(), 20U);
    for (const Row& phrase : phrases) {
        EXPECT_NE(words.find(phrase.front()), std::string::npos) << phrase.front();
    }
}

/// Names in `{{"a", ...}, {"b", ...}}`, whose outer brace stands at `open`.
Names names_given(std::string_view code, std::size_t open) {
    Names names;
    int depth = 0;
    for (std::size_t at = open; at < code.size(); ++at) {
        if (code[at] == '"') {
            const Literal literal = literal_at(code, at);
            if (depth == 2 && code[at - 1] == '{') {
                names.insert(literal.text);
            }
            at = literal.end - 1;
            continue;
        }
        depth += code[at] == '{' || code[at] == '(' ? 1 : 0;
        depth -= code[at] == '}' || code[at] == ')' ? 1 : 0;
        if (depth == 0) {
            break;
        }
    }
    return names;
}

/// The literals in the first argument of a call, of which the call takes one, and the place of the comma or
/// bracket behind it.
std::pair<std::vector<std::string>, std::size_t> first_argument(std::string_view code, std::size_t at) {
    std::vector<std::string> found;
    int depth = 0;
    for (; at < code.size() && depth >= 0 && !(depth == 0 && code[at] == ','); ++at) {
        if (code[at] == '"') {
            const Literal literal = literal_at(code, at);
            found.push_back(literal.text);
            at = literal.end - 1;
        }
        depth += code[at] == '(' || code[at] == '{' ? 1 : 0;
        depth -= code[at] == ')' || code[at] == '}' ? 1 : 0;
    }
    return {found, depth < 0 ? at - 1 : at};
}

TEST(PageTexts, GetAValueForEachPlaceholder) {
    const Names texts = english_texts();
    const std::string_view call = "page_text(";
    std::size_t calls = 0;
    for (const PageSource& source : page_sources(R"(\.cpp$)")) {
        const std::string_view code = source.code;
        for (std::size_t at = code.find(call); at != std::string_view::npos; at = code.find(call, at + 1)) {
            const auto [found, end] = first_argument(code, at + call.size());
            const std::size_t next = std::min(code.find_first_not_of(" \n,", end), code.size() - 1);
            const Names given =
                code.substr(end, 1) == "," && code[next] == '{' ? names_given(code, next) : Names{};
            for (const std::string& text : found) {
                if (found.size() > 1 && !texts.contains(text)) {
                    continue;  // compared to choose one of the others
                }
                EXPECT_TRUE(texts.contains(text)) << source.name << ": " << text;
                EXPECT_EQ(fields_in(text), given) << source.name << ": " << text;
                ++calls;
            }
        }
    }
    EXPECT_GT(calls, 500U);
}

}  // namespace
