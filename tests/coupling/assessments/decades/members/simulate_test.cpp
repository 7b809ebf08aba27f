#include "coupling/assessments/decades/members/simulate.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <utility>

#include "coupling/exchange/regimes/shipped.hpp"
#include "forest/deadwood/deadwood.hpp"
#include "forest/stand/allometry.hpp"
#include "tests/coupling/inputs/forest_project.hpp"

namespace coupling::decades::simulate_test {
namespace {

constexpr std::int32_t years = 25;

std::vector<std::string> with_all_that_kills() {
    std::string every_year = "output.tree_list_years=0";
    for (int year = 1; year <= years; ++year) {
        every_year += ", " + std::to_string(year);
    }
    std::string regimes = "regimes.list=";
    for (const std::string& name : shipped_regime_names()) {
        regimes += (regimes.back() == '=' ? "" : ", ") + name;
    }
    return {"run.years=" + std::to_string(years),
            "trees.file=",
            "stands.records=records.csv",
            "climate.sequence=repeat",
            "release.rocks=200",
            "feedback.on=yes",
            "feedback.rocks_per_year=100",
            "disturbance.wind=yes",
            "disturbance.storm_interval=4",
            "disturbance.snow=yes",
            "disturbance.beetle=yes",
            "disturbance.beetle_background=0.3",
            "output.all_removed_trees=yes",
            every_year,
            regimes};
}

/// Every shipped regime on 0.8 ha, with storms, beetles and rocks that hurt trees.
class Members : public ::testing::Test {
protected:
    static void SetUpTestSuite() {
        const ForestProject project;
        const Opened opened = open(project, with_all_that_kills());
        ASSERT_TRUE(opened.site) << opened.errors;
        const ForestSite& forest = *opened.site->forest;
        config::Warnings warnings;
        const Management management = read_management(*opened.scenario, forest, warnings);
        const exchange::YearlyRockfall rocks{
            *opened.scenario, *opened.site, forest.species.fracture_energy, {}};
        const Decades decades{*opened.scenario, forest, management, &rocks};
        members = new std::vector<MemberYears>;
        for (std::uint32_t regime = 0; regime < management.regimes.size(); ++regime) {
            members->push_back(simulate(decades, {regime, 0}, 1, [] {}));
        }
        area_ha = forest.grid.area_ha();
        table = new forest::SpeciesTable{forest.species.table};
    }
    static void TearDownTestSuite() {
        delete members;
        delete table;
    }

