// How many sheets of paper pages take for a commune with three hundred houses.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <string>

#include "config/text/joined.hpp"
#include "tests/coupling/parts_of_text.hpp"
#include "tests/runs/browser.hpp"

namespace coupling::printed_pages_test {
namespace {

using config::joined;

/// A slope of cells of 10 m that falls eastward, with three hundred houses below a wall.
struct Commune {
    std::string name;
    int columns;
    int rows;
    bool with_forest;
};

std::string grid_of(const Commune& commune, const std::string& (*value)(int column)) {
    std::ostringstream text;
    text << "ncols " << commune.columns << "\nnrows " << commune.rows
         << "\nxllcorner 1000\nyllcorner 2000\ncellsize 10\n";
    for (int row = 0; row < commune.rows; ++row) {
        for (int column = 0; column < commune.columns; ++column) {
            text << value(column) << ' ';
        }
        text << '\n';
    }
    return text.str();
}

const std::string& source_in(int column) {
    static const std::string yes = "1";
    static const std::string no = "0";
    return column == 2 ? yes : no;
}

const std::string& height_in(int column) {
    thread_local std::string height;
    height = std::to_string(600 - 6 * column);
    return height;
}

std::string houses_of(const Commune& commune) {
    constexpr int all = 300;
    const int in_a_row = (commune.columns - 6) * 10 / 12;
    const int lines = (all + in_a_row - 1) / in_a_row;
    const double step_m = (10.0 * commune.rows - 20.0) / lines;
    std::ostringstream text;
    text << "target_id,name,wkt,persons,hours_per_day,house_value\n";
    for (int house = 0; house < all; ++house) {
        const double x = 1055.0 + house % in_a_row * 12.0;
        const double y = 2010.0 + house / in_a_row * step_m;
        const double wide = 0.6 * std::min(10.0, step_m);
        text << "house_" << house + 1 << ",Main street " << house + 1 << ",\"POLYGON ((" << x << ' ' << y
             << ", " << x + 6.0 << ' ' << y << ", " << x + 6.0 << ' ' << y + wide << ", " << x << ' '
             << y + wide << ", " << x << ' ' << y << "))\",3,16,500000\n";
    }
    return text.str();
}

void fill(const SampleProject& project, const Commune& commune) {
    project.write("dem.asc", grid_of(commune, height_in));
    project.write("source.asc", grid_of(commune, source_in));
    project.write("targets.csv", houses_of(commune));
    project.write("blocks.csv", "return_period_years,diameter_m\n30,0.3\n100,0.7\n300,1.2\n");
    std::ostringstream trees;
    trees << "tree_id,x_m,y_m,species,dbh_cm,height_m\n";
    for (int tree = 0; tree < 200; ++tree) {
        trees << tree + 1 << ',' << 1035 + tree % 3 * 4 << ',' << 2005 + tree / 3 * 10 * commune.rows / 70
              << ",PIAB," << 20 + tree * 7 % 30 << ",25\n";
    }
    project.write("trees.csv", trees.str());
    project.write("scenario.ini",
                  joined("[terrain]\ndem = dem.asc\nground = fine_debris_and_soil\n",
                         commune.with_forest ? "[trees]\nfile = trees.csv\n" : "",
                         "[release]\nsource = source.asc\nrocks = 900\n[nets]\nkeep_paths = yes\n"
                         "[design]\nrule = own\nenergy_factor = 1.2\nfreeboard_m = 0.5\n"
                         "[hazard]\nblocks = blocks.csv\n[risk]\nassess = yes\n[report]\nlanguage = de\n"
                         "[targets]\nfile = targets.csv\n"));
}

std::size_t sheets_of(const SampleProject& project, const std::string& page) {
    const Outcome printed = call_browser(
        project,
        joined("--no-pdf-header-footer --print-to-pdf=\"$PWD/page.pdf\" \"file://$PWD/", page, "\""));
    EXPECT_EQ(printed.code, 0) << printed.err;
    const std::string pdf = project.read("page.pdf");
    return text_checks::count_of(pdf, "/Type /Page") - text_checks::count_of(pdf, "/Type /Pages");
}

TEST(PrintedPages, OfThreeHundredHousesTakeFiveSheets) {
    if (!has_browser()) {
        GTEST_SKIP() << "chromium is not installed";
    }
    for (const Commune& commune : {Commune{"wide", 40, 24, true}, Commune{"tall", 16, 56, true},
                                   Commune{"wide, bare", 40, 24, false}}) {
        const SampleProject project;
        fill(project, commune);
        const Outcome run = call(project, "run scenario.ini --quiet --out out");
        ASSERT_EQ(run.code, 0) << commune.name << run.err;
        const std::size_t hazard = sheets_of(project, "out/hazard/report.html");
        EXPECT_GE(hazard, 3U) << commune.name;
        EXPECT_LE(hazard, 5U) << commune.name;
        if (commune.name != "wide") {
            continue;
        }
        EXPECT_LE(sheets_of(project, "out/return_period_300/report.html"), 6U) << commune.name;
        // With all its details it is longer.
        std::string page = project.read("out/return_period_300/report.html");
        const std::string box = "id=\"print-details\"";
        page.replace(page.find(box), box.size(), box + " checked=\"checked\"");
        project.write("whole.html", page);
        EXPECT_GT(sheets_of(project, "whole.html"), 8U) << commune.name;
        // Two runs beside each other, as a hazard page and a few sheets more.
        const Outcome compared = call(project,
                                      "compare out/return_period_100 out/return_period_300 --page "
                                      "compare.html");
        ASSERT_EQ(compared.code, 0) << compared.err;
        EXPECT_LE(sheets_of(project, "compare.html"), 8U) << commune.name;
        EXPECT_NE(project.read("compare.html").find("Main street "), std::string::npos) << "names, not ids";
    }
}

}  // namespace
}  // namespace coupling::printed_pages_test
