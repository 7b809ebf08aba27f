#include "coupling/inputs/formats/geotiff.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>

#include "config/grid/ascii_grid.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/systems/coordinate_systems.hpp"
#include "coupling/results/maps/geotiff.hpp"
#include "tests/coupling/inputs/formats/given_files.hpp"

namespace coupling::geotiff_test {
namespace {

using formats::read_geotiff;

/// The bytes of a file with a tag of its first directory set to another value (little endian, 2 or 4 bytes).
std::string with_tag(std::string bytes, std::uint16_t tag, std::uint32_t value) {
    const auto number = [&](std::size_t at, std::size_t size) {
        std::uint32_t found = 0;
        std::memcpy(&found, bytes.data() + at, size);
        return found;
    };
    const std::size_t directory = number(4, 4);
    for (std::size_t i = 0; i < number(directory, 2); ++i) {
        const std::size_t entry = directory + 2 + 12 * i;
        if (number(entry, 2) == tag) {
            std::memcpy(bytes.data() + entry + 8, &value, number(entry + 2, 2) == 3 ? 2 : 4);
            return bytes;
        }
    }
    throw std::logic_error{"no such tag"};
}

std::string refused(const std::string& bytes) {
    return refusal_of([&] { read_geotiff(bytes, "dem.tif"); });
}

TEST(ReadGeotiff, GivesTheGridThatItWasMadeFrom) {
    const SampleProject project;
    for (const auto& [tif, asc] : {std::pair{"dem.tif", "dem.asc"}, std::pair{"surface.tif", "surface.asc"},
                                   std::pair{"source.tif", "source.asc"}}) {
        const formats::PlacedGrid grid = read_geotiff(given_file(tif), tif);
        const config::Raster<double> given = config::read_ascii_grid(project.read(asc), asc);
        EXPECT_EQ(grid.raster.frame, given.frame) << tif;
        EXPECT_EQ(grid.raster.values, given.values) << tif;
    }
}

TEST(ReadGeotiff, NamesTheCoordinateSystemOfItsKeys) {
    const auto projection =
        plausible::read_projection(read_geotiff(given_file("dem.tif"), "dem.tif").projection);
    ASSERT_TRUE(projection);
    EXPECT_EQ(projection->name, "JGD_2000_Japan_Zone_1");
    EXPECT_EQ(projection->central_meridian_deg, 129.5);
}

TEST(ReadGeotiff, NamesTheUnitOfItsHeights) {
    const std::string system = read_geotiff(given_file("feet.tif"), "feet.tif").projection;
    const auto plan = plausible::read_projection(system);
    ASSERT_TRUE(plan);
    EXPECT_EQ(plan->metres_per_unit, 1.0) << "of the plan";
    const auto heights = plausible::height_unit_in(system);
    ASSERT_TRUE(heights) << system;
    EXPECT_NEAR(heights->metres, 1200.0 / 3937.0, 1e-9);
    EXPECT_EQ(heights->name, "NAVD88 height (ftUS)");
    EXPECT_FALSE(plausible::height_unit_in(read_geotiff(given_file("dem.tif"), "dem.tif").projection));
}

TEST(ReadGeotiff, ReadsWhatTheProgramWrites) {
    const SampleProject project;
    config::Raster<double> raster{{3, 2, 100.5, 200.25, 0.5, 0.5}, 0.0};
    raster.values = {1.5, -2.25, std::nan(""), 1e6, 0.0, 4.0};
    const std::string system =
        "PROJCS[\"Own\",GEOGCS[\"G\",DATUM[\"D\",SPHEROID[\"Bessel_1841\",6377397.155,299.1528128]],"
        "PRIMEM[\"Greenwich\",0],UNIT[\"Degree\",0.0174532925199433]],PROJECTION[\"Transverse_Mercator\"],"
        "PARAMETER[\"Central_Meridian\",10],UNIT[\"Meter\",1]]";
    write_geotiff(project.file("own.tif"), raster, system);
    const formats::PlacedGrid grid = read_geotiff(project.read("own.tif"), "own.tif");
    EXPECT_EQ(grid.raster.frame, raster.frame);
    EXPECT_EQ(grid.projection, system);
    for (std::size_t i = 0; i < raster.values.size(); ++i) {
        EXPECT_TRUE(grid.raster.values[i] == raster.values[i] ||
                    (std::isnan(grid.raster.values[i]) && std::isnan(raster.values[i])))
            << i;
    }
}

TEST(ReadGeotiff, RefusesAFileThatIsCutOff) {
    const std::string whole = given_file("dem.tif");
    const std::string rows = given_file("source.tif");
    for (const std::size_t bytes : {std::size_t{4}, std::size_t{9}, std::size_t{100}, whole.size() / 2}) {
        EXPECT_NE(refused(whole.substr(0, bytes)), "") << bytes;
    }
    constexpr std::size_t after_last_row = 632;  // GDAL fills the last strip up
    for (std::size_t bytes = 8; bytes < after_last_row; ++bytes) {
        const std::string message = refused(rows.substr(0, bytes));
        EXPECT_TRUE(message.find("cut off") != std::string::npos ||
                    message.find("no place on the map") != std::string::npos)
            << bytes << ": " << message;
    }
}

TEST(ReadGeotiff, RefusesWhatAGridOfOursCannotHave) {
    const std::string plain = given_file("source.tif");
    EXPECT_EQ(refused(with_tag(plain, 277, 2)),
              "dem.tif: found 2 bands, expected a grid of one band; export the band that holds the values "
              "(QGIS: Translate; gdal_translate -b 1)");
    EXPECT_EQ(refused(with_tag(plain, 259, 34712)),
              "dem.tif: found compression 34712, expected none, LZW, deflate, packbits, LZMA, ZSTD or LERC; "
              "save it with one of these (QGIS: Translate, option COMPRESS=DEFLATE)");
    EXPECT_NE(refused(with_tag(plain, 258, 12)).find("found cells of 12 bits"), std::string::npos);
    EXPECT_NE(refused(with_tag(plain, 339, 5)).find("complex or unknown"), std::string::npos);
}

/// The bytes of a file in which a tag of its first directory is another one (little endian).
std::string with_other_tag(std::string bytes, std::uint16_t tag, std::uint16_t other) {
    std::uint32_t directory = 0;
    std::memcpy(&directory, bytes.data() + 4, 4);
    std::uint16_t entries = 0;
    std::memcpy(&entries, bytes.data() + directory, 2);
    for (std::size_t at = directory + 2U; at < directory + 2U + 12U * entries; at += 12) {
        if (std::memcmp(bytes.data() + at, &tag, 2) == 0) {
            std::memcpy(bytes.data() + at, &other, 2);
            return bytes;
        }
    }
    throw std::logic_error{"no such tag"};
}

TEST(ReadGeotiff, TakesItsPlaceFromAWorldFileWhereItHasNone) {
    const std::string placed = given_file("source.tif");
    const std::string without = with_other_tag(with_other_tag(placed, 33550, 33551), 33922, 33923);
    EXPECT_NE(refused(without).find("no place on the map"), std::string::npos);
    const config::GridFrame frame = read_geotiff(placed, "dem.tif").raster.frame;
    const auto text = [](double number) { return config::to_text(number) + "\r\n"; };
    const std::string world = text(frame.cell_width_m) + text(0) + text(0) + text(-frame.cell_height_m) +
                              text(frame.x_centre_m(0)) + text(frame.y_centre_m(0));
    EXPECT_EQ(read_geotiff(without, "dem.tif", world).raster.frame, frame);
    EXPECT_NE(
        refusal_of([&] { read_geotiff(without, "dem.tif", "10\n0\nx\n"); }).find("six lines of numbers"),
        std::string::npos);
    EXPECT_NE(
        refusal_of([&] { read_geotiff(without, "dem.tif", "10\n1\n1\n-10\n0\n0\n"); }).find("a rotated grid"),
        std::string::npos);
}

/// The bytes of a file whose cells number the colours of a table: in place of another tag, at its end.
std::string with_colours(const std::string& file, std::uint16_t instead_of) {
    constexpr std::uint16_t photometric = 262;
    constexpr std::uint16_t colour_map = 320;
    constexpr std::uint32_t shorts = 3U << 16U;  // of cells of 16 bits
    std::string bytes = with_tag(file, photometric, 3);
    const auto end = static_cast<std::uint32_t>(bytes.size());
    bytes = with_other_tag(bytes, instead_of, colour_map);
    std::uint32_t directory = 0;
    std::memcpy(&directory, bytes.data() + 4, 4);
    std::size_t at = directory + 2U;
    while (std::memcmp(bytes.data() + at, &colour_map, 2) != 0) {
        at += 12;
    }
    constexpr std::uint16_t type_short = 3;
    std::memcpy(bytes.data() + at + 2, &type_short, 2);
    std::memcpy(bytes.data() + at + 4, &shorts, 4);
    std::memcpy(bytes.data() + at + 8, &end, 4);
    return bytes + std::string(2U * shorts, '\x20');
}

TEST(ReadGeotiff, NamesATableOfColours) {
    const std::string codes = given_file("source.tif");
    const auto grid = read_geotiff(with_colours(codes, 339), "source.tif");
    EXPECT_EQ(grid.remarks, (std::vector<std::string>{
                                "has a table of colours, which is not used: its cells are taken as codes"}));
    EXPECT_TRUE(read_geotiff(codes, "source.tif").remarks.empty());
}

TEST(ReadGeotiff, TakesNoMemoryForCellsThatTheFileDoesNotHold) {
    const std::string large = with_tag(with_tag(given_file("source.tif"), 256, 60'000), 257, 60'000);
    EXPECT_NE(refused(large).find("400 million cells"), std::string::npos) << refused(large);
    const std::string wide = with_tag(with_tag(given_file("source.tif"), 256, 10'000), 257, 10'000);
    EXPECT_NE(refused(wide).find("a file that holds its cells"), std::string::npos) << refused(wide);
}

TEST(IsTiff, TakesBothByteOrdersAndBothSizes) {
    for (const std::string& beginning : {std::string{"II*\0", 4}, std::string{"MM\0*", 4},
                                         std::string{"II+\0", 4}, std::string{"MM\0+", 4}}) {
        EXPECT_TRUE(formats::is_tiff(beginning + "more"));
    }
    EXPECT_FALSE(formats::is_tiff("ncols 12"));
    EXPECT_FALSE(formats::is_tiff(""));
}

}  // namespace
}  // namespace coupling::geotiff_test
