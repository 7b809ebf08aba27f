#include "coupling/results/excel_csv.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "config/table/table.hpp"

namespace coupling::excel_csv_test {
namespace {

std::string excel(const std::string& table, char decimal_sign) {
    std::ostringstream out;
    OwnRows rows{table, "table.csv"};
    write_excel_csv(out, rows, decimal_sign);
    return out.str();
}

constexpr const char* table =
    "target_id,name,energy_kj,wkt\n"
    "r1,\"road; \"\"B 198\"\"\",-12.50,\"LINESTRING (1.5 2, 3 4)\"\n"
    "2,,,\n";

TEST(ExcelCsv, HasSemicolonsABomAndTheDecimalSign) {
    EXPECT_EQ(excel(table, ','),
              "\xEF\xBB\xBFtarget_id;name;energy_kj;wkt\n"
              "r1;\"road; \"\"B 198\"\"\";-12,50;LINESTRING (1.5 2, 3 4)\n"
              "2;;;\n");
    EXPECT_NE(excel(table, '.').find("-12.50"), std::string::npos);
}

TEST(ExcelCsv, IsReadBackAsWhatItWas) {
    const config::Table before = config::Table::read(table, "before.csv");
    const std::string text = excel(table, ',');
    const config::Table after = config::Table::read(text, "after.csv");
    ASSERT_EQ(after.rows(), before.rows());
    EXPECT_EQ(after.columns(), before.columns());
    for (std::size_t row = 0; row < before.rows(); ++row) {
        EXPECT_EQ(after.text(row, "energy_kj"), before.text(row, "energy_kj"));
        EXPECT_EQ(after.text(row, "name"), before.text(row, "name"));
    }
}

}  // namespace
}  // namespace coupling::excel_csv_test
