// The texts of the pages stand in one table (coupling/results/text/texts_en.csv): the code that writes
// pages has none of its own, uses every text, and gives each placeholder its value.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace page_fs = std::filesystem;
using Names = std::set<std::string>;

std::string text_of_file(const page_fs::path& path) {
    std::ifstream in{path};
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
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
                found.push_back({name, text_of_file(entry.path())});
            }
        }
    }
    return found;
}

/// Key -> placeholders of its text.
std::map<std::string, Names> table_of_texts(const std::string& language = "en") {
    std::ifstream in{std::string{BANNWALD_SOURCE_DIR} + "/coupling/results/text/texts_" + language + ".csv"};
    std::map<std::string, Names> table;
    std::string line;
    std::getline(in, line);
    const std::regex placeholder{R"(\{(\w+)\})"};
    while (std::getline(in, line)) {
        const std::string key = line.substr(0, line.find(','));
        const std::string text = line.substr(key.size() + 1);
        Names& names = table[key];
        for (std::sregex_iterator at{text.begin(), text.end(), placeholder}; at != std::sregex_iterator{};
             ++at) {
            names.insert((*at)[1]);
        }
    }
    return table;
}

TEST(PageTexts, HaveTheSameKeysAndPlaceholdersInAllLanguages) {
    const std::map<std::string, Names> english = table_of_texts();
    ASSERT_GT(english.size(), 800U);
    for (const std::string language : {"de", "fr", "it"}) {
        const std::map<std::string, Names> table = table_of_texts(language);
        for (const auto& [key, names] : english) {
            const auto row = table.find(key);
            ASSERT_NE(row, table.end()) << language << " lacks " << key;
            EXPECT_EQ(row->second, names) << language << ": " << key;
        }
        for (const auto& [key, names] : table) {
            EXPECT_TRUE(english.contains(key)) << language << " alone has " << key;
        }
    }
}

std::string lines_of_texts(const std::string& language) {
    return text_of_file(page_fs::path{BANNWALD_SOURCE_DIR} / "coupling/results/text" /
                        ("texts_" + language + ".csv"));
}

/// Key -> tags of its text, and whether the text begins and ends with a blank.
std::map<std::string, std::string> shapes_of_texts(const std::string& language) {
    std::istringstream in{lines_of_texts(language)};
    std::map<std::string, std::string> shapes;
    std::string line;
    const std::regex tag{"<[^>]*>"};
    while (std::getline(in, line)) {
        const std::string key = line.substr(0, line.find(','));
        std::multiset<std::string> tags;
        for (std::sregex_iterator at{line.begin(), line.end(), tag}; at != std::sregex_iterator{}; ++at) {
            tags.insert(at->str());
        }
        for (const std::string& one : tags) {
            shapes[key] += one;
        }
        shapes[key] += line.ends_with(" \"") ? "|" : "";
    }
    return shapes;
}

TEST(PageTexts, HaveTheSameTagsInAllLanguages) {
    const auto english = shapes_of_texts("en");
    for (const std::string language : {"de", "fr", "it"}) {
        EXPECT_EQ(shapes_of_texts(language), english) << language;
    }
}

TEST(PageTexts, AreTranslated) {
    // Names, units and words that are the same in two languages are a small part of the sentences.
    std::istringstream english{lines_of_texts("en")};
    std::set<std::string> sentences;
    for (std::string line; std::getline(english, line);) {
        if (std::count(line.begin(), line.end(), ' ') >= 4) {
            sentences.insert(line);
        }
    }
    ASSERT_GT(sentences.size(), 200U);
    for (const std::string language : {"de", "fr", "it"}) {
        std::istringstream in{lines_of_texts(language)};
        for (std::string line; std::getline(in, line);) {
            EXPECT_FALSE(sentences.contains(line)) << language << ": " << line;
        }
    }
}

