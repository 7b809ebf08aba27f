// French texts call a thing by one name, that of the practice.

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "coupling/results/text/catalogue.hpp"

namespace french_terms_test {
namespace {

/// An English term, and in rows that have it what the French text must, or must not say.
struct Term {
    const char* english;
    const char* says;
    const char* never;  ///< "": nothing is left out
};

constexpr std::array terms{
    // The process is "chutes de pierres" (hazard), what falls a "bloc".
    Term{"\\b[Rr]ocks?\\b", "", "(^|[^s] (de )?)[Ll]?es pierres|\\bune pierre\\b|rocher"},
    Term{"\\b[Nn]ets? (to order|holds?|that)|\\b[Nn]ets?$|^[Nn]ets?\\b(?!, EUR)", "[Ff]ilets?", ""},
    Term{"\\b[Bb]arriers?\\b", "[Ff]ilets? pare-blocs", "ouvrage|barrière"},
    Term{"[Rr]each probabilit", "[Pp]robabilités? d’atteinte", ""},
    Term{"[Ll]east reach", "[Pp]robabilité d’atteinte", ""},
    Term{"[Rr]un-outs?\\b", "[Dd]istances? de propagation", "portée"},
    Term{"\\b[Rr]eleased\\b", "", "blocs? partis?"}, Term{"[Rr]elease sources", "[Pp]oints de départ", ""},
    Term{"[Pp]assing height|[Hh]eights? of passage", "[Hh]auteurs? de passage", "rebond"},
    Term{"\\b[Ss]tems\\b(?!\\.|_)", "", "\\b[Tt]roncs\\b(?! au sol)"},
    Term{"\\b[Rr]egimes?\\b(?!\\.|_)", "", "régime"},
    // Terms of France: those of Switzerland are made from them (results/text/catalogue).
    Term{"\\b[Hh]azard(?! (matrix|rule))\\b(?!\\.|_)", "", "\\b[Dd]anger"},
    Term{"\\b[Tt]argets?\\b(?!\\.|_)", "", "\\b[Oo]bjets?\\b"},
    Term{"^(?!.*degrees).*\\b[Ll]evels?\\b", "", "\\b[Dd]egrés?\\b"}};

TEST(FrenchTerms, AreOneForOneThing) {
    std::array<std::size_t, terms.size()> found{};
    for (const char* table : {"pages", "messages", "scripts", "phrases"}) {
        std::ifstream in{std::string{BANNWALD_SOURCE_DIR "/coupling/results/text/"} + table + ".csv"};
        std::ostringstream text;
        text << in.rdbuf();
        for (const std::vector<std::string>& row : coupling::report::rows_of_texts(text.str())) {
            const std::string& english = row[row.size() - 4];
            const std::string& french = row[row.size() - 2];
            for (std::size_t i = 0; i < terms.size(); ++i) {
                const Term& term = terms[i];
                if (!std::regex_search(english, std::regex{term.english})) {
                    continue;
                }
                ++found[i];
                EXPECT_TRUE(std::regex_search(french, std::regex{term.says})) << english << "\n" << french;
                EXPECT_TRUE(*term.never == '\0' || !std::regex_search(french, std::regex{term.never}))
                    << english << "\n"
                    << french;
            }
        }
    }
    for (std::size_t i = 0; i < terms.size(); ++i) {
        EXPECT_GT(found[i], 0U) << terms[i].english;
    }
}

}  // namespace
}  // namespace french_terms_test
