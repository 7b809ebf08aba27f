// The order of all pages: title, how many warnings there are, the answer, what it rests on, then the
// warnings.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

namespace {

namespace order_fs = std::filesystem;

/// What may begin the answer of a page.
constexpr std::array answers{std::string_view{"class=\"lead"}, std::string_view{"class=\"card"},
                             std::string_view{"{{{decision}}}"}, std::string_view{"{{{areas}}}"},
                             std::string_view{"{{{charts}}}"}};

std::size_t first_answer(const std::string& page) {
    std::size_t first = std::string::npos;
    for (const std::string_view answer : answers) {
        first = std::min(first, page.find(answer));
    }
    return first;
}

/// What is wrong with the order of a template; empty where nothing is.
std::string fault_of_order(const std::string& page) {
    const std::size_t box = page.find("{{{first_warnings}}}");
    if (box == std::string::npos) {
        return "";
    }
    const std::size_t link = page.find("{{{warnings_link}}}");
    if (link == std::string::npos) {
        return "no link to the warnings";
    }
    const std::size_t title = std::min(page.find("{{{head}}}"), page.find("<h1>"));
    const std::size_t answer = first_answer(page);
    if (title > link || (link > answer && page.find("question", answer) > link)) {
        return "the link does not stand between the title and the answer";
    }
    return box < answer ? "the warnings stand before the answer" : "";
}

TEST(PageOrder, PutsTheAnswerBeforeTheWarnings) {
    std::size_t pages = 0;
    for (const auto& entry :
         order_fs::recursive_directory_iterator{order_fs::path{BANNWALD_SOURCE_DIR} / "coupling"}) {
        if (entry.path().string().ends_with("_page.html")) {
            std::ifstream in{entry.path()};
            std::ostringstream text;
            text << in.rdbuf();
            pages += text.str().find("first_warnings") == std::string::npos ? 0 : 1;
            EXPECT_EQ(fault_of_order(text.str()), "") << entry.path();
        }
    }
    EXPECT_GE(pages, 9U);
}

TEST(PageOrder, FaultsAreFound) {
    const std::string head = "{{{head}}}\n";
    const std::string link = "{{{warnings_link}}}\n";
    const std::string box = "{{{first_warnings}}}\n";
    const std::string answer = "<p class=\"lead\"></p>\n";
    EXPECT_EQ(fault_of_order(head + link + answer + box), "");
    EXPECT_EQ(fault_of_order(head + answer), "");
    EXPECT_NE(fault_of_order(head + answer + box), "");
    EXPECT_NE(fault_of_order(head + link + box + answer), "");
    EXPECT_NE(fault_of_order(link + head + answer + box), "");
    EXPECT_NE(fault_of_order(head + answer + link + box), "");
}

}  // namespace
