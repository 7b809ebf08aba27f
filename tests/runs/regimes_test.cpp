// What regimes of users do in whole runs, and what tables and pages say of their timber and money.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "coupling/results/figures/few_rocks.hpp"
#include "tests/runs/years.hpp"

namespace coupling::regimes_test {
namespace {

/// Two regimes of the user's own in two replicates, forest only.
constexpr const char* own_regimes =
    "run scenario.ini --quiet --set trees.file= --set stands.records=records.csv --set run.replicates=2 "
    "--set run.rockfall_every=0 --set climate.sequence=random ";

TEST(OwnRegimes, CountSalvagedTimberInEachTable) {
    const ForestProject project;
    project.write("salvage.csv",
                  "treatment,first_year,every_years,share,oldest_years,left_share\n"
                  "salvage,1,1,0.9,2,\nthin_below,2,,0.2,,0.5\n");
    const Outcome outcome = call(project, std::string{own_regimes} + "--set regimes.list=none,salvage.csv");
    ASSERT_EQ(outcome.code, 0) << outcome.err;

    const config::Table work = table(project, "out/tables/interventions.csv");
    std::map<std::string, double> taken_m3;
    std::map<std::string, double> left_m3;
    for (std::size_t row = 0; row < work.rows(); ++row) {
        taken_m3[work.text(row, "treatment")] += number(work, row, "taken_m3");
        left_m3[work.text(row, "treatment")] += number(work, row, "left_m3");
    }
    ASSERT_GT(taken_m3["salvage"], 0.0) << "trees die in four years";

    const config::Table years = table(project, "out/tables/work_by_year.csv");
    EXPECT_EQ(years.rows(), 2U * 2U * 5U) << "regimes, replicates, years: also those without work";
    double salvaged_m3pha = 0.0;
    double removed_m3pha = 0.0;
    for (std::size_t row = 0; row < years.rows(); ++row) {
        const double in = number(years, row, "felled_m3pha") + number(years, row, "salvaged_m3pha");
        const double out = number(years, row, "removed_m3pha") + number(years, row, "left_m3pha");
        EXPECT_NEAR(in, out, 2.1e-4) << "four figures of four decimals, row " << row;
        if (years.text(row, "regime") == "none") {
            EXPECT_EQ(in, 0.0);
        }
        salvaged_m3pha += number(years, row, "salvaged_m3pha");
        removed_m3pha += number(years, row, "removed_m3pha");
    }
    constexpr double area_ha = 0.8;
    EXPECT_NEAR(salvaged_m3pha, (taken_m3["salvage"] + left_m3["salvage"]) / area_ha,
                0.001 * static_cast<double>(years.rows()));
    EXPECT_NEAR(removed_m3pha, (taken_m3["salvage"] + taken_m3["thin_below"]) / area_ha,
                0.001 * static_cast<double>(years.rows()));

    // The mean of a regime over its replicates, and its paired difference.
    const config::Table means = table(project, "out/tables/regimes_by_year.csv");
    double sum_of_means = 0.0;
    for (std::size_t row = 0; row < means.rows(); ++row) {
        if (means.text(row, "quantity") == "salvaged_m3pha") {
            sum_of_means += number(means, row, "mean");
        }
    }
    EXPECT_NEAR(sum_of_means, salvaged_m3pha / 2.0, 0.0005 * 10.0);
    const std::string differences = project.read("out/tables/regime_differences.csv");
    for (const char* quantity :
         {"felled_m3pha", "salvaged_m3pha", "removed_m3pha", "left_m3pha", "contribution_margin_eur_pha"}) {
        EXPECT_NE(differences.find(quantity), std::string::npos) << quantity;
    }
    const std::string page = project.read("out/report.html");
    for (const char* words : {"Salvaged, m³/ha a year", "Removed from the forest, m³/ha a year",
                              "Contribution margin, EUR/ha a year"}) {
        EXPECT_NE(page.find(words), std::string::npos) << words;
    }
}

TEST(OwnRegimes, ActInTheirYearsAndWarnOfWhatNeverDid) {
    const ForestProject project;
    project.write("calendar.csv", "treatment,first_year,share\nthin_below,2003,0.2\n");
    project.write("of_run.csv", "treatment,first_year,share\nthin_below,3,0.2\n");
    project.write("never.csv", "name,treatment,from_age_years,share\nold,thin_below,400,0.2\n");
    const Outcome outcome =
        call(project, std::string{own_regimes} + "--set regimes.list=calendar.csv,of_run.csv,never.csv");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("regime never: old never came due"), std::string::npos) << outcome.err;
    const config::Table work = table(project, "out/tables/interventions.csv");
    std::map<std::string, double> felled_m3;
    for (std::size_t row = 0; row < work.rows(); ++row) {
        EXPECT_EQ(work.text(row, "year"), "3");
        felled_m3[work.text(row, "regime")] += number(work, row, "taken_m3");
    }
    EXPECT_GT(felled_m3["of_run"], 0.0);
    EXPECT_EQ(felled_m3["calendar"], felled_m3["of_run"]) << "2003 is year 3";
}

TEST(OwnRegimes, TieWorkToTheGapsJustCut) {
    const ForestProject project;
    project.write(
        "gaps.csv",
        "name,treatment,first_year,side_m,area_share,where,after_years,fence_years,species,plants_pha\n"
        "gaps,group_cut,1,20,0.2,,,,,\nfences,fence,,,,cuts_of:gaps,,10,,\n"
        "plants,plant,,,,cuts_of:gaps,1,,abal,2500\n");
    project.write("corridors.csv",
                  "treatment,first_year,where,lines,width_m\nclear_cut,1,corridors,lines.csv,12\n");
    // Straight down the middle of the forest, which lies in the east of the map.
    project.write("lines.csv", "name,wkt\na,\"LINESTRING (" + std::string{"1070 2005, 1070 2095"} + ")\"\n");
    const Outcome outcome =
        call(project, std::string{own_regimes} + "--set regimes.list=gaps.csv,corridors.csv");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const config::Table work = table(project, "out/tables/interventions.csv");
    std::map<std::string, double> area_ha;
    std::map<std::string, std::string> years;
    for (std::size_t row = 0; row < work.rows(); ++row) {
        if (work.text(row, "replicate") == "1") {
            const std::string& name = work.text(row, "intervention");
            area_ha[name] = number(work, row, "area_ha");
            years[name] += work.text(row, "year") + " ";
            EXPECT_EQ(work.text(row, "found_nothing"), "no") << name;
        }
    }
    EXPECT_GE(area_ha["gaps"], 0.04) << "holes of 20 m";
    EXPECT_LE(area_ha["gaps"], 0.16) << "on at most a fifth of 0.8 ha";
    EXPECT_EQ(area_ha["fences"], area_ha["gaps"]);
    EXPECT_EQ(area_ha["plants"], area_ha["gaps"]);
    EXPECT_EQ(years["gaps"], "1 ");
    EXPECT_EQ(years["fences"], "1 ");
    EXPECT_EQ(years["plants"], "2 ");
    EXPECT_NEAR(area_ha["clear_cut"], 0.108, 0.01) << "12 x 90 m";

    // Where trees were cut, as patches: at least all of the holes, at most those that touch them.
    const config::Table made = table(project, "out/tables/cuts_made.csv");
    ASSERT_EQ(made.rows(), 2U) << "a group cut and the corridors: fences and plants cut nothing";
    for (std::size_t row = 0; row < made.rows(); ++row) {
        EXPECT_EQ(made.text(row, "year"), "1");
        EXPECT_EQ(made.text(row, "wkt").rfind("MULTIPOLYGON (((", 0), 0U);
        const double cut_ha = area_ha[made.text(row, "intervention")];
        EXPECT_GT(number(made, row, "area_ha"), 0.5 * cut_ha) << "patches without a tree are not cut";
        EXPECT_LT(number(made, row, "area_ha"), 4.0 * cut_ha) << made.text(row, "intervention");
    }
    EXPECT_NE(project.read("out/results.gpkg").find("cuts_made"), std::string::npos);
    EXPECT_NE(project.read("out/report.html").find("<h3>Cuts made</h3>"), std::string::npos);
    const config::Table money = table(project, "out/tables/margins.csv");
    for (std::size_t row = 0; row < money.rows(); ++row) {
        if (money.text(row, "year") == "2") {
            // 2500 plants a hectare on a fifth of the forest, not on all of it.
            EXPECT_LT(number(money, row, "young_growth_cost_eur_pha"), 0.25 * 2500.0 * 5.0);
        }
    }
}

TEST(OwnRegimes, OfAWholeStudyAreTakenWithTheInventoryOfTheirStands) {
    const ForestProject project;
    ASSERT_EQ(call(project, "init study --example regimes-small").code, 0);
    for (const auto& file :
         std::filesystem::directory_iterator{BANNWALD_SOURCE_DIR "/tests/runs/regime_study"}) {
        std::filesystem::copy_file(file.path(), project.file("study") / file.path().filename(),
                                   std::filesystem::copy_options::overwrite_existing);
    }
    const Outcome outcome = call(project, "check study/scenario.ini");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("4 regimes x 2 climates x 20 replicates, 2025 to 2064"), std::string::npos)
        << outcome.out;
    EXPECT_NE(outcome.out.find("target_profile profile.csv"), std::string::npos) << "columns are apart";
    EXPECT_NE(outcome.err.find("of Abies alba browsed"), std::string::npos) << outcome.err;
}

