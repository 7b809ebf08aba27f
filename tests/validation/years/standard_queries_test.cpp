// The standard figures on tables that were made by hand, against what they must give.

#include "validation/engine/years/standard_queries.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include "validation/engine/years/result_tables.hpp"

namespace coupling::validation::years::standard_queries_test {
namespace {

/// Two sites at 500 m and one at 1500 m; two replicates, judged from year 10 on. The year 9 counts nowhere.
const std::string rows = R"(
CREATE TABLE sites (site TEXT, words);
INSERT INTO sites VALUES ('a', 'here'), ('b', 'beside it'), ('c', 'high up');
CREATE TABLE places (site TEXT, area_ha, elevation_m, changed, all_deaths);
INSERT INTO places VALUES ('a', 2, 500, 0, 1), ('b', 2, 500, 0, 0), ('c', 2, 1500, 0, 0);
CREATE TABLE asked (from_year, last_year);
INSERT INTO asked VALUES (10, 11);
CREATE TABLE figures (figure TEXT, value REAL);
CREATE TABLE expected (site TEXT, "group", species, published, source);
CREATE TABLE species_names (species, code, latin_name, thinning_intercept, thinning_slope);
INSERT INTO species_names VALUES ('PIAB', 'piab', 'Picea abies', 0, 0), ('ABAL', 'abal', 'Abies alba', 0, 0),
  ('FASY', 'fasy', 'Fagus sylvatica', 0, 0);
INSERT INTO stands (site, replicate, year, stand, species, above_ground_tpha, volume_m3pha, basal_area_m2pha,
    dominant_height_m, drought_index)
  VALUES ('a', 1, 9, 'all', 'all', 9000, 9000, 9000, 9000, 9000),
    ('a', 1, 10, 'all', 'all', 100, 300, 20, 24, 0.1), ('a', 2, 10, 'all', 'all', 300, 500, 40, 32, 0.3),
    ('a', 1, 10, 'all', 'PIAB', 60, 1, 1, 1, 1), ('a', 2, 10, 'all', 'PIAB', 180, 1, 1, 1, 1),
    ('a', 1, 10, 'all', 'ABAL', 30, 1, 1, 1, 1), ('a', 2, 10, 'all', 'ABAL', 70, 1, 1, 1, 1),
    ('a', 1, 10, 'all', 'FASY', 10, 1, 1, 1, 1), ('a', 2, 10, 'all', 'FASY', 50, 1, 1, 1, 1),
    ('a', 1, 10, '7', 'PIAB', 9000, 9000, 9000, 9000, 9000),
    ('b', 1, 10, 'all', 'all', 100, 1, 1, 1, 1), ('b', 1, 10, 'all', 'FASY', 100, 1, 1, 1, 1),
    ('c', 1, 10, 'all', 'all', 50, 1, 1, 1, 1), ('c', 1, 10, 'all', 'PIAB', 50, 1, 1, 1, 1);
INSERT INTO forest_years (site, year, snags_m3pha, logs_m3pha, dead_wood_class1_m3pha, dead_wood_class5_m3pha)
  VALUES ('a', 9, 9000, 9000, 9000, 9000), ('a', 10, 10, 20, 4, 1), ('a', 10, 30, 40, 6, 2),
    ('a', 11, 10, 30, 5, 3), ('a', 11, 20, 40, 5, 2);
INSERT INTO mortality (site, year, cause, volume_m3pha)
  VALUES ('a', 9, 'wind', 9000), ('a', 10, 'wind', 6), ('a', 11, 'wind', 2), ('a', 11, 'snow', 1);
INSERT INTO dbh_classes (site, year, species, dbh_from_cm, stems_pha)
  VALUES ('a', 9, 'all', 12, 9000), ('a', 10, 'all', 8, 500), ('a', 10, 'all', 12, 60),
    ('a', 10, 'all', 16, 140), ('a', 10, 'all', 60, 30), ('a', 10, 'all', 100, 10),
    ('a', 10, 'PIAB', 12, 9000);
INSERT INTO removed_trees (site, year, dbh_cm)
  VALUES ('a', 9, 15), ('a', 10, 11.9), ('a', 10, 12), ('a', 11, 19.9), ('a', 10, 20), ('a', 11, 75);
)";

/// The tables with the views of the standard queries.
class StandardFigures : public ::testing::Test {
protected:
    StandardFigures() {
        tables_.database().execute(rows);
        for (const Query& query : queries_) {
            if (query.use == QueryUse::definition) {
                static_cast<void>(rows_of(tables_.database(), query));
            }
        }
    }

