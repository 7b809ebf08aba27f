#include "validation/engine/forest_cases/yield_trial/comparison.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>

#include "tests/validation/forest_cases/shipped_case.hpp"

namespace coupling::validation::forest_cases::yield_trial::comparison_test {
namespace {

using forest::SpeciesTable;
using forest::TreeLight;

const SpeciesTable species = SpeciesTable::shipped();

config::Table shipped(const std::string& file) {
    return shipped_table("forest_yield", file);
}

config::Table table_of(const std::string& text) {
    std::istringstream in{text};
    return config::Table::read(in, "made up");
}

const YieldCase& shipped_case() {
    static const YieldCase data = [] {
        config::Warnings warnings;
        return YieldCase{read_yield_sites(shipped("sites.csv"), species),
                         read_yield_rows(shipped("yield_tables.csv")),
                         forest::read_climate(shipped("climate.csv"), warnings),
                         shipped_parameters("forest_yield", CaseKind::forest_yield)};
    }();
    return data;
}

const YieldSite& site_of(const std::string& name) {
    for (const YieldSite& site : shipped_case().sites) {
        if (site.name == name) {
            return site;
        }
    }
    throw std::runtime_error{"no site " + name};
}

SiteYields grown(const std::string& site, Treatment treatment, TreeLight light,
                 const std::vector<int>& ages) {
    return compare_yields(shipped_case(), site_of(site), species, treatment, light, ages);
}

TEST(CompareYields, StartsAsTheYoungestStandAndKeepsTheStemsOfTheTable) {
    const SiteYields spruce = grown("piab_1000", Treatment::as_the_table, TreeLight::in_space, {40, 60});
    ASSERT_EQ(spruce.ages.size(), 2U);
    for (const YieldComparison& one : spruce.ages) {
        EXPECT_NEAR(one.simulated.figures.stems_pha / one.published->stems_pha, 1.0, 0.01) << one.age_years;
    }
    const std::vector<YieldTableRow> rows = rows_of(shipped_case(), site_of("piab_1000"));
    EXPECT_EQ(rows.front().age_years, 30);
    EXPECT_EQ(ages_of(shipped_case(), site_of("piab_1000"), {20, 30, 40, 145}), (std::vector<int>{40}));
}

/// All species, one site each: three of four figures at 70 and 100 years (the case asks for 85 % of all).
TEST(CompareYields, MeetsTheTablesOfLightDemandingSpeciesToo) {
    // Larch and pine stood four times too dense and half as tall.
    for (const char* site :
         {"piab_1000", "abal_500", "fasy_500", "lade_500", "pisy_1000", "frex_500", "bepe_500", "qupe_500"}) {
        const SiteYields yields = grown(site, Treatment::as_the_table, TreeLight::in_space, {50, 70, 100});
        const Agreement agreement = agreement_of(yields, 0, 1000);
        EXPECT_GE(agreement.share(), 0.75) << site;
    }
}

TEST(CompareYields, LeavesTwinsOnTheSelfThinningLine) {
    for (const char* site : {"piab_1000", "lade_500", "pisy_1000"}) {
        const SiteYields twin = grown(site, Treatment::left_alone, TreeLight::in_space, {40, 70, 100});
        const SiteYields thinned = grown(site, Treatment::as_the_table, TreeLight::in_space, {100});
        EXPECT_LE(twin.greatest_density, 1.1) << site;
        EXPECT_GT(twin.ages.back().simulated.figures.stems_pha,
                  thinned.ages.back().simulated.figures.stems_pha)
            << site;
        // Larch is judged by the case, which prints its miss.
        EXPECT_LT(twin.ages.back().simulated.dominant_slenderness, 110.0) << site;
    }
}

TEST(CompareYields, FindsNearlyTheSameVolumesInLightByLayers) {
    for (const char* site : {"piab_500", "piab_1500"}) {
        const double layers = grown(site, Treatment::left_alone, TreeLight::by_layers, {100})
                                  .ages.back()
                                  .simulated.figures.volume_m3pha;
        const double space = grown(site, Treatment::left_alone, TreeLight::in_space, {100})
                                 .ages.back()
                                 .simulated.figures.volume_m3pha;
        EXPECT_NEAR(layers / space, 1.0, 0.1) << site;
    }
}

TEST(CompareYields, RanksElevations) {
    const auto volume = [](const char* site) {
        return grown(site, Treatment::left_alone, TreeLight::by_layers, {100})
            .ages.back()
            .simulated.figures.volume_m3pha;
    };
    EXPECT_GT(volume("piab_500"), volume("piab_1000"));
    EXPECT_GT(volume("piab_1000"), volume("piab_1750"));
    EXPECT_GT(volume("acps_500"), volume("acps_1500"));
}

TEST(Agreement, CountsThreeFiguresOfEachAgeWithinFifteenPerCent) {
    SiteYields yields;
    YieldComparison one{"x", 80, {.age_years = 80, .figures = {}}, {}};
    one.simulated.figures.volume_m3pha = 114.0;
    one.simulated.figures.mean_dbh_cm = 86.0;
    one.simulated.mean_height_m = 116.0;
    YieldTableRow row;
    row.mean_height_m = 100.0;
    row.mean_dbh_cm = 100.0;
    row.volume_m3pha = 100.0;
    one.published = row;
    yields.ages = {one};
    EXPECT_EQ(agreement_of(yields, 0, 100).figures, 3U);
    EXPECT_NEAR(agreement_of(yields, 0, 100).share(), 2.0 / 3.0, 1e-12);
    EXPECT_EQ(agreement_of(yields, 81, 100).figures, 0U) << "other ages do not count";
}

TEST(ReadYieldSites, NamesTheSpeciesItDoesNotKnow) {
    const config::Table table = table_of("site,species,elevation_m,fertility,table,class\na,pyab,500,2,,\n");
    try {
        static_cast<void>(read_yield_sites(table, species));
        FAIL();
    } catch (const config::InputError& error) {
        EXPECT_EQ(error.problems().size(), 2U) << "species and fertility";
        EXPECT_EQ(error.problems()[0].place.line, 2U);
    }
}

TEST(CompareYields, AsksForTheClimateAndTheTableOfEachSite) {
    YieldCase data = shipped_case();
    YieldSite site = site_of("piab_500");
    site.site_class = "9";
    const auto compare = [&] {
        static_cast<void>(
            compare_yields(data, site, species, Treatment::left_alone, TreeLight::by_layers, {70}));
    };
    EXPECT_THROW(compare(), config::InputError) << "no such class";
    site = site_of("piab_500");
    data.climates.erase(data.climates.begin());
    EXPECT_THROW(compare(), config::InputError) << "no climate at 500 m";
}

}  // namespace
}  // namespace coupling::validation::forest_cases::yield_trial::comparison_test
