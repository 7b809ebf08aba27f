#include "coupling/assessments/compare/runs/forest_over_years.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <tuple>

#include "coupling/assessments/compare/runs/side_by_side.hpp"
#include "tests/coupling/inputs/sample_project.hpp"

namespace coupling::compare::forest_over_years_test {
namespace {

/// Tables of a finished run of two years, two regimes and two replicates.
struct Tables {
    /// stand rows "regime,replicate,year,species,basal area,volume".
    std::string stands =
        "none,1,0,all,20,100\nnone,1,0,PIAB,15,70\nnone,1,0,FASY,5,30\n"
        "none,1,1,all,22,110\nnone,1,1,PIAB,16,80\nnone,1,1,FASY,6,30\n"
        "none,1,2,all,24,120\nnone,1,2,PIAB,24,120\n"
        "none,2,0,all,20,100\nnone,2,0,PIAB,15,70\nnone,2,0,FASY,5,30\n"
        "none,2,1,all,24,130\nnone,2,1,PIAB,18,100\nnone,2,1,FASY,6,30\n"
        "none,2,2,all,28,160\nnone,2,2,PIAB,21,130\nnone,2,2,FASY,7,30\n"
        "cut,1,0,all,20,100\ncut,1,2,all,10,50\ncut,2,0,all,20,100\ncut,2,2,all,10,50\n";
    std::string deaths =
        "none,1,1,background,PIAB,3\nnone,1,2,background,FASY,30\nnone,2,1,background,PIAB,1\n"
        "none,1,2,wind,PIAB,8\ncut,1,1,felled,PIAB,60\n";

