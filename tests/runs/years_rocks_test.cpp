#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "tests/runs/motion_models.hpp"
#include "tests/runs/years.hpp"

namespace coupling::years_rocks_test {
namespace {

namespace fs = std::filesystem;

/// A row of the table of protection at targets; without what only other runs have.
using Protection = std::vector<std::string>;

/// The protection of a regime's first replicate in a year, by target; of an assessment of today with regime
/// and year left out.
std::vector<Protection> protection(const config::Table& table, const std::string& regime = "",
                                   const std::string& year = "") {
    std::vector<Protection> rows;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (regime.empty() || (table.text(row, "regime") == regime && table.text(row, "year") == year &&
                               table.text(row, "replicate") == "1")) {
            rows.emplace_back();
            for (const std::string column :
                 {"target_id", "rocks", "reached_bare", "reached_forest", "reached_both",
                  "protection_percent", "protection_low_percent", "protection_high_percent", "bari_percent",
                  "miri_percent", "orpi_percent"}) {
                rows.back().push_back(table.text(row, column));
            }
        }
    }
    return rows;
}

/// Every few metres a tree, one in four a thin one if these are wanted.
std::string dense_list(bool with_thin_trees) {
    std::ostringstream list;
    list << "tree_id,x_m,y_m,species,dbh_cm,height_m\n";
    for (int i = 0; i < 400; ++i) {
        const int column = i % 20;
        const int row = i / 20;
        if (i % 4 != 0) {
            list << i + 1 << ',' << 1041.5 + 3.9 * column << ',' << 2003.25 + 4.7 * row + 0.2 * column
                 << (i % 3 == 0 ? ",PIAB," : ",FASY,") << 8 + i * 7 % 31 << ',' << 9 + i * 7 % 31 / 2 << '\n';
        } else if (with_thin_trees) {
            list << i + 1 << ',' << 1041.5 + 3.9 * column << ',' << 2003.25 + 4.7 * row << ",ABAL,4.9,5\n";
        }
    }
    return list.str();
}

class FirstRocksOfYearsUnderModel : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Motion, FirstRocksOfYearsUnderModel, ::testing::ValuesIn(motion_model_names()),
                         [](const auto& model) { return model.param; });

TEST_P(FirstRocksOfYearsUnderModel, AreThoseOfToday) {
    // The rocks of year 0 fall through the trees of the list, on patches or not, with the same random
    // numbers: the figures agree to the last digit, whichever way the stems are numbered.
    const ForestProject project;
    project.write("list.csv", dense_list(false));
    project.write("stands.asc", SampleProject::header() + SampleProject::rows([](int column, int) {
                                    return column < 8 ? "0" : "7";
                                }));
    const std::string rocks =
        "run scenario.ini --quiet --set trees.file=list.csv --set run.parameter_draws=no " +
        rocks_for(GetParam(), GetParam() == "rigid" ? 10000 : 1000) + motion_settings(GetParam());
    ASSERT_EQ(call(project, rocks + "--set run.years=0 --out today").code, 0);
    const Outcome years = call(project, rocks + "--set run.years=1 --out years");
    ASSERT_EQ(years.code, 0) << years.err;
    const auto today = protection(table(project, "today/tables/protection.csv"));
    EXPECT_EQ(today.size(), 2U);
    EXPECT_EQ(protection(table(project, "years/tables/protection.csv"), "none", "0"), today);
    const config::Table rows = table(project, "today/tables/protection.csv");
    EXPECT_GT(number(rows, 0, "protection_percent"), 20.0);
    EXPECT_LT(number(rows, 0, "protection_percent"), 99.0);
}

TEST(FirstRocksOfYears, DoNotMeetTreesBelowFiveCentimetres) {
    const ForestProject project;
    project.write("thick.csv", dense_list(false));
    project.write("all.csv", dense_list(true));
    project.write("stands.asc", SampleProject::header() + SampleProject::rows([](int column, int) {
                                    return column < 8 ? "0" : "7";
                                }));
    const std::string rocks =
        "run scenario.ini --quiet --set release.rocks=1000 --set run.parameter_draws=no ";
    ASSERT_EQ(call(project, rocks + "--set run.years=0 --set trees.file=thick.csv --out thick").code, 0);
    ASSERT_EQ(call(project, rocks + "--set run.years=0 --set trees.file=all.csv --out all").code, 0);
    ASSERT_EQ(call(project, rocks + "--set run.years=1 --set trees.file=all.csv --out years").code, 0);
    const auto thick = protection(table(project, "thick/tables/protection.csv"));
    EXPECT_NE(protection(table(project, "all/tables/protection.csv")), thick);
    EXPECT_EQ(protection(table(project, "years/tables/protection.csv"), "none", "0"), thick);
}

