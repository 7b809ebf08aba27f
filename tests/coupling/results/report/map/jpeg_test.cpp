#include "coupling/results/report/map/jpeg.hpp"

#include <gtest/gtest.h>

#include "coupling/inputs/picture/picture_file.hpp"

namespace coupling::report::jpeg_test {
namespace {

picture::Pixels noise(std::uint32_t side) {
    picture::Pixels pixels{side, side, {}};
    for (std::uint32_t i = 0; i < 3 * side * side; ++i) {
        pixels.rgb.push_back(static_cast<std::uint8_t>(i * 2'654'435'761U >> 24U));
    }
    return pixels;
}

TEST(Jpeg, IsReadBackNearlyTheSame) {
    picture::Pixels smooth{64, 48, {}};
    for (int row = 0; row < 48; ++row) {
        for (int column = 0; column < 64; ++column) {
            smooth.rgb.insert(smooth.rgb.end(), {static_cast<std::uint8_t>(3 * column),
                                                 static_cast<std::uint8_t>(4 * row), 90});
        }
    }
    const picture::PlacedPicture read =
        picture::read_picture(jpeg(smooth, 90), "a.jpg", [](const std::string& ending) -> std::string_view {
            return ending == ".jgw" ? "1\n0\n0\n-1\n0\n0\n" : std::string_view{};
        });
    ASSERT_EQ(read.pixels.rgb.size(), smooth.rgb.size());
    double sum = 0.0;
    for (std::size_t i = 0; i < smooth.rgb.size(); ++i) {
        sum += std::abs(static_cast<double>(read.pixels.rgb[i]) - smooth.rgb[i]);
    }
    EXPECT_LT(sum / static_cast<double>(smooth.rgb.size()), 4.0);
}

TEST(Jpeg, IsTheSameBytesAndSmallerInALowerQuality) {
    const picture::Pixels pixels = noise(200);
    EXPECT_EQ(jpeg(pixels, 80), jpeg(pixels, 80));
    EXPECT_LT(jpeg(pixels, 30).size(), jpeg(pixels, 80).size());
    const std::size_t most = jpeg(pixels, 60).size();
    EXPECT_LE(jpeg_of_at_most(pixels, most).size(), most);
    EXPECT_EQ(jpeg_of_at_most(pixels, 1).size(), jpeg(pixels, 10).size());
    EXPECT_EQ(jpeg_of_at_most(pixels, 10'000'000), jpeg(pixels, 85));
}

}  // namespace
}  // namespace coupling::report::jpeg_test
