#include "config/options/options.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <sstream>

namespace config::options_test {
namespace {

enum class Motion { picus, pir3d };

/// What a run might be told; declared as a room would.
struct Settings {
    double friction = 0.5;
    std::uint64_t seed = 1;
    std::uint64_t years = 0;
    bool feedback = false;
    std::string dem = "dem.asc";
    std::vector<double> diameters_m{0.5, 1.0};
    Motion motion = Motion::picus;
    std::string preset = "default";
};

Options declared(Settings& settings) {
    Options options;
    options.count("run.seed", settings.seed, {.meaning = "seed of all random numbers"});
    options.count("run.years", settings.years,
                  {.unit = "years", .high = 500.0, .meaning = "length of the run"});
    options.text("run.dem", settings.dem, {.meaning = "terrain, ESRI ASCII grid"});
    options.text("rockfall.preset", settings.preset, {.meaning = "named set of settings"});
    options.number("rockfall.rolling_friction", settings.friction,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 2.0,
                    .meaning = "rolling friction coefficient of every ground type",
                    .source = "Azzoni et al. 1995",
                    .presets = {{"strict", "0.4"}, {"final", "0.3"}}});
    options.flag("rockfall.feedback", settings.feedback, {.meaning = "rocks wound trees"});
    options.numbers("rockfall.diameters_m", settings.diameters_m,
                    {.unit = "m", .low = 0.0, .high = 20.0, .meaning = "rock diameters"});
    options.choice("rockfall.motion", settings.motion, {{"picus", Motion::picus}, {"pir3d", Motion::pir3d}},
                   {.meaning = "law of motion"});
    options.free_section("regime:");
    return options;
}

void read(Options& options, const std::string& text, const std::vector<std::string>& overrides = {},
          const std::string& preset_key = "rockfall.preset") {
    std::istringstream in{text};
    options.read(in, "run.ini", overrides, preset_key);
}

TEST(Options, KeepTheRemarkBehindTheValueThatCounts) {
    Settings settings;
    Options options = declared(settings);
    const std::string text = "[run]\nseed = 7 ; GUESS: a number\ndem = \"a ; b\"\n";
    read(options, text);
    EXPECT_EQ(options.remark_of("run.seed"), "GUESS: a number");
    EXPECT_EQ(options.remark_of("run.dem"), "");
    EXPECT_EQ(options.remark_of("run.years"), "");
    read(options, text, {"run.seed=8"});
    EXPECT_EQ(options.remark_of("run.seed"), "");
}

TEST(Options, SetWhatTheFileSays) {
    Settings settings;
    Options options = declared(settings);
    read(options,
         "[run]\nseed = 18446744073709551615\ndem = \"my dem#1.asc\"\n[rockfall]\nrolling_friction = 0.35 ; "
         "low\n"
         "feedback = On\ndiameters_m = 0.5, 1.0 1.5\nmotion = pir3d\n");
    EXPECT_EQ(settings.seed, 18446744073709551615ULL);
    EXPECT_EQ(settings.dem, "my dem#1.asc");
    EXPECT_EQ(settings.friction, 0.35);
    EXPECT_TRUE(settings.feedback);
    EXPECT_EQ(settings.diameters_m, (std::vector<double>{0.5, 1.0, 1.5}));
    EXPECT_EQ(settings.motion, Motion::pir3d);
    EXPECT_EQ(settings.years, 0U);
}

TEST(Options, LetLaterOverridesWin) {
    Settings settings;
    Options options = declared(settings);
    read(options, "[run]\nseed = 2\n", {"run.seed=3", "run.seed=4", "run.dem= a b.asc "});
    EXPECT_EQ(settings.seed, 4U);
    EXPECT_EQ(settings.dem, "a b.asc");
    EXPECT_EQ(options.place_of("run.seed").file, "--set run.seed=4");
}

TEST(Options, KnowWhereAKeyWasSet) {
    Settings settings;
    Options options = declared(settings);
    read(options, "[run]\n\nseed = 2\n");
    EXPECT_TRUE(options.was_set("run.seed"));
    EXPECT_EQ(options.place_of("run.seed").line, 3U);
    EXPECT_FALSE(options.was_set("run.years"));
    EXPECT_EQ(options.place_of("run.years").file, "run.ini");
    EXPECT_EQ(options.place_of("run.years").line, 0U);
}

/// Reads settings that have no presets.
void read_plain(Options& options, const std::string& text, const std::vector<std::string>& overrides = {}) {
    read(options, text, overrides, "");
}

/// Settings of which one had another name before.
Options with_renamed(Settings& settings) {
    Options options;
    options.number("picus.rolling_friction", settings.friction,
                   {.low = 0.0, .high = 2.0, .meaning = "friction", .formerly = "rockfall.friction"});
    return options;
}

TEST(Options, ReadEarlierNamesOfKeysAndSayWhichOnesWereUsed) {
    Settings settings;
    Options options = with_renamed(settings);
    read_plain(options, "[rockfall]\n\nfriction = 0.7\n");
    EXPECT_EQ(settings.friction, 0.7);
    EXPECT_TRUE(options.was_set("picus.rolling_friction"));
    EXPECT_EQ(options.place_of("picus.rolling_friction").line, 3U);
    ASSERT_EQ(options.renamings().size(), 1U);
    EXPECT_EQ(to_string(options.renamings().front()),
              "run.ini:3:1: rockfall.friction is renamed to picus.rolling_friction; it works as before, but "
              "write the new name");

    read_plain(options, "", {"rockfall.friction=0.6"});
    EXPECT_EQ(settings.friction, 0.6);
    ASSERT_EQ(options.renamings().size(), 1U);
    EXPECT_EQ(options.renamings().front().place.file, "--set rockfall.friction=0.6");

    read_plain(options, "[picus]\nrolling_friction = 0.5\n");
    EXPECT_TRUE(options.renamings().empty());
    std::ostringstream written;
    options.write_ini(written, false);
    EXPECT_EQ(written.str(), "[picus]\nrolling_friction = 0.5\n");
}

TEST(Options, NameAllProblemsAtOnceAndThenSetNothing) {
    Settings settings;
    Options options = declared(settings);
    try {
        read(options, "[run]\nseed = 9\nyears = fifty\nsede = 1\nnonsense\n",
             {"run.years=-1", "run.what=1", "run", "rockfall.preset=strikt"});
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.problems().size(), 7U) << error.what();
    }
    EXPECT_EQ(settings.seed, 1U);
}

