#include "coupling/results/text/messages.hpp"

#include <gtest/gtest.h>

#include <cctype>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "config/errors/brief.hpp"
#include "config/errors/input_error.hpp"
#include "config/options/options.hpp"
#include "coupling/inputs/collapse_settings.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/maps/rasters.hpp"
#include "coupling/results/text/writing_language.hpp"

namespace coupling::report::messages_test {
namespace {

constexpr std::array all_languages{config::Language::en, config::Language::de, config::Language::fr,
                                   config::Language::it};

std::string in(config::Language language, const std::string& message) {
    const WritingLanguage writing{language};
    return translated(message).value_or("(none)");
}

const std::string yews =
    "old/trees.csv: 477 trees of TABA (Taxus baccata) taken like ABAL, but with their own fracture energy of "
    "1.2; write another code if another species comes nearer";

TEST(Messages, AreThoseOfTheProgramInEnglish) {
    EXPECT_EQ(in(config::Language::en, yews), yews);
    EXPECT_EQ(in(config::Language::en, "what no table has"), "what no table has");
}

TEST(Messages, AreTranslatedWithTheirValues) {
    EXPECT_EQ(in(config::Language::de, yews),
              "old/trees.csv: 477 Bäume von TABA (Taxus baccata) behandelt wie ABAL, aber mit eigener "
              "Bruchenergie von 1,2; einen anderen Code schreiben, wenn eine andere Baumart näher kommt");
    EXPECT_EQ(
        in(config::Language::it, yews),
        "old/trees.csv: 477 alberi di TABA (Taxus baccata) trattati come ABAL, ma con una propria energia "
        "di rottura di 1,2; scrivere un altro codice se un’altra specie è più vicina");
    EXPECT_EQ(in(config::Language::fr, "old/trees.csv: 1 tree on the same spot as another"),
              "old/trees.csv\u00a0: 1 arbre au même endroit qu’un autre");
}

/// A text at the end of a message does not take in what stands in brackets behind it.
TEST(Messages, WithPeriodsBehindThemAreTranslatedToTheEnd) {
    for (const auto& row : all_messages()) {
        if (!row[0].ends_with("{text}")) {
            continue;
        }
        std::string message = row[0];
        for (std::size_t at = message.find('{'); at != std::string::npos; at = message.find('{')) {
            const std::size_t end = message.find('}', at);
            const std::string name = message.substr(at + 1, end - at - 1);
            message.replace(at, end - at + 1,
                            name.starts_with("number")  ? "12"
                            : name.starts_with("words") ? "5 trees"
                                                        : "Xyz");
        }
        const std::string german = in(config::Language::de, message + " (return periods: 10, 100)");
        EXPECT_NE(german.find(" (Wiederkehrdauern: 10, 100)"), std::string::npos)
            << message << ": " << german;
        EXPECT_EQ(german.find("return period"), std::string::npos) << message << ": " << german;
    }
}

TEST(Messages, WithPlaceFindingExpectationAndAdviceAreTranslatedPartByPart) {
    const std::string doubt =
        config::to_string(config::Problem{config::ExitCode::data,
                                          {"my sources.csv", 3, 7},
                                          "a source polygon of zone 4 with less than 1 % of its area (1 m2 "
                                          "of 12345 m2) off the terrain; no rock "
                                          "starts there",
                                          "sources on the terrain",
                                          "take a larger terrain if rocks start there too"});
    EXPECT_EQ(
        in(config::Language::de, doubt),
        "my sources.csv:3:7: gefunden: ein Ausbruchpolygon von Gebiet 4, von dem weniger als 1\u00a0% der "
        "Fläche (1 m² von 12\u202f345 m²) außerhalb des Geländes liegen; dort bricht kein Block aus; "
        "erwartet: Ausbruchstellen auf dem Gelände; Abhilfe: ein größeres Gelände nehmen, wenn auch dort "
        "Blöcke ausbrechen");
}

TEST(Messages, TranslateEachItemOfAList) {
    EXPECT_EQ(in(config::Language::de,
                 "rock face 0.11, 100 % of it steeper; soil 0.54, 98 % of it steeper; talus 0.25, 99 % of it "
                 "steeper"),
              "rock face 0,11, 100\u00a0% davon steiler; soil 0,54, 98\u00a0% davon steiler; talus 0,25, "
              "99\u00a0% davon steiler");
    EXPECT_EQ(
        in(config::Language::fr,
           "17.6 % over the west edge; 8.1 % into the hole at 177818, 377512; 0.14 % elsewhere"),
        "17,6\u00a0% par le bord ouest\u202f; 8,1\u00a0% dans le trou à 177\u202f818 / 377\u202f512\u202f; "
        "0,14\u00a0% ailleurs");
}

TEST(Messages, OfSeveralRunsAndPeriodsKeepTheirNames) {
    EXPECT_EQ(in(config::Language::de, "dense, thin: trees.csv: 3 trees below 1 cm diameter left out"),
              "dense, thin: trees.csv: 3 Bäume unter 1 cm Durchmesser weggelassen");
    EXPECT_EQ(
        in(config::Language::de, "trees.csv: 3 trees below 1 cm diameter left out (return periods: 30, 100)"),
        "trees.csv: 3 Bäume unter 1 cm Durchmesser weggelassen (Wiederkehrdauern: 30, 100)");
}

TEST(Messages, KeepYearsAndExponentsInOnePiece) {
    EXPECT_EQ(in(config::Language::de, "zone 1950"), "Gebiet 1950");
    EXPECT_EQ(in(config::Language::de, "zone 19500"), "Gebiet 19\u202f500");
    EXPECT_EQ(in(config::Language::de, "zone 1.5e-05"), "Gebiet 1,5e-05");
    EXPECT_EQ(in(config::Language::de, "zone nan"), "(none)");
}

TEST(Messages, HaveThousandsApartInAllLanguages) {
    const std::string walls =
        "dem.asc: walls rise within one or two cells of 5 m in 1272 places, which leans them: rocks may land "
        "too "
        "far out below; cells of at most 1 m keep walls";
    for (const config::Language language : all_languages) {
        EXPECT_NE(in(language, walls).find(" 1\u202f272 "), std::string::npos) << in(language, walls);
        for (const char* trees : {"999", "1000", "1950", "12345", "1234567"}) {
            std::string apart = trees;
            for (std::size_t at = apart.size(); at > 3; at -= 3) {
                apart.insert(at - 3, at > 3 ? "\u202f" : "");
            }
            const std::string found =
                in(language, "trees.csv: " + std::string{trees} + " trees below 1 cm diameter left out");
            EXPECT_NE(found.find(" " + apart + " "), std::string::npos) << found;
        }
    }
}

TEST(Messages, AreTranslatedWhollyOrNotAtAll) {
    EXPECT_EQ(in(config::Language::de, "trees.csv: what no table has"), "(none)");
    EXPECT_EQ(in(config::Language::de, "found no trees, expected what no table has"), "(none)");
    EXPECT_EQ(in(config::Language::de, "no trees" + std::string(longest_message_bytes, ' ')), "(none)");
    EXPECT_EQ(in(config::Language::de, ""), "(none)");
}

TEST(Messages, OnPagesSayWhereTheyAreEnglish) {
    EXPECT_EQ(message_html("a < b"), "a &lt; b");
    const WritingLanguage german{config::Language::de};
    EXPECT_EQ(message_html("a < b"), "<span lang=\"en\">a &lt; b</span>");
    EXPECT_EQ(message_html("column '<b>' is taken as dbh_cm"), "Spalte '&lt;b&gt;' wird als dbh_cm gelesen");
}

TEST(Messages, HaveTheMeaningOfEachSetting) {
    Scenario scenario;
    collapse::CollapseSettings of_collapse;
    config::Options options;
    declare(options, scenario);
    collapse::declare(options, of_collapse);
    const std::vector<config::ParameterRow> rows = options.rows();
    EXPECT_GT(rows.size(), 250U);
    for (const config::ParameterRow& row : rows) {
        EXPECT_NE(in(config::Language::de, row.meaning), "(none)")
            << row.key << ": add a row to messages.csv: " << row.meaning;
    }
    EXPECT_EQ(in(config::Language::it, "density of the rock"), "densità della roccia");
}

TEST(Messages, HaveEachUnitThatIsAnEnglishWord) {
    Scenario scenario;
    config::Options options;
    declare(options, scenario);
    std::size_t words = 0;
    for (const config::ParameterRow& row : options.rows()) {
        for (const char* word : {"yr", "year", "day", "deg"}) {
            if (row.unit.find(word) == std::string::npos) {
                continue;
            }
            ++words;
            for (const config::Language language :
                 {config::Language::de, config::Language::fr, config::Language::it}) {
                const std::string unit = in(language, row.unit);
                EXPECT_NE(unit, "(none)") << row.key << ": add a row to messages.csv: " << row.unit;
                EXPECT_NE(unit, row.unit) << row.key;
            }
        }
    }
    EXPECT_GT(words, 20U);
    EXPECT_EQ(in(config::Language::fr, "yr"), "ans");
}

TEST(Messages, HaveTheMeaningOfEachRaster) {
    std::vector<RasterKind> kinds = raster_kinds();
    for (const std::vector<RasterKind>& more : {release_kinds(), spread_kinds()}) {
        kinds.insert(kinds.end(), more.begin(), more.end());
    }
    for (const RasterKind& kind : kinds) {
        const std::string meaning{kind.meaning};
        for (const std::string part : {"with forest", "on the bare slope", "with forest minus bare slope"}) {
            std::string sentence = meaning + " [kJ], " + part + ".";
            sentence.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence.front())));
            EXPECT_NE(in(config::Language::de, sentence), "(none)") << sentence;
        }
        EXPECT_NE(in(config::Language::de, "E_95 [kJ]: " + meaning + "; year 5, none"), "(none)") << meaning;
    }
    EXPECT_EQ(in(config::Language::fr, "Rocks that passed the cell, each counted once [rocks], with forest."),
              "Blocs passés par la cellule, chacun compté une fois [blocs], avec forêt.");
}

/// A row with its placeholders filled in, in a language.
std::string with_samples(const std::string& row, config::Language language) {
    const bool point = language == config::Language::en;
    std::map<std::string, std::string> samples{{"number", point ? "-12.5" : "-12,5"},
                                               {"place", "old/trees.csv:3"},
                                               {"text", "'X y'"},
                                               {"words", in(language, "7 trees")}};
    const std::regex placeholder{R"(\{([a-z]+)\d*\})"};
    std::string text;
    std::string rest = row;
    for (std::smatch found; std::regex_search(rest, found, placeholder); rest = found.suffix()) {
        text += found.prefix().str() + samples.at(found[1]);
    }
    return text + rest;
}

TEST(Messages, OfEachRowBecomeWhatItSays) {
    ASSERT_GT(all_messages().size(), 200U);
    for (const auto& row : all_messages()) {
        for (const config::Language language : all_languages) {
            EXPECT_EQ(in(language, with_samples(row[0], config::Language::en)),
                      with_samples(row[static_cast<std::size_t>(language)], language));
        }
    }
}

}  // namespace
}  // namespace coupling::report::messages_test
