#include "coupling/validation/summary_table.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "coupling/validation/verdict.hpp"

namespace coupling::validation::summary_table_test {
namespace {

/// The text of the README between the lines that frame the summary; "" without them.
std::string section_of_readme() {
    std::ifstream in{std::string{BANNWALD_SOURCE_DIR} + "/README.md"};
    std::ostringstream whole;
    whole << in.rdbuf();
    const std::string text = whole.str();
    const std::size_t begin = text.find(summary_begins);
    const std::size_t end = text.find(summary_ends);
    return begin == std::string::npos || end == std::string::npos ? "" : text.substr(begin, end - begin);
}

/// The part of the section about one case.
std::string part_about(const std::string& section, const std::string& name) {
    const std::size_t begin = section.find("**" + name + "** - ");
    return begin == std::string::npos ? "" : section.substr(begin, section.find("\n**", begin + 1) - begin);
}

std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream in{line.substr(std::min<std::size_t>(2, line.size()))};
    for (std::string cell; std::getline(in, cell, '|');) {
        const std::size_t first = cell.find_first_not_of(' ');
        cells.push_back(
            first == std::string::npos ? "" : cell.substr(first, cell.find_last_not_of(' ') - first + 1));
    }
    return cells;
}

/// Whether a line of a table has these fixed cells: figure, unit, observed, published, ours twice, criterion.
bool has_line(const std::string& part, const std::vector<std::string>& fixed) {
    std::istringstream in{part};
    for (std::string line; std::getline(in, line);) {
        const std::vector<std::string> cells = cells_of(line);
        const bool of_forest = cells.size() < 7;  // figure, unit, reference, ours, criterion
        if (of_forest && cells.size() >= 5 && cells[0] == fixed[0] && cells[1] == fixed[1] &&
            cells[2] == fixed[3] && cells[4] == fixed[4]) {
            return true;
        }
        if (cells.size() >= 7 && cells[0] == fixed[0] && cells[1] == fixed[1] && cells[2] == fixed[2] &&
            cells[3] == fixed[3] && cells[6] == fixed[4]) {
            return true;
        }
    }
    return false;
}

TEST(Summary, OfTheReadmeHasTheFiguresAndCriteriaOfTheCases) {
    const std::string section = section_of_readme();
    if (section.empty()) {
        GTEST_SKIP() << "the README has no summary yet";
    }
    for (const CaseFiles& files : shipped_cases()) {
        const ValidationCase of = read_case(files);
        const std::string part = part_about(section, files.name);
        EXPECT_NE(part, "") << files.name;
        if (of.kind == CaseKind::factors) {
            continue;
        }
        for (const VerdictRow& row : verdict_rows(of, {}, {})) {
            EXPECT_TRUE(has_line(part, fixed_cells(row)))
                << files.name << ", " << row.quantity
                << ": write the section anew from summary.md of `bannwald validate all`";
        }
    }
}

TEST(Summary, ShowsAMissInBoldAndGivesItsCause) {
    CaseResult result;
    result.name = "somewhere";
    result.title = "a slope";
    VerdictRow row;
    row.label = "mean speed";
    row.unit = "m/s";
    row.observed = 11.0;
    row.strict_value = {8.0, 8.1, 0.25};
    row.default_value = {10.0, {}, {}};
    row.low = 9.0;
    row.high = 12.5;
    row.rests_on = "rebuilding";
    row.cause = "no survey";
    row.strict_verdict = Verdict::missed;
    row.default_verdict = Verdict::inside;
    result.rows = {row};
    std::ostringstream out;
    write_summary(out, {&result, 1});
    EXPECT_NE(out.str().find("| mean speed | m/s | 11.0 |  | **8.00 ± 0.25** | 10.0 | 9 to 12.5 r |"),
              std::string::npos)
        << out.str();
    EXPECT_NE(out.str().find("strict 0, default 1 of 1"), std::string::npos);
    EXPECT_NE(out.str().find("Missed: mean speed. Likely cause: no survey"), std::string::npos);
    EXPECT_TRUE(has_line(out.str(), fixed_cells(row)));
}

}  // namespace
}  // namespace coupling::validation::summary_table_test