TEST(PageTexts, KeepSignsWithWhatTheyBelongTo) {
    // In French a no-break blank stands before : » and behind «, a narrow one before ; ! ?; in all languages
    // but English a no-break blank before %.
    const std::regex attributes{"<[^>]*>|&[a-z]+;"};
    const std::regex loose{"[0-9}] %"};
    const std::regex loose_in_french{"[^ \xA0\xAF,\"/][;:!?](?=[ \"])| [;:!?%]| »|« |\xC2\xA0[;!?]"};
    for (const std::string language : {"de", "fr", "it"}) {
        std::istringstream in{lines_of_texts(language)};
        for (std::string line; std::getline(in, line);) {
            const std::string text = std::regex_replace(line, attributes, "");
            EXPECT_FALSE(std::regex_search(text, loose)) << language << ": " << line;
            EXPECT_FALSE(language == "fr" && std::regex_search(text, loose_in_french)) << line;
        }
    }
}

/// Where a string literal that begins at `begin` ends: at its closing quote.
std::size_t end_of_literal(std::string_view code, std::size_t begin) {
    std::size_t at = begin + 1;
    while (at < code.size() && code[at] != '"') {
        at += code[at] == '\\' ? 2U : 1U;
    }
    return at;
}

/// What follows the literals of a source: each with the place of its first character.
std::vector<std::pair<std::size_t, std::string>> literals_of(std::string_view code) {
    std::vector<std::pair<std::size_t, std::string>> literals;
    for (std::size_t at = 0; at < code.size(); ++at) {
        if (code.compare(at, 2, "//") == 0 || (code[at] == '#' && (at == 0 || code[at - 1] == '\n'))) {
            at = std::min(code.find('\n', at), code.size());
        } else if (code[at] == '\'' && at > 0 &&
                   std::isalnum(static_cast<unsigned char>(code[at - 1])) == 0) {
            at = code.find('\'', at + (code[at + 1] == '\\' ? 3U : 2U));
        } else if (code[at] == '"') {
            const std::size_t end = end_of_literal(code, at);
            literals.emplace_back(at, std::string{code.substr(at + 1, end - at - 1)});
            at = end;
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

TEST(PageTexts, StandInTheTableAlone) {
    // Two words, or one that joins two values: "(", low, " to ", high, ")".
    const std::regex sentence{
        "[A-Za-z]{2,}[,:;.]? [A-Za-z]{2,}|^[^A-Za-z]*( "
        "(to|of|and|or|with|from|by)|(to|of|and|or|with|from|by) )[^A-Za-z]*$"};
    const std::vector<PageSource> sources = page_sources(
        R"((/report/.*|/page/.*|validation/page\w*|_page|_drawing|net_words|effect_words|few_rocks)\.cpp$)");
    EXPECT_GT(sources.size(), 50U);
    for (const PageSource& source : sources) {
        for (const auto& [at, literal] : literals_of(source.code)) {
            const std::string before = source.code.substr(at - std::min<std::size_t>(at, 3), 3);
            // Names of figures are compared; rules of CSS and what a page never shows are no sentences.
            const bool is_name = before == "== " || before == "!= ";
            const bool is_css = literal.find("@media") != std::string::npos;
            const bool is_fault =
                source.name.ends_with("page_text.cpp") || source.name.ends_with("report/messages.cpp");
            EXPECT_TRUE(is_name || is_css || is_fault ||
                        !std::regex_search(outside_of_tags(literal), sentence))
                << source.name << ": \"" << literal << "\": move it to results/text/texts_en.csv";
        }
    }
}

/// The scripts of pages, as they are written.
std::string texts_of_scripts() {
    std::string all;
    const std::string folder = std::string{BANNWALD_SOURCE_DIR} + "/coupling/page_scripts/sources";
    for (const auto& entry : std::filesystem::directory_iterator{folder}) {
        std::ifstream in{entry.path()};
        all.append(std::istreambuf_iterator<char>{in}, {});
    }
    return all;
}

TEST(PageTexts, OfScriptsAreInTheTable) {
    const std::string code = texts_of_scripts();
    const std::map<std::string, Names> table = table_of_texts();
    static const std::regex key{"\"(script\\.[a-z_.]+)\""};
    std::size_t keys = 0;
    for (std::sregex_iterator at{code.begin(), code.end(), key}; at != std::sregex_iterator{}; ++at) {
        EXPECT_TRUE(table.contains((*at)[1])) << (*at)[1];
        ++keys;
    }
    EXPECT_GT(keys, 20U);
    static const std::regex sentence{"[\"`] ?[A-Z][a-z]+ [a-z]+ [^\"`]*[\"`]"};
    std::smatch found;
    EXPECT_FALSE(std::regex_search(code, found, sentence)) << found.str();
}

TEST(PageTexts, AreAllUsed) {
    const std::string scripts = texts_of_scripts();
    Names used;
    for (const PageSource& source : page_sources(R"(\.cpp$)")) {
        for (const auto& [at, literal] : literals_of(source.code)) {
            used.insert(literal);
        }
    }
    for (const auto& [key, names] : table_of_texts()) {
        EXPECT_TRUE(used.contains(key) || key.starts_with("phrase.") ||
                    scripts.find('"' + key + '"') != std::string::npos)
            << key;
    }
}

/// All sources and shipped tables of the rooms that know no pages.
std::string words_of_the_rooms() {
    const page_fs::path root{BANNWALD_SOURCE_DIR};
    std::string all;
    for (const char* room : {"rockfall", "forest", "config"}) {
        for (const auto& entry : page_fs::recursive_directory_iterator{root / room}) {
            const std::string ending = entry.path().extension().string();
            if (ending == ".cpp" || ending == ".csv") {
                all += text_of_file(entry.path());
            }
        }
    }
    return all;
}

TEST(PageTexts, KnowThePhrasesThatOtherRoomsStillSay) {
    const std::string words = words_of_the_rooms();
    std::istringstream english{lines_of_texts("en")};
    std::size_t phrases = 0;
    for (std::string line; std::getline(english, line);) {
        if (line.starts_with("phrase.")) {
            const std::size_t first = line.find(",\"") + 2;
            const std::string phrase = line.substr(first, line.size() - first - 1);
            EXPECT_NE(words.find(phrase), std::string::npos) << line;
            ++phrases;
        }
    }
    EXPECT_GT(phrases, 20U);
}

/// Names in `{{"a", ...}, {"b", ...}}`, whose outer brace stands at `open`.
Names names_given(std::string_view code, std::size_t open) {
    Names names;
    int depth = 0;
    for (std::size_t at = open; at < code.size(); ++at) {
        if (code[at] == '"') {
            const std::size_t end = end_of_literal(code, at);
            if (depth == 2 && code[at - 1] == '{') {
                names.emplace(code.substr(at + 1, end - at - 1));
            }
            at = end;
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

TEST(PageTexts, GetAValueForEachPlaceholder) {
    const std::map<std::string, Names> table = table_of_texts();
    const std::string_view call = "page_text(";
    std::size_t calls = 0;
    for (const PageSource& source : page_sources(R"(\.cpp$)")) {
        const std::string_view code = source.code;
        for (std::size_t at = code.find(call); at != std::string_view::npos; at = code.find(call, at + 1)) {
            const std::size_t quote = code.find_first_not_of(" \n", at + call.size());
            if (code[quote] != '"') {
                continue;  // the key comes from a table of keys: such texts have no placeholders
            }
            const std::size_t end = end_of_literal(code, quote);
            const std::string key{code.substr(quote + 1, end - quote - 1)};
            const std::size_t next = code.find_first_not_of(" \n,", end + 1);
            const auto row = table.find(key);
            ASSERT_NE(row, table.end()) << source.name << ": " << key;
            EXPECT_EQ(row->second, code[next] == '{' ? names_given(code, next) : Names{})
                << source.name << ": " << key;
            ++calls;
        }
    }
    EXPECT_GT(calls, 500U);
}

}  // namespace
