#include "validation/engine/forest_cases/succession_trial/comparison.hpp"

#include <gtest/gtest.h>

#include <iostream>
#include <map>
#include <sstream>

#include "tests/validation/forest_cases/shipped_case.hpp"

namespace coupling::validation::forest_cases::succession_trial::comparison_test {
namespace {

using forest::LapseRates;
using forest::read_climate_of_one_place;
using forest::SpeciesId;
using forest::SpeciesTable;
using forest::YearWindow;

config::Table shipped(const std::string& file) {
    return shipped_table("forest_belts", file);
}

config::Table table_of(const std::string& text) {
    std::istringstream in{text};
    return config::Table::read(in, "made up");
}

SuccessionCase shipped_case(const SpeciesTable& species) {
    config::Warnings warnings;
    return {read_succession_sites(shipped("sites.csv")),
            read_species_groups(shipped("expected.csv"), species),
            read_climate_of_one_place(shipped("climate.csv"), warnings), LapseRates::shipped(),
            shipped_parameters("forest_belts", CaseKind::forest_belts)};
}

const SuccessionSite& site_named(const SuccessionCase& data, const std::string& name) {
    for (const SuccessionSite& site : data.sites) {
        if (site.name == name) {
            return site;
        }
    }
    throw std::runtime_error("no site " + name);
}

/// A third of a hectare and 600 years instead of a whole one and 800.
SuccessionTrial small_trial_at(const SuccessionCase& data, const std::string& site) {
    SuccessionTrial trial = trial_at(data, site_named(data, site));
    trial.side_patches = 6;
    trial.years = 600;
    return trial;
}

std::map<std::string, double> figures_of_years(const SuccessionCase& data,
                                               const std::vector<SuccessionRun>& runs, YearWindow years) {
    std::map<std::string, double> figures;
    for (const auto& [name, value] : succession_figures(data, runs, years)) {
        figures[name] = value;
    }
    return figures;
}

TEST(GrowSuccession, BringsTheBeltsInTheirOrder) {
    const SpeciesTable species = SpeciesTable::shipped();
    SuccessionCase data = shipped_case(species);
    data.groups.push_back({"e0500", "tolerant", {*species.find("fasy"), *species.find("abal")}});
    data.groups.push_back({"e0500", "spruce", {*species.find("piab")}});
    data.groups.push_back({"e1500", "tolerant", {*species.find("fasy"), *species.find("abal")}});
    std::vector<SuccessionRun> runs;
    for (const std::string site : {"e0500", "e1500", "e2000"}) {
        SuccessionTrial trial = small_trial_at(data, site);
        trial.years = 700;
        runs.push_back({site, grow_succession(trial, species, {1, 0})});
    }
    // The larches that settled first live to 600 years; the case judges the years 600 to 800, too.
    std::map<std::string, double> figures = figures_of_years(data, runs, {600, 700});
    for (const auto& [name, value] : figures) {
        std::cout << name << ' ' << value << '\n';
    }
    EXPECT_GT(figures["margin:tolerant:e0500"], 0.0);
    EXPECT_LT(figures["share:spruce:e0500"], 0.33);
    EXPECT_GT(figures["margin:spruce:e1500"], 0.0);
    EXPECT_LT(figures["share:tolerant:e1500"], 0.3);
    // On this small plot only the order is asked for; the case judges the shares after 600 years.
    EXPECT_GT(figures["share:larch_cembra:e2000"], figures["share:larch:e1500"] + 0.1);
    EXPECT_LT(figures["share:spruce:e2000"], figures["share:spruce:e1500"]);
    EXPECT_GT(figures["biomass_tpha:e0500"], figures["biomass_tpha:e1500"]);
    // The cembras that settled first still stand at 2000 m, so its biomass is that of one generation.
    EXPECT_GT(figures["biomass_tpha:e0500"], figures["biomass_tpha:e2000"]);
    EXPECT_GT(figures["biomass_tpha:e2000"], 50.0);
}

TEST(GrowSuccession, LetsPioneersGiveWayToTolerantSpecies) {
    const SpeciesTable species = SpeciesTable::shipped();
    SuccessionCase data = shipped_case(species);
    data.groups = {{"e0750", "tolerant", {*species.find("fasy"), *species.find("abal")}},
                   {"e0750",
                    "pioneers",
                    {*species.find("bepe"), *species.find("soau"), *species.find("lade"),
                     *species.find("pisy"), *species.find("frex")}}};
    const std::vector<SuccessionRun> runs{
        {"e0750", grow_succession(small_trial_at(data, "e0750"), species, {1, 0})}};
    std::map<std::string, double> early = figures_of_years(data, runs, {20, 40});
    std::map<std::string, double> late = figures_of_years(data, runs, {500, 600});
    EXPECT_GT(early["share:pioneers:e0750"], 0.2);
    EXPECT_LT(late["share:pioneers:e0750"], 0.15);  // larch grows old
    EXPECT_GT(late["share:tolerant:e0750"], early["share:tolerant:e0750"]);
}

TEST(GrowSuccession, GivesTheSameBytesForTheSameKeyAndOthersForAnother) {
    const SpeciesTable species = SpeciesTable::shipped();
    const SuccessionCase data = shipped_case(species);
    SuccessionTrial trial = small_trial_at(data, "e1000");
    trial.side_patches = 3;
    trial.years = 40;
    const std::vector<SuccessionState> once = grow_succession(trial, species, {1, 0});
    const std::vector<SuccessionState> again = grow_succession(trial, species, {1, 0});
    ASSERT_EQ(once.size(), 4U);
    EXPECT_EQ(once.back().year, 40);
    EXPECT_EQ(once.back().volume_m3pha, again.back().volume_m3pha);
    EXPECT_NE(once.back().volume_m3pha, grow_succession(trial, species, {1, 1}).back().volume_m3pha);
}

SuccessionState state_with(int year, std::vector<double> biomass_tpha, double volume_m3pha = 0.0) {
    SuccessionState state;
    state.year = year;
    state.volume_m3pha = volume_m3pha;
    for (const double one : biomass_tpha) {
        state.species.push_back({.biomass_tpha = one});
    }
    return state;
}

TEST(SuccessionFigures, AreMeansOverYearsAndReplicates) {
    SuccessionCase data;
    data.sites = {{"here", 500.0, {}}, {"elsewhere", 500.0, {}}};
    data.groups = {{"here", "first_two", {SpeciesId{0}, SpeciesId{1}}}};
    const std::vector<SuccessionRun> runs{
        {"here", {state_with(290, {900.0, 0.0, 0.0}), state_with(300, {10.0, 20.0, 70.0}, 410.0)}},
        {"here", {state_with(300, {30.0, 20.0, 50.0}, 430.0), state_with(401, {900.0, 0.0, 0.0})}}};
    const auto in_order = succession_figures(data, runs, {300, 400});
    const std::map<std::string, double> figures(in_order.begin(), in_order.end());
    EXPECT_EQ(figures.size(), in_order.size()) << "each figure once";
    EXPECT_EQ(figures.at("biomass_tpha:here"), 100.0);
    EXPECT_EQ(figures.at("volume_m3pha:here"), (410.0 + 430.0) / 2.0);
    EXPECT_DOUBLE_EQ(figures.at("share:first_two:here"), 0.4);
    EXPECT_DOUBLE_EQ(figures.at("margin:first_two:here"), 0.4 - 0.6);
    for (const auto& [name, value] : figures) {
        EXPECT_TRUE(name.ends_with(":here")) << "nothing of a site without runs: " << name << " " << value;
    }
}

TEST(SuccessionFigures, CountTheReplicatesThatKeepASpecies) {
    SuccessionCase data;
    data.sites = {{"here", 500.0, {}}};
    data.natives = {{"here", "a", {SpeciesId{0}}}, {"here", "b", {SpeciesId{1}}}};
    SuccessionState both = state_with(300, {10.0, 20.0});
    both.species[0].stems_10cm_pha = 3.0;
    both.species[1].stems_10cm_pha = 1.0;
    SuccessionState one = both;
    one.species[1].stems_10cm_pha = 0.0;
    both.species[1].stems_pha = 4.0;
    one.species[1].stems_pha = 4.0;
    const std::vector<SuccessionRun> runs{{"here", {both, one}}, {"here", {one, both}}, {"here", {both}}};
    const auto in_order = succession_figures(data, runs, {300, 400});
    const std::map<std::string, double> figures(in_order.begin(), in_order.end());
    EXPECT_EQ(figures.at("kept:a:here"), 3.0);
    EXPECT_EQ(figures.at("kept:b:here"), 2.0) << "at the end";
    EXPECT_EQ(figures.at("alive:b:here"), 3.0) << "thinner ones count, too";
}

TEST(GrowSuccession, BeginsDisturbancesInTheirYear) {
    const SpeciesTable species = SpeciesTable::shipped();
    const SuccessionCase data = shipped_case(species);
    SuccessionTrial trial = small_trial_at(data, "e1000");
    trial.side_patches = 3;
    trial.years = 80;
    const std::vector<SuccessionState> calm = grow_succession(trial, species, {1, 0});
    trial.parameters.disturbance.wind = true;
    trial.parameters.disturbance.storm_interval_years = 1.0;
    trial.disturbed_from_year = 61;
    const std::vector<SuccessionState> stormy = grow_succession(trial, species, {1, 0});
    ASSERT_EQ(stormy.size(), 8U);
    const std::size_t wind = index_of(forest::Cause::wind);
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_EQ(calm[i].lost_m3pha[wind], 0.0);
        EXPECT_EQ(stormy[i].lost_m3pha[wind] > 0.0, i >= 6) << stormy[i].year;
    }
    EXPECT_NEAR(stormy[5].dead_wood_by_class_m3pha[0], calm[5].dead_wood_by_class_m3pha[0], 1.0);
}

TEST(SuccessionFigures, AreZeroOnBareGround) {
    SuccessionCase data;
    data.sites = {{"here", 500.0, {}}};
    data.groups = {{"here", "first", {SpeciesId{0}}}};
    for (const auto& [name, value] : succession_figures(
             data, std::vector<SuccessionRun>{{"here", {state_with(300, {0.0, 0.0})}}}, {300, 400})) {
        EXPECT_EQ(value, 0.0) << name;
    }
}

TEST(ReadSpeciesGroups, NamesTheSpeciesItDoesNotKnow) {
    const config::Table table = table_of("site,group,species\ne1,a,piab abel fasi\n");
    try {
        static_cast<void>(read_species_groups(table, SpeciesTable::shipped()));
        FAIL();
    } catch (const config::InputError& error) {
        EXPECT_EQ(error.problems().size(), 2U);
    }
}

TEST(ReadSuccessionSites, TellsAllThatIsWrong) {
    const config::Table table = table_of(
        "site,elevation_m,fertility,water_mm,nitrogen_kg_ha_yr,ph\na,500,2,120,60,5\nb,x,0.5,120,60,5\n");
    try {
        static_cast<void>(read_succession_sites(table));
        FAIL();
    } catch (const config::InputError& error) {
        EXPECT_EQ(error.problems().size(), 2U);
    }
}

TEST(TrialAt, ChangesTheClimateAsTheSiteSays) {
    SuccessionCase data = shipped_case(SpeciesTable::shipped());
    const SuccessionSite as_given = site_named(data, "e1000");
    SuccessionSite changed = as_given;
    changed.warmer_k = 4.0;
    changed.rain_factor = 0.7;
    const forest::ClimateMonth before = trial_at(data, as_given).climate.years[3].months[6];
    const forest::ClimateMonth after = trial_at(data, changed).climate.years[3].months[6];
    EXPECT_NEAR(after.tave_degc, before.tave_degc + 4.0, 1e-9);
    EXPECT_NEAR(after.prec_mm, 0.7 * before.prec_mm, 1e-9);
}

TEST(ReadSuccessionSites, TakesAnotherClimateWhereItIsGiven) {
    const std::vector<SuccessionSite> sites = read_succession_sites(
        table_of("site,elevation_m,fertility,water_mm,nitrogen_kg_ha_yr,ph,warmer_k,rain_factor\n"
                 "a,500,0.7,120,60,5,4,0.7\n"));
    EXPECT_EQ(sites[0].warmer_k, 4.0);
    EXPECT_EQ(sites[0].rain_factor, 0.7);
    EXPECT_THROW(static_cast<void>(read_succession_sites(table_of(
                     "site,elevation_m,fertility,water_mm,nitrogen_kg_ha_yr,ph,warmer_k,rain_factor\n"
                     "a,500,0.7,120,60,5,40,-1\n"))),
                 config::InputError);
}

TEST(TrialAt, AsksForTheElevationOfTheClimate) {
    SuccessionCase data = shipped_case(SpeciesTable::shipped());
    const SuccessionTrial high = trial_at(data, site_named(data, "e2000"));
    EXPECT_LT(high.climate.years[0].months[6].tave_degc, data.climate.years[0].months[6].tave_degc - 8.0);
    data.climate.elevation_m.reset();
    EXPECT_THROW(static_cast<void>(trial_at(data, data.sites[0])), config::InputError);
}

}  // namespace
}  // namespace coupling::validation::forest_cases::succession_trial::comparison_test
