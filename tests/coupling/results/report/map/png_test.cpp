#include "coupling/results/report/map/png.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/coupling/results/small_run.hpp"

namespace coupling::report::png_test {
namespace {

const IndexedPicture flag{3, 2, {1, 2, 0, 2, 2, 1}, {{255, 255, 255}, {200, 0, 0}, {0, 0, 120}}};

TEST(Png, BeginsAndEndsAsTheSpecificationSays) {
    const std::string bytes = png(flag);
    EXPECT_EQ(bytes.substr(0, 8), "\x89PNG\r\n\x1a\n");
    EXPECT_EQ(bytes.substr(12, 4), "IHDR");
    // The check sum of an empty IEND chunk is a constant of the format.
    EXPECT_EQ(bytes.substr(bytes.size() - 8), std::string("IEND\xae\x42\x60\x82", 8));
}

TEST(Png, IsReadByGdalWithItsSizeAndColours) {
    const small_runs::TestFolder folder;
    std::ofstream{folder.path() / "flag.png", std::ios::binary} << png(flag);
    const std::string said = small_runs::gdalinfo(folder.path() / "flag.png");
    if (said.empty()) {
        GTEST_SKIP() << "gdalinfo is not installed";
    }
    EXPECT_NE(said.find("Size is 3, 2"), std::string::npos) << said;
    EXPECT_NE(said.find("1: 200,0,0,255"), std::string::npos) << said;
    EXPECT_NE(said.find("0: 255,255,255,0"), std::string::npos) << "see-through: " << said;
    EXPECT_NE(said.find("Checksum=8"), std::string::npos) << "the sum of the six pixels: " << said;
}

TEST(Png, OfShadesIsReadByGdalPixelByPixel) {
    GreyPicture ramp{16, 16, {}};
    for (int i = 0; i < 256; ++i) {
        ramp.pixels.push_back(static_cast<std::uint8_t>(i));
    }
    const small_runs::TestFolder folder;
    std::ofstream{folder.path() / "ramp.png", std::ios::binary} << png(ramp);
    const std::string said = small_runs::gdalinfo(folder.path() / "ramp.png");
    if (said.empty()) {
        GTEST_SKIP() << "gdalinfo is not installed";
    }
    EXPECT_NE(said.find("Size is 16, 16"), std::string::npos) << said;
    EXPECT_EQ(said.find("ERROR"), std::string::npos) << said;
    EXPECT_NE(said.find("Checksum="), std::string::npos) << "all pixels decoded: " << said;
}

}  // namespace
}  // namespace coupling::report::png_test
