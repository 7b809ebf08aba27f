#include "forest/protection/nais.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace forest::nais_test {
namespace {

const SpeciesTable& shipped_species() {
    static const SpeciesTable table = SpeciesTable::shipped();
    return table;
}

TEST(Nais, ReadsLimitsInTheDirectionOfTheCriterion) {
    EXPECT_TRUE(nais_limit("300", true)->holds(300.0));
    EXPECT_FALSE(nais_limit("300", true)->holds(299.0));
    EXPECT_TRUE(nais_limit("20", false)->holds(20.0));
    EXPECT_FALSE(nais_limit("20", false)->holds(20.1));
    EXPECT_TRUE(nais_limit("10-90", true)->holds(10.0));
    EXPECT_FALSE(nais_limit("10-90", true)->holds(95.0));
    EXPECT_FALSE(nais_limit(">=5", false)->holds(4.0));
    EXPECT_FALSE(nais_limit("<=80", true)->holds(81.0));
    for (const char* text : {"", "abc", "90-10", "-5", "10-", ">=", "nan"}) {
        EXPECT_FALSE(nais_limit(text, true)) << text;
    }
}

TEST(Nais, KnowsItsCriteriaByName) {
    const auto named = [](const char* name) { return nais_criterion(name, shipped_species(), 24.0); };
    EXPECT_EQ(named("stems_from_36_cm")->dbh_from_cm, 36.0);
    EXPECT_EQ(named("stems_effective")->dbh_from_cm, 24.0);
    EXPECT_EQ(named("mixture_ABAL_percent")->species, *shipped_species().find("abal"));
    EXPECT_FALSE(named("gap_m")->wants_much());
    EXPECT_TRUE(named("cover_percent")->wants_much());
    for (const char* name : {"stems_from_25_cm", "stems_from_0_cm", "mixture_oakk_percent", "gap", ""}) {
        EXPECT_FALSE(named(name)) << name;
    }
    EXPECT_FALSE(nais_criterion("stems_effective", shipped_species(), 0.0)) << "no size of rocks";
}

TEST(Nais, IsIdealOnlyWhereAnIdealIsGivenAndMet) {
    const NaisLimit minimal = *nais_limit("300", true);
    const std::optional<NaisLimit> ideal = nais_limit("400", true);
    EXPECT_EQ(status_of(299.0, minimal, ideal), NaisStatus::below);
    EXPECT_EQ(status_of(399.0, minimal, ideal), NaisStatus::minimal);
    EXPECT_EQ(status_of(400.0, minimal, ideal), NaisStatus::ideal);
    EXPECT_EQ(status_of(400.0, minimal, std::nullopt), NaisStatus::minimal);
    EXPECT_EQ(status_of(std::nan(""), minimal, ideal), NaisStatus::below) << "nothing stands";
}

TEST(Nais, CountsStemsFromTheClassOfTheDiameter) {
    StandFigures figures;
    figures.stems_pha_by_class[8] = 10.0;  // 32 to 36 cm
    figures.stems_pha_by_class[9] = 20.0;  // 36 to 40 cm
    figures.stems_pha_by_class[20] = 5.0;
    figures.basal_area_m2pha = 40.0;
    EXPECT_EQ(nais_value(*nais_criterion("stems_from_36_cm", shipped_species(), 0.0), {&figures}), 25.0);
    EXPECT_EQ(nais_value(*nais_criterion("mixture_ABAL_percent", shipped_species(), 0.0),
                         {&figures, nullptr, nullptr, 10.0}),
              25.0);
}

}  // namespace
}  // namespace forest::nais_test