    [[nodiscard]] FinishedRun run() const {
        const SampleProject project;
        std::filesystem::create_directory(project.file("tables"));
        const auto write = [&](const std::string& name, const std::string& head, const std::string& rows) {
            project.write("tables/" + name, head + "\n" + rows);
        };
        std::string all = stands;
        for (std::size_t at = 0; at < all.size(); at = all.find('\n', at) + 1) {
            std::size_t field = at;
            for (int i = 0; i < 3; ++i) {
                field = all.find(',', field) + 1;
            }
            all.insert(field, "all,");
        }
        write("stands.csv", "regime,replicate,year,stand,species,basal_area_m2pha,volume_m3pha", all);
        write("forest_years.csv",
              "regime,replicate,year,snags_m3pha,logs_m3pha,saplings_pha,ingrowth_stems_pha",
              "none,1,0,0,0,0,\nnone,1,1,3,1,900,10\nnone,1,2,6,2,900,20\n"
              "none,2,0,0,0,0,\nnone,2,1,3,1,900,10\nnone,2,2,6,2,900,20\n");
        write("mortality.csv", "regime,replicate,year,cause,species,volume_m3pha", deaths);
        write("work_by_year.csv",
              "regime,replicate,year,felled_m3pha,salvaged_m3pha,removed_m3pha,left_m3pha,"
              "contribution_margin_eur_pha",
              "cut,1,0,60,0,50,10,100\ncut,1,1,0,0,0,0,0\ncut,2,0,50,0,40,10,-20\n");
        FinishedRun run;
        run.folder = "out";
        run.summary.kind = "years";
        run.summary.years = 2;
        run.summary.replicates = 2;
        add_forest_over_years(project.folder(), 2, run.figures);
        return run;
    }
};

const Figure& figure(const FinishedRun& run, const std::string& regime, const std::string& quantity,
                     const std::string& when) {
    const auto found = std::find_if(run.figures.begin(), run.figures.end(), [&](const Figure& each) {
        return each.key == FigureKey{"", regime, quantity, when, each.key.climate};
    });
    EXPECT_NE(found, run.figures.end()) << regime << ' ' << quantity << ' ' << when;
    return *found;
}

TEST(ForestOverYears, HasMeansAndTheLastYear) {
    const FinishedRun run = Tables{}.run();
    EXPECT_DOUBLE_EQ(figure(run, "none", "volume_m3pha", over_years).value, 120.0) << "of 110 and 130";
    EXPECT_DOUBLE_EQ(figure(run, "none", "volume_m3pha", last_year).value, 140.0);
    EXPECT_DOUBLE_EQ(figure(run, "cut", "basal_area_m2pha", last_year).value, 10.0);
    EXPECT_DOUBLE_EQ(figure(run, "none", "snags_m3pha", over_years).value, 3.0);
    EXPECT_DOUBLE_EQ(figure(run, "none", "saplings_pha", over_years).value, 600.0);
    EXPECT_DOUBLE_EQ(figure(run, "none", "ingrowth_stems_pha", over_years).value, 15.0)
        << "of years 1 and 2: the start has none";
    EXPECT_FALSE(figure(run, "none", "volume_m3pha", last_year).is_part);
}

TEST(ForestOverYears, CountsWhatAMemberLacksAsNothing) {
    const FinishedRun run = Tables{}.run();
    // Beech is gone from one replicate, and from the other regime as far as tables say.
    EXPECT_DOUBLE_EQ(figure(run, "none", "volume_FASY_m3pha", last_year).value, 15.0);
    EXPECT_DOUBLE_EQ(figure(run, "none", "volume_PIAB_m3pha", last_year).value, 125.0);
    EXPECT_DOUBLE_EQ(figure(run, "cut", "volume_FASY_m3pha", last_year).value, 0.0);
    // A year: 33 and 1 m3 over two years; wind took 8 m3 from one of two replicates.
    EXPECT_DOUBLE_EQ(figure(run, "none", "died_background_m3pha", over_years).value, 8.5);
    EXPECT_DOUBLE_EQ(figure(run, "none", "died_wind_m3pha", over_years).value, 2.0);
    EXPECT_DOUBLE_EQ(figure(run, "cut", "died_wind_m3pha", over_years).value, 0.0);
    // Felling belongs to work.
    EXPECT_DOUBLE_EQ(figure(run, "cut", "felled_m3pha", over_years).value, 27.5);
    EXPECT_DOUBLE_EQ(figure(run, "cut", "contribution_margin_eur_pha", over_years).value, 20.0);
    for (const Figure& each : run.figures) {
        EXPECT_NE(each.key.quantity, "died_felled_m3pha");
    }
}

TEST(ForestOverYears, StandsBesideARunWithoutASpeciesOrACause) {
    Tables calm;
    calm.deaths.erase(calm.deaths.find("none,1,2,wind"), std::string{"none,1,2,wind,PIAB,8\n"}.size());
    const std::vector<FinishedRun> runs{calm.run(), Tables{}.run()};
    const SideBySide comparison = side_by_side(runs);
    const auto line = [&](const std::string& regime, const std::string& quantity) {
        return std::find_if(comparison.lines.begin(), comparison.lines.end(), [&](const Line& each) {
            return each.key.regime == regime && each.key.quantity == quantity;
        });
    };
    const auto wind = line("none", "died_wind_m3pha");
    ASSERT_NE(wind, comparison.lines.end());
    ASSERT_TRUE(wind->figures[0]);
    EXPECT_EQ(wind->figures[0]->value, 0.0) << "no storm, not: unknown";
    ASSERT_TRUE(wind->differences[1]);
    EXPECT_DOUBLE_EQ(wind->differences[1]->value, 2.0);
    EXPECT_TRUE(wind->differences[1]->has_interval()) << "replicates are pairs";
    EXPECT_EQ(std::next(line("none", "died_background_m3pha")), wind) << "beside the other causes";
    EXPECT_TRUE(is_nothing_everywhere(*line("cut", "died_wind_m3pha")));
    EXPECT_FALSE(is_nothing_everywhere(*wind));
}

TEST(ForestOverYears, OfADeadForestIsShown) {
    Tables dead;
    dead.stands = "none,1,0,all,20,100\nnone,1,2,all,0,0\n";
    const std::vector<FinishedRun> runs{dead.run(), dead.run()};
    const SideBySide comparison = side_by_side(runs);
    const auto last = std::find_if(comparison.lines.begin(), comparison.lines.end(), [](const Line& line) {
        return line.key.when == last_year && line.key.quantity == "volume_m3pha";
    });
    ASSERT_NE(last, comparison.lines.end());
    EXPECT_FALSE(is_nothing_everywhere(*last));
}

}  // namespace
}  // namespace coupling::compare::forest_over_years_test
