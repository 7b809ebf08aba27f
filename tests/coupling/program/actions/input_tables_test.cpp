// What holds for each column of each declared table: what is wrong with one field gives one problem that
// names the file, the line and the column of the text. Names of single tests are not repeated for each table.

#include "coupling/program/actions/input_tables.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

#include "config/data/shipped_tables.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/tables/meant_columns.hpp"
#include "forest/stand/species_fields.hpp"

namespace coupling::input_tables_test {
namespace {

using config::ColumnRules;
using config::FieldKind;
using config::TableSchema;
using Rows = std::vector<std::vector<std::string>>;

std::vector<const TableSchema*> all_tables() {
    std::vector<const TableSchema*> tables = input_tables();
    tables.push_back(&forest::species_columns());
    return tables;
}

/// A text that a column may hold, another one in each of three rows.
std::string good_text(const ColumnRules& column, std::size_t row) {
    const double low = std::isfinite(column.rules.range.low) ? column.rules.range.low : 1.0;
    const double high = std::min(column.rules.range.high, low + 12.0);
    const auto step = static_cast<double>(row + 1);
    switch (column.kind) {
        case FieldKind::number:
        case FieldKind::numbers:
            return config::to_text(low + (high - low) * step / 4.0);
        case FieldKind::whole:
            return config::to_text(std::min(high, std::ceil(low) + step - 1.0));
        case FieldKind::word:
            return column.rules.words[row % column.rules.words.size()];
        case FieldKind::flag:
            return row == 0 ? "yes" : "no";
        case FieldKind::shape:
            break;
        case FieldKind::text:
        case FieldKind::words:
            return "text" + std::to_string(row);
    }
    switch (column.rules.shapes.front()) {
        case config::Shape::Kind::point:
            return "POINT (3 4)";
        case config::Shape::Kind::line:
            return "LINESTRING (3 4, 5 6)";
        default:
            return "POLYGON ((0 0, 1 0, 1 1, 0 0))";
    }
}

/// A table of a schema that has nothing wrong, until a test changes it.
struct Sample {
    explicit Sample(const TableSchema& of) : schema{of}, names{of.names()} {
        for (std::size_t row = 0; row < 2; ++row) {
            std::vector<std::string>& cells = rows.emplace_back();
            for (const ColumnRules& column : of.columns()) {
                cells.push_back(good_text(column, row));
            }
        }
    }

    void leave_out(std::size_t column) {
        names.erase(names.begin() + static_cast<std::ptrdiff_t>(column));
        for (auto& cells : rows) {
            cells.erase(cells.begin() + static_cast<std::ptrdiff_t>(column));
        }
    }

    [[nodiscard]] static std::string line_of(const std::vector<std::string>& cells) {
        std::string line;
        for (const std::string& cell : cells) {
            line += (line.empty() && &cell == &cells.front() ? "" : ",") + config::csv_field(cell);
        }
        return line + "\n";
    }
    [[nodiscard]] config::Table table() const {
        std::string text = line_of(names);
        for (const auto& cells : rows) {
            text += line_of(cells);
        }
        std::istringstream in{text};
        return config::Table::read(in, "t.csv");
    }
    [[nodiscard]] std::vector<config::Problem> problems() const {
        config::Problems found;
        try {
            schema.check(table(), found);
        } catch (const config::InputError& error) {
            found.add(error);
        }
        return found.list();
    }
    /// The only problem, in the field of a row and column.
    [[nodiscard]] std::string problem_in(std::size_t row, std::size_t column) const {
        const auto found = problems();
        if (found.size() != 1) {
            return std::to_string(found.size()) + " problems";
        }
        config::Place place = table().place(row, names[column]);
        place.column += rows[row][column].find(',') == std::string::npos ? 0 : 1;  // behind the quote
        const bool is_there =
            found[0].place.file == "t.csv" && found[0].place.line == place.line &&
            std::max(found[0].place.column, place.column) - std::min(found[0].place.column, place.column) <=
                1;
        return is_there ? found[0].found + ", expected " + found[0].expected
                        : "elsewhere: " + config::to_string(found[0]);
    }