    /// The figure whose name has its columns in braces, at site a.
    double value(const std::string& name, Fields fields = {}) {
        fields["site"] = "a";
        for (const Query& query : queries_) {
            if (query.use == QueryUse::figure && query.title == name) {
                return value_of(tables_.database(), query, fields);
            }
        }
        ADD_FAILURE() << "no figure " << name;
        return 0.0;
    }
    double deaths_between(const char* low, const char* high, const char* all_deaths) {
        return value("death_rate_from_{low}cm:{site}",
                     {{"area_ha", "2"}, {"low", low}, {"high", high}, {"all_deaths", all_deaths}});
    }
    /// Rows of the charts with this word for a plot.
    std::vector<std::vector<std::string>> layers(const std::string& plot) {
        for (const Query& query : queries_) {
            if (query.use == QueryUse::stack && query.sql.find("'" + plot + "'") != std::string::npos) {
                return rows_of(tables_.database(), query);
            }
        }
        ADD_FAILURE() << "no plot " << plot;
        return {};
    }

    std::vector<Query> queries_ = standard_queries();
    ResultTables tables_{{}, queries_, forest::SpeciesTable::shipped(), "standard_queries.sql"};
};

TEST_F(StandardFigures, AreMeansOverYearsAndReplicates) {
    EXPECT_DOUBLE_EQ(value("biomass_tpha:{site}"), 200.0);
    EXPECT_DOUBLE_EQ(value("volume_m3pha:{site}"), 400.0);
    EXPECT_DOUBLE_EQ(value("basal_area_m2pha:{site}"), 30.0);
    EXPECT_DOUBLE_EQ(value("top_height_m:{site}"), 28.0);
    EXPECT_DOUBLE_EQ(value("drought_index:{site}"), 0.2);
    EXPECT_DOUBLE_EQ(value("dead_wood_m3pha:{site}"), 0.25 * (30.0 + 70.0 + 40.0 + 60.0));
    EXPECT_DOUBLE_EQ(value("dead_wood_class{class}_m3pha:{site}", {{"class", "1"}}), 5.0);
    EXPECT_DOUBLE_EQ(value("dead_wood_class{class}_m3pha:{site}", {{"class", "5"}}), 2.0);
}

TEST_F(StandardFigures, ShareWhatHappenedOutAmongYearsWithoutIt) {
    EXPECT_DOUBLE_EQ(value("stems_60cm_pha:{site}"), (30.0 + 10.0) / 2.0) << "two states";
    EXPECT_DOUBLE_EQ(value("lost_to_wind_m3pha:{site}"), 8.0 / 4.0) << "two years, two replicates";
    EXPECT_DOUBLE_EQ(value("lost_to_snow_m3pha:{site}"), 1.0 / 4.0);
    EXPECT_DOUBLE_EQ(value("lost_to_beetle_m3pha:{site}"), 0.0);
}

TEST_F(StandardFigures, DivideDeathsByTheTreesOfTheirClass) {
    // Two trees died on 2 ha in four years, where 100 stood on a hectare.
    EXPECT_DOUBLE_EQ(deaths_between("12", "20", "1"), 2.0 / 2.0 / 4.0 / 100.0);
    EXPECT_DOUBLE_EQ(deaths_between("60", "1000", "1"), 1.0 / 2.0 / 4.0 / 20.0);
    EXPECT_TRUE(std::isnan(deaths_between("20", "40", "1"))) << "none stands there";
    EXPECT_TRUE(std::isnan(deaths_between("12", "20", "0"))) << "the table lacks most deaths";
}

TEST_F(StandardFigures, CompareAGroupWithAllAndWithTheGreatestOther) {
    const Fields group{{"group", "conifers"}, {"species", "PIAB ABAL"}};
    EXPECT_DOUBLE_EQ(value("share:{group}:{site}", group), (240.0 + 100.0) / 400.0);
    EXPECT_DOUBLE_EQ(value("margin:{group}:{site}", group), (340.0 - 60.0) / 400.0);
    const Fields beech{{"group", "beech"}, {"species", "FASY"}};
    EXPECT_DOUBLE_EQ(value("margin:{group}:{site}", beech), (60.0 - 240.0) / 400.0);
    const Fields nothing{{"group", "oak"}, {"species", "QUPE"}};
    EXPECT_DOUBLE_EQ(value("share:{group}:{site}", nothing), 0.0);
}

TEST_F(StandardFigures, MakeOnePlaceOfSitesOfTheSameElevation) {
    for (const auto& [plot, at_500_m, at_1500_m] :
         {std::tuple{"Shares of the biomass", 100.0, 100.0}, {"Biomass", 0.5 * (200.0 + 100.0), 50.0}}) {
        double low = 0.0;
        double high = 0.0;
        for (const std::vector<std::string>& row : layers(plot)) {
            (row[2] == "500" ? low : high) += std::stod(row[3]);
        }
        EXPECT_NEAR(low, at_500_m, 1e-9) << plot;
        EXPECT_NEAR(high, at_1500_m, 1e-9) << plot;
    }
    tables_.database().execute("UPDATE places SET elevation_m = 500;");
    EXPECT_TRUE(layers("Biomass").empty()) << "one elevation makes no line";
}

}  // namespace
}  // namespace coupling::validation::years::standard_queries_test