TEST(RocksOfYears, MeetTreesOutsideTheForestInEachYear) {
    const ForestProject project;
    project.write("list.csv", dense_list(false));
    project.write("stands.asc", SampleProject::header() + SampleProject::rows([](int column, int row) {
                                    return column == 4 && row == 0 ? "7" : "0";
                                }));
    const Outcome outcome = call(project,
                                 "run scenario.ini --set trees.file=list.csv --set release.rocks=500 "
                                 "--set run.years=2");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("trees outside the forest: obstacles that do not grow"), std::string::npos)
        << outcome.err;
    EXPECT_NE(project.read("out/summary.json").find("trees outside the forest: obstacles that do not grow"),
              std::string::npos);
    const config::Table rows = table(project, "out/tables/protection.csv");
    ASSERT_EQ(rows.rows(), 3U * 2U);
    for (std::size_t row = 0; row < rows.rows(); row += 2) {
        EXPECT_GT(number(rows, row, "protection_percent"), 20.0) << rows.text(row, "year");
    }
}

TEST(RocksOfYears, AreAllToldByWhatEndedTheirFall) {
    const ForestProject project;
    ASSERT_EQ(call(project, four_members).code, 0);
    const config::Table causes = table(project, "out/tables/causes.csv");
    std::map<std::string, double> rocks;  // by regime, replicate, year and slope
    for (std::size_t row = 0; row < causes.rows(); ++row) {
        const std::string key = causes.text(row, "regime") + '/' + causes.text(row, "replicate") + '/' +
                                causes.text(row, "year") + '/' + causes.text(row, "cover");
        rocks[key] += number(causes, row, "stopped");
        EXPECT_LE(number(causes, row, "share_low_percent"), number(causes, row, "share_percent"));
        EXPECT_GE(number(causes, row, "share_high_percent"), number(causes, row, "share_percent"));
        if (causes.text(row, "cover") == "bare" &&
            (causes.text(row, "cause") == "tree" || causes.text(row, "cause") == "log")) {
            EXPECT_EQ(causes.text(row, "stopped"), "0");
        }
    }
    EXPECT_EQ(rocks.size(), 4U * 3U * 2U);
    for (const auto& [key, count] : rocks) {
        EXPECT_EQ(count, 200.0) << key;
    }

    // Rocks of half a metre: stems from 24 cm on. Two stands and the whole of them.
    const config::Table profile = table(project, "out/tables/target_profile.csv");
    ASSERT_EQ(profile.rows(), 4U * 5U * 3U * 2U);
    for (std::size_t row = 0; row < profile.rows(); row += 2) {
        EXPECT_EQ(profile.text(row, "criterion"), "stems_from_24_cm");
        EXPECT_EQ(profile.text(row, "met") == "yes", number(profile, row, "value") >= 300.0);
        EXPECT_EQ(profile.text(row + 1, "criterion"), "longest_gap");
        EXPECT_EQ(profile.text(row + 1, "met") == "yes", number(profile, row + 1, "value") <= 20.0);
    }
    const config::Table compared = table(project, "out/tables/regimes_by_year.csv");
    double shares = 0.0;
    double met = -1.0;
    for (std::size_t row = 0; row < compared.rows(); ++row) {
        const std::string quantity = compared.text(row, "quantity");
        if (compared.text(row, "regime") != "none" || compared.text(row, "year") != "4") {
            continue;
        }
        if (quantity.starts_with("stopped_by_") || quantity == "left_terrain_percent" ||
            quantity == "gave_up_percent") {
            shares += number(compared, row, "mean");
        }
        met = quantity == "target_profile_met_percent" ? number(compared, row, "mean") : met;
    }
    EXPECT_NEAR(shares, 100.0, 0.01);
    EXPECT_GE(met, 0.0);
    EXPECT_LE(met, 100.0);
}

