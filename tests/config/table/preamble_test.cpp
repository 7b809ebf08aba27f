#include "config/table/preamble.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <string>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/table/table.hpp"

namespace config::preamble_test {
namespace {

TEST(LinesAboveHeader, AreWhatServicesPutThere) {
    EXPECT_EQ(lines_above_header("Latitude: 47.2  Longitude: 11.4\nTile: 12, north\n\n"
                                 "year,yday,tmax (deg c)\n1990,1,2.5\n1990,2,3.5\n"),
              3U);
    EXPECT_EQ(lines_above_header("MeteoSchweiz / MeteoSuisse\n\nstn;time;tre200d0\nDAV;19810101;-3.2\n"), 2U);
}

TEST(LinesAboveHeader, MayEndWithAHeaderInAComment) {
    const Table table = Table::read(std::string_view{"BRON: x\nTN = low, in 0.1 degC\n\n# STN,DAY,   TN, \n\n"
                                                     "  260,19800101,  -8, \n  260,19800102,  -21, \n"},
                                    "file");
    EXPECT_EQ(table.columns(), (std::vector<std::string>{"STN", "DAY", "TN"}));
    EXPECT_EQ(table.text(1, "TN"), "-21");
    EXPECT_EQ(table.place(0, "TN").line, 6U);
}

TEST(LinesAboveHeader, MayBeATableOfTheirOwnAboveAnEmptyLine) {
    const Table table = Table::read(
        std::string_view{
            "latitude,longitude,elevation,zone\n47.2,11.4,1210,GMT\n\ntime,tmax,tmin\n1,2,3\n4,5,6\n"},
        "file");
    EXPECT_EQ(table.columns(), (std::vector<std::string>{"time", "tmax", "tmin"}));
    EXPECT_EQ(table.rows(), 2U);
}

TEST(LinesAboveHeader, AreNoneOfAnOrdinaryTable) {
    EXPECT_EQ(lines_above_header("year,month,tmin_c\n1990,1,2.5\n1990,2,3.5\n"), 0U);
    EXPECT_EQ(lines_above_header("# a comment\nyear,month,tmin_c\n1990,1,2.5\n"), 0U);
    EXPECT_EQ(lines_above_header("sep=;\na;b;c\n1;2;3\n4;5;6\n"), 0U);
    EXPECT_EQ(lines_above_header(""), 0U);
    EXPECT_EQ(lines_above_header("a,b,c\n"), 0U);
    EXPECT_EQ(lines_above_header("id;dbh;name\n1;32,5;a,b\n2;-0,25;1,5 m\n"), 0U) << "decimal commas";
    EXPECT_EQ(lines_above_header("id;dbh;name\n1;32,5;a,b\n2;-0,25;1,5 m;x\n"), 0U) << "and uneven rows";
}

TEST(LinesAboveHeader, AreLookedForOnlyWhereTheFirstLineIsNoHeader) {
    const Table table =
        Table::read(std::string_view{"name,shape,height\n\"a\nb;c;d\ne;f;g\nh;i;j\",x,y\n"}, "file");
    EXPECT_EQ(table.columns(), (std::vector<std::string>{"name", "shape", "height"}));
    EXPECT_EQ(table.text(0, "name"), "a\nb;c;d\ne;f;g\nh;i;j") << "line breaks in a field";
    EXPECT_TRUE(table.lines_above().empty());
}

TEST(LinesAboveHeader, DoNotHideUnevenRows) {
    // A header of two columns above rows of three numbers: the table is wrong, not explained.
    EXPECT_EQ(lines_above_header("tree_id,dbh_cm\n1,20,3\n2,30,4\n"), 0U);
    EXPECT_EQ(lines_above_header("tree_id,species\nbeech,a,b\n1,2,3\n4,5,6\n7,8\n"), 0U);
}

TEST(LinesAboveHeader, LeaveTheTableAndItsLinesAsTheyAre) {
    EXPECT_TRUE(rc::check([] {
        const int above = *rc::gen::inRange(0, 12);
        std::string text;
        for (int i = 0; i < above; ++i) {
            text += *rc::gen::element(std::string{"-BEGIN HEADER-"}, std::string{"Missing values: -999"},
                                      std::string{"T2M_MIN  minimum (C), of 2 m"}, std::string{});
            text += '\n';
        }
        const std::string table = "YEAR,MO,DY,T2M_MIN\n1990,1,1,-3.5\n1990,1,2,-2.5\n";
        const Table plain = Table::read(std::string_view{table}, "file");
        const std::string whole = text + table;
        const Table read = Table::read(std::string_view{whole}, "file");
        RC_ASSERT(read.columns() == plain.columns());
        RC_ASSERT(read.rows() == plain.rows());
        for (std::size_t row = 0; row < read.rows(); ++row) {
            RC_ASSERT(read.text(row, "T2M_MIN") == plain.text(row, "T2M_MIN"));
            RC_ASSERT(read.place(row, "MO").line ==
                      plain.place(row, "MO").line + static_cast<std::size_t>(above));
        }
    }));
}

}  // namespace
}  // namespace config::preamble_test