    const TableSchema& schema;
    std::vector<std::string> names;
    Rows rows;
};

/// Calls `test` with a new sample for each column of each table.
template <class Test>
void for_each_column(Test test) {
    for (const TableSchema* schema : all_tables()) {
        for (std::size_t i = 0; i < schema->columns().size(); ++i) {
            SCOPED_TRACE(schema->rules().setting + ": " + schema->columns()[i].name);
            test(Sample{*schema}, schema->columns()[i], i);
        }
    }
}

void expect_in(const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text << "\nlacks: " << part;
}

TEST(InputTables, HaveNothingWrongWithGoodRows) {
    EXPECT_GE(all_tables().size(), 25U);
    for (const TableSchema* schema : all_tables()) {
        const Sample sample{*schema};
        for (const config::Problem& problem : sample.problems()) {
            ADD_FAILURE() << schema->rules().setting << ": " << config::to_string(problem);
        }
    }
}

TEST(InputTables, NameAColumnThatIsMissingOrMisspelt) {
    for_each_column([](Sample sample, const ColumnRules& column, std::size_t i) {
        Sample misspelt = sample;
        misspelt.names[i].insert(1, "q");
        sample.leave_out(i);
        if (!column.is_needed()) {
            EXPECT_EQ(sample.problems().size(), 0U);
            const auto warnings = misspelt_columns(misspelt.table(), sample.schema.names());
            ASSERT_EQ(warnings.size(), 1U);
            EXPECT_EQ(config::to_string(warnings[0]), "t.csv: found column '" + misspelt.names[i] +
                                                          "', which is passed over, expected " + column.name +
                                                          ", if that is what is meant");
            return;
        }
        if (!sample.names.empty()) {
            ASSERT_EQ(sample.problems().size(), 1U);
            expect_in(config::to_string(sample.problems()[0]), "t.csv: no column '" + column.name + "'");
        }
        ASSERT_EQ(misspelt.problems().size(), 1U);
        const std::string meant =
            column.name.size() < 3 ? "" : " (is '" + misspelt.names[i] + "' meant to be it?)";
        expect_in(config::to_string(misspelt.problems()[0]),
                  "t.csv: no column '" + column.name + "'" + meant);
    });
}

TEST(InputTables, TakeNumbersAtTheirBoundsAndRefuseThemBeyond) {
    for_each_column([](Sample sample, const ColumnRules& column, std::size_t i) {
        if (column.kind != FieldKind::number && column.kind != FieldKind::whole) {
            return;
        }
        const config::NumberRange& range = column.rules.range;
        for (const bool is_low : {true, false}) {
            const double bound = is_low ? range.low : range.high;
            if (!std::isfinite(bound)) {
                continue;
            }
            sample.rows[0][i] = config::to_text(bound);
            const bool is_inside = !(is_low && range.low_excluded);
            if (is_inside) {
                EXPECT_EQ(sample.problems().size(), 0U) << bound;
            } else {
                expect_in(sample.problem_in(0, i), config::to_string(range));
            }
            const double beyond = column.kind == FieldKind::whole ? 1.0 : 1e-3 + 1e-6 * std::abs(bound);
            sample.rows[0][i] = config::to_text(is_low ? bound - beyond : bound + beyond);
            expect_in(sample.problem_in(0, i), column.name + " '" + sample.rows[0][i] + "', expected a ");
            expect_in(sample.problem_in(0, i), config::to_string(range));
        }
        sample.rows[0][i] = "1;5";
        expect_in(sample.problem_in(0, i), column.name + " '1;5', expected a ");
    });
}

TEST(InputTables, RefuseUnknownWordsFlagsAndShapes) {
    for_each_column([](Sample sample, const ColumnRules& column, std::size_t i) {
        sample.rows[1][i] = column.kind == FieldKind::shape ? "POINT 3" : "xyzzy";
        if (column.kind == FieldKind::word || column.kind == FieldKind::flag) {
            expect_in(sample.problem_in(1, i),
                      column.name + " 'xyzzy', expected " + column.values_in_words());
        } else if (column.kind == FieldKind::numbers) {
            expect_in(sample.problem_in(1, i), column.name + " 'xyzzy', expected a number");
        } else if (column.kind == FieldKind::shape) {
            ASSERT_EQ(sample.problems().size(), 1U);
            EXPECT_EQ(sample.problems()[0].place.line, 3U);
        }
    });
}

TEST(InputTables, RefuseEmptyFieldsThatAreNeeded) {
    for_each_column([](Sample sample, const ColumnRules& column, std::size_t i) {
        sample.rows[1][i].clear();
        if (column.may_be_empty() || sample.names.size() == 1) {
            EXPECT_EQ(sample.problems().size(), 0U);
        } else if (column.kind == FieldKind::shape) {
            ASSERT_EQ(sample.problems().size(), 1U);
            EXPECT_EQ(sample.problems()[0].place.line, 3U);
        } else {
            expect_in(sample.problem_in(1, i), column.name);
        }
    });
}

TEST(InputTables, NameTheLineOfAValueThatComesASecondTime) {
    std::size_t tested = 0;
    for (const TableSchema* schema : all_tables()) {
        std::vector<std::vector<std::string>> groups = schema->rules().unique_together;
        for (const ColumnRules& column : schema->columns()) {
            if (column.rules.unique) {
                groups.push_back({column.name});
            }
        }
        for (const auto& group : groups) {
            Sample sample{*schema};
            std::size_t last = 0;
            for (const std::string& name : group) {
                last = static_cast<std::size_t>(std::find(sample.names.begin(), sample.names.end(), name) -
                                                sample.names.begin());
                sample.rows[1][last] = sample.rows[0][last];
            }
            expect_in(sample.problem_in(1, last), " a second time, as in line 2, expected one ");
            ++tested;
        }
    }
    EXPECT_GE(tested, 8U);
}

TEST(InputTables, KnowTheColumnsThatOtherProgramsCallOtherwise) {
    std::set<std::string> roles;
    std::set<std::string> known;
    for (const TableSchema* schema : all_tables()) {
        roles.insert(schema->rules().role);
        for (const std::string& name : schema->names()) {
            known.insert(schema->rules().role + "," + name);
        }
    }
    const config::Table words = config::read_shipped_table("column_names.csv");
    for (std::size_t row = 0; row < words.rows(); ++row) {
        const std::string& role = words.text(row, "role");
        if (roles.contains(role)) {
            EXPECT_TRUE(known.contains(role + "," + words.text(row, "column")))
                << role << ", " << words.text(row, "column");
        }
    }
}

TEST(InputTables, StandInTheManualAsTheProgramPrintsThem) {
    std::ifstream in{std::string{BANNWALD_SOURCE_DIR} + "/coupling/inputs/tables/README.md"};
    const std::string manual{std::istreambuf_iterator<char>{in}, {}};
    std::ostringstream printed;
    write_input_tables("", printed);
    EXPECT_NE(manual.find("<!-- written by bannwald info inputs -->\n" + printed.str() + "<!-- end of "),
              std::string::npos)
        << "put the output of `bannwald info inputs` between the two marks of "
           "coupling/inputs/tables/README.md";
}

TEST(InputTables, ThatNobodyKnowsAreRefusedWithTheNearestName) {
    std::ostringstream out;
    try {
        write_input_tables("tree", out);
        FAIL();
    } catch (const config::InputError& error) {
        expect_in(error.what(), "found table 'tree', expected 'trees'");
    }
}

}  // namespace
}  // namespace coupling::input_tables_test
