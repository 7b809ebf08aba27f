#include "coupling/results/geopackage/column_types.hpp"

#include <gtest/gtest.h>

namespace coupling::geopackage::column_types_test {
namespace {

TEST(ColumnTypes, AreThoseOfTheLayoutButKeysAreWords) {
    const std::vector<TableLayout> layouts{{"trees_YEAR.csv",
                                            "a tree",
                                            {{"tree_id", "-", "", "", Holds::whole},
                                             {"hits", "-", "", "", Holds::whole},
                                             {"energy_kj", "kJ", "", "", Holds::number},
                                             {"species", "text", "", "", Holds::text}}}};
    const std::vector<std::string> names{"tree_id", "hits", "energy_kj", "species", "unknown"};
    std::vector<ColumnType> types;
    for (const Column& column : declared_columns(names, layouts, "tables/trees_30.csv")) {
        types.push_back(column.type);
    }
    EXPECT_EQ(types, (std::vector{ColumnType::text, ColumnType::whole, ColumnType::number, ColumnType::text,
                                  ColumnType::text}));
    EXPECT_EQ(declared_columns({"hits"}, layouts, "tables/rocks.csv")[0].type, ColumnType::text);
}

}  // namespace
}  // namespace coupling::geopackage::column_types_test
