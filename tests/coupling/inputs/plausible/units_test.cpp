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

TEST(TreeUnits, LetRealStandsPass) {
    EXPECT_EQ(unit_fault("dbh_cm,height_m\n37.6,23.6\n15.7,13.9\n34.2,23\n"), "");
    EXPECT_EQ(unit_fault("dbh_cm\n8\n120\n45\n"), "");
    // Giants: the thickest silver firs and the tallest Douglas firs of Europe.
    EXPECT_EQ(unit_fault("dbh_cm,height_m\n150,48\n140,67\n199,55\n"), "");
}

TEST(TreeUnits, LetSaplingsPassThatHaveTheirHeights) {
    EXPECT_EQ(unit_fault("dbh_cm,height_m\n0.5,1.6\n0.8,1.9\n1.2,2.4\n"), "");
    EXPECT_NE(unit_fault("dbh_cm\n0.5\n0.8\n1.2\n").find("if these are saplings, add height_m"),
              std::string::npos);
}

TEST(TreeUnits, LetStumpsAndSnagsPass) {
    EXPECT_EQ(unit_fault("dbh_cm,height_m,state\n45,0.4,stump\n60,0.5,stump\n"), "");
    EXPECT_EQ(unit_fault("dbh_cm,height_m,state\n45,0.4,stump\n60,0.5,stump\n30,22,\n"), "");
}

TEST(TreeUnits, FindMetresAndMillimetresOfDiameters) {
    EXPECT_NE(unit_fault("dbh_cm,height_m\n0.37,23\n0.16,14\n0.34,23\n").find("looks like metres"),
              std::string::npos);
    EXPECT_NE(unit_fault("dbh_cm\n376\n157\n342\n").find("looks like millimetres"), std::string::npos);
    // A thicket: its median says nothing yet, but nowhere is one tree in twenty thicker than 1.5 m.
    EXPECT_NE(unit_fault("dbh_cm\n76\n57\n80\n190\n").find("looks like girths or millimetres"),
              std::string::npos);
    EXPECT_NE(unit_fault("dbh_cm,height_m\n150,11\n140,10\n160,12\n").find("looks like millimetres"),
              std::string::npos);
}

TEST(TreeUnits, FindGirthsByTheNameOfTheirColumn) {
    for (const char* name : {"Umfang (cm)", "girth_cm", "circonference", "C130", "circumference"}) {
        std::istringstream in{std::string{"species,"} + name + "\nPIAB,90\n"};
        try {
            refuse_girths_alone(config::Table::read(in, "trees.csv"));
            ADD_FAILURE() << name;
        } catch (const config::InputError& error) {
            EXPECT_NE(std::string{error.what()}.find("in cm divided by 3.14159"), std::string::npos) << name;
        }
    }
    std::istringstream both{"species,girth_cm,dbh_cm\nPIAB,90,28.6\n"};
    EXPECT_NO_THROW(refuse_girths_alone(config::Table::read(both, "trees.csv")));
}

TEST(TreeUnits, FindOtherUnitsOfHeights) {
    EXPECT_NE(unit_fault("dbh_cm,height_m\n37,230\n16,140\n").find("height_m of 230"), std::string::npos);
    EXPECT_NE(unit_fault("dbh_cm,height_m\n12,60\n14,70\n13,65\n").find("times as high as thick"),
              std::string::npos);
    EXPECT_NE(unit_fault("dbh_cm,height_m\n37,0.23\n16,0.14\n").find("another unit"), std::string::npos);
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
