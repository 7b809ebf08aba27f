#include "coupling/assessments/today/report/page.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/text/messages.hpp"
#include "coupling/results/text/page_text.hpp"
#include "tests/coupling/results/markup_checks.hpp"
#include "tests/coupling/results/small_run.hpp"

namespace coupling::report::page_test {
namespace {

using small_runs::SmallRun;

std::string page_of(const SmallRun& run) {
    std::ostringstream out;
    write_page(out, run.results(), figures_of(run.results()), {{"tables/targets.csv", "What arrives."}});
    return out.str();
}

SmallRun some_rocks() {
    SmallRun run;
    run.fall(400);
    return run;
}

TEST(WritePage, IsWellFormed) {
    EXPECT_EQ(text_checks::markup_fault(page_of(some_rocks())), "");
    EXPECT_EQ(text_checks::markup_fault(page_of(SmallRun{})), "") << "no rocks at all";
}

TEST(WritePage, IsWellFormedWithoutForestTargetsPercentilesAndPaths) {
    SmallRun run = some_rocks();
    run.with_forest = false;
    run.histograms[1].reset();
    run.site.targets.clear();
    run.tally.targets.clear();
    run.paths.clear();
    const std::string page = text_checks::without_scripts(page_of(run));
    EXPECT_EQ(text_checks::markup_fault(page), "");
    EXPECT_EQ(page.find("with forest"), std::string::npos) << page.substr(page.find("with forest"), 100);
}

TEST(WritePage, ReachesOutToNothing) {
    const std::string page = coupling::text_checks::without_scripts(page_of(some_rocks()));
    for (const char* outside : {"http:", "https:", "url(//", "<link", "@import", "javascript:"}) {
        EXPECT_EQ(page.find(outside), std::string::npos) << outside;
    }
    EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
}

/// What stands between each `before` and the next of the signs in `ends`.
std::vector<std::string> all_between(const std::string& text, const std::string& before, const char* ends) {
    std::vector<std::string> found;
    for (std::size_t at = text.find(before); at != std::string::npos; at = text.find(before, at + 1)) {
        const std::size_t first = at + before.size();
        found.push_back(text.substr(first, text.find_first_of(ends, first) - first));
    }
    return found;
}

TEST(WritePage, RefersOnlyToWhatItDefinesAndDefinesItOnce) {
    const std::string page = text_checks::without_scripts(page_of(some_rocks()));
    std::set<std::string> ids;
    for (const std::string& id : all_between(page, " id=\"", "\"")) {
        EXPECT_TRUE(ids.insert(id).second) << id;
    }
    EXPECT_GT(ids.size(), 5U);
    for (const char* reference : {"href=\"#", "url(#"}) {
        for (const std::string& id : all_between(page, reference, "\")")) {
            EXPECT_TRUE(ids.contains(id)) << id;
        }
    }
}

TEST(WritePage, AnswersBeforeItExplains) {
    const std::string page = page_of(some_rocks());
    const std::size_t answer = page.find("The forest stops <b>75.0\u00a0%</b>");
    ASSERT_NE(answer, std::string::npos);
    EXPECT_LT(answer, page.find("<h2>Maps"));
    EXPECT_LT(page.find("<h2>Maps"), page.find("<h2>Settings"));
    EXPECT_NE(page.find("<b>No rock</b> of 400 arrives here"), std::string::npos) << "at the house";
}

TEST(WritePage, TellsNoProtectionFromAHandfulOfRocks) {
    SmallRun few;
    few.fall(40);
    const std::string page = page_of(few);
    EXPECT_NE(page.find("only 4 rocks arrive over the bare slope: too few for a protection figure"),
              std::string::npos);
    EXPECT_EQ(page.find("The forest stops <b>"), std::string::npos);
    EXPECT_EQ(page.find("(MIRI)"), std::string::npos);
}

TEST(WritePage, LeavesOutMiriAndOrpiOfFewRocks) {
    const std::string page = page_of(some_rocks());
    EXPECT_NE(page.find("75.0\u00a0% fewer rocks (BARI). MIRI and ORPI cannot be estimated"),
              std::string::npos)
        << "10 rocks come through";
}

TEST(WritePage, MarksOnItsFirstScreenWhatTheScenarioSetAndWhatIsADefault) {
    const std::string page = page_of(some_rocks());
    const std::string first_screen = page.substr(0, page.find("<h2>"));
    const auto fact = [&](const std::string& name) {
        const std::size_t at = first_screen.find("<dt>" + name + "</dt>");
        EXPECT_NE(at, std::string::npos) << name;
        return first_screen.substr(at, first_screen.find("</dd>", at) - at);
    };
    EXPECT_NE(fact("Rock density").find("2\u202f500 kg/m³ <span class=\"mark given\">set</span>"),
              std::string::npos)
        << fact("Rock density");
    EXPECT_NE(fact("Random seed").find("<span class=\"mark\">default</span>"), std::string::npos);
    for (const char* name : {"Rocks", "Rock diameter", "Start", "Spread of directions", "Motion",
                             "Preset of the rockfall laws"}) {
        EXPECT_NE(fact(name).find("default"), std::string::npos) << name;
        EXPECT_EQ(fact(name).find(">set<"), std::string::npos) << name;
    }
}

TEST(WritePage, CountsRocksAboveEnergiesPer1000Released) {
    const std::string page = page_of(some_rocks());
    EXPECT_NE(page.find("above 300\u00a0kJ"), std::string::npos);
    // Of 400 rocks 40 arrive over the bare slope, 32 of them with more than 30 kJ: 80 per 1000.
    int above = 0;
    for (int rock = 0; rock < 400; rock += 10) {
        above += 20.0 + 2.0 * (rock % 89) > 30.0 ? 1 : 0;
    }
    const std::string rate = std::to_string(1000 * above / 400);
    EXPECT_NE(page.find("<td>" + rate), std::string::npos) << rate;
}

TEST(WritePage, EscapesWhatTheUserWrote) {
    const std::string page = page_of(some_rocks());
    EXPECT_EQ(page.find("<bridge>"), std::string::npos);
    EXPECT_NE(page.find("Road &amp; &lt;bridge&gt;"), std::string::npos);
    EXPECT_NE(page.find("2 trees lie outside the terrain &amp; were left out"), std::string::npos);
    EXPECT_NE(page.find("density of the rocks &lt;dry&gt;"), std::string::npos);
}

TEST(WritePage, MarksChangedSettings) {
    const std::string page = page_of(some_rocks());
    EXPECT_NE(page.find("<tr class=\"changed\"><td><code>density_kgpm3</code></td><td>2500</td>"),
              std::string::npos);
    EXPECT_NE(page.find("<tr><td><code>seed</code></td><td>1</td>"), std::string::npos);
}

TEST(WritePage, AnswersThenMapThenAssumptionsThenWarnings) {
    const std::string page = page_of(some_rocks());
    const std::string first_screen = page.substr(0, page.find("<h2>"));
    std::size_t last = 0;
    for (const char* part :
         {"<h1>", "class=\"lead question\"", "href=\"#first-warnings\"", "The forest stops <b>75.0",
          "class=\"sheet\"", "What decides it", "id=\"first-warnings\""}) {
        const std::size_t at = first_screen.find(part);
        ASSERT_NE(at, std::string::npos) << part;
        EXPECT_GT(at, last) << part;
        last = at;
    }
}

TEST(WritePage, ListsChangedSettingsAndFoldsTheRest) {
    const std::string page = page_of(some_rocks());
    const std::size_t changed = page.find("<h2>Settings that differ from the defaults");
    const std::size_t all = page.find("<details><summary>All settings");
    ASSERT_LT(changed, all);
    const std::string differing = page.substr(changed, all - changed);
    EXPECT_NE(differing.find("density_kgpm3"), std::string::npos);
    EXPECT_EQ(differing.find("<code>seed</code>"), std::string::npos);
}

TEST(WritePage, HasTheHeadThatTheUserGave) {
    SmallRun run = some_rocks();
    EXPECT_EQ(page_of(run).find("<header"), std::string::npos);
    run.scenario->report.title = "Rockfall <Kot>";
    run.scenario->report.client = "Commune & canton";
    run.scenario->report.date = "2026-11-24";
    run.scenario->report.picture = {"image/png", "abc"};
    run.scenario->report.logo = "logo.png";
    const std::string page = page_of(run);
    EXPECT_NE(page.find("<title>Rockfall &lt;Kot&gt;</title>"), std::string::npos);
    EXPECT_NE(page.find("<h1>Rockfall &lt;Kot&gt;</h1>"), std::string::npos);
    EXPECT_NE(page.find("<dt>Client</dt><dd>Commune &amp; canton</dd>"), std::string::npos);
    EXPECT_NE(page.find("<dd>24 November 2026</dd>"), std::string::npos);
    EXPECT_NE(page.find("src=\"data:image/png;base64,YWJj\""), std::string::npos);
    EXPECT_EQ(page.find("<dt>Author</dt>"), std::string::npos);
    EXPECT_EQ(text_checks::markup_fault(page), "");
}

/// A page without the tables that have rows of settings under a heading such as [release].
std::string without_tables_of_settings(std::string page) {
    for (std::size_t begin = page.find("<table"); begin != std::string::npos;) {
        const std::size_t end = page.find("</table>", begin);
        const std::size_t group = page.find(">[", begin);
        if (end != std::string::npos && group < end) {
            page.erase(begin, end - begin);
        }
        begin = page.find("<table", begin + 1);
    }
    return page;
}

/// Texts of pages and messages of at least four words, without placeholders.
std::vector<std::string> english_sentences() {
    std::vector<std::string> all;
    const auto take = [&](const std::string& text) {
        if (std::count(text.begin(), text.end(), ' ') >= 3 && text.find_first_of("{<") == std::string::npos) {
            all.push_back(text);
        }
    };
    for (const std::string& text : english_page_texts()) {
        take(text);
    }
    for (const auto& row : all_messages()) {
        take(row[0]);
    }
    return all;
}

/// 14 stretches of a line, 12 zones and 2 sizes, each with the arrivals at a target.
Breakdown breakdown_of(const RunResults& results) {
    Breakdown breakdown;
    breakdown.is_known = true;
    breakdown.lines.resize(1);
    for (int i = 0; i < 14; ++i) {
        Stretch stretch;
        stretch.from_m = 10.0 * i;
        stretch.to_m = 10.0 * (i + 1);
        stretch.tally = results.tally.targets[0];
        breakdown.lines[0].stretches.push_back(stretch);
    }
    for (std::uint32_t zone = 1; zone <= 12; ++zone) {
        breakdown.zones.push_back({.zone = zone, .released = 400, .targets = results.tally.targets});
    }
    for (const double size_m : {0.5, 1.0}) {
        breakdown.sizes.push_back(
            {.smallest_m = size_m, .largest_m = size_m, .released = 400, .targets = results.tally.targets});
    }
    return breakdown;
}

TEST(WritePage, ShowsWhatOnlyFewRunsHave) {
    SmallRun run = some_rocks();
    for (int more = 0; more < 60; ++more) {
        run.site.targets.push_back(run.site.targets.back());
        run.tally.targets.push_back(run.tally.targets.back());
    }
    run.scenario->output.path_rocks = {0.0};
    RunResults results = run.results();
    results.breakdown = breakdown_of(results);
    observed::StopComparison stops;
    stops.group = "<upper>";
    stops.simulated.left_terrain = 0.25;
    stops.observed_run_out_m = {10.0, 20.0};
    stops.simulated_run_out_m = {12.0, 25.0};
    results.observed_stops = {stops};
    results.observed_events = {{.place = "road", .quantity = "speed_mps", .unit = "m/s"}};
    std::ostringstream out;
    write_page(out, results, figures_of(results), {});
    const std::string page = text_checks::without_scripts(out.str());
    EXPECT_EQ(text_checks::markup_fault(page), "");
    for (const char* part :
         {" of 62 targets over the bare slope and ", " with forest. These 4 are reached by most;",
          "Charts of the 10 of 62 targets", "The 10 of 62 targets that most rocks reach",
          "<summary>All stretches of 10 m</summary>", "Shown: for each target the 10 of 12 zones",
          "<td>Zone 10</td><td>400</td>", "<td>0.5 m</td><td>400</td>", "<td>&lt;upper&gt;, observed</td>",
          "25.0\u00a0% of the simulated rocks left the terrain",
          "<code>passage.speed_mps:road</code>, simulated", "The rocks that output.path_rocks names"}) {
        EXPECT_NE(page.find(part), std::string::npos) << part;
    }
    EXPECT_EQ(page.find("<td>Zone 11</td>"), std::string::npos) << "as many rocks come from the ten before";
}

TEST(WritePage, SpeaksTheLanguageOfTheScenario) {
    using config::Language;
    struct Spoken {
        Language language;
        const char* tag;
        const char* answer;
        const char* date;
    };
    const std::vector<std::string> sentences = english_sentences();
    EXPECT_GT(sentences.size(), 500U);
    for (const Spoken& spoken :
         {Spoken{Language::de, "<html lang=\"de\">", "Der Wald hält <b>75,0\u00a0%</b>", "24.11.2026"},
          Spoken{Language::fr, "<html lang=\"fr\">", "La forêt arrête <b>75,0\u00a0%</b>", "24.11.2026"},
          Spoken{Language::it, "<html lang=\"it\">", "che arriverebbero: <b>75,0\u00a0%</b>",
                 "24.11.2026"}}) {
        SmallRun run = some_rocks();
        run.scenario->report.language = spoken.language;
        run.scenario->report.date = "2026-11-24";
        const std::string page = page_of(run);
        for (const char* text : {spoken.tag, spoken.answer, spoken.date}) {
            EXPECT_NE(page.find(text), std::string::npos) << text;
        }
        EXPECT_EQ(text_checks::markup_fault(page), "") << spoken.tag;
        // English is what settings mean and what the model calls its parts; headings are none of that.
        const std::string words = without_tables_of_settings(text_checks::without_scripts(page));
        for (const char* english : {"<h2>What", "<h2>Settings", "<h2>The forest", "with forest<",
                                    "bare slope<", "rocks</small>", "of the rocks"}) {
            EXPECT_EQ(words.find(english), std::string::npos) << spoken.tag << english;
        }
        for (const std::string& english : sentences) {
            EXPECT_EQ(words.find(english), std::string::npos) << spoken.tag << english;
        }
    }
    EXPECT_NE(page_of(some_rocks()).find("<html lang=\"en\">"), std::string::npos) << "nothing is left over";
}

TEST(WritePage, CarriesHashesProjectionVersionAndSeed) {
    const std::string page = page_of(some_rocks());
    for (const char* text :
         {"0123456789abcdef", "MGI_Austria_Lambert", "Bannwald 0.1.0", "seed 1", "What arrives."}) {
        EXPECT_NE(page.find(text), std::string::npos) << text;
    }
}

}  // namespace
}  // namespace coupling::report::page_test