TEST(OwnRegimes, CountSalvagedTimberInComparisons) {
    const ForestProject project;
    project.write("salvage.csv", "treatment,first_year,every_years,share\nsalvage,1,1,0.9\n");
    for (const std::string folder : {"a", "b"}) {
        const Outcome outcome =
            call(project, std::string{own_regimes} + "--set regimes.list=salvage.csv --out " + folder +
                              " --seed " + (folder == "a" ? "1" : "2"));
        ASSERT_EQ(outcome.code, 0) << outcome.err;
    }
    ASSERT_EQ(call(project, "compare a b --quiet --out c").code, 0);
    const config::Table compared = table(project, "c/compare.csv");
    std::map<std::string, double> a;
    for (std::size_t row = 0; row < compared.rows(); ++row) {
        if (compared.text(row, "run") == "A" && compared.text(row, "when") == "mean over years") {
            a[compared.text(row, "quantity")] = number(compared, row, "value");
        }
    }
    EXPECT_GT(a["salvaged_m3pha"], 0.0);
    EXPECT_EQ(a["felled_m3pha"], 0.0);
    EXPECT_NEAR(a["removed_m3pha"] + a["left_m3pha"], a["salvaged_m3pha"], 0.002) << "stumps stay";
    EXPECT_NE(a["contribution_margin_eur_pha"], 0.0);
}

