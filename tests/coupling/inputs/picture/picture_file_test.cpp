#include "coupling/inputs/picture/picture_file.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <map>

#include "config/errors/input_error.hpp"
#include "coupling/results/report/map/jpeg.hpp"
#include "coupling/results/report/map/png.hpp"

namespace coupling::picture::picture_file_test {
namespace {

using Beside = std::map<std::string, std::string>;

/// Pixels of two metres, the centre of the first one at 101, 199.
const std::string world_file = "2\n0\n0\n-2\n101\n199\n";

PlacedPicture read(const std::string& bytes, const Beside& beside) {
    return read_picture(bytes, "photo", [&](const std::string& ending) -> std::string_view {
        const auto found = beside.find(ending);
        return found == beside.end() ? std::string_view{} : std::string_view{found->second};
    });
}

std::string refusal(const std::string& bytes, const Beside& beside) {
    try {
        (void)read(bytes, beside);
    } catch (const config::InputError& error) {
        return error.what();
    }
    return "read";
}

/// Three by two pixels: red, green, blue; below them see-through ones.
std::string small_png() {
    return report::png(
        report::IndexedPicture{3, 2, {1, 2, 3, 0, 0, 0}, {{9, 9, 9}, {250, 0, 0}, {0, 250, 0}, {0, 0, 250}}});
}

const std::vector<std::uint8_t> small_rgb{250, 0,   0,   0,   250, 0,   0,   0,   250,
                                          255, 255, 255, 255, 255, 255, 255, 255, 255};

/// A TIFF without compression, its rows in one strip, with a place as GeoTIFF says it.
std::string small_tiff(const std::vector<std::uint8_t>& rgb, std::uint32_t width, std::uint32_t height,
                       bool has_place) {
    std::string bytes;
    const auto put = [&](std::uint64_t value, int size) {
        for (int i = 0; i < size; ++i) {
            bytes += static_cast<char>(value >> (8 * i) & 0xFFU);
        }
    };
    const std::uint32_t at_pixels = 8;
    const auto pixel_bytes = static_cast<std::uint32_t>(rgb.size());
    const std::uint32_t at_bits = at_pixels + pixel_bytes + pixel_bytes % 2;
    const std::uint32_t at_scale = at_bits + 6;
    const std::uint32_t at_tie = at_scale + 3 * 8;
    const std::uint32_t at_tags = at_tie + 6 * 8;
    bytes = "II*";
    put(0, 1);
    put(at_tags, 4);
    bytes.append(rgb.begin(), rgb.end());
    bytes.resize(at_bits, '\0');
    for (int i = 0; i < 3; ++i) {
        put(8, 2);
    }
    for (const double number : {2.0, 2.0, 0.0, 0.0, 0.0, 0.0, 100.0, 200.0, 0.0}) {
        put(std::bit_cast<std::uint64_t>(number), 8);
    }
    struct Tag {
        std::uint32_t code, type, count, value;
    };
    std::vector<Tag> tags{{256, 4, 1, width}, {257, 4, 1, height}, {258, 3, 3, at_bits},
                          {259, 3, 1, 1},     {262, 3, 1, 2},      {273, 4, 1, at_pixels},
                          {277, 3, 1, 3},     {278, 4, 1, height}, {279, 4, 1, pixel_bytes}};
    if (has_place) {
        tags.push_back({33550, 12, 3, at_scale});
        tags.push_back({33922, 12, 6, at_tie});
    }
    put(tags.size(), 2);
    for (const Tag& tag : tags) {
        put(tag.code, 2);
        put(tag.type, 2);
        put(tag.count, 4);
        put(tag.value, 4);
    }
    put(0, 4);
    return bytes;
}

void expect_place(const PlacedPicture& found) {
    EXPECT_EQ(found.frame.columns, 3);
    EXPECT_EQ(found.frame.rows, 2);
    EXPECT_DOUBLE_EQ(found.frame.x_west_m, 100.0);
    EXPECT_DOUBLE_EQ(found.frame.y_north_m(), 200.0);
    EXPECT_DOUBLE_EQ(found.frame.cell_width_m, 2.0);
}

TEST(ReadPicture, TakesAPngWithItsWorldFileAndSystem) {
    for (const char* ending : {".pgw", ".pngw", ".wld"}) {
        const PlacedPicture found = read(small_png(), {{ending, world_file}, {".prj", " PROJCS[\"A\"]\n"}});
        expect_place(found);
        EXPECT_EQ(found.pixels.rgb, small_rgb);
        EXPECT_EQ(found.projection, "PROJCS[\"A\"]");
    }
}

TEST(ReadPicture, TakesAJpegWithItsWorldFile) {
    const Pixels grey{3, 2, std::vector<std::uint8_t>(18, 120)};
    for (const char* ending : {".jgw", ".jpgw", ".jpegw", ".wld"}) {
        const PlacedPicture found = read(report::jpeg(grey, 90), {{ending, world_file}});
        expect_place(found);
        for (const std::uint8_t part : found.pixels.rgb) {
            EXPECT_NEAR(part, 120, 2);
        }
    }
}

TEST(ReadPicture, TakesAGeotiffByItsTagsOrItsWorldFile) {
    for (const bool has_place : {true, false}) {
        const PlacedPicture found = read(small_tiff(small_rgb, 3, 2, has_place), {{".tfw", world_file}});
        expect_place(found);
        EXPECT_EQ(found.pixels.rgb, small_rgb);
    }
}

TEST(ReadPicture, RefusesWhatHasNoPlaceOrIsNoPicture) {
    EXPECT_NE(refusal(small_png(), {}).find("found a picture without a place on the map"), std::string::npos);
    EXPECT_NE(refusal(small_png(), {{".pgw", "2\n0\n0"}}).find("six lines of numbers"), std::string::npos);
    EXPECT_NE(refusal(small_png(), {{".pgw", "2\n1\n1\n-2\n101\n199\n"}}).find("a rotated grid"),
              std::string::npos);
    EXPECT_NE(refusal(small_tiff(small_rgb, 3, 2, false), {}).find("no place on the map"), std::string::npos);
    EXPECT_NE(refusal("ncols 3\n", {}).find("a file that is no picture of these kinds"), std::string::npos);
    EXPECT_NE(refusal("", {}).find("an empty file"), std::string::npos);
}

TEST(ReadPicture, RefusesWhatIsCutOffAtAnyByte) {
    const Beside beside{{".wld", world_file}};
    Pixels noise{40, 30, {}};
    for (std::uint32_t i = 0; i < 3600; ++i) {
        noise.rgb.push_back(static_cast<std::uint8_t>(i * 2'654'435'761U >> 24U));
    }
    for (const std::string& whole :
         {small_png(), report::jpeg(noise, 80), small_tiff(noise.rgb, 40, 30, true)}) {
        EXPECT_EQ(refusal(whole, beside), "read");
        // Past the pixels some bytes only close the file.
        const std::size_t least = whole.size() > 3600 ? 3600 : whole.size() - 20;
        for (std::size_t size = 1; size < least; size += 7) {
            EXPECT_NE(refusal(whole.substr(0, size), beside), "read") << size << " of " << whole.size();
        }
    }
}

TEST(ReadPicture, RefusesMorePixelsThanItMayHave) {
    std::string bytes = small_tiff(small_rgb, 3, 2, true);
    const std::size_t tags = bytes.size() - 4 - 11 * 12;
    const auto set = [&](std::size_t tag, std::uint32_t value) {
        for (std::size_t i = 0; i < 4; ++i) {
            bytes[tags + 12 * tag + 8 + i] = static_cast<char>(value >> (8 * i) & 0xFFU);
        }
    };
    set(0, 200'000);
    set(1, 200'000);
    EXPECT_NE(refusal(bytes, {}).find("200000 x 200000 pixels, expected 1 to 100 million pixels"),
              std::string::npos)
        << refusal(bytes, {});
}

}  // namespace
}  // namespace coupling::picture::picture_file_test
