// Pages in German, French and Italian have no English left: no sentence without a translation, and no English
// words within a translated one, such as a figure that was joined to it in English.

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "tests/runs/hazard.hpp"
#include "tests/runs/program.hpp"

namespace coupling::page_languages_test {
namespace {

/// Whether a tag opens or closes an element whose text no one reads, or which holds names and settings.
bool is_code(std::string_view tag) {
    for (const std::string_view name : {"script", "style", "code", "pre"}) {
        if (tag.starts_with(name) && (tag.size() == name.size() || tag[name.size()] == ' ')) {
            return true;
        }
    }
    return false;
}

/// The words of a page that people read, without commas, points and brackets around them.
std::vector<std::string> words_of(std::string_view page) {
    std::vector<std::string> words;
    std::string word;
    int in_code = 0;
    const auto end_word = [&] {
        while (!word.empty() && std::ispunct(static_cast<unsigned char>(word.back())) != 0) {
            word.pop_back();
        }
        std::size_t first = 0;
        while (first < word.size() && std::ispunct(static_cast<unsigned char>(word[first])) != 0) {
            ++first;
        }
        if (first < word.size()) {
            words.push_back(word.substr(first));
        }
        word.clear();
    };
    for (std::size_t i = 0; i < page.size(); ++i) {
        if (page[i] == '<') {
            const std::size_t close = page.find('>', i);
            const std::string_view tag = page.substr(i + 1, close - i - 1);
            if (is_code(tag)) {
                ++in_code;
            } else if (tag.starts_with('/') && is_code(tag.substr(1))) {
                --in_code;
            }
            end_word();
            i = close;
        } else if (in_code == 0 && std::isspace(static_cast<unsigned char>(page[i])) == 0) {
            word += page[i];
        } else {
            end_word();
        }
    }
    return words;
}

/// Words that stand in almost each English sentence, and in none of the other languages.
const std::set<std::string, std::less<>> english{"the",  "of",    "with",  "and",     "which",
                                                 "from", "are",   "cells", "period",  "periods",
                                                 "by",   "found", "where", "expected"};

std::string english_in(const std::string& page) {
    const std::vector<std::string> words = words_of(page);
    std::string found;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i] == "Evaluation") {  // title and journal of the paper that each page cites
            i = static_cast<std::size_t>(
                std::find(words.begin() + static_cast<std::ptrdiff_t>(i), words.end(), "Sciences") -
                words.begin());
        } else if (english.contains(words[i])) {
            for (std::size_t k = i < 4 ? 0 : i - 4; k < std::min(words.size(), i + 5); ++k) {
                found += words[k] + " ";
            }
            found += "| ";
        }
    }
    return found;
}

/// A hazard run with what pages speak of: nets, works, risk, a cut terrain, grounds with noise, few rocks.
void add_all(const SampleProject& project) {
    add_blocks(project);
    project.write("nets.csv", "name,height_m,class,wkt\nlow,3,1,\"LINESTRING (1090 2010, 1090 2030)\"\n");
    project.write(
        "works.csv",
        "name,kind,height_m,capacity_kj,wkt\nMauer,wall,2,300,\"LINESTRING (1085 2060, 1085 2080)\"\n");
    project.write(
        "targets.csv",
        "target_id,name,wkt,vehicles_per_day,speed_kmph,persons_per_vehicle,persons,hours_per_day,"
        "house_value\nroad,Weg,\"LINESTRING (1105 2010, 1105 2120)\",1200,60,1.6,,,\n"
        "house,Haus,\"POLYGON ((1090 2040, 1100 2040, 1100 2050, 1090 2050, 1090 2040))\",,,,4,16,"
        "900\nfar,Hof,\"POLYGON ((1030 2086, 1034 2086, 1034 2090, 1030 2090, 1030 2086))\",,,,1,2,\n");
    project.replace("scenario.ini", "[hazard]",
                    "[nets]\nfile = nets.csv\n[works]\nfile = works.csv\n[risk]\nassess = yes\n[hazard]");
    project.replace("scenario.ini", "[terrain]", "[terrain]\nextent_m = 1000, 2000, 1120, 2095\n");
}

TEST(PageLanguages, LeaveNoEnglish) {
    const SampleProject project;
    add_all(project);
    for (const std::string language : {"de", "fr", "it"}) {
        const Outcome outcome = call(
            project, std::string{quick_hazard} + "--set report.language=" + language + " --out " + language);
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        for (const char* folder : {"hazard", "return_period_100"}) {
            const std::string page = project.read(language + "/" + folder + "/report.html");
            EXPECT_EQ(english_in(page), "") << language << " " << folder;
            const std::size_t marked = page.find("lang=\"en\"");
            EXPECT_EQ(marked, std::string::npos)
                << language << " " << folder << ": " << page.substr(std::min(marked, page.size()), 300);
        }
    }
}

/// The search finds English where there is some.
TEST(PageLanguages, AreToldFromEnglish) {
    EXPECT_EQ(english_in("<p>ausgeschnitten, 12 x 10 cells of 5 m</p><code>the</code><style>of{}</style>"),
              "ausgeschnitten 12 x 10 cells of 5 m | 12 x 10 cells of 5 m | ");
    EXPECT_EQ(english_in("<p title=\"the\">Zellen (von 5 m), und tables/the.csv</p>"), "");
}

}  // namespace
}  // namespace coupling::page_languages_test