TEST(OwnRegimes, HaveTheSameProtectionOverYearsInARunAndInAComparison) {
    const ForestProject project;
    for (const std::string folder : {"a", "b"}) {
        const Outcome outcome = call(project, std::string{four_members} + "--out " + folder + " --seed " +
                                                  (folder == "a" ? "1" : "2"));
        ASSERT_EQ(outcome.code, 0) << outcome.err;
    }
    ASSERT_EQ(call(project, "compare a b --quiet --out c").code, 0);
    using At = std::pair<std::string, std::string>;
    std::map<At, std::pair<double, double>> of_run;
    const config::Table by_year = table(project, "a/tables/regimes_by_year.csv");
    const config::Table protection = table(project, "a/tables/protection.csv");
    const auto rocks_bare = [&](const std::string& regime, const std::string& target,
                                const std::string& year) {
        double sum = 0.0;
        for (std::size_t row = 0; row < protection.rows(); ++row) {
            if (protection.text(row, "regime") == regime && protection.text(row, "target_id") == target &&
                protection.text(row, "year") == year) {
                sum += number(protection, row, "reached_bare");
            }
        }
        return sum;
    };
    for (std::size_t row = 0; row < by_year.rows(); ++row) {
        const At at{by_year.text(row, "regime"), by_year.text(row, "target_id")};
        if (by_year.text(row, "quantity") == "protection_percent" &&
            rocks_bare(at.first, at.second, by_year.text(row, "year")) >= least_arrivals_for_protection) {
            of_run[at].first += number(by_year, row, "mean");
            of_run[at].second += 1.0;
        }
    }
    const config::Table compared = table(project, "c/compare.csv");
    std::size_t seen = 0;
    for (std::size_t row = 0; row < compared.rows(); ++row) {
        if (compared.text(row, "run") == "A" && compared.text(row, "quantity") == "protection_percent" &&
            compared.text(row, "when") == "mean over years" && !compared.text(row, "value").empty()) {
            const auto& [sum, years] =
                of_run.at({compared.text(row, "regime"), compared.text(row, "target_id")});
            EXPECT_NEAR(number(compared, row, "value"), sum / years, 2e-3) << "to three places each";
            ++seen;
        }
    }
    EXPECT_GT(seen, 0U);
}

