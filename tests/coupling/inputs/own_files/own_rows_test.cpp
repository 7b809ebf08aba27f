#include "coupling/inputs/own_files/own_rows.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <fstream>
#include <sstream>

#include "coupling/inputs/tables/csv_row.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "tests/coupling/results/small_run.hpp"

namespace coupling::own_rows_test {
namespace {

using small_runs::TestFolder;

std::vector<std::vector<std::string>> all_of(OwnRows& rows) {
    std::vector<std::vector<std::string>> all;
    while (rows.next()) {
        all.emplace_back(rows.fields().begin(), rows.fields().end());
    }
    return all;
}

TEST(OwnRows, GiveBackAnyTextThatCsvRowWrote) {
    const TestFolder folder;
    rc::check([&](const std::vector<std::pair<std::string, std::string>>& texts) {
        OutFile file{folder.path() / "table.csv"};
        file.count_table();
        file.stream() << "one,two\n";
        CsvRow row{file.stream(), 2};
        std::vector<std::vector<std::string>> expected;
        for (const auto& [one, two] : texts) {
            row.text(one).text(two).end();
            expected.push_back({one, two});
        }
        file.close();
        RC_ASSERT(file.end()->rows == texts.size());
        OwnRows rows{folder.path() / "table.csv", file.end()};
        RC_ASSERT(all_of(rows) == expected);
    });
}

TEST(OwnRows, GiveBackNamesWithWhateverSeparatesFields) {
    const std::string letters = "a,\"\n\r;= #'\t";
    rc::check([&] {
        const auto text = *rc::gen::container<std::string>(rc::gen::elementOf(letters));
        std::ostringstream out;
        out << "name,next\n";
        CsvRow row{out, 2};
        row.text(text).text("x").end();
        row.text("y").text(text).end();
        const std::string table = out.str();
        OwnRows rows{table, "table.csv"};
        RC_ASSERT(all_of(rows) == (std::vector<std::vector<std::string>>{{text, "x"}, {"y", text}}));
    });
}

TEST(OwnRows, ReadTablesOfManyBlocksWithRowsAcrossTheirEnds) {
    const TestFolder folder;
    OutFile file{folder.path() / "table.csv"};
    file.count_table();
    file.stream() << "number,text\n";
    CsvRow row{file.stream(), 2};
    constexpr std::uint64_t count = 60'000;  // about 3 MB: blocks are of 1 MiB
    const auto text_of = [](std::uint64_t i) {
        return i == 40'000 ? std::string(3'000'000, 'w') : std::string(i % 97, i % 7 == 0 ? '"' : 'x');
    };
    for (std::uint64_t i = 0; i < count; ++i) {
        row.whole(i).text(text_of(i)).end();
    }
    file.close();
    OwnRows rows{folder.path() / "table.csv", file.end()};
    for (std::uint64_t i = 0; i < count; ++i) {
        ASSERT_TRUE(rows.next());
        ASSERT_EQ(rows.fields()[0], std::to_string(i));
        ASSERT_EQ(rows.fields()[1], text_of(i));
        ASSERT_EQ(rows.line(), i + 2);
    }
    EXPECT_FALSE(rows.next());
    EXPECT_EQ(rows.share(), 1.0);
}

/// As a spreadsheet saves a table: the carriage return behind a quote may be the last byte of a block.
TEST(OwnRows, ReadLineEndsOfSpreadsheetsAcrossTheEndOfABlock) {
    constexpr std::size_t block_bytes = std::size_t{1} << 20U;
    const TestFolder folder;
    for (std::size_t short_by = 0; short_by < 6; ++short_by) {
        std::string table = "name,next\r\n\"";
        table += std::string(block_bytes - table.size() - 6 + short_by, 'x') + "\",\"y\"\r\nz,\"w\"\r\n";
        std::ofstream{folder.path() / "table.csv", std::ios::binary} << table;
        OwnRows rows{folder.path() / "table.csv"};
        const std::vector<std::vector<std::string>> all = all_of(rows);
        ASSERT_EQ(all.size(), 2U);
        EXPECT_EQ(all.front().back(), "y");
        EXPECT_EQ(all.back(), (std::vector<std::string>{"z", "w"}));
    }
}

TEST(OwnRows, RefuseEveryTableThatIsCutOff) {
    const TestFolder folder;
    const std::string whole = "rock,target\n1,\"Gasthof \"\"Post\"\"\"\n22,\"two\nlines\"\n333,road\n";
    const TableEnd end{whole.size(), 3};
    for (std::size_t bytes = 0; bytes <= whole.size(); ++bytes) {
        std::ofstream{folder.path() / "table.csv", std::ios::binary} << whole.substr(0, bytes);
        const auto read = [&] {
            OwnRows rows{folder.path() / "table.csv", end};
            return all_of(rows).size();
        };
        if (bytes == whole.size()) {
            EXPECT_EQ(read(), 3U);
        } else {
            EXPECT_THROW(read(), config::InputError) << bytes;
        }
    }
}

TEST(OwnRows, RefuseWhatThisProgramCannotHaveWritten) {
    for (const char* text : {"", "a,b", "a,b\n1\n", "a,b\n1,2,3\n", "a,b\n\"1\"x,2\n", "a,b\n\"1,2\n",
                             "a,b\n1,2", "a,b\n\n1,2\n"}) {
        EXPECT_THROW(
            {
                OwnRows rows(text, "table.csv");
                all_of(rows);
            },
            config::InputError)
            << text;
    }
    try {
        OwnRows rows{"a,b\n1,2\n1,\"x\n\"\n3\n", "table.csv"};
        all_of(rows);
        FAIL();
    } catch (const config::InputError& error) {
        EXPECT_EQ(error.code(), config::ExitCode::file);
        EXPECT_NE(std::string{error.what()}.find("table.csv:5:1"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace coupling::own_rows_test
