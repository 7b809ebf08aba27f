#include "config/data/shipped_tables.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "config/table/table.hpp"

namespace config::shipped_tables_test {
namespace {

std::vector<std::string> tables_in_the_folder() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator{BANNWALD_SOURCE_DIR "/config/data"}) {
        if (entry.path().extension() == ".csv") {
            names.push_back(entry.path().filename().string());
        }
    }
    std::sort(names.begin(), names.end());
    return names;
}

TEST(ShippedTables, AreAllThatLieInTheFolder) {
    EXPECT_EQ(shipped_table_names(), tables_in_the_folder());
}

TEST(ShippedTables, HoldTheBytesOfTheirFiles) {
    for (const std::string& name : shipped_table_names()) {
        std::ifstream in{BANNWALD_SOURCE_DIR "/config/data/" + name, std::ios::binary};
        const std::string bytes{std::istreambuf_iterator<char>{in}, {}};
        EXPECT_EQ(shipped_table(name), bytes) << name;
    }
}

TEST(ShippedTables, AreWellFormed) {
    for (const std::string& name : shipped_table_names()) {
        std::istringstream in{std::string{shipped_table(name)}};
        EXPECT_GT(Table::read(in, name).rows(), 0U) << name;
    }
}

TEST(ShippedTables, RefuseANameThatIsNotShipped) {
    EXPECT_THROW(shipped_table("gold.csv"), std::out_of_range);
}

}  // namespace
}  // namespace config::shipped_tables_test