/// Figures of the first run in a table of `compare`, by name and time.
std::map<std::pair<std::string, std::string>, double> figures_of_a(const config::Table& compared) {
    std::map<std::pair<std::string, std::string>, double> figures;
    for (std::size_t row = 0; row < compared.rows(); ++row) {
        if (compared.text(row, "run") == "A" && !compared.text(row, "value").empty()) {
            figures[{compared.text(row, "quantity"), compared.text(row, "when")}] =
                number(compared, row, "value");
        }
    }
    return figures;
}

TEST(OwnRegimes, StandBesideEachOtherWithSpeciesDeathsAndDeadWood) {
    const ForestProject project;
    for (const std::string folder : {"a", "b"}) {
        const Outcome outcome = call(project, std::string{own_regimes} + "--set run.years=40 --out " +
                                                  folder + " --seed " + (folder == "a" ? "1" : "2"));
        ASSERT_EQ(outcome.code, 0) << outcome.err;
    }
    const Outcome screen = call(project, "compare a b --out c");
    ASSERT_EQ(screen.code, 0) << screen.err;
    const auto a = figures_of_a(table(project, "c/compare.csv"));

    const config::Table stands = table(project, "a/tables/stands.csv");
    const std::string last = stands.text(stands.rows() - 1, "year");
    double volume_m3pha = 0.0;
    double members = 0.0;
    for (std::size_t row = 0; row < stands.rows(); ++row) {
        if (stands.text(row, "stand") == "all" && stands.text(row, "species") == "all" &&
            stands.text(row, "year") == last) {
            volume_m3pha += number(stands, row, "volume_m3pha");
            members += 1.0;
        }
    }
    EXPECT_NEAR(a.at({"volume_m3pha", "last year"}), volume_m3pha / members, 1e-3);
    double of_species_m3pha = 0.0;
    for (const auto& [name, value] : a) {
        if (name.second == "last year" && name.first.starts_with("volume_") && name.first != "volume_m3pha") {
            of_species_m3pha += value;
        }
    }
    EXPECT_NEAR(of_species_m3pha, volume_m3pha / members, 0.1) << "rounded species by species";

    const config::Table deaths = table(project, "a/tables/mortality.csv");
    double died_m3 = 0.0;
    for (std::size_t row = 0; row < deaths.rows(); ++row) {
        died_m3 += deaths.text(row, "cause") == "background" ? number(deaths, row, "volume_m3pha") : 0.0;
    }
    const auto died = a.find({"died_background_m3pha", "mean over years"});
    EXPECT_NEAR(died == a.end() ? 0.0 : died->second, died_m3 / members / std::stod(last), 1e-3);
    EXPECT_TRUE(a.contains({"snags_m3pha", "mean over years"}));

    // Nobody works: the table for scripts says so, the screen does not fill with zeros.
    EXPECT_EQ(a.at({"felled_m3pha", "mean over years"}), 0.0);
    EXPECT_EQ(screen.out.find("felled_m3pha"), std::string::npos) << screen.out;
    EXPECT_NE(screen.out.find("volume_m3pha, last"), std::string::npos) << screen.out;
}

