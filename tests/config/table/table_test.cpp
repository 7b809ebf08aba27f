#include "config/table/table.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <sstream>

namespace config::table_test {
namespace {

Table table_of(const std::string& text) {
    std::istringstream in{text};
    return Table::read(in, "trees.csv");
}

std::string message_of(const std::string& text) {
    try {
        table_of(text);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(Table, ReadsNamesUnitsAndFields) {
    const Table table = table_of("species,dbh,height\nunit,cm,m\nabal,32.5,25\nfasy,18,\n");
    ASSERT_EQ(table.rows(), 2U);
    EXPECT_EQ(table.units(), (std::vector<std::string>{"unit", "cm", "m"}));
    EXPECT_EQ(table.text(0, "species"), "abal");
    EXPECT_EQ(table.text(1, "height"), "");
    EXPECT_TRUE(table.has("dbh"));
    EXPECT_FALSE(table.has("DBH"));
}

TEST(Table, ReadsTheSameFromAnySpreadsheet) {
    for (const std::string text :
         {"a,b\n1,2\n",
          "\xEF\xBB\xBF"
          "a,b\r\n1,2\r\n",
          "a;b\n1;2", "# note; with\na , b\n\n 1 ,\t2\n,\n", "\"a\",\"b\"\n\"1\",2\n", "a,b,\n1,2,\n"}) {
        const Table table = table_of(text);
        ASSERT_EQ(table.columns(), (std::vector<std::string>{"a", "b"})) << text;
        ASSERT_EQ(table.rows(), 1U) << text;
        EXPECT_EQ(table.text(0, "a") + table.text(0, "b"), "12") << text;
    }
}

TEST(Table, ReadsTabsAndTheLineOfExcelThatNamesTheSeparator) {
    for (const std::string text :
         {"a\tb, c\td\n1\t2\t3\n", "sep=;\na;b, c;d\n1;2;3\n", "a\tb, c\td\r\n1\t2\t3\r\n"}) {
        const Table table = table_of(text);
        ASSERT_EQ(table.columns(), (std::vector<std::string>{"a", "b, c", "d"})) << text;
        EXPECT_EQ(table.text(0, "b, c"), "2") << text;
    }
    EXPECT_EQ(table_of("sep=,\na,b\n1,2\n").place(0, "b").line, 3U);
}

TEST(Table, ReadsDecimalCommasWhereTheySeparateNothing) {
    const Table table = table_of("id;dbh;name\n1;32,5;a,b\n2;-0,25;1,5 m\n");
    EXPECT_EQ(table.text(0, "dbh"), "32.5");
    EXPECT_EQ(table.text(1, "dbh"), "-0.25");
    EXPECT_EQ(table.text(0, "name"), "a,b");
    EXPECT_EQ(table.text(1, "name"), "1,5 m");
    EXPECT_EQ(table_of("id\tdbh\n1\t0,5\n").text(0, "dbh"), "0.5");
    EXPECT_EQ(table_of("id,dbh\n1,\"0,5\"\n").text(0, "dbh"), "0,5");  // they separate fields here
}

TEST(Features, GiveATableWithPlacesByTheirNumbers) {
    Features features{.file = "map.gpkg|roads",
                      .columns = {"wkt"},
                      .cells = {{"POINT (1 2)"}, {"POINT (3 4)", "b"}},
                      .numbers = {7, 9}};
    features.add_column("name");
    Table table = Table::of(std::move(features));
    EXPECT_EQ(table.text(0, "name"), "");
    EXPECT_EQ(table.text(1, "name"), "b");
    EXPECT_EQ(table.place(1, "name").line, 9U);
    EXPECT_EQ(table.place(1, "name").column, 2U);
    table.rename("name", "id");
    EXPECT_FALSE(table.has("name"));
    table.add_column("x", {"1", "3"}, "wkt");
    EXPECT_EQ(table.text(1, "x"), "3");
    EXPECT_EQ(table.place(1, "x").line, 9U);
}

TEST(Features, CallColumnsOfOneNameDifferently) {
    Features features;
    for (const char* name : {"wkt", "a", "a", ""}) {
        features.add_column(name);
    }
    EXPECT_EQ(features.columns, (std::vector<std::string>{"wkt_2", "a", "a_2", "column"}));
}

TEST(Table, KeepsCommasQuotesAndLineBreaksInsideQuotes) {
    const Table table = table_of("name,wkt\n\"a \"\"b\"\"\nc\",\"LINESTRING (0 0, 1 1)\"\nd,e\n");
    EXPECT_EQ(table.text(0, "name"), "a \"b\"\nc");
    EXPECT_EQ(table.text(0, "wkt"), "LINESTRING (0 0, 1 1)");
    EXPECT_EQ(table.place(1, "wkt").line, 4U);
}

TEST(Table, KnowsWhereAFieldStands) {
    const Place place = table_of("a,b\n# note\n\n10, x\n").place(0, "b");
    EXPECT_EQ(place.file, "trees.csv");
    EXPECT_EQ(place.line, 4U);
    EXPECT_EQ(place.column, 5U);
}

TEST(Table, TellsAFirstColumnWithoutANameWhereItMayComeFrom) {
    // Inputs of a run may lack it.
    EXPECT_EQ(message_of(",a\n"),
              "trees.csv:1:1: found a column without a name, expected a name; name it, or delete it: R's "
              "write.csv adds row names unless row.names = FALSE");
}

TEST(Table, CutsLongNamesOfColumnsOffInMessages) {
    const Table table = table_of(std::string(5000, 'a') + ",\"two\nlines\"\n");
    Problems problems;
    EXPECT_FALSE(table.require({"species"}, problems));
    const std::string message = to_string(problems.list().at(0));
    EXPECT_LT(message.size(), 300U);
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

TEST(Table, ReadsNumbersInTheirRange) {
    const Table table = table_of("id,dbh_cm\n7,32.5\n");
    Problems problems;
    EXPECT_EQ(table.number(0, "dbh_cm", {.low = 0.0}, problems), 32.5);
    EXPECT_EQ(table.whole(0, "id", {}, problems), 7);
    EXPECT_TRUE(problems.empty());
    EXPECT_FALSE(table.whole(0, "dbh_cm", {.low = 1.0}, problems));
    EXPECT_EQ(to_string(problems.list().at(0)),
              "trees.csv:2:3: found dbh_cm '32.5', expected a whole number >= 1");
}

/// What a table of a text is refused for.
std::vector<std::string> refused(const std::string& text) {
    std::vector<std::string> messages;
    try {
        Table::read(std::string_view{text}, "trees.csv");
    } catch (const InputError& error) {
        for (const Problem& problem : error.problems()) {
            messages.push_back(to_string(problem));
        }
    }
    return messages;
}

TEST(Table, RefusesALineOfTooManyFieldsAtOnce) {
    std::string header = "c1";
    for (std::size_t i = 2; i <= Table::most_columns; ++i) {
        header += ",c" + std::to_string(i);
    }
    EXPECT_EQ(refused(header), std::vector<std::string>{});
    const std::vector<std::string> messages = refused(header + ",one,two\n1,2\n");
    ASSERT_EQ(messages.size(), 1U);
    EXPECT_TRUE(messages[0].starts_with("trees.csv:1:") &&
                messages[0].find("found a line of more than 1000 fields, expected") != std::string::npos)
        << messages[0];
    EXPECT_EQ(refused("a,b\n" + header + ",x\n").size(), 1U);
}

TEST(Table, RefusesAFieldThatIsTooLongAtOnce) {
    const std::string longest(Table::longest_field_bytes, 'x');
    EXPECT_EQ(refused("a,b\n1," + longest + "\n"), std::vector<std::string>{});
    for (const std::string quote : {"", "\""}) {
        const std::vector<std::string> messages =
            refused("a,b\n1," + quote + longest + "x" + quote + "\n1\n");
        ASSERT_EQ(messages.size(), 1U);
        EXPECT_TRUE(
            messages[0].starts_with("trees.csv:2:3: found a field of more than 10 million bytes, expected"))
            << messages[0];
    }
}

TEST(Table, EndsAfterAHundredUnevenRows) {
    std::string text = "a,b\n";
    for (int row = 0; row < 300; ++row) {
        text += "1\n";
    }
    EXPECT_EQ(refused(text).size(), 100U);
}

RC_GTEST_PROP(CsvField, ReadsBackAsWritten, (const std::vector<std::string>& fields)) {
    std::ostringstream header;
    std::ostringstream row;
    header << "first";
    row << "x";
    for (std::size_t i = 0; i < fields.size(); ++i) {
        RC_PRE(fields[i].find('\0') == std::string::npos);
        header << ",c" << i;
        row << ',' << csv_field(fields[i]);
    }
    const Table table = table_of(header.str().append("\n").append(row.str()));
    for (std::size_t i = 0; i < fields.size(); ++i) {
        RC_ASSERT(table.text(0, table.columns()[i + 1]) == fields[i]);
    }
}

}  // namespace
}  // namespace config::table_test
