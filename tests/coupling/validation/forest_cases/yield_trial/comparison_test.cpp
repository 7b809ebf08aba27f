#include "coupling/validation/forest_cases/yield_trial/comparison.hpp"

#include <gtest/gtest.h>

#include <iomanip>
#include <iostream>
#include <map>
#include <sstream>

#include "tests/coupling/validation/forest_cases/shipped_case.hpp"

namespace coupling::validation::forest_cases::yield_trial::comparison_test {
namespace {

using forest::SpeciesTable;
using forest::TreeLight;

config::Table shipped(const std::string& file) {
    return shipped_table("forest_yield", file);
}

config::Table table_of(const std::string& text) {
    std::istringstream in{text};
    return config::Table::read(in, "made up");
}

YieldCase shipped_case(const SpeciesTable& species) {
    config::Warnings warnings;
    return {read_yield_sites(shipped("sites.csv"), species), read_yield_rows(shipped("yield_tables.csv")),
            forest::read_climate(shipped("climate.csv"), warnings),
            shipped_parameters("forest_yield", CaseKind::forest_yield)};
}

void print(const std::vector<YieldComparison>& comparisons) {
    for (const YieldComparison& one : comparisons) {
        std::cout << std::left << std::setw(10) << one.site << std::right << std::setw(4) << one.age_years
                  << std::fixed << std::setprecision(0) << std::setw(6) << one.simulated.stems_pha << " /ha"
                  << std::setprecision(1) << std::setw(6) << one.simulated.mean_dbh_cm << " cm"
                  << std::setw(6) << mean_per_lorey_height * one.simulated.lorey_height_m << " m"
                  << std::setprecision(0) << std::setw(6) << one.simulated.volume_m3pha << " m3/ha";
        if (one.published) {
            std::cout << "   table" << std::setw(6) << one.published->stems_pha << std::setprecision(1)
                      << std::setw(6) << one.published->mean_dbh_cm << std::setw(6)
                      << one.published->mean_height_m << std::setprecision(0) << std::setw(6)
                      << one.published->volume_m3pha;
        }
        std::cout << '\n';
    }
}

/// All of criteria.csv.
void expect_criteria(const std::vector<YieldComparison>& comparisons) {
    std::map<std::string, double> figures;
    for (const auto& [name, value] : yield_figures(comparisons)) {
        figures[name] = value;
    }
    const config::Table criteria = shipped("criteria.csv");
    ASSERT_GT(criteria.rows(), 40U);
    for (std::size_t row = 0; row < criteria.rows(); ++row) {
        const std::string& quantity = criteria.text(row, "quantity");
        ASSERT_EQ(figures.count(quantity), 1U) << quantity;
        EXPECT_GE(figures[quantity], std::stod(criteria.text(row, "low"))) << quantity;
        EXPECT_LE(figures[quantity], std::stod(criteria.text(row, "high"))) << quantity;
    }
}

TEST(CompareYields, MeetsTheTablesInTheModelsOwnLight) {
    const SpeciesTable species = SpeciesTable::shipped();
    YieldCase data = shipped_case(species);
    std::erase_if(data.sites, [](const YieldSite& site) {
        return site.table.empty() && site.name != "abal_1000" && site.name != "fasy_1000";
    });
    const std::vector<YieldComparison> comparisons =
        compare_yields(data, species, TreeLight::in_space, {70, 100});
    print(comparisons);
    expect_criteria(comparisons);
}

TEST(CompareYields, FindsNearlyTheSameVolumesInLightByLayers) {
    const SpeciesTable species = SpeciesTable::shipped();
    YieldCase data = shipped_case(species);
    data.sites.resize(5);  // spruce
    const std::vector<YieldComparison> layers =
        compare_yields(data, species, TreeLight::by_layers, {70, 100});
    const std::vector<YieldComparison> space = compare_yields(data, species, TreeLight::in_space, {70, 100});
    print(layers);
    for (std::size_t i = 0; i < layers.size(); ++i) {
        EXPECT_NEAR(layers[i].simulated.volume_m3pha / space[i].simulated.volume_m3pha, 1.0, 0.1)
            << layers[i].site;
    }
}

TEST(CompareYields, RanksElevations) {
    const SpeciesTable species = SpeciesTable::shipped();
    YieldCase data = shipped_case(species);
    const std::vector<YieldComparison> comparisons =
        compare_yields(data, species, TreeLight::by_layers, {100});
    for (std::size_t i = 1; i < comparisons.size(); ++i) {
        const bool same_species = data.sites[i].species == data.sites[i - 1].species;
        if (same_species) {
            EXPECT_LT(comparisons[i].simulated.volume_m3pha, comparisons[i - 1].simulated.volume_m3pha)
                << comparisons[i].site;
        }
    }
}

TEST(ReadYieldSites, NamesTheSpeciesItDoesNotKnow) {
    const config::Table table = table_of("site,species,elevation_m,fertility,table,class\na,pyab,500,2,,\n");
    try {
        static_cast<void>(read_yield_sites(table, SpeciesTable::shipped()));
        FAIL();
    } catch (const config::InputError& error) {
        EXPECT_EQ(error.problems().size(), 2U) << "species and fertility";
        EXPECT_EQ(error.problems()[0].place.line, 2U);
    }
}

TEST(CompareYields, AsksForTheClimateOfEachSite) {
    const SpeciesTable species = SpeciesTable::shipped();
    YieldCase data = shipped_case(species);
    data.climates.erase(data.climates.begin());
    EXPECT_THROW(static_cast<void>(compare_yields(data, species, TreeLight::by_layers, {70})),
                 config::InputError);
}

}  // namespace
}  // namespace coupling::validation::forest_cases::yield_trial::comparison_test
