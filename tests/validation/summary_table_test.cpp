#include "validation/engine/summary_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "validation/engine/kinds/verdict.hpp"

namespace coupling::validation::summary_table_test {
namespace {

/// The text of a README between two lines; "" without them.
std::string section_of(const std::string& readme, std::string_view begins, std::string_view ends) {
    std::ifstream in{std::string{BANNWALD_SOURCE_DIR} + "/" + readme};
    std::ostringstream whole;
    whole << in.rdbuf();
    const std::string text = whole.str();
    const std::size_t begin = text.find(begins);
    const std::size_t end = text.find(ends);
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

/// Whether a line of a table has these fixed cells: figure, unit, observed, published, ours under each set of
/// settings, criterion.
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
            cells[3] == fixed[3] && cells.back() == fixed[4]) {
            return true;
        }
    }
    return false;
}

/// The first whole number before a text; "" without one.
std::string number_before(const std::string& line, const std::string& text) {
    const std::size_t at = line.find(text);
    if (at == std::string::npos || at == 0) {
        return "";
    }
    const std::size_t begin = line.find_last_not_of("0123456789", at - 1);
    return line.substr(begin + 1, at - begin - 1);
}

TEST(Overview, OfTheRootReadmeSaysWhatTheWholeTableSays) {
    const std::string overview = section_of("README.md", overview_begins, overview_ends);
    const std::string summary = section_of("validation/VERDICTS.md", summary_begins, summary_ends);
    ASSERT_LE(std::count(overview.begin(), overview.end(), '\n'), 1 + 2 + std::ssize(shipped_cases()));
    for (const CaseFiles& files : shipped_cases()) {
        std::string line = part_about(summary, files.name);
        line = line.substr(0, line.find('\n'));
        const std::string criteria = line.substr(std::min(line.size(), line.rfind(" of ")));
        const std::size_t row = overview.find("| [" + files.name + "](validation/");
        ASSERT_NE(row, std::string::npos) << files.name;
        const std::vector<std::string> cells = cells_of(overview.substr(row, overview.find('\n', row) - row));
        ASSERT_EQ(cells.size(), 4U) << files.name;
        const std::string of = criteria.substr(0, criteria.find('.'));
        EXPECT_EQ(cells[3], number_before(line, criteria) + of) << files.name;
        EXPECT_EQ(cells[2],
                  line.find("strict ") == std::string::npos ? "" : number_before(line, ", default ") + of)
            << files.name;
    }
}

TEST(Overview, HasARowForEachCase) {
    CaseResult result;
    result.name = "somewhere";
    result.title = "a slope";
    VerdictRow row;
    row.strict_verdict = Verdict::missed;
    row.default_verdict = Verdict::inside;
    result.rows = {row};
    std::ostringstream out;
    write_overview(out, {&result, 1});
    EXPECT_NE(out.str().find("| [somewhere](validation/somewhere/README.md) | a slope | 0 of 1 | 1 of 1 |\n"),
              std::string::npos)
        << out.str();
}

TEST(Overview, LinksNoOwnCaseToAReadmeThatIsNotThere) {
    CaseResult result;
    result.name = "mine";
    result.title = "a plot";
    result.is_own = true;
    std::ostringstream out;
    write_overview(out, {&result, 1});
    EXPECT_NE(out.str().find("| mine | a plot |"), std::string::npos) << out.str();
    EXPECT_EQ(out.str().find("README.md"), std::string::npos);
}

TEST(Summary, OfTheValidationReadmeHasTheFiguresAndCriteriaOfTheCases) {
    const std::string section = section_of("validation/VERDICTS.md", summary_begins, summary_ends);
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
                << ": update the section with validation/engine/update_readme.sh";
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
