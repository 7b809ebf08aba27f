#include "coupling/inputs/files/file_bytes.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cstdint>

#include "tests/coupling/inputs/sample_project.hpp"

namespace coupling::file_bytes_test {
namespace {

TEST(Fnv1a, HashesAsPublished) {
    // Test vectors of the authors (Fowler, Noll, Vo).
    EXPECT_EQ(fnv1a(""), 0xCBF29CE484222325ULL);
    EXPECT_EQ(fnv1a("a"), 0xAF63DC4C8601EC8CULL);
    EXPECT_EQ(fnv1a("foobar"), 0x85944171F73967E8ULL);
}

TEST(FileBytes, AreThoseOfTheFile) {
    const SampleProject project;
    project.write("some.txt", "foobar");
    project.write("empty.txt", "");
    const FileBytes some = open_file(project.file("some.txt"), {}, "a text");
    EXPECT_EQ(some.text(), "foobar");
    EXPECT_EQ(some.hash(), "85944171f73967e8");
    EXPECT_EQ(open_file(project.file("empty.txt"), {}, "a text").text(), "");
}

TEST(FileBytes, TellWhyAFileCannotBeOpened) {
    const SampleProject project;
    const auto message = [&](const std::string& name) -> std::string {
        try {
            open_file(project.file(name), {"scenario.ini", 3, 0}, "a grid");
        } catch (const config::InputError& error) {
            EXPECT_EQ(error.code(), config::ExitCode::file);
            return error.what();
        }
        return "";
    };
    EXPECT_TRUE(message("gone.asc").starts_with("scenario.ini:3: found no file '")) << message("gone.asc");
    EXPECT_TRUE(message("").starts_with("scenario.ini:3: found a folder, '")) << message("");
}

TEST(FileBytes, NameAMissingFileWholeHoweverLongItsPathIs) {
    EXPECT_TRUE(rc::check([](std::uint8_t folders, std::uint8_t letters) {
        const std::string path =
            std::string(folders % 20U, '/') + std::string(1U + letters % 200U, 'x') + "/gone.asc";
        try {
            open_file(path, {"scenario.ini", 3, 0}, "a grid");
        } catch (const config::InputError& error) {
            RC_ASSERT(std::string{error.what()}.find("found no file '" + path + "'") != std::string::npos);
            return;
        }
        RC_FAIL("opened");
    }));
}

}  // namespace
}  // namespace coupling::file_bytes_test
