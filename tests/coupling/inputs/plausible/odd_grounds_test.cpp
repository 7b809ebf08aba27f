#include "coupling/inputs/plausible/odd_grounds.hpp"

#include <gtest/gtest.h>

#include "tests/coupling/inputs/opened.hpp"

namespace coupling::plausible::odd_grounds_test {
namespace {

TEST(OddGrounds, AreRefusedWhereAllHaveTheColumnsSwapped) {
    const SampleProject project;
    project.replace("surface_types.csv", "r_n,r_t", "r_t,r_n");
    const Opened opened = open(project);
    EXPECT_EQ(opened.code, config::ExitCode::data);
    EXPECT_NE(opened.errors.find("r_n above r_t in 2 of 2 ground types: the columns look swapped"),
              std::string::npos)
        << opened.errors;
}

TEST(OddGrounds, AreWarnedOfOneByOne) {
    const SampleProject project;
    project.replace("surface_types.csv", "0.30,0.80", "0.80,0.30");
    const Opened opened = open(project);
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_EQ(
        opened.warnings,
        std::vector<std::string>{
            "surface_types.csv: found r_n above r_t in 1 of 2 ground types, such as code 3 (r_n 0.8, r_t "
            "0.3), expected r_n below r_t: rocks keep less of their speed normal to the ground than along "
            "it; check whether the two are swapped there"});
}

}  // namespace
}  // namespace coupling::plausible::odd_grounds_test
