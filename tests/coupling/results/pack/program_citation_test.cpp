#include "coupling/results/pack/program_citation.hpp"

#include <gtest/gtest.h>

#include "config/version.hpp"

namespace coupling::pack::program_citation_test {
namespace {

TEST(ProgramCitation, ReadsAuthorsOfBothForms) {
    const ProgramCitation read = read_citation(
        "cff-version: 1.2.0\ntitle: \"A: b\"\nversion: 1.2.3\nlicense: MIT\nauthors:\n  - name: \"The "
        "group\"\n"
        "  - family-names: Muster\n    given-names: A.\nrepository-code: \"https://example.org/code\"\n"
        "references:\n  - type: article\n    title: \"Other\"\n    authors:\n      - family-names: Else\n");
    EXPECT_EQ(read.title, "A: b");
    EXPECT_EQ(read.version, "1.2.3");
    EXPECT_EQ(read.licence, "MIT");
    EXPECT_EQ(read.authors, (std::vector<std::string>{"The group", "Muster, A."}));
    EXPECT_EQ(read.repository, "https://example.org/code");
}

/// The file of the repository says what the program says of itself.
TEST(ProgramCitation, IsThatOfTheProgram) {
    const ProgramCitation& citation = program_citation();
    EXPECT_EQ(citation.version, config::version());
    EXPECT_EQ(citation.licence, "GPL-3.0-or-later");
    EXPECT_FALSE(citation.authors.empty());
}

}  // namespace
}  // namespace coupling::pack::program_citation_test
