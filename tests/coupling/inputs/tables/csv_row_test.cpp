#include "coupling/inputs/tables/csv_row.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>

#include "config/text/joined.hpp"

namespace coupling::csv_row_test {
namespace {

using config::joined;

template <class Fill>
std::string row_of(Fill fill) {
    std::ostringstream out;
    CsvRow row{out};
    fill(row);
    row.end();
    return out.str();
}

TEST(CsvRow, WritesFixedDecimals) {
    EXPECT_EQ(
        row_of([](CsvRow& row) { row.number<2>(1.005e3).number<3>(-0.0426).number<0>(12.6).number<2>(0.0); }),
        "1005.00,-0.043,13,0.00\n");
}

TEST(CsvRow, NeverWritesAMinusBeforeZero) {
    EXPECT_EQ(row_of([](CsvRow& row) { row.number<2>(-0.001); }), "0.00\n");
}

TEST(CsvRow, LeavesWhatIsNotKnownEmpty) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(row_of([](CsvRow& row) { row.whole(7U).number<2>(std::nan("")).number<2>(infinity).empty(); }),
              "7,,,\n");
}

TEST(CsvRow, WritesNumbersTooLargeForWholeDigits) {
    EXPECT_EQ(row_of([](CsvRow& row) { row.number<1>(1e18); }), "1000000000000000000.0\n");
}

TEST(CsvRow, QuotesTexts) {
    EXPECT_EQ(row_of([](CsvRow& row) { row.text("a,b").text("plain"); }), "\"a,b\",plain\n");
}

TEST(CsvRow, HoldsRowsLongerThanItsBuffer) {
    std::string expected = "0";
    for (int i = 1; i < 1000; ++i) {
        expected += joined(",", std::to_string(i));
    }
    EXPECT_EQ(row_of([](CsvRow& row) {
                  for (unsigned i = 0; i < 1000; ++i) {
                      row.whole(i);
                  }
              }),
              expected + "\n");
}

}  // namespace
}  // namespace coupling::csv_row_test
