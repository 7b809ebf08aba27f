// Tables for spreadsheets: the workbook, and CSV as Excel opens it.

#include <gtest/gtest.h>

#include <string>

#include "tests/runs/years.hpp"

namespace coupling::spreadsheets_test {
namespace {

constexpr const char* quick = "run scenario.ini --quiet --set release.rocks=300 --set output.sample_paths=5 ";

TEST(Spreadsheets, HoldEveryTableAsASheetWithTheSameNumbers) {
    const SampleProject project;
    const Outcome run = call(project, std::string{quick} + "--set output.xlsx=yes --out out");
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_NE(project.read("out/summary.json").find("results.xlsx"), std::string::npos);
    if (shell(project, "/usr/bin/python3 -c 'import openpyxl'").code != 0) {
        GTEST_SKIP() << "python3-openpyxl is not installed";
    }
    project.write("compare.py", R"(
import csv, glob, openpyxl, os
book = openpyxl.load_workbook('out/results.xlsx')
tables = sorted(glob.glob('out/tables/*.csv'))
assert book.sheetnames[0] == 'contents'
assert sorted(book.sheetnames[1:]) == [os.path.basename(t)[:-4][:31] for t in tables], book.sheetnames
numbers = 0
for table in tables:
    sheet = book[os.path.basename(table)[:-4][:31]]
    rows = list(csv.reader(open(table, encoding='utf-8', newline='')))
    assert sheet.max_row == len(rows), table
    assert sheet.freeze_panes == 'A2', table
    for i, row in enumerate(rows):
        for k, field in enumerate(row):
            cell = sheet.cell(i + 1, k + 1).value
            if field == '':
                assert cell is None, (table, i, k, cell)
            elif isinstance(cell, (int, float)):
                assert cell == float(field), (table, i, k, cell, field)
                numbers += 1
            else:
                assert cell == field.replace('\r', ''), (table, i, k, cell, field)
print('equal' if numbers > 1000 else 'few')
)");
    const Outcome same = shell(project, "/usr/bin/python3 compare.py\n");
    EXPECT_EQ(same.code, 0) << same.err;
    EXPECT_EQ(same.out, "equal\n");
}

TEST(Spreadsheets, AreTheSameBytesAtAnyTime) {
    const SampleProject project;
    const std::string xlsx = std::string{quick} + "--set output.xlsx=yes ";
    ASSERT_EQ(call(project, xlsx + "--threads 1 --out first").code, 0);
    // Dates inside a workbook have steps of a second.
    const Outcome second = shell(project, "sleep 1.1\n\"$bannwald\" " + xlsx +
                                              "--threads 3 --out second && cmp first/results.xlsx "
                                              "second/results.xlsx\n");
    EXPECT_EQ(second.code, 0) << second.out << second.err;
}

TEST(Spreadsheets, GoOverTheYearsAndAlongAProfileToo) {
    const SampleProject project;
    ASSERT_EQ(call(project, "init line --example profile --quiet").code, 0);
    const Outcome run =
        call(project,
             "run line/scenario.ini --quiet --set release.rocks=50 --set output.xlsx=yes --set "
             "output.csv=excel --out line/out");
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_TRUE(project.read("line/out/results.xlsx").starts_with("PK"));
    EXPECT_TRUE(project.read("line/out/tables/rocks.csv").starts_with("\xEF\xBB\xBFrock;"));
}

TEST(ExcelTables, HoldTheSameAsPlainOnes) {
    const SampleProject project;
    ASSERT_EQ(call(project, std::string{quick} + "--out plain").code, 0);
    const Outcome run = call(project, std::string{quick} + "--set output.csv=excel --out excel");
    ASSERT_EQ(run.code, 0) << run.err;
    for (const auto& entry : std::filesystem::directory_iterator{project.file("plain/tables")}) {
        const std::string name = entry.path().filename().string();
        const std::string text = project.read("excel/tables/" + name);
        EXPECT_TRUE(text.starts_with("\xEF\xBB\xBF")) << name;
        const config::Table plain = table(project, "plain/tables/" + name);
        const config::Table excel = table(project, "excel/tables/" + name);
        EXPECT_EQ(excel.columns(), plain.columns()) << name;
        ASSERT_EQ(excel.rows(), plain.rows()) << name;
        for (std::size_t row = 0; row < plain.rows(); ++row) {
            for (const std::string& column : plain.columns()) {
                EXPECT_EQ(excel.text(row, column), plain.text(row, column)) << name << ' ' << column;
            }
        }
    }
    // What reads results reads them in either form.
    const Outcome compared = call(project, "compare plain excel --out both");
    EXPECT_EQ(compared.code, 0) << compared.err;
}

}  // namespace
}  // namespace coupling::spreadsheets_test