/// Protection of a regime in a year: mean and range of the replicates.
struct ProtectionRange {
    double mean_percent = 0.0;
    double low_percent = 0.0;
    double high_percent = 0.0;
};

ProtectionRange protection_range(const config::Table& by_year, const std::string& regime, int year) {
    for (std::size_t row = 0; row < by_year.rows(); ++row) {
        if (by_year.text(row, "regime") == regime && by_year.text(row, "quantity") == "protection_percent" &&
            by_year.text(row, "year") == std::to_string(year)) {
            return {number(by_year, row, "mean"), number(by_year, row, "least"),
                    number(by_year, row, "most")};
        }
    }
    ADD_FAILURE() << "no protection of " << regime << " in year " << year;
    return {};
}

TEST(FirstExample, LosesTensOfPercentOfItsProtectionToClearCutsAlone) {
    const SampleProject project;
    ASSERT_EQ(call(project, "init first --quiet --example regimes-small").code, 0);
    // By the central values: three replicates with draws of their own are too few for bounds of a mean.
    const Outcome run = call(project,
                             "run first/scenario.ini --quiet --out out --set run.rockfall_every=30 "
                             "--set release.rocks=1000 "
                             "--set run.parameter_draws=no "
                             "--set run.replicates=3 --set \"regimes.list=none, clear_cut_strips.csv\"");
    ASSERT_EQ(run.code, 0) << run.err;
    const config::Table by_year = table(project, "out/tables/regimes_by_year.csv");
    const ProtectionRange start = protection_range(by_year, "none", 0);
    EXPECT_GT(start.low_percent, 65.0);
    EXPECT_LT(start.high_percent, 95.0);
    const ProtectionRange untouched = protection_range(by_year, "none", 30);
    const ProtectionRange cut = protection_range(by_year, "clear_cut_strips", 30);
    EXPECT_GT(untouched.low_percent, cut.high_percent + 10.0);
    EXPECT_GT(start.low_percent, cut.high_percent);
    EXPECT_GT(start.mean_percent, cut.mean_percent + 10.0);
}

TEST(Feedback, SwitchedOffChangesNothing) {
    const ForestProject project;
    project.write("list.csv", dense_list(false));
    const std::string rocks =
        "run scenario.ini --quiet --set trees.file=list.csv --set release.rocks=500 --set run.years=3 ";
    ASSERT_EQ(call(project, rocks + "--out without").code, 0);
    ASSERT_EQ(call(project, rocks + "--set feedback.on=no --set feedback.rocks_per_year=300 --out off").code,
              0);
    const Outcome same =
        shell(project, "diff -r without/tables off/tables && diff -r without/rasters off/rasters\n");
    EXPECT_EQ(same.code, 0) << same.out << same.err;
    EXPECT_FALSE(fs::exists(project.file("off/tables/removed_trees.csv")));

    // On, the first rocks meet the same forest; later ones meet another.
    ASSERT_EQ(call(project, rocks + "--set feedback.on=yes --set feedback.rocks_per_year=300 --out on").code,
              0);
    const config::Table off = table(project, "off/tables/protection.csv");
    const config::Table on = table(project, "on/tables/protection.csv");
    EXPECT_EQ(protection(on, "none", "0"), protection(off, "none", "0"));
    EXPECT_NE(protection(on, "none", "3"), protection(off, "none", "3"));
    EXPECT_EQ(protection(on, "none", "3")[0][2], protection(off, "none", "3")[0][2]);  // over the bare slope
}

