#include "coupling/inputs/own_files/file_reader.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "config/errors/input_error.hpp"
#include "tests/coupling/results/small_run.hpp"

namespace coupling::file_reader_test {
namespace {

using small_runs::TestFolder;

std::string message_of(const std::function<void()>& call) {
    try {
        call();
    } catch (const config::InputError& error) {
        EXPECT_EQ(error.code(), config::ExitCode::file);
        return error.what();
    }
    return "";
}

TEST(FileReader, TakesSmallAndLargePiecesInOrderAndAgain) {
    const TestFolder folder;
    std::string text;
    for (int i = 0; i < 100'000; ++i) {
        text += std::to_string(i);
    }
    std::ofstream{folder.path() / "file", std::ios::binary} << text;
    FileReader in{folder.path() / "file"};
    EXPECT_EQ(in.bytes(), text.size());
    std::string read(text.size(), ' ');
    std::size_t at = 0;
    for (std::size_t piece = 1; at < text.size(); piece = piece * 3 + 1) {
        at += in.read(read.data() + at, std::min(piece, text.size() - at));
    }
    EXPECT_EQ(read, text);
    EXPECT_EQ(in.read(read.data(), 1), 0U) << "the end";
    in.seek(5000);
    EXPECT_EQ(in.read(read.data(), 10), 10U);
    EXPECT_EQ(read.substr(0, 10), text.substr(5000, 10));
    EXPECT_EQ(in.place(), 5010U);
    EXPECT_EQ(text_of_file(folder.path() / "file"), text);
}

TEST(FileReader, NamesAFileThatBecomesShorterWhileItIsRead) {
    const TestFolder folder;
    std::ofstream{folder.path() / "file"} << std::string(1'000'000, 'x');
    FileReader in{folder.path() / "file"};
    std::string read(1'000'000, ' ');
    in.read(read.data(), 10);
    ASSERT_EQ(truncate((folder.path() / "file").c_str(), 200'000), 0);
    const std::string message = message_of([&] { in.read(read.data(), 999'990); });
    EXPECT_NE(message.find("/file: found ends before the 1000000 bytes"), std::string::npos) << message;
}

TEST(FileReader, NamesWhatCannotBeRead) {
    const TestFolder folder;
    EXPECT_NE(message_of([&] { FileReader{folder.path() / "none"}; }).find("/none"), std::string::npos);
    EXPECT_NE(message_of([&] { FileReader{folder.path()}; }).find("a folder"), std::string::npos);
}

}  // namespace
}  // namespace coupling::file_reader_test
