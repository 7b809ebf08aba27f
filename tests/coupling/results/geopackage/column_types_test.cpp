#include "coupling/results/geopackage/column_types.hpp"

#include <gtest/gtest.h>

namespace coupling::geopackage::column_types_test {
namespace {

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
}  // namespace coupling::geopackage::column_types_test
