#include "validation/engine/forest_cases/plain_3pg/inputs.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "tests/validation/forest_cases/plain_3pg/reference.hpp"

namespace coupling::validation::forest_cases::plain_3pg::inputs_test {
namespace {

config::Table table_of(const std::string& text) {
    std::istringstream in{text};
    return config::Table::read(in, "table.csv");
}

template <class Read>
std::string message_of(Read read) {
    try {
        read();
    } catch (const config::InputError& error) {
        return error.what();
    }
    return "";
}

TEST(Plain3pgTables, ReadTheDemonstrationSite) {
    const Site site = read_site(reference_table("demo_site.csv"));
    EXPECT_NEAR(site.latitude.in_degrees(), 47.57, 1e-12);
    EXPECT_DOUBLE_EQ(site.max_water_mm, 106.0);
    EXPECT_EQ(site.to.count() - site.from.count(), 119);
    EXPECT_EQ(read_climate(reference_table("demo_climate.csv"), site).size(), 120U);
    EXPECT_EQ(read_thinnings(reference_table("demo_thinning.csv")).size(), 3U);
    const std::vector<Parameters> parameters = read_parameters(reference_table("demo_parameters.csv"));
    ASSERT_EQ(parameters.size(), 2U);
    EXPECT_EQ(parameters[1].species, "Pinus sylvestris");
    EXPECT_DOUBLE_EQ(parameters[1].nutrition.at_zero, 0.2);
}

TEST(Plain3pgTables, TakeDefaultsForParametersThatAreLeftOut) {
    const std::vector<Parameters> parameters = read_parameters(table_of("parameter,oak\nk,0.6\n"));
    EXPECT_DOUBLE_EQ(parameters[0].extinction, 0.6);
    EXPECT_DOUBLE_EQ(parameters[0].light_use.npp_share, 0.47);
    EXPECT_DOUBLE_EQ(parameters[0].net_radiation.intercept_wpm2, -90.0);
}

TEST(Plain3pgTables, NameSpeciesWithoutParameters) {
    Inputs inputs = demonstration({"Fagus sylvatica"});
    inputs.species[0].species = "Quercus robur";
    EXPECT_EQ(
        message_of([&] { inputs_of(inputs.site, inputs.species, inputs.parameters, inputs.climate, {}); }),
        "no parameters of 'Quercus robur'");
}

}  // namespace
}  // namespace coupling::validation::forest_cases::plain_3pg::inputs_test