TEST(Options, PutAPresetBetweenDefaultsAndSettings) {
    Settings settings;
    Options options = declared(settings);
    read(options, "[rockfall]\npreset = strict\n");
    EXPECT_EQ(settings.friction, 0.4);
    EXPECT_FALSE(options.was_set("rockfall.rolling_friction"));
    read(options, "[rockfall]\nrolling_friction = 0.7\npreset = strict\n");
    EXPECT_EQ(settings.friction, 0.7);
    read(options, "", {"rockfall.preset=final"});
    EXPECT_EQ(settings.friction, 0.3);
    read(options, "");
    EXPECT_EQ(settings.friction, 0.5);
    EXPECT_EQ(options.preset_names(), (std::vector<std::string>{"strict", "final"}));
}

TEST(Options, NameWhatWasSetWithoutEffectByTheNeedThatIsNotMet) {
    Settings settings;
    double spread = 0.1;
    double tilt_deg = 0.0;
    Options options = declared(settings);
    options.number("pir3d.spread", spread,
                   {.needs = {{"rockfall.motion", {"pir3d"}}, {"rockfall.feedback"}}});
    options.number("pir3d.tilt_deg", tilt_deg, {.needs = {{"rockfall.motion", {"pir3d"}}, {"run.dem"}}});
    const auto idle = [&](const std::vector<std::string>& overrides) {
        read(options, "", overrides);
        std::string words;
        for (const IdleSettings& one : options.idle()) {
            for (const std::string& key : one.keys) {
                words += key + ' ';
            }
            words += "of " + one.other + '=' + one.value + '\n';
        }
        return words;
    };
    EXPECT_EQ(idle({}), "") << "defaults are no one's wish";
    EXPECT_EQ(idle({"pir3d.spread=0.1", "pir3d.tilt_deg=2"}),
              "pir3d.spread pir3d.tilt_deg of rockfall.motion=picus\n");
    EXPECT_EQ(idle({"pir3d.spread=0.2", "pir3d.tilt_deg=2", "rockfall.motion=pir3d"}),
              "pir3d.spread of rockfall.feedback=no\n");
    EXPECT_EQ(idle({"pir3d.tilt_deg=2", "rockfall.motion=pir3d", "run.dem="}),
              "pir3d.tilt_deg of run.dem=\n");
    EXPECT_EQ(idle({"pir3d.spread=0.2", "rockfall.motion=pir3d", "rockfall.feedback=yes"}), "");
}

TEST(Options, HandOverFreeSectionsUnread) {
    Settings settings;
    Options options = declared(settings);
    read(options, "[regime:no management]\nthin = 20, 40\n[run]\nseed = 2\n",
         {"regime:no management.thin=30"});
    ASSERT_EQ(options.free_entries().size(), 1U);
    const FreeEntry& entry = options.free_entries()[0];
    EXPECT_EQ(entry.section + "/" + entry.key + "/" + entry.value, "regime:no management/thin/30");
    EXPECT_THROW(read(options, "[regimes]\nthin = 20\n"), InputError);
}

