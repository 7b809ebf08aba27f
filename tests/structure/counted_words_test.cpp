// Texts of pages that count things: a number of one has the words of one, in each language.

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "coupling/results/text/catalogue.hpp"

namespace counted_words_test {
namespace {

constexpr std::array tongues{"en", "de", "fr", "it"};

const std::vector<std::vector<std::string>>& texts() {
    static const std::vector<std::vector<std::string>> rows = [] {
        std::ifstream in{BANNWALD_SOURCE_DIR "/coupling/results/text/pages.csv"};
        std::ostringstream text;
        text << in.rdbuf();
        return coupling::report::rows_of_texts(text.str());
    }();
    return rows;
}

/// "{rocks?rock|rocks}": the words of one and of many.
const std::regex& choice() {
    static const std::regex pattern{R"(\{(\w+)\?([^|{}]+)\|([^|{}]+)\})"};
    return pattern;
}

/// Each match of a pattern in a text.
template <class Take>
void for_each(const std::string& text, const std::regex& pattern, const Take& take) {
    for (std::sregex_iterator at{text.begin(), text.end(), pattern}; at != std::sregex_iterator{}; ++at) {
        take(*at);
    }
}

TEST(CountedWords, BelongToANumberOfTheText) {
    std::size_t choices = 0;
    for (const auto& row : texts()) {
        for (const std::string& text : row) {
            for_each(text, choice(), [&](const std::smatch& found) {
                EXPECT_NE(row.front().find('{' + found.str(1) + '}'), std::string::npos) << text;
                EXPECT_NE(found[2], found[3]) << text;
                ++choices;
            });
            EXPECT_EQ(std::regex_replace(text, choice(), "").find_first_of("|"), std::string::npos) << text;
        }
    }
    EXPECT_GT(choices, 300U);
}

/// Words of many are those that any text says of many: a new text cannot forget its words of one.
TEST(CountedWords, AreThereWhereANumberMayBeOne) {
    // Numbers that are never 1, or for which the code takes another text then, and what is no count.
    const std::set<std::string> never_one{
        "count", "strata",     "least",        "least_rocks",   "limit",
        "shown", "rows_shown", "replicates",   "periods",       "least_arrivals_for_protection",
        "every", "sizes",      "result_rocks", "result_series", "result_rocks_per_series",
        "share", "percent",    "last_year",    "difference",    "profile_least_stems_pha",
        "answer"};
    const std::regex counted{"\\{(\\w+)\\}(?: |\u00a0)([^ 0-9{}.,:;()<]+)"};
    for (std::size_t i = 0; i < tongues.size(); ++i) {
        std::set<std::string> of_many;
        for (const auto& row : texts()) {
            for_each(row[i], choice(), [&](const std::smatch& found) { of_many.insert(found.str(3)); });
        }
        EXPECT_GT(of_many.size(), 20U) << tongues[i];
        for (const auto& row : texts()) {
            for_each(row[i], counted, [&](const std::smatch& found) {
                const std::string name = found.str(1);
                EXPECT_TRUE(never_one.contains(name) || name.ends_with("_html") ||
                            !of_many.contains(found.str(2)))
                    << tongues[i] << ": {" << name << "} may be 1: \"" << row[i] << '"';
            });
        }
    }
}

}  // namespace
}  // namespace counted_words_test
