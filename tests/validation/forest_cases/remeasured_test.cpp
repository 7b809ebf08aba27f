// The case kind "trees measured twice", on a synthetic plot.
#include <gtest/gtest.h>

#include <cmath>
#include <iomanip>

#include "tests/validation/forest_cases/remeasured/synthetic_plot.hpp"
#include "validation/engine/forest_cases/remeasured/trial.hpp"
#include "validation/engine/forest_cases/shared/comparison.hpp"

namespace coupling::validation::forest_cases::remeasured_test {
namespace {

using remeasured::synthetic_case;

Comparison comparison_of(const CaseFiles& files, std::uint64_t replicates) {
    RemeasuredSettings settings;
    settings.replicates = replicates;
    return read_remeasured(files, settings, {});
}

std::map<std::string, double> values_of(const CaseFiles& files, std::uint64_t replicates, int threads = 1) {
    return comparison_of(files, replicates).run({threads, [](std::uint64_t) {}}).values;
}

TEST(RemeasuredCase, ObservesGrowthDeathsAndIngrowth) {
    const Comparison comparison = comparison_of(synthetic_case(), 1);
    const auto observed = [&](const std::string& name) { return comparison.references.at(name).value; };
    EXPECT_NEAR(observed("increment_cm:all:all"), 0.2, 1e-12);
    EXPECT_NEAR(observed("increment_cm:piab:20cm"), 0.2, 1e-12);
    EXPECT_NEAR(observed("survivors:all:all"), 33.0 / 35.0, 1e-12) << "the felled one does not count";
    EXPECT_NEAR(observed("survivors:fasy:all"), 17.0 / 18.0, 1e-12);
    EXPECT_NEAR(observed("survivors:piab:all"), 16.0 / 17.0, 1e-12);
    EXPECT_NEAR(observed("ingrowth_pha:abal"), 1.0 / 0.09, 1e-9);
    EXPECT_NEAR(observed("stems_pha:all"), 34.0 / 0.09, 1e-9);
}

TEST(RemeasuredCase, GivesEachFigureThatItNames) {
    const Comparison comparison = comparison_of(synthetic_case(), 2);
    const std::map<std::string, double> values = values_of(synthetic_case(), 2, 2);
    EXPECT_EQ(values, values_of(synthetic_case(), 2)) << "any number of threads";
    for (const Figure& figure : comparison.figures) {
        ASSERT_TRUE(values.contains(figure.name)) << figure.name;
        EXPECT_TRUE(std::isfinite(values.at(figure.name))) << figure.name;
    }
    EXPECT_GT(values.at("increment_cm:all:all"), 0.02);
    EXPECT_LT(values.at("increment_cm:all:all"), 1.5);
}

TEST(RemeasuredCase, AgreesWithAPlotThatTheModelGrewItself) {
    CaseFiles files = synthetic_case();
    const forest::SpeciesTable species = forest::SpeciesTable::shipped();
    const auto table = [&](const char* name) { return table_of(files, name); };
    config::Warnings warnings;
    const remeasured::MeasuredStand stand =
        remeasured::read_measured_stand({.site = table("site.csv"),
                                         .trees = table("trees.csv"),
                                         .trees_end = table("trees_end.csv"),
                                         .climate = table("climate.csv"),
                                         .fell_list = table("fell_list.csv")},
                                        species, warnings);
    const remeasured::Regrown end = regrow(stand, species, {}, {1, 0});
    EXPECT_FALSE(end.end_dbh_cm[5]) << "felled";
    std::ostringstream text;
    text << std::setprecision(17) << "tree_id,species,dbh_cm\n";
    for (std::size_t i = 0; i < stand.trees.size(); ++i) {
        if (end.end_dbh_cm[i]) {
            text << stand.trees[i].id << ',' << species[stand.trees[i].species].code << ','
                 << *end.end_dbh_cm[i] << '\n';
        }
    }
    std::uint64_t number = 1000;
    for (const remeasured::IngrownTree& tree : end.ingrown) {
        text << number++ << ',' << species[tree.species].code << ',' << tree.dbh_cm << '\n';
    }
    files.texts["trees_end.csv"] = text.str();
    const std::map<std::string, double> values = values_of(files, 1);
    EXPECT_NEAR(values.at("increment_ratio:all:all"), 1.0, 1e-9);
    EXPECT_NEAR(values.at("increment_ratio:piab:all"), 1.0, 1e-9);
    EXPECT_NEAR(values.at("dbh_rmse_cm:all:all"), 0.0, 1e-9);
    EXPECT_NEAR(values.at("survivors_difference:all:all"), 0.0, 1e-12);
    EXPECT_NEAR(values.at("ingrowth_difference_pha:all"), 0.0, 1e-9);
    EXPECT_NEAR(values.at("basal_area_ratio:all"), 1.0, 1e-9);
}

TEST(RemeasuredCase, TakesSaplingsThatGrowIn) {
    CaseFiles files = synthetic_case();
    files.texts["site.csv"].replace(files.texts["site.csv"].rfind(",7\n"), 3, ",1\n");
    const double without = values_of(files, 1).at("ingrowth_pha:all");
    files.texts["saplings.csv"] = "species,stems_pha,height_m,age_years\nfasy,5000,1.9,12\n";
    EXPECT_GT(values_of(files, 1).at("ingrowth_pha:all"), without + 200.0);
}

TEST(RemeasuredCase, NotesHowMissingHeightsAreFilledIn) {
    const Comparison comparison = comparison_of(synthetic_case(), 1);
    EXPECT_TRUE(comparison.warnings.empty());
    ASSERT_FALSE(comparison.notes.empty());
    EXPECT_NE(comparison.notes.front().find("height"), std::string::npos) << comparison.notes.front();
}

TEST(RemeasuredCase, RefusesClassesThatDoNotRise) {
    RemeasuredSettings settings;
    settings.classes_cm = {20.0, 10.0};
    EXPECT_THROW(static_cast<void>(read_remeasured(synthetic_case(), settings, {})), config::InputError);
}

}  // namespace
}  // namespace coupling::validation::forest_cases::remeasured_test