    static std::vector<MemberYears>* members;
    static forest::SpeciesTable* table;
    static double area_ha;
};
std::vector<MemberYears>* Members::members = nullptr;
forest::SpeciesTable* Members::table = nullptr;
double Members::area_ha = 0.0;

/// What is done at the start comes after what stood then: it belongs to the first year.
std::int32_t year_of_flow(std::int32_t year) {
    return year == 0 ? 1 : year;
}

TEST_F(Members, LoseNoTreeWithoutACause) {
    std::set<forest::Cause> causes;
    for (const MemberYears& member : *members) {
        SCOPED_TRACE(member.member.regime);
        std::map<std::int32_t, std::map<std::uint64_t, float>> standing;  // diameters by year and tree
        std::map<std::int32_t, double> stems;
        for (const TreeRow& tree : member.trees) {
            standing[tree.year][tree.tree] = tree.dbh_cm;
            stems[tree.year] += tree.stems;
        }
        std::map<std::int32_t, std::set<std::uint64_t>> removed;
        for (const RemovedRow& tree : member.removed) {
            EXPECT_TRUE(removed[year_of_flow(tree.year)].insert(tree.tree).second)
                << tree.tree << " dies twice";
            causes.insert(tree.cause);
        }
        for (const LossRow& loss : member.losses) {
            stems[year_of_flow(loss.year) + 1000] += loss.loss.stems_pha * area_ha;
        }
        for (std::int32_t year = 1; year <= years; ++year) {
            for (const auto& [tree, dbh_cm] : standing[year - 1]) {
                const bool is_gone = !standing[year].contains(tree);
                if (dbh_cm >= static_cast<float>(forest::least_dead_wood_cm)) {
                    EXPECT_EQ(is_gone, removed[year].contains(tree)) << "tree " << tree << ", year " << year;
                }
            }
            const double in = member.years[static_cast<std::size_t>(year)].ingrowth_stems_pha * area_ha;
            EXPECT_NEAR(stems[year], stems[year - 1] + in - stems[year + 1000], 1e-6) << year;
        }
    }
    for (const forest::Cause cause : {forest::Cause::background, forest::Cause::wind, forest::Cause::beetle,
                                      forest::Cause::rock, forest::Cause::felled}) {
        EXPECT_TRUE(causes.contains(cause)) << forest::name_of(cause) << " has not been put to the test";
    }
}

TEST_F(Members, CloseTheBudgetOfWoodInEachYear) {
    for (const MemberYears& member : *members) {
        SCOPED_TRACE(member.member.regime);
        double hauled_tpha = 0.0;
        double decayed_tpha = 0.0;
        double salvaged_tpha = member.years[0].dead_wood_taken_tpha;
        for (std::size_t t = 1; t < member.years.size(); ++t) {
            const YearRow& before = member.years[t - 1];
            YearRow flows = member.years[t];
            const YearRow& now = member.years[t];
            if (t == 1) {
                flows.stem_losses_tpha += before.stem_losses_tpha;
                flows.dead_wood_in_tpha += before.dead_wood_in_tpha;
            }
            const double living = before.stem_wood_tpha + flows.stem_growth_tpha + flows.stem_ingrowth_tpha -
                                  flows.stem_losses_tpha;
            EXPECT_NEAR(now.stem_wood_tpha, living, 1e-9 * living) << t;
            const double dead = before.dead_stems_tpha + flows.dead_wood_in_tpha -
                                flows.dead_wood_decayed_tpha - flows.dead_wood_to_soil_tpha -
                                flows.dead_wood_taken_tpha;
            EXPECT_NEAR(now.dead_stems_tpha, dead, 1e-9 * (living + dead)) << t;
            EXPECT_GE(now.stem_hauled_tpha, -1e-9);
            hauled_tpha += now.stem_hauled_tpha;
            decayed_tpha += now.dead_wood_decayed_tpha;
            salvaged_tpha += now.dead_wood_taken_tpha;
        }
        hauled_tpha += member.years[0].stem_hauled_tpha;
        EXPECT_GT(decayed_tpha, 0.0);
        // What was hauled is what the timber table says was taken.
        double timber_tpha = 0.0;
        for (const TimberRow& row : member.timber) {
            const double density_kgpm3 = table->all()[row.species].allometry.stem_density_kgpm3;
            timber_tpha += row.timber.taken_m3 * density_kgpm3 / 1000.0 / area_ha;
        }
        if (salvaged_tpha > 0.0) {  // shipped regimes that salvage fell nothing; dead wood has lost some mass
            EXPECT_NEAR(hauled_tpha, 0.0, 1e-9);
            EXPECT_LE(salvaged_tpha, timber_tpha * (1.0 + 1e-9));
            EXPECT_GT(salvaged_tpha, 0.5 * timber_tpha);
        } else {
            EXPECT_NEAR(hauled_tpha, timber_tpha, 1e-9 * (1.0 + timber_tpha));
        }
    }
}

TEST_F(Members, TellTheWoodThatTheirTreesHave) {
    for (const MemberYears& member : *members) {
        std::map<std::int32_t, double> wood_tpha;
        for (const TreeRow& tree : member.trees) {
            const forest::Allometry& allometry = table->all()[tree.species].allometry;
            wood_tpha[tree.year] += tree.stems * allometry.stem_density_kgpm3 *
                                    forest::stem_volume_m3(allometry, static_cast<double>(tree.dbh_cm),
                                                           static_cast<double>(tree.height_m)) /
                                    1000.0 / area_ha;
        }
        for (const YearRow& row : member.years) {
            // The lists keep sizes in single precision.
            EXPECT_NEAR(row.stem_wood_tpha, wood_tpha[row.year], 1e-6 * row.stem_wood_tpha) << row.year;
        }
    }
}

}  // namespace
}  // namespace coupling::decades::simulate_test
