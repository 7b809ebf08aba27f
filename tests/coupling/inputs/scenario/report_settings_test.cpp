#include "coupling/inputs/scenario/report_settings.hpp"

#include <gtest/gtest.h>

#include <string>

#include "coupling/inputs/scenario/scenario.hpp"
#include "tests/coupling/inputs/sample_project.hpp"

namespace coupling {
namespace {

using namespace std::string_literals;

/// 1 x 1 pixel, whole.
std::string small_png() {
    return "\x89PNG\r\n\x1a\n"s
           "\0\0\0\rIHDR\0\0\0\1\0\0\0\1\x08\0\0\0\0\x3a\x7e\x9b\x55"s
           "\0\0\0\nIDAT\x78\x9c\x63\x60\0\0\0\2\0\1\x48\xaf\xa4\x71"s
           "\0\0\0\0IEND\xae\x42\x60\x82"s;
}

/// The marks of a JPEG without its pixels.
std::string small_jpeg() {
    return "\xff\xd8\xff\xe0\0\4ab\xff\xda\0\4cd1234\xff\xd9"s;
}

const std::string small_svg =
    "<?xml version=\"1.0\"?>\n<!-- a circle -->\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
    "viewBox=\"0 0 2 2\"><circle cx=\"1\" cy=\"1\" r=\"1\" fill=\"url(#g)\"/></svg>\n";

TEST(ReadLogo, TakesPngJpegAndSvgAsTheyAre) {
    EXPECT_EQ(read_logo(small_png(), {}).media_type, "image/png");
    EXPECT_EQ(read_logo(small_png(), {}).bytes, small_png());
    EXPECT_EQ(read_logo(small_jpeg(), {}).media_type, "image/jpeg");
    EXPECT_EQ(read_logo(small_svg, {}).media_type, "image/svg+xml");
}

std::string refusal_of(const std::string& bytes) {
    try {
        read_logo(bytes, {"logo"});
    } catch (const config::InputError& error) {
        EXPECT_EQ(error.code(), config::ExitCode::data);
        return error.what();
    }
    ADD_FAILURE() << "taken";
    return "";
}

TEST(ReadLogo, RefusesPicturesThatWereCutOffAnywhere) {
    for (std::size_t length = 0; length < small_png().size(); ++length) {
        refusal_of(small_png().substr(0, length));
    }
    for (std::size_t length = 0; length + 1 < small_jpeg().size(); ++length) {
        refusal_of(small_jpeg().substr(0, length));
    }
    EXPECT_NE(refusal_of(small_png().substr(0, 40)).find("ends before its end"), std::string::npos);
}

TEST(ReadLogo, RefusesAPngWithAnyByteChanged) {
    for (std::size_t at = 0; at < small_png().size(); ++at) {
        std::string changed = small_png();
        changed[at] = static_cast<char>(changed[at] ^ 0x20);
        EXPECT_FALSE(refusal_of(changed).empty()) << at;
    }
    std::string changed = small_png();
    changed.back() = static_cast<char>(changed.back() ^ 1);
    EXPECT_NE(refusal_of(changed).find("has another checksum"), std::string::npos) << "that of IEND";
}

TEST(ReadLogo, RefusesMoreThanTwoMegabytes) {
    EXPECT_NE(refusal_of(small_png() + std::string(2'000'000, ' ')).find("bytes"), std::string::npos);
}

TEST(ReportSettings, AreReadWithTheLogoThatTheyName) {
    const SampleProject project;
    project.write("logo.png", small_png());
    const auto scenario =
        read_scenario(project.file("scenario.ini"),
                      {"report.title=Steinschlag Kot", "report.client=Gemeinde", "report.date=24.11.2026",
                       "report.logo=logo.png", "report.language=de"});
    EXPECT_EQ(scenario->report.title, "Steinschlag Kot");
    EXPECT_EQ(scenario->report.language, config::Language::de);
    EXPECT_EQ(scenario->report.picture.media_type, "image/png");
    EXPECT_TRUE(has_head(scenario->report));
}

}  // namespace
}  // namespace coupling
