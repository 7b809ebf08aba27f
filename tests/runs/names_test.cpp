// Any name in, the same name out: names of targets, trees and nets go through the program's own files, which
// it reads again.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/runs/any_names.hpp"

namespace coupling::names_test {
namespace {

struct Given {
    std::vector<std::string> targets;  ///< ids
    std::vector<std::string> called;   ///< names of the same
    std::vector<std::string> trees;
    std::string net;
};

Given write_names(const SampleProject& project, unsigned seed) {
    NameMaker make{seed};
    Given given{{seed == 0 ? "unit" : make.next(), make.next()},
                {make.next(), make.next()},
                {make.next(), seed == 1 ? "#7" : make.next(), make.next()},
                make.next()};
    project.write("targets.csv",
                  "target_id,name,wkt\n" + in_csv(given.targets[0]) + "," + in_csv(given.called[0]) +
                      ",\"LINESTRING (1105 2010, 1105 2090)\"\n" + in_csv(given.targets[1]) + "," +
                      in_csv(given.called[1]) +
                      ",\"POLYGON ((1090 2040, 1100 2040, 1100 2050, 1090 2050, 1090 2040))\"\n");
    project.write("trees.csv", "tree_id,x_m,y_m,species,dbh_cm,height_m\n" + in_csv(given.trees[0]) +
                                   ",1060,2050,ABAL,32.5,25\n" + in_csv(given.trees[1]) +
                                   ",1070,2042,piab,20,18\n" + in_csv(given.trees[2]) +
                                   ",1080,2061,Fagus sylvatica,41,28\n");
    project.write("nets.csv", "name,height_m,capacity_kj,wkt\n" + in_csv(given.net) +
                                  ",3,50,\"LINESTRING (1098 2030, 1098 2060)\"\n");
    return given;
}

TEST(Names, ComeOutOfAStaticRunAsTheyWentIn) {
    for (unsigned seed = 0; seed < 3; ++seed) {
        const SampleProject project;
        const Given given = write_names(project, seed);
        const std::string run =
            "run scenario.ini --quiet --set release.rocks=400 --set nets.file=nets.csv --set "
            "output.percentiles=no --set output.xlsx=yes --set output.csv=";
        for (const std::string form : {"plain", "excel"}) {
            const Outcome outcome = call(project, run + form + " --out " + form);
            ASSERT_EQ(outcome.code, 0) << seed << "\n" << outcome.err;
            const Names targets{given.targets.begin(), given.targets.end()};
            EXPECT_EQ(column_of(project, form, "targets.csv", "target_id"), targets) << seed << form;
            EXPECT_EQ(column_of(project, form, "targets.csv", "name"),
                      Names(given.called.begin(), given.called.end()))
                << seed << form;
            EXPECT_EQ(column_of(project, form, "arrivals.csv", "target_id"), targets) << seed << form;
            EXPECT_EQ(column_of(project, form, "by_zone.csv", "target_id"), targets) << seed << form;
            EXPECT_EQ(column_of(project, form, "stems.csv", "tree_id"),
                      Names(given.trees.begin(), given.trees.end()))
                << seed << form;
            EXPECT_EQ(column_of(project, form, "nets.csv", "net"), Names{given.net}) << seed << form;
        }
        const Outcome compared = call(project, "compare plain excel --page page.html");
        EXPECT_EQ(compared.code, 0) << seed << "\n" << compared.err;
    }
}

TEST(Names, ComeOutOfAHazardMapAsTheyWentIn) {
    for (unsigned seed = 0; seed < 2; ++seed) {
        const SampleProject project;
        const Given given = write_names(project, seed);
        project.write("blocks.csv", "return_period_years,zone,diameter_m\n30,1,0.5\n300,1,1.2\n");
        project.replace("scenario.ini", "diameter_m = 0.5\n", "");
        project.replace("scenario.ini", "[targets]", "[hazard]\nblocks = blocks.csv\n[targets]");
        const Outcome outcome = call(project,
                                     "run scenario.ini --quiet --set release.rocks=400 --set "
                                     "output.percentiles=no --set hazard.rule=release --set "
                                     "hazard.energy=max --out out");
        ASSERT_EQ(outcome.code, 0) << seed << "\n" << outcome.err;
        EXPECT_EQ(column_of(project, "out/hazard", "hazard_arrivals.csv", "target_id"),
                  Names(given.targets.begin(), given.targets.end()))
            << seed;
    }
}

}  // namespace
}  // namespace coupling::names_test
