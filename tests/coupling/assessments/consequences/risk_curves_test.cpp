#include "coupling/assessments/consequences/risk_curves.hpp"

#include <gtest/gtest.h>

#include "config/data/shipped_tables.hpp"
#include "config/errors/input_error.hpp"

namespace coupling::consequences::risk_curves_test {
namespace {

Curves curves_of(const std::string& rows) {
    return Curves::read(config::Table::read(
        "energy_from_kj,lethality_in_vehicle,lethality_in_house,damage_to_house\n" + rows, "curves.csv"));
}

TEST(RiskCurves, BeginAClassAtItsLowerEnd) {
    const Curves curves = curves_of("300,0.8,0.3,0.5\n0,0.1,0,0\n30,0.5,0.03,0.1\n");
    ASSERT_EQ(curves.classes().size(), 3U);
    EXPECT_EQ(curves.class_of(0.0), 0U);
    EXPECT_EQ(curves.class_of(29.999), 0U);
    EXPECT_EQ(curves.class_of(30.0), 1U);
    EXPECT_EQ(curves.class_of(299.999), 1U);
    EXPECT_EQ(curves.class_of(300.0), 2U);
    EXPECT_EQ(curves.class_of(1e9), 2U);
    EXPECT_EQ(curves.classes()[1].lethality_in_vehicle, 0.5);
}

/// No number of the shipped table passes for a published one.
TEST(RiskCurves, SayWhereTheShippedOnesComeFrom) {
    const config::Table table = config::read_shipped_table("risk_curves.csv");
    ASSERT_EQ(table.rows(), Curves::shipped().classes().size());
    for (std::size_t row = 0; row < table.rows(); ++row) {
        EXPECT_EQ(table.text(row, "source"), "[choice]");
    }
}

TEST(RiskCurves, AreRefusedWhereTheyFallOrBeginLate) {
    EXPECT_THROW(curves_of("0,0.1,0,0\n30,0.05,0.03,0.1\n"), config::InputError);
    EXPECT_THROW(curves_of("30,0.1,0,0\n"), config::InputError);
    EXPECT_THROW(curves_of("0,0.1,0,0\n0,0.2,0,0\n"), config::InputError);
    EXPECT_THROW(curves_of("0,1.1,0,0\n"), config::InputError);
}

}  // namespace
}  // namespace coupling::consequences::risk_curves_test