TEST(DecisionOfARun, StandsInTableSummaryPageAndClosingLines) {
    const ForestProject project;
    std::string loud{four_members};
    loud.erase(loud.find("--quiet "), 8);
    const Outcome outcome =
        call(project, loud + "--set decision.protection_at_least=20 --set decision.probability=0.7");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const config::Table decision = table(project, "out/tables/decision.csv");
    ASSERT_EQ(decision.rows(), 2U * table(project, "targets.csv").rows())
        << "a row for each regime and target";
    for (std::size_t row = 0; row < decision.rows(); ++row) {
        EXPECT_EQ(number(decision, row, "protection_at_least_percent"), 20.0);
        EXPECT_EQ(number(decision, row, "probability"), 0.7);
        EXPECT_NE(decision.text(row, "keeps"), "yes") << "two replicates prove nothing";
        EXPECT_EQ(number(decision, row, "first_year"), 2.0)
            << "rocks fall every second year; the start is none";
    }
    const std::string asked = "protection of at least 20 % in all years with rocks (2 to 4)";
    EXPECT_NE(project.read("out/report.html").find(asked), std::string::npos);
    EXPECT_NE(project.read("out/summary.json").find(asked), std::string::npos);
    EXPECT_NE(outcome.out.find("protection of at least 20 %"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("tables/decision.csv"), std::string::npos) << outcome.out;
}

TEST(TargetProfiles, ComeToTheShareOfReplicatesInEachStatus) {
    const ForestProject project;
    project.write("profile.csv",
                  "stand,site_type,hazard,criterion,minimal,ideal\n"
                  "all,55,rockfall,stems_from_12_cm,1,100000\n"
                  "7,55,rockfall,gap_m,100000,100000\n"
                  "all,55,rockfall,cover_percent,101,\n"
                  "8,55,rockfall,cover_percent,0,0\n"
                  "all,55,avalanche,mixture_FASY_percent,0-100,\n");
    const Outcome outcome =
        call(project, std::string{four_members} + "--set stands.target_profile=profile.csv");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const config::Table nais = table(project, "out/tables/nais.csv");
    std::map<std::string, double> share;
    for (std::size_t row = 0; row < nais.rows(); ++row) {
        if (nais.text(row, "regime") == "none" && nais.text(row, "year") == "0") {
            share[nais.text(row, "stand") + " " + nais.text(row, "hazard") + " " +
                  nais.text(row, "criterion") + " " + nais.text(row, "status")] =
                number(nais, row, "share_of_replicates");
        }
    }
    EXPECT_EQ(share["7 rockfall stems_from_12_cm minimal"], 1.0);
    EXPECT_EQ(share["7 rockfall gap_m ideal"], 1.0);
    EXPECT_FALSE(share.contains("8 rockfall gap_m ideal")) << "asked of stand 7 alone";
    EXPECT_EQ(share["7 rockfall cover_percent below"], 1.0);
    EXPECT_EQ(share["8 rockfall cover_percent ideal"], 1.0) << "its own row replaces that of all";
    EXPECT_EQ(share["7 rockfall all below"], 1.0) << "the worst of all";
    EXPECT_EQ(share["8 rockfall all minimal"], 1.0);
    EXPECT_EQ(share["8 avalanche mixture_FASY_percent minimal"], 1.0);
    const std::string page = project.read("out/report.html");
    EXPECT_NE(page.find("class=\"nais nais-below\""), std::string::npos);
}

TEST(InterventionAreas, AreATableALayerAndAPageBeforeTheRun) {
    const ForestProject project;
    project.write("strips.csv",
                  "name,treatment,first_year,every_years,where,width_m,angle_deg,entries\n"
                  "cut,clear_cut,1,5,strips,20,0,2\n");
    const std::string settings =
        "--set trees.file= --set stands.records=records.csv --set regimes.list=none,strips.csv --set "
        "run.rockfall_every=0 --set run.replicates=1 --set climate.sequence=random ";
    const Outcome checked = call(project, "check scenario.ini --page plan.html " + settings);
    ASSERT_EQ(checked.code, 0) << checked.err;
    const std::string plan = project.read("plan.html");
    EXPECT_NE(plan.find("clip-path=\"url(#sheet)\""), std::string::npos);
    EXPECT_NE(plan.find("strips"), std::string::npos);
    EXPECT_NE(plan.find("turn 1: in 2001; turn 2: not in the years of the run"), std::string::npos);
    EXPECT_NE(plan.find(">2001</text>"), std::string::npos) << "in the areas themselves";
    EXPECT_EQ(call(project, "check scenario.ini --page plan.html " + settings).code, 2) << "it is there";
    EXPECT_FALSE(std::filesystem::exists(project.file("out"))) << "check writes nothing else";

    ASSERT_EQ(call(project, "run scenario.ini --quiet " + settings).code, 0);
    const config::Table areas = table(project, "out/tables/intervention_areas.csv");
    double forest_ha = 0.0;
    for (std::size_t row = 0; row < areas.rows(); ++row) {
        EXPECT_EQ(areas.text(row, "intervention"), "cut");
        EXPECT_EQ(areas.text(row, "wkt").rfind("MULTIPOLYGON (((", 0), 0U);
        EXPECT_EQ(areas.text(row, "first_year"), areas.text(row, "turn") == "1" ? "1" : "6");
        EXPECT_EQ(areas.text(row, "years"), areas.text(row, "turn") == "1" ? "2001" : "") << "within the run";
        EXPECT_EQ(areas.text(row, "condition"), "");
        forest_ha += number(areas, row, "area_ha");
    }
    EXPECT_NEAR(forest_ha, 0.8, 0.01) << "strips cover the forest";
    EXPECT_NE(project.read("out/results.gpkg").find("intervention_areas"), std::string::npos);
}

}  // namespace
}  // namespace coupling::regimes_test
