#include "coupling/inputs/own_files/table_count.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <sstream>

#include "coupling/inputs/own_files/own_rows.hpp"
#include "coupling/inputs/tables/csv_row.hpp"

namespace coupling::table_count_test {
namespace {

TEST(TableCount, CountsRowsAsTheReaderDoesHoweverTheBytesArrive) {
    rc::check([](const std::vector<std::string>& texts) {
        std::ostringstream out;
        out << "text,x\n";
        CsvRow row{out, 2};
        for (const std::string& text : texts) {
            row.text(text).text("").end();
        }
        const std::string table = out.str();
        TableCount count;
        for (std::size_t at = 0; at < table.size();) {
            const auto piece = *rc::gen::inRange<std::size_t>(1, table.size() - at + 1);
            count.add(table.data() + at, piece);
            at += piece;
        }
        RC_ASSERT(count.end().bytes == table.size());
        RC_ASSERT(count.end().rows == texts.size());
    });
}

TEST(TableCount, GoesOnBehindWholeRows) {
    const std::string more = "3,4\n5,6\n";
    TableCount count{TableEnd{8, 1}};
    count.add(more.data(), more.size());
    EXPECT_EQ(count.end().bytes, 16U);
    EXPECT_EQ(count.end().rows, 3U);
}

}  // namespace
}  // namespace coupling::table_count_test