TEST(Feedback, ExplainsEachTreeThatARockBroke) {
    const ForestProject project;
    project.write("list.csv", dense_list(false));
    const Outcome outcome = call(project,
                                 "run scenario.ini --quiet --set trees.file=list.csv --set release.rocks=500 "
                                 "--set run.years=3 --set feedback.on=yes --set feedback.rocks_per_year=300 "
                                 "--set \"output.tree_list_years=0, 1, 2, 3\"");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    // Trees by year: where each stands.
    std::vector<std::map<std::string, std::string>> standing(4);
    for (std::size_t year = 0; year < standing.size(); ++year) {
        const config::Table trees = table(project, "out/tables/trees_" + std::to_string(year) + ".csv");
        for (std::size_t row = 0; row < trees.rows(); ++row) {
            standing[year][trees.text(row, "tree_id")] =
                trees.text(row, "x_m") + ' ' + trees.text(row, "y_m") + ' ' + trees.text(row, "species");
        }
    }
    const config::Table removed = table(project, "out/tables/removed_trees.csv");
    std::map<std::string, double> broken;
    for (std::size_t row = 0; row < removed.rows(); ++row) {
        const std::string id = removed.text(row, "tree_id");
        const auto year = static_cast<std::size_t>(number(removed, row, "year"));
        // What broke at the start was still listed there.
        ASSERT_TRUE(standing[year == 0 ? 0 : year - 1].contains(id)) << id;
        EXPECT_EQ(
            standing[year == 0 ? 0 : year - 1][id],
            removed.text(row, "x_m") + ' ' + removed.text(row, "y_m") + ' ' + removed.text(row, "species"));
        EXPECT_FALSE(standing[year == 0 ? 1 : year].contains(id)) << id;
        EXPECT_TRUE(removed.text(row, "reason") == "rock" || removed.text(row, "reason") == "wound");
        if (removed.text(row, "reason") == "rock") {
            broken[removed.text(row, "year")] += 1.0;
        }
    }
    const config::Table losses = table(project, "out/tables/mortality.csv");
    std::map<std::string, double> counted;
    std::map<std::string, double> rows;
    for (std::size_t row = 0; row < losses.rows(); ++row) {
        if (losses.text(row, "cause") == "rock") {
            counted[losses.text(row, "year")] += 0.8 * number(losses, row, "stems_pha");
            rows[losses.text(row, "year")] += 1.0;
        }
    }
    ASSERT_EQ(counted.size(), broken.size());
    double all = 0.0;
    for (const auto& [year, stems] : broken) {
        // Thousandths, rounded for each species.
        EXPECT_NEAR(stems, counted[year], rows[year] * 0.8 * 0.0005 + 1e-9) << year;
        all += stems;
    }
    EXPECT_GT(all, 10.0);
}

TEST(Regimes, AClearCutAboveTheTargetLowersItsProtectionAtOnce) {
    const ForestProject project;
    project.write("list.csv", dense_list(false));
    project.write("strip.csv",
                  "name,treatment,first_year,where,polygons\nstrip,clear_cut,1,polygons,areas.csv\n");
    project.write("areas.csv",
                  "wkt\n\"POLYGON ((1040 2020, 1120 2020, 1120 2080, 1040 2080, 1040 2020))\"\n");
    const Outcome outcome =
        call(project,
             "run scenario.ini --quiet --set trees.file=list.csv --set release.rocks=1000 "
             "--set run.years=2 --set \"regimes.list=none, strip.csv\"");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const config::Table rows = table(project, "out/tables/protection.csv");
    const auto of = [&](const std::string& regime, const std::string& year) {
        return protection(rows, regime, year).front();
    };
    EXPECT_EQ(of("none", "0"), of("strip", "0"));
    EXPECT_EQ(of("none", "1")[2], of("strip", "1")[2]);  // the same rocks over the bare slope
    EXPECT_LT(std::stod(of("strip", "1")[5]), std::stod(of("none", "1")[5]) - 10.0);

    const config::Table work = table(project, "out/tables/interventions.csv");
    ASSERT_EQ(work.rows(), 1U);
    EXPECT_EQ(work.text(0, "regime") + ' ' + work.text(0, "treatment"), "strip clear_cut");
    EXPECT_EQ(work.text(0, "year"), "1");
    EXPECT_GT(number(work, 0, "stems"), 100.0);
    const config::Table timber = table(project, "out/tables/timber.csv");
    double stems = 0.0;
    for (std::size_t row = 0; row < timber.rows(); ++row) {
        stems += number(timber, row, "stems");
    }
    EXPECT_EQ(stems, number(work, 0, "stems"));
    EXPECT_TRUE(fs::exists(project.file("out/tables/margins.csv")));
}

}  // namespace
}  // namespace coupling::years_rocks_test
