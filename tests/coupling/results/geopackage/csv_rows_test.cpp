#include "coupling/results/geopackage/csv_rows.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "coupling/results/csv_row.hpp"

namespace coupling::geopackage::csv_rows_test {
namespace {

TEST(CsvRows, ReadWhatCsvRowWrote) {
    std::ostringstream out;
    out << "name,count,mass_kg\n";
    CsvRow row{out};
    row.text("road \"B 198\", lower\nlane").whole(3U).number<1>(2.5).end();
    row.text("").empty().number<2>(-1.0).end();
    const std::string text = out.str();
    CsvRows rows{text};
    EXPECT_EQ(rows.columns(), (std::vector<std::string>{"name", "count", "mass_kg"}));
    ASSERT_TRUE(rows.next());
    EXPECT_EQ(rows.fields(), (std::vector<std::string_view>{"road \"B 198\", lower\nlane", "3", "2.5"}));
    ASSERT_TRUE(rows.next());
    EXPECT_EQ(rows.fields(), (std::vector<std::string_view>{"", "", "-1.00"}));
    EXPECT_FALSE(rows.next());
}

TEST(ColumnTypes, ComeFromTheValuesButKeysAreWords) {
    ColumnTypes types{{"tree_id", "hits", "energy_kj", "species", "unknown"}};
    types.see({"12", "3", "1.5", "PIAB", ""});
    types.see({"13", "-4", "2", "7", ""});
    std::vector<ColumnType> seen;
    for (const Column& column : types.columns()) {
        seen.push_back(column.type);
    }
    EXPECT_EQ(seen, (std::vector{ColumnType::text, ColumnType::whole, ColumnType::number, ColumnType::text,
                                 ColumnType::number}));
}

}  // namespace
}  // namespace coupling::geopackage::csv_rows_test
