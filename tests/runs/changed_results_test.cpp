// Results that were damaged after their run: nothing is compared with them, and no finished return period
// counts as finished.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/runs/program.hpp"

namespace coupling::changed_results_test {
namespace {

TEST(ChangedResults, AreNotCompared) {
    const SampleProject project;
    ASSERT_EQ(call(project, "run scenario.ini --quiet --set release.rocks=2000").code, 0);
    ASSERT_EQ(shell(project, "cp -r out other\n\"$bannwald\" compare out other --page page.html\n").code, 0);
    const std::string file = "other/tables/run_out.csv";
    const std::string table = project.read(file);
    const std::string row = table.substr(table.find("\nforest,") + 1);
    const std::string first = row.substr(0, row.find('\n'));
    const std::string but_rocks = first.substr(0, first.rfind(',') + 1);
    const auto compared = [&] { return call(project, "compare out other --page again.html --overwrite"); };
    project.replace(file, first, but_rocks + "1");
    const Outcome changed = compared();
    EXPECT_EQ(changed.code, 4) << changed.err;
    EXPECT_NE(changed.err.find(file + ": found a file that changed since its run"), std::string::npos)
        << changed.err;
    // Results without checksums: what no run can give is refused all the same.
    std::filesystem::remove(project.file("other/.checksums"));
    for (const std::string damaged : {"-1", "1e308", "nan", "x", "0.5", "18446744073709551616"}) {
        project.write(file, table);
        project.replace(file, first, but_rocks + damaged);
        const Outcome refused = compared();
        EXPECT_EQ(refused.code, 4) << damaged << "\n" << refused.err;
        EXPECT_NE(refused.err.find("run_out.csv"), std::string::npos) << damaged << "\n" << refused.err;
    }
    project.write(file, table);
    ASSERT_EQ(compared().code, 0);
    for (const std::string damaged : {"1e308", "-1e30", "1e13"}) {
        const std::string raster = "other/rasters/bare/Nr_deposited.asc";
        const std::string whole = project.read(raster);
        project.write(raster, whole.substr(0, whole.rfind(' ') + 1) + damaged + "\n");
        const Outcome refused = compared();
        EXPECT_EQ(refused.code, 4) << damaged << "\n" << refused.err;
        EXPECT_NE(refused.err.find("Nr_deposited.asc"), std::string::npos) << damaged << "\n" << refused.err;
        project.write(raster, whole);
    }
}

TEST(ChangedResults, OfAFinishedReturnPeriodAreNoticed) {
    const SampleProject project;
    project.write("blocks.csv", "return_period_years,zone,diameter_m\n30,1,0.5\n300,1,1.2\n");
    project.replace("scenario.ini", "diameter_m = 0.5\n", "");
    project.replace("scenario.ini", "[targets]", "[hazard]\nblocks = blocks.csv\n[targets]");
    const std::string run =
        "run scenario.ini --quiet --set release.rocks=400 --set output.percentiles=no --set "
        "hazard.rule=release --set hazard.energy=max "
        "--out out";
    ASSERT_EQ(call(project, run).code, 0);
    ASSERT_EQ(call(project, run).code, 0) << "finished before";
    for (const std::string name : {"tables/rocks.csv", "report.html", "rasters/bare/E_max.asc"}) {
        const std::string file = "out/return_period_30/" + name;
        const std::string whole = project.read(file);
        std::string damaged = whole;
        damaged[damaged.size() / 2] = static_cast<char>(damaged[damaged.size() / 2] ^ 1);
        project.write(file, damaged);
        const Outcome refused = call(project, run);
        EXPECT_EQ(refused.code, 2) << refused.err;
        EXPECT_NE(refused.err.find("results of which " + name + " has changed"), std::string::npos)
            << refused.err;
        project.write(file, whole);
    }
    EXPECT_EQ(call(project, run).code, 0);
}

}  // namespace
}  // namespace coupling::changed_results_test
