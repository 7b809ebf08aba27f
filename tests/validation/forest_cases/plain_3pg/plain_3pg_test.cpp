#include "validation/engine/forest_cases/plain_3pg/plain_3pg.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "config/text/numbers.hpp"
#include "tests/validation/forest_cases/plain_3pg/reference.hpp"

namespace coupling::validation::forest_cases::plain_3pg::plain_3pg_test {
namespace {

const std::string beech = "Fagus sylvatica";
const std::string pine = "Pinus sylvestris";

struct Difference {
    double largest = 0.0;        ///< relative
    double largest_stock = 0.0;  ///< of biomass, t/ha
    std::string where;
    std::size_t compared = 0;
};

/// All figures of all months that both programs give. r3PG prints nine digits.
Difference difference(const std::vector<Row>& rows, const config::Table& reference) {
    Difference result;
    EXPECT_EQ(rows.size(), reference.rows());
    for (const Column& column : columns()) {
        if (!reference.has(column.name)) {
            continue;
        }
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const auto expected = config::parse_number(reference.text(i, column.name));
            if (!expected) {
                continue;
            }
            // What has not been computed before the first month is 0 in r3PG.
            if (i == 0 && *expected == 0.0) {
                continue;
            }
            const double found = column.of(rows[i]);
            const double scale = std::max(std::abs(*expected), 1e-7);
            const double relative = std::abs(found - *expected) / scale;
            if (relative > result.largest) {
                result.largest = relative;
                result.where = std::string{column.name} + " in month " + std::to_string(i) + ": " +
                               std::to_string(found) + " for " + std::to_string(*expected);
            }
            if (column.name.starts_with("biom_") && column.name != "biom_tree" &&
                column.name != "biom_tree_max") {
                result.largest_stock = std::max(result.largest_stock, std::abs(found - *expected));
            }
            ++result.compared;
        }
    }
    return result;
}

TEST(Plain3pg, MeetsEveryMonthOfThePineRun) {
    const Difference found = difference(run(demonstration({pine}), {}), reference_table("out_pine_pjs.csv"));
    EXPECT_GT(found.compared, 7000U);
    EXPECT_LT(found.largest, 1e-6) << found.where;
    EXPECT_LT(found.largest_stock, 5e-7);
}

TEST(Plain3pg, MeetsEveryMonthOfTheBeechRun) {
    const Difference found =
        difference(run(demonstration({beech}), {}), reference_table("out_beech_pjs.csv"));
    EXPECT_GT(found.compared, 7000U);
    EXPECT_LT(found.largest, 1e-6) << found.where;
    EXPECT_LT(found.largest_stock, 5e-7);
}

/// The stand in two halves of one species, which are to behave like one.
Inputs halved(const std::string& species) {
    Inputs inputs = demonstration({species});
    StartingSpecies& half = inputs.species.front();
    half.stems_pha *= 0.5;
    half.stem_tpha *= 0.5;
    half.root_tpha *= 0.5;
    half.foliage_tpha *= 0.5;
    inputs.species.push_back(half);
    inputs.parameters.push_back(inputs.parameters.front());
    return inputs;
}

/// Water that never runs short, so that what two conductances side by side take more than one does not
/// matter.
Inputs without_drought(Inputs inputs) {
    inputs.site.soil_class = 0;
    inputs.site.max_water_mm = 9000.0;
    inputs.site.start_water_mm = 9000.0;
    return inputs;
}

/// Room for all trees.
Inputs without_crowding(Inputs inputs) {
    for (Parameters& parameters : inputs.parameters) {
        parameters.self_thinning.at_1000_kg = 1e5;
    }
    return inputs;
}

TEST(Plain3pg, GrowsTwoHalvesLikeOneStandWithTheModelsOfMixtures) {
    Settings settings = mixture_settings;
    for (const std::string& species : {beech, pine}) {
        const std::vector<Row> whole = run(without_drought(demonstration({species})), settings);
        const std::vector<Row> halves = run(without_drought(halved(species)), settings);
        ASSERT_EQ(halves.size(), 2 * whole.size());
        for (std::size_t m = 0; m < whole.size(); ++m) {
            const Stocks& one = whole[m].state.stocks;
            const Stocks& a = halves[2 * m].state.stocks;
            const Stocks& b = halves[2 * m + 1].state.stocks;
            ASSERT_NEAR(a.stem + b.stem, one.stem, 1e-9 * one.stem) << species << ", month " << m;
            ASSERT_NEAR(a.root + b.root, one.root, 1e-9 * one.root) << species << ", month " << m;
            ASSERT_NEAR(a.foliage, b.foliage, 1e-12);
        }
    }
}

TEST(Plain3pg, BalancesWaterInEveryMonthOfAMixture) {
    for (const Settings& settings : {Settings{}, mixture_settings}) {
        const std::vector<Row> rows = run(demonstration({beech, pine}), settings);
        for (std::size_t i = 2; i < rows.size(); i += 2) {
            const StandWater& water = rows[i].water;
            const double change_mm = water.soil_mm - rows[i - 2].water.soil_mm;
            EXPECT_NEAR(rows[i].climate.prec_mm,
                        water.evapotranspiration_mm + water.runoff_mm - water.irrigation_mm + change_mm,
                        1e-9);
            double parts_mm = water.soil_evaporation_mm;
            for (const std::size_t species : {i, i + 1}) {
                parts_mm +=
                    rows[species].state.water.transpiration_mm + rows[species].state.water.interception_mm;
            }
            EXPECT_NEAR(parts_mm, water.evapotranspiration_mm, 1e-9) << i;
        }
    }
}

TEST(Plain3pg, AccountsForEveryTonOfBiomass) {
    for (const Settings& settings : {Settings{}, mixture_settings}) {
        const std::vector<Row> rows = run(without_crowding(demonstration({beech, pine})), settings);
        for (std::size_t i = 2; i < rows.size(); ++i) {
            const Stocks& before = rows[i - 2].state.stocks;
            const Stocks& after = rows[i].state.stocks;
            const Production& p = rows[i].state.production;
            EXPECT_NEAR(after.stem - before.stem, p.stem_growth, 1e-10);
            EXPECT_NEAR(after.root - before.root, p.root_growth - p.root_loss, 1e-10);
            EXPECT_GE(after.foliage, 0.0);
            EXPECT_GE(after.foliage_debt, 0.0);
            EXPECT_NEAR(p.root_share + p.stem_share + p.foliage_share, 1.0, 1e-12);
        }
    }
}

TEST(Plain3pg, ThinsToTheNumbersOfTheList) {
    const std::vector<Row> rows = run(without_crowding(demonstration({beech, pine}, true)), {});
    double beech_stems = 800.0;
    double pine_stems = 800.0;
    double pine_stem_before = 0.0;
    for (const Row& row : rows) {
        double& stems = row.species == 0 ? beech_stems : pine_stems;
        const double age = row.state.age.years;
        EXPECT_LE(row.state.stocks.stems_pha, stems) << "stems only fall";
        stems = row.state.stocks.stems_pha;
        if (row.species == 0) {
            EXPECT_NEAR(stems, age >= 48.0 ? 500.0 : 800.0, 1e-9) << age;
        } else {
            EXPECT_NEAR(stems, age >= 50.0 ? 400.0 : age >= 47.0 ? 600.0 : 800.0, 1e-9) << age;
            if (row.state.deaths.cut_pha > 0.0) {
                const double share = row.state.deaths.cut_pha / (stems + row.state.deaths.cut_pha);
                const double grown = pine_stem_before + row.state.production.stem_growth;
                EXPECT_NEAR(row.state.stocks.stem, grown * (1.0 - share), 1e-9);
            }
            pine_stem_before = row.state.stocks.stem;
        }
    }
    EXPECT_DOUBLE_EQ(beech_stems, 500.0);
    EXPECT_DOUBLE_EQ(pine_stems, 400.0);
}

TEST(Plain3pg, ThinsItselfAlongItsLimit) {
    Inputs inputs = demonstration({pine});
    inputs.parameters[0].self_thinning = {80.0, 1.5};
    const std::vector<Row> rows = run(inputs, {});
    EXPECT_LT(rows.back().state.stocks.stems_pha, 800.0);
    for (std::size_t i = 12; i < rows.size(); ++i) {
        const double stems_pha = rows[i].state.stocks.stems_pha;
        EXPECT_LE(rows[i].state.sizes.tree_kg, 1.001 * 80.0 * std::pow(1000.0 / stems_pha, 1.5)) << i;
    }
}

TEST(Plain3pg, LosesThePercentOfRandomMortality) {
    Inputs inputs = demonstration({pine});
    inputs.parameters[0].random_mortality = {2.4, 2.4, 0.0, 1.0};
    const std::vector<Row> rows = run(inputs, {});
    EXPECT_NEAR(rows.back().state.stocks.stems_pha, 800.0 * std::pow(1.0 - 0.024 / 12.0, 119), 1e-8);
}

TEST(Plain3pg, MeetsTheSecondImplementationOfAThinnedMixture) {
    const std::vector<Row> rows = run(demonstration({beech, pine}, true), mixture_settings);
    const config::Table reference = reference_table("own_mixture_thinned.csv");
    ASSERT_EQ(rows.size(), reference.rows() + 2) << "all but the starting state";
    for (std::size_t i = 0; i < reference.rows(); ++i) {
        for (const std::string& column : reference.columns()) {
            if (column != "month_number" && column != "species") {
                const double expected = config::parse_number(reference.text(i, column)).value();
                EXPECT_NEAR(value(rows[i + 2], column), expected, 1e-8 * std::max(1.0, std::abs(expected)))
                    << column << " of " << reference.text(i, "species") << " in month " << i / 2 + 1;
            }
        }
    }
}

TEST(Plain3pg, PlantsASpeciesWhenItsMonthComes) {
    Inputs inputs = demonstration({beech, pine});
    inputs.species[1].planted = {2005, 1};
    const std::vector<Row> rows = run(inputs, {});
    for (const Row& row : rows) {
        if (row.species == 1) {
            const bool there = row.when.count() >= YearMonth{2005, 1}.count();
            EXPECT_EQ(row.state.stocks.stems_pha, there ? 800.0 : 0.0);
            EXPECT_TRUE(std::isfinite(row.state.stocks.stem));
            EXPECT_TRUE(std::isfinite(row.state.sizes.height_m));
        }
    }
    EXPECT_GT(rows.back().state.stocks.stem, inputs.species[1].stem_tpha);
}

TEST(Plain3pg, TakesTheOtherHeightLawToo) {
    Inputs inputs = demonstration({pine});
    inputs.parameters[0].height_m = {.factor = 30.0, .dbh = 12.0, .competition = 0.001};
    inputs.parameters[0].crown_length_m = {.factor = 10.0, .dbh = 12.0};
    Settings settings;
    settings.height = HeightModel::exponential;
    const Row last = run(inputs, settings).back();
    const double dbh_cm = last.state.sizes.dbh_cm;
    const double competition = last.state.age.wood_density_tpm3 * last.state.sizes.basal_area_m2pha;
    EXPECT_NEAR(last.state.sizes.height_m,
                1.3 + 30.0 * std::exp(-12.0 / dbh_cm) + 0.001 * competition * dbh_cm, 1e-8);
}

TEST(Plain3pg, StaysFiniteWhereLeavesMatureWithinAYear) {
    // Published sets of birch, cembra pine and Scots pine have tSLA = 1 year, that of birch and cembra pine
    // with SLA0 above SLA1: at the age of 43 years nothing is left of the young leaves.
    for (const std::string& species : {beech, pine}) {
        Inputs inputs = demonstration({species});
        ByAge& sla = inputs.parameters[0].sla_m2pkg;
        sla = {.young = 2.0 * sla.mature, .mature = sla.mature, .half_years = 1.0};
        for (const Row& row : run(inputs, {})) {
            for (const Column& column : columns()) {
                ASSERT_TRUE(std::isfinite(column.of(row))) << column.name << " of " << species;
            }
            ASSERT_DOUBLE_EQ(row.state.age.sla_m2pkg, sla.mature) << species;
        }
    }
}

TEST(Plain3pg, GivesTheSheetsFiguresOfPineInJune) {
    const std::vector<Row> rows = run(demonstration({pine}), {});
    const Row& june = rows[5];
    EXPECT_NEAR(value(june, "apar"), 219.051, 5e-4);
    EXPECT_NEAR(value(june, "gpp"), 2.55731, 5e-6);
    EXPECT_NEAR(value(june, "npp"), 1.20193, 5e-6);
    EXPECT_NEAR(value(june, "f_vpd"), 0.726345, 5e-7);
    EXPECT_NEAR(value(june, "npp_fract_root"), 0.47167, 5e-6);
}

}  // namespace
}  // namespace coupling::validation::forest_cases::plain_3pg::plain_3pg_test
