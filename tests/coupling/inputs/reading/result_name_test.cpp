#include "coupling/inputs/reading/result_name.hpp"

#include <gtest/gtest.h>

#include <string>

namespace coupling::result_name_test {
namespace {

TEST(ResultName, IsOneThatAFolderOfTheResultsCanHave) {
    for (const std::string name : {"pfm1", "single_tree_selection", "RCP8-5", "year", "a"}) {
        EXPECT_TRUE(is_result_name(name)) << name;
    }
    for (const std::string name : {"", ".", "..", "a.b", "a/b", "a b", "bare", "year_5", "w\xC3\xA4rmer"}) {
        EXPECT_FALSE(is_result_name(name)) << name;
    }
    EXPECT_TRUE(is_result_name(std::string(100, 'x')));
    EXPECT_FALSE(is_result_name(std::string(101, 'x')));
}

}  // namespace
}  // namespace coupling::result_name_test
