#include "coupling/results/vectors/dbf_fields.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <set>
#include <tuple>

#include "config/text/numbers.hpp"
#include "config/text/reading.hpp"

namespace coupling::vectors::dbf_fields_test {
namespace {

using geopackage::Column;
using geopackage::ColumnType;

std::string stripped(const std::string& row, std::size_t from, int width) {
    return std::string{config::trimmed(row.substr(from, static_cast<std::size_t>(width)))};
}

TEST(ShortNames, AreUniqueAndOfTenCharacters) {
    const std::vector<Column> columns{{"energy_mean_kj"}, {"energy_max_kj"},  {"energy_max_low_kj"},
                                      {"cover"},          {"Energy_Maximum"}, {"energy_ma"}};
    EXPECT_EQ(short_names(columns), (std::vector<std::string>{"energy_mea", "energy_max", "energy_m_2",
                                                              "cover", "Energy_M_3", "energy_ma"}));
    EXPECT_TRUE(rc::check([] {
        std::vector<Column> any;
        for (int i = *rc::gen::inRange(1, 60); i > 0; --i) {
            // Long names that differ at their ends only.
            any.push_back(
                {"a_long_column_" + std::to_string(i) + (*rc::gen::arbitrary<bool>() ? "_kj" : "_m")});
        }
        const std::vector<std::string> names = short_names(any);
        std::set<std::string> seen;
        for (const std::string& name : names) {
            RC_ASSERT(!name.empty() && name.size() <= 10U);
            seen.insert(config::in_lower_case(name));
        }
        RC_ASSERT(seen.size() == any.size());
    }));
}

TEST(DbfFields, KeepEveryNumber) {
    EXPECT_TRUE(rc::check([] {
        const auto declared = static_cast<std::size_t>(*rc::gen::inRange(0, 6));
        const std::vector<Column> columns{
            {"value", ColumnType::number}, {"count", ColumnType::whole}, {"words", ColumnType::text}};
        std::vector<std::vector<std::string>> rows;
        DbfFields fields{columns, std::vector<std::size_t>{declared, 0, 0}};
        for (int i = *rc::gen::inRange(1, 20); i > 0; --i) {
            const double value =
                static_cast<double>(*rc::gen::arbitrary<int>()) * std::pow(10.0, *rc::gen::inRange(-12, 12));
            rows.push_back({*rc::gen::inRange(0, 5) == 0 ? std::string{} : config::to_text(value),
                            std::to_string(*rc::gen::arbitrary<int>()), std::string(3, 'a')});
            fields.add_row(rows.back());
        }
        for (const std::vector<std::string>& row : rows) {
            const std::string bytes = fields.row(row);
            RC_ASSERT(bytes.size() == fields.row_bytes());
            const auto& [value, count, words] =
                std::tie(fields.fields()[0], fields.fields()[1], fields.fields()[2]);
            const std::string first = stripped(bytes, 1, value.width);
            RC_ASSERT(first.empty() == row[0].empty());
            if (!first.empty()) {
                const bool is_same = config::parse_number(first) == config::parse_number(row[0]);
                RC_ASSERT(is_same);
            }
            const auto behind = static_cast<std::size_t>(1 + value.width);
            RC_ASSERT(stripped(bytes, behind, count.width) == row[1]);
            RC_ASSERT(value.decimals >= static_cast<int>(declared));
        }
    }));
}

TEST(DbfFields, GiveWholeNumbersRoomForThePlaceThatAnExponentNeeds) {
    const std::vector<Column> columns{{"value", ColumnType::number}};
    DbfFields fields{columns, std::vector<std::size_t>{0}};
    for (const std::string number : {"12345678", "1e-9"}) {
        fields.add_row(std::vector{number});
    }
    EXPECT_EQ(fields.row(std::vector<std::string>{"12345678"}), " 12345678.0");
    EXPECT_EQ(fields.row(std::vector<std::string>{"1e-9"}), "       1e-9");
}

TEST(DbfFields, HaveTheDecimalsOfTheTable) {
    const std::vector<Column> columns{{"energy_kj", ColumnType::number}};
    DbfFields fields{columns, std::vector<std::size_t>{2}};
    for (const std::string number : {"12.5", "0", "-3.25"}) {
        fields.add_row(std::vector{number});
    }
    EXPECT_EQ(fields.fields()[0].decimals, 2);
    EXPECT_EQ(fields.row(std::vector<std::string>{"12.5"}), " 12.50");
    EXPECT_EQ(fields.row(std::vector<std::string>{"-3.25"}), " -3.25");
    EXPECT_EQ(fields.row(std::vector<std::string>{""}), "      ");
}

TEST(DbfFields, CutWordsBetweenCharactersAndSaySo) {
    const std::vector<Column> columns{{"name", ColumnType::text}};
    DbfFields fields{columns, std::vector<std::size_t>{0}};
    std::string words(253, 'a');
    words += "ö";  // two bytes, of which one would fit
    fields.add_row(std::vector{words});
    EXPECT_TRUE(fields.fields()[0].is_cut);
    EXPECT_EQ(fields.row(std::vector{words}), " " + std::string(253, 'a') + " ");
}

TEST(DbfFields, TakeAWordAmongNumbersForWords) {
    const std::vector<Column> columns{{"hits", ColumnType::whole}};
    DbfFields fields{columns, std::vector<std::size_t>{0}};
    fields.add_row(std::vector<std::string>{"12"});
    fields.add_row(std::vector<std::string>{"or_more"});
    EXPECT_EQ(fields.fields()[0].type, 'C');
    EXPECT_EQ(fields.row(std::vector<std::string>{"or_more"}), " or_more");
}

}  // namespace
}  // namespace coupling::vectors::dbf_fields_test