TEST(Options, ListWhatIsDeclared) {
    Settings settings;
    Options options = declared(settings);
    read(options, "[rockfall]\nrolling_friction = 0.7\n");
    const std::vector<ParameterRow> rows = options.rows();
    ASSERT_EQ(rows.size(), 8U);
    EXPECT_EQ(rows[4].key, "rockfall.rolling_friction");
    EXPECT_EQ(rows[4].kind, "number");
    EXPECT_EQ(rows[4].range, "[0, 2]");
    EXPECT_EQ(rows[4].default_text, "0.5");
    EXPECT_EQ(rows[4].value_text, "0.7");
    EXPECT_TRUE(rows[4].changed);
    EXPECT_FALSE(rows[0].changed);
    EXPECT_EQ(rows[0].range, ">= 0");
    EXPECT_EQ(rows[7].kind, "one of picus|pir3d");
}

TEST(WriteHelp, IsATableByTheSectionsOfAtMostAHundredColumns) {
    Settings settings;
    settings.dem = "a/very/long/path/to/the/terrain/of/the/slope.asc";
    std::ostringstream out;
    declared(settings).write_help(out);
    std::istringstream lines{out.str()};
    for (std::string line; std::getline(lines, line);) {
        EXPECT_LE(line.size(), 100U) << line;
    }
    std::ostringstream rockfall_only;
    declared(settings).write_help(rockfall_only, "rockfall");
    EXPECT_EQ(rockfall_only.str().find("[run]"), std::string::npos);
    EXPECT_NE(rockfall_only.str().find("  rolling_friction  0.5"), std::string::npos) << rockfall_only.str();
}

TEST(WriteIni, SaysWhatEachKeyMeans) {
    Settings settings;
    std::ostringstream out;
    declared(settings).write_ini(out, true);
    EXPECT_NE(
        out.str().find("# rolling friction coefficient of every ground type; strict: 0.4; final: 0.3 (Azzoni "
                       "et al. 1995) in\n# [0, 2], default 0.5\nrolling_friction = 0.5\n"),
        std::string::npos)
        << out.str();
}

/// A text of one line, with what is awkward in INI files more often than chance would have it.
rc::Gen<std::string> one_line() {
    const auto awkward =
        rc::gen::element<char>('"', '#', ';', '=', ' ', '\t', '[', ']', '.', ',', '\\', '\'');
    const auto printable =
        rc::gen::map(rc::gen::inRange(0x20, 0x7F), [](int c) { return static_cast<char>(c); });
    return rc::gen::container<std::string>(rc::gen::oneOf(awkward, printable));
}

RC_GTEST_PROP(WriteIni, ReadsBackAsWritten, (bool feedback, bool with_comments, std::uint64_t seed)) {
    Settings settings;
    settings.seed = seed;
    settings.years = *rc::gen::inRange<std::uint64_t>(0, 501);
    settings.feedback = feedback;
    settings.dem = *one_line();
    settings.friction = *rc::gen::inRange(0, 2001) / 1000.0;
    settings.diameters_m = *rc::gen::container<std::vector<double>>(
        rc::gen::map(rc::gen::inRange(0, 7001), [](int v) { return v / 350.1; }));
    settings.motion = feedback ? Motion::pir3d : Motion::picus;
    settings.preset = *rc::gen::element<std::string>("default", "strict", "final");
    std::ostringstream out;
    declared(settings).write_ini(out, with_comments);

    Settings again;
    Options options = declared(again);
    read(options, out.str());

    RC_ASSERT(again.seed == settings.seed);
    RC_ASSERT(again.years == settings.years);
    RC_ASSERT(again.feedback == settings.feedback);
    RC_ASSERT(again.dem == settings.dem);
    RC_ASSERT(again.friction == settings.friction);
    RC_ASSERT(again.diameters_m == settings.diameters_m);
    RC_ASSERT(again.motion == settings.motion);
    RC_ASSERT(again.preset == settings.preset);
}

TEST(WriteIni, KeepsFreeSections) {
    Settings settings;
    Options options = declared(settings);
    read(options, "[regime:a]\nthin = \" # 20\"\n");
    std::ostringstream out;
    options.write_ini(out, false);
    Settings again;
    Options reader = declared(again);
    read(reader, out.str());
    ASSERT_EQ(reader.free_entries().size(), 1U);
    EXPECT_EQ(reader.free_entries()[0].value, " # 20");
}

}  // namespace
}  // namespace config::options_test
