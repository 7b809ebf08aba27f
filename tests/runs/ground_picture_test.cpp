// An aerial picture behind the maps of a page and over its view in three dimensions.

#include <gtest/gtest.h>

#include <string>

#include "coupling/results/report/map/jpeg.hpp"
#include "coupling/results/report/map/png.hpp"
#include "tests/coupling/results/markup_checks.hpp"
#include "tests/runs/years.hpp"

namespace coupling::ground_picture_test {
namespace {

constexpr const char* run = "run scenario.ini --quiet --set release.rocks=100 --set output.sample_paths=5 ";
constexpr const char* with_picture = "--set terrain.picture=photo.png ";

/// A picture of 60 x 50 pixels of 2 m, from `west_m` on; the sample project lies at 1000 to 1120 east, 2000
/// to 2100 north.
void add_picture(const SampleProject& project, double west_m) {
    report::IndexedPicture picture{60, 50, std::vector<std::uint8_t>(3000), {{0, 0, 0}}};
    for (std::size_t i = 1; i < 200; ++i) {
        picture.palette.push_back({static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(255 - i), 40});
    }
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        picture.pixels[i] = static_cast<std::uint8_t>(1 + i % 199);
    }
    project.write("photo.png", report::png(picture));
    project.write("photo.pgw", "2\n0\n0\n-2\n" + std::to_string(west_m + 1.0) + "\n2099\n");
}

std::size_t times(const std::string& text, const std::string& words) {
    std::size_t count = 0;
    for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) {
        ++count;
    }
    return count;
}

TEST(GroundPicture, LiesOnceInThePageBehindAllMaps) {
    const SampleProject project;
    add_picture(project, 1000.0);
    ASSERT_EQ(call(project, std::string{run} + with_picture).code, 0);
    ASSERT_EQ(call(project, std::string{run} + "--out without").code, 0);
    const std::string page = project.read("out/report.html");
    EXPECT_EQ(times(page, "id=\"ground-picture\""), 1U);
    EXPECT_EQ(times(page, "data:image/jpeg;base64,"), 1U);
    const std::size_t maps = times(page, "<use class=\"shade\"");
    EXPECT_GT(maps, 3U);
    EXPECT_EQ(times(page, "<use class=\"ground-picture\" href=\"#ground-picture\"/>"), maps);
    EXPECT_EQ(text_checks::markup_fault(text_checks::without_scripts(page)), "");
    EXPECT_NE(page.find("\"picture\":{\"west\":"), std::string::npos);
    const std::string plain = project.read("without/report.html");
    EXPECT_EQ(plain.find("<use class=\"ground-picture\""), std::string::npos);
    EXPECT_NE(plain.find("\"picture\":null"), std::string::npos);
    const std::string summary = project.read("out/summary.json");
    EXPECT_NE(summary.find("\"photo.png\""), std::string::npos);
    EXPECT_NE(summary.find("\"photo.pgw\""), std::string::npos);
    // What lies behind maps moves no rock.
    EXPECT_EQ(project.read("out/tables/rocks.csv"), project.read("without/tables/rocks.csv"));
}

TEST(GroundPicture, IsTheSameBytes) {
    const SampleProject project;
    add_picture(project, 1000.0);
    ASSERT_EQ(call(project, std::string{run} + with_picture + "--threads 1").code, 0);
    ASSERT_EQ(call(project, std::string{run} + with_picture + "--threads 3 --out three").code, 0);
    EXPECT_EQ(project.read("out/report.html"), project.read("three/report.html"));
}

TEST(GroundPicture, IsNotedWhereItCoversAPartAndRefusedWhereNone) {
    const SampleProject project;
    add_picture(project, 1060.0);
    const Outcome part = call(project, std::string{"check scenario.ini "} + with_picture);
    EXPECT_EQ(part.code, 0) << part.err;
    EXPECT_NE(part.err.find("photo.png: covers 50 % of the map"), std::string::npos) << part.err;
    EXPECT_NE(part.err.find("photo.png: names no coordinate system; taken as that of the terrain"),
              std::string::npos)
        << part.err;
    add_picture(project, 5000.0);
    const Outcome none = call(project, std::string{"check scenario.ini "} + with_picture);
    EXPECT_EQ(none.code, 4);
    EXPECT_NE(none.err.find("bannwald: photo.png: found a picture of 5 000 to 5 120 east, "
                            "2 000 to 2 100 north, expected one that shows the terrain, "
                            "1 000 to 1 120 east"),
              std::string::npos)
        << none.err;
}

TEST(GroundPicture, IsRefusedInAnotherSystem) {
    const SampleProject project;
    add_picture(project, 1000.0);
    const auto system = [](const std::string& name, const std::string& meridian) {
        return "PROJCS[\"" + name +
               "\",GEOGCS[\"GCS_MGI\",DATUM[\"D_MGI\",SPHEROID[\"Bessel_1841\",6377397.155,299.1528128]],"
               "PRIMEM[\"Greenwich\",0.0],UNIT[\"Degree\",0.0174532925199433]],PROJECTION[\"Transverse_"
               "Mercator\"],PARAMETER[\"False_Easting\",0.0],PARAMETER[\"False_Northing\",0.0],PARAMETER["
               "\"Central_Meridian\"," +
               meridian +
               "],PARAMETER[\"Scale_Factor\",1.0],PARAMETER[\"Latitude_Of_Origin\",0.0],UNIT[\"Meter\",1.0]]";
    };
    project.write("dem.prj", system("one", "10.0"));
    project.write("photo.prj", system("two", "13.0"));
    const Outcome outcome = call(project, std::string{"check scenario.ini "} + with_picture);
    EXPECT_EQ(outcome.code, 4) << outcome.err;
    EXPECT_NE(outcome.err.find("photo.png"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("'two'"), std::string::npos) << outcome.err;
}

TEST(GroundPicture, TakesRoomWithinLimits) {
    const SampleProject project;
    picture::Pixels noise{2400, 2000, {}};
    noise.rgb.reserve(std::size_t{3} * 2400 * 2000);
    for (std::uint32_t i = 0; i < 3U * 2400U * 2000U; ++i) {
        noise.rgb.push_back(static_cast<std::uint8_t>(i * 2'654'435'761U >> 24U));
    }
    project.write("photo.jpg", report::jpeg(noise, 95));
    project.write("photo.jgw", "0.05\n0\n0\n-0.05\n1000.025\n2099.975\n");
    ASSERT_EQ(call(project, std::string{run} + "--set terrain.picture=photo.jpg").code, 0);
    const std::string page = project.read("out/report.html");
    const std::size_t begin = page.find("data:image/jpeg;base64,");
    ASSERT_NE(begin, std::string::npos);
    EXPECT_LT(page.find('"', begin) - begin, 1'200'000U);
}

}  // namespace
}  // namespace coupling::ground_picture_test
