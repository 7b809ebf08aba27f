#include "config/table/column_form.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <utility>

namespace config::column_form_test {
namespace {

std::string taken_apart(const std::string& name) {
    const ColumnForm form = form_of(name);
    return form.quantity + "|" + form.unit;
}

bool same(const std::string& a, const std::string& b) {
    return is_same_column(form_of(a), form_of(b));
}

TEST(FormOf, TakesTheUnitInBracketsOrBehindTheName) {
    for (const char* name :
         {"BHD [cm]", "bhd_cm", "BHD (cm)", "Bhd.cm", "BHD cm", "BHD in cm", " bhd  [ cm ]"}) {
        EXPECT_EQ(taken_apart(name), "bhd|cm") << name;
    }
    EXPECT_EQ(taken_apart("Höhe [m ü. M.]"), "hoehe|m");
    EXPECT_EQ(taken_apart("rad_mj_m2_d"), "rad|mjm2d");
    EXPECT_EQ(taken_apart("Radiation [MJ/m²/d]"), "radiation|mjm2d");
    EXPECT_EQ(taken_apart("stems [1/ha]"), "stems|pha");
    EXPECT_EQ(taken_apart("Tmin (°C)"), "tmin|c");
    EXPECT_EQ(taken_apart("speed_in_mps"), "speedin|mps");  // the speed of what comes in
    EXPECT_EQ(taken_apart("Dip [°]"), "dip|deg");
    EXPECT_EQ(taken_apart("side_c_m"), "sidec|m");  // not in cm
    EXPECT_EQ(taken_apart("prec_mm_d"), "prec|mmpd");
    EXPECT_EQ(taken_apart("N° arbre"), "narbre|");
}

TEST(FormOf, LeavesWhatIsNoUnit) {
    EXPECT_EQ(taken_apart("DBH (old)"), "dbhold|");
    EXPECT_EQ(taken_apart("r_n [-]"), "rn|");
    EXPECT_EQ(taken_apart("m"), "m|");  // a unit alone is a name
    EXPECT_EQ(taken_apart(""), "|");
    EXPECT_EQ(taken_apart("[m]"), "m|");
}

TEST(IsSameColumn, PassesOverTheFormAlone) {
    EXPECT_TRUE(same("Year", "year"));
    EXPECT_TRUE(same("R_N [-]", "r_n"));
    EXPECT_TRUE(same("Diamètre (cm)", "diametre_cm"));
    EXPECT_TRUE(same("velocity [m/s]", "velocity_mps"));
    EXPECT_FALSE(same("DBH (old)", "dbh_cm"));
    EXPECT_FALSE(same("DBH", "dbh_cm"));
    EXPECT_FALSE(same("", ""));
}

TEST(IsOtherUnit, NeedsTwoUnitsOfOneQuantity) {
    const auto other = [](const char* a, const char* b) { return is_other_unit(form_of(a), form_of(b)); };
    EXPECT_TRUE(other("BHD [mm]", "bhd_cm"));
    EXPECT_TRUE(other("prec [mm/d]", "prec_mm"));
    EXPECT_FALSE(other("BHD", "bhd_cm"));
    EXPECT_FALSE(other("BHD [cm]", "bhd_cm"));
    EXPECT_FALSE(other("height_cm", "bhd_mm"));
}

TEST(ColumnForm, LeavesNamesOfDamagedTablesAsTheyAre) {
    const std::string longest(longest_column_bytes, 'a');
    EXPECT_TRUE(is_same_column(form_of("A" + longest.substr(1)), form_of(longest)));
    const std::string longer = "DBH [cm] " + longest;
    EXPECT_EQ(form_of(longer).letters, longer);
    EXPECT_TRUE(form_of(longer).quantity.empty() && form_of(longer).unit.empty());
    EXPECT_FALSE(is_same_column(form_of(longer), form_of("dbh_cm")));
}

TEST(UnitFactor, IsExactBetweenUnitsOfAKind) {
    EXPECT_DOUBLE_EQ(unit_factor("mm", "cm"), 0.1);
    EXPECT_DOUBLE_EQ(unit_factor("ft", "m"), 0.3048);
    EXPECT_DOUBLE_EQ(unit_factor("kmph", "mps"), 1.0 / 3.6);
    EXPECT_EQ(unit_factor("mm", "kg"), 0.0);
    EXPECT_EQ(unit_factor("k", "c"), 0.0);  // no factor
}

}  // namespace
}  // namespace config::column_form_test
