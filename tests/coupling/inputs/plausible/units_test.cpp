#include "coupling/inputs/plausible/units.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>

#include "config/errors/input_error.hpp"

namespace coupling::plausible::units_test {
namespace {

/// What is wrong with such a list of trees; "" if nothing is.
std::string unit_fault(const std::string& text) {
    std::istringstream in{text};
    try {
        check_tree_units(config::Table::read(in, "trees.csv"));
        return "";
    } catch (const config::InputError& error) {
        return error.what();
    }
}

/// Trees of 20 to 60 cm with the heights of a stand, each figure times a factor.
std::string stand(double dbh_factor, double height_factor, bool swapped = false) {
    std::string text = swapped ? "height_m,dbh_cm\n" : "dbh_cm,height_m\n";
    for (int i = 0; i < 20; ++i) {
        const double dbh_cm = 20.0 + 2.0 * i;
        const double height_m = 1.3 + 31.0 * (1.0 - std::exp(-0.045 * dbh_cm));
        text += std::to_string(dbh_factor * dbh_cm) + "," + std::to_string(height_factor * height_m) + "\n";
    }
    return text;
}

TEST(TreeUnits, FindExchangedColumnsInchesAndFeet) {
    EXPECT_EQ(unit_fault(stand(1.0, 1.0)), "");
    EXPECT_NE(unit_fault(stand(1.0, 1.0, true)).find("the columns dbh_cm and height_m look swapped"),
              std::string::npos)
        << unit_fault(stand(1.0, 1.0, true));
    EXPECT_NE(unit_fault(stand(1.0 / 2.54, 1.0)).find("dbh_cm looks like inches"), std::string::npos);
    EXPECT_NE(unit_fault(stand(1.0, 1.0 / 0.3048)).find("height_m"), std::string::npos);
}

TEST(TreeUnits, LetADenseThicketPass) {
    std::string poles = "dbh_cm,height_m\n";
    for (int i = 0; i < 30; ++i) {
        poles += std::to_string(6 + i % 7) + "," + std::to_string(8.0 + 0.6 * (i % 7)) + "\n";
    }
    EXPECT_EQ(unit_fault(poles), "");
}

}  // namespace
}  // namespace coupling::plausible::units_test
