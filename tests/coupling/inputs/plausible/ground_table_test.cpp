// What is said of a table of ground types depends neither on the order of its rows nor on that of its
// columns, and each wrong row is found wherever it stands.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "config/text/numbers.hpp"
#include "tests/coupling/inputs/opened.hpp"

namespace coupling::plausible::ground_table_test {
namespace {

using Row = std::map<std::string, std::string>;

/// A table of ground types, written in any order.
struct GroundTable {
    std::vector<std::string> columns;
    std::vector<Row> rows;

    [[nodiscard]] std::string text() const {
        std::string text;
        for (const std::string& column : columns) {
            text += (text.empty() ? "" : ",") + column;
        }
        for (const Row& row : rows) {
            std::string line;
            for (const std::string& column : columns) {
                line += (line.empty() ? "\n" : ",") + row.at(column);
            }
            text += line;
        }
        return text + "\n";
    }
};

std::string number_of(std::mt19937& random, double low, double high) {
    return config::to_text(0.001 *
                           std::round(1000.0 * std::uniform_real_distribution<double>{low, high}(random)));
}

/// Two to fifteen types with r_n below r_t; codes 1 and 3 are those of the map.
GroundTable right_table(std::mt19937& random) {
    GroundTable table{{"code", "label", "r_n", "r_t", "p_stop", "sliding_friction", "note"}, {}};
    const int count = std::uniform_int_distribution{2, 15}(random);
    for (int i = 0; i < count; ++i) {
        table.rows.push_back({{"code", std::to_string(1 + 2 * i)},
                              {"label", "ground " + std::to_string(i)},
                              {"r_n", number_of(random, 0.2, 0.5)},
                              {"r_t", number_of(random, 0.55, 0.95)},
                              {"p_stop", number_of(random, 0.0, 0.02)},
                              {"sliding_friction", number_of(random, 0.3, 0.8)},
                              {"note", "x"}});
    }
    return table;
}

/// What is refused and warned of, with the code of the row in place of its line and without columns.
struct Answer {
    config::ExitCode code = config::ExitCode::done;
    std::multiset<std::string> sentences;
    friend bool operator==(const Answer&, const Answer&) = default;
};

std::string in_words(const Answer& answer) {
    std::string words = std::to_string(static_cast<int>(answer.code)) + "\n";
    for (const std::string& sentence : answer.sentences) {
        words += sentence + "\n";
    }
    return words;
}

/// "surface_types.csv:4:3: found ..." as "code 7: found ...".
std::string with_code(const std::string& sentence, const GroundTable& table) {
    const std::string file = "surface_types.csv:";
    if (!sentence.starts_with(file) || sentence[file.size()] == ' ') {
        return sentence;
    }
    const std::size_t line = std::stoul(sentence.substr(file.size()));
    return "code " + table.rows.at(line - 2).at("code") + sentence.substr(sentence.find(": "));
}

Answer answer_to(const GroundTable& table, const std::vector<std::string>& settings = {}) {
    const SampleProject project;
    project.write("surface_types.csv", table.text());
    const Opened opened = open(project, settings);
    Answer answer{opened.code, {opened.warnings.begin(), opened.warnings.end()}};
    std::istringstream lines{opened.errors};
    for (std::string line; std::getline(lines, line);) {
        answer.sentences.insert(with_code(line, table));
    }
    return answer;
}

void shuffle(GroundTable& table, std::mt19937& random) {
    std::shuffle(table.rows.begin(), table.rows.end(), random);
    std::shuffle(table.columns.begin(), table.columns.end(), random);
}

/// A slip that makes some rows of a table wrong.
struct Slip {
    const char* what;
    void (*make)(Row& row);
    const char* said;  ///< part of what is said
    bool of_each_row;  ///< a sentence for each wrong row, else one with their number
};

const std::vector<Slip> slips{
    {"r_n and r_t exchanged", [](Row& row) { std::swap(row["r_n"], row["r_t"]); }, "r_n above r_t in ",
     false},
    {"r_n in percent", [](Row& row) { row["r_n"] = config::to_text(100.0 * std::stod(row["r_n"])); },
     "expected a number in [0, 0.99]", true},
    {"r_t in percent", [](Row& row) { row["r_t"] = config::to_text(100.0 * std::stod(row["r_t"])); },
     "expected a number in [0, 0.99]", true},
    {"p_stop in percent", [](Row& row) { row["p_stop"] = "1.5"; }, "expected a number in [0, 1]", true},
    {"sliding friction in degrees", [](Row& row) { row["sliding_friction"] = "31"; },
     "expected a number in [0.01, 5]", true},
    {"a decimal comma", [](Row& row) { row["r_n"] = "\"0,35\""; }, "found r_n '0,35'", true},
    {"an empty field", [](Row& row) { row["r_t"] = ""; }, "found r_t empty", true}};

std::size_t count_of(const Answer& answer, const std::string& part) {
    return static_cast<std::size_t>(
        std::count_if(answer.sentences.begin(), answer.sentences.end(),
                      [&](const std::string& sentence) { return sentence.find(part) != std::string::npos; }));
}

TEST(GroundTable, OfRightRowsIsNotDoubted) {
    std::mt19937 random{1};
    for (int trial = 0; trial < 20; ++trial) {
        GroundTable table = right_table(random);
        shuffle(table, random);
        const Answer answer = answer_to(table);
        EXPECT_EQ(in_words(answer), "0\nsurface_types.csv: columns that are not read: 'note'\n")
            << table.text();
    }
}

TEST(GroundTable, HasEachWrongRowFoundInAnyOrder) {
    std::mt19937 random{2};
    for (const Slip& slip : slips) {
        for (int trial = 0; trial < 12; ++trial) {
            GroundTable table = right_table(random);
            // At least one row is wrong and one is right, anywhere in the table.
            std::shuffle(table.rows.begin(), table.rows.end(), random);
            const auto wrong = std::uniform_int_distribution<std::size_t>{1, table.rows.size() - 1}(random);
            std::set<std::string> codes;
            for (std::size_t i = 0; i < wrong; ++i) {
                slip.make(table.rows[i]);
                codes.insert(table.rows[i].at("code"));
            }
            const Answer expected = answer_to(table);
            if (slip.of_each_row) {
                EXPECT_EQ(count_of(expected, slip.said), wrong) << slip.what << in_words(expected);
                for (const std::string& code : codes) {
                    EXPECT_EQ(count_of(expected, "code " + code + ": "), 1U) << slip.what;
                }
            } else {
                EXPECT_EQ(count_of(expected, slip.said + std::to_string(wrong) + " of "), 1U)
                    << slip.what << in_words(expected);
            }
            for (int order = 0; order < 3; ++order) {
                shuffle(table, random);
                EXPECT_EQ(in_words(answer_to(table)), in_words(expected)) << slip.what << "\n"
                                                                          << table.text();
            }
        }
    }
}

TEST(GroundTable, WithAllRowsExchangedIsRefusedInAnyOrder) {
    std::mt19937 random{3};
    for (int trial = 0; trial < 10; ++trial) {
        GroundTable table = right_table(random);
        for (Row& row : table.rows) {
            std::swap(row["r_n"], row["r_t"]);
        }
        shuffle(table, random);
        const Answer answer = answer_to(table);
        EXPECT_EQ(answer.code, config::ExitCode::data);
        EXPECT_EQ(count_of(answer, "the columns look swapped"), 1U) << in_words(answer);
    }
}

/// A row that takes its values from a shipped type, and one of them in a column with another unit.
TEST(GroundTable, NamesColumnsInAnotherUnitInAnyOrder) {
    std::mt19937 random{4};
    for (const std::string quantity : {"r_n", "r_t", "p_stop", "sliding_friction", "jump_angle_factor"}) {
        for (const std::string unit : {"_percent", " [%]", "_deg", " (deg)"}) {
            const std::string column = quantity + unit;
            GroundTable table{{"code", "like", column}, {}};
            for (const char* code : {"1", "3", "5"}) {
                table.rows.push_back({{"code", code}, {"like", "solid_rock"}, {column, "40"}});
            }
            for (int order = 0; order < 3; ++order) {
                shuffle(table, random);
                const Answer answer = answer_to(table);
                EXPECT_EQ(in_words(answer), "0\nsurface_types.csv: found column '" + column +
                                                "', which is passed over, expected " + quantity +
                                                ", if that is what is meant\n");
            }
        }
    }
}

}  // namespace
}  // namespace coupling::plausible::ground_table_test
