#include "coupling/inputs/grids/vrt.hpp"

#include <gtest/gtest.h>

#include "coupling/inputs/grids/xml_elements.hpp"
#include "tests/coupling/inputs/formats/given_files.hpp"

namespace coupling::grids::vrt_test {
namespace {

/// As gdalbuildvrt writes it.
constexpr const char* two_tiles = R"(<VRTDataset rasterXSize="6" rasterYSize="4">
  <SRS dataAxisToSRSAxisMapping="1,2">PROJCS["A &amp; B"]</SRS>
  <GeoTransform>  1.0000000000000000e+03,  5.0000000000000000e+00,  0.0000000000000000e+00,  2.0200000000000000e+03,  0.0000000000000000e+00, -5.0000000000000000e+00</GeoTransform>
  <VRTRasterBand dataType="Float32" band="1">
    <NoDataValue>-9999</NoDataValue>
    <ColorInterp>Gray</ColorInterp>
    <ComplexSource>
      <SourceFilename relativeToVRT="1">west.tif</SourceFilename>
      <SourceBand>1</SourceBand>
      <SourceProperties RasterXSize="3" RasterYSize="4" DataType="Float32" BlockXSize="3" BlockYSize="4" />
      <SrcRect xOff="0" yOff="0" xSize="3" ySize="4" />
      <DstRect xOff="0" yOff="0" xSize="3" ySize="4" />
      <NODATA>-32768</NODATA>
    </ComplexSource>
    <SimpleSource>
      <SourceFilename relativeToVRT="0">/data/east &amp; on.tif</SourceFilename>
      <SrcRect xOff="1" yOff="2" xSize="3" ySize="2" />
      <DstRect xOff="2.9999999" yOff="0" xSize="3" ySize="2" />
    </SimpleSource>
  </VRTRasterBand>
</VRTDataset>
)";

std::string refusal(const std::string& from, const std::string& to) {
    std::string text = two_tiles;
    text.replace(text.find(from), from.size(), to);
    return refusal_of([&] { read_virtual_raster(text, "all.vrt"); });
}

TEST(VirtualRaster, NamesItsTilesAndTheirPlaces) {
    EXPECT_TRUE(is_virtual_raster(two_tiles));
    EXPECT_TRUE(is_virtual_raster("<?xml version=\"1.0\"?>\n<VRTDataset rasterXSize=\"1\">"));
    EXPECT_FALSE(is_virtual_raster("<OGRVRTDataSource>"));
    const VirtualRaster raster = read_virtual_raster(two_tiles, "all.vrt");
    EXPECT_EQ(raster.frame, (config::GridFrame{.columns = 6,
                                               .rows = 4,
                                               .x_west_m = 1000.0,
                                               .y_south_m = 2000.0,
                                               .cell_width_m = 5.0,
                                               .cell_height_m = 5.0}));
    EXPECT_EQ(raster.system, "PROJCS[\"A & B\"]");
    ASSERT_EQ(raster.sources.size(), 2U);
    EXPECT_EQ(raster.sources[0].file, "west.tif");
    EXPECT_EQ(raster.sources[0].from, (CellWindow{{0, 0}, 3, 4}));
    EXPECT_EQ(raster.sources[0].none, (std::vector<double>{-32768.0, -9999.0}));
    EXPECT_EQ(raster.sources[1].file, "/data/east & on.tif");
    EXPECT_EQ(raster.sources[1].from, (CellWindow{{1, 2}, 3, 2}));
    EXPECT_EQ(raster.sources[1].to, (config::Cell{3, 0}));
    EXPECT_EQ(raster.sources[1].line, 15U);
}

TEST(VirtualRaster, RefusesWhatWouldChangeCells) {
    EXPECT_NE(refusal("rasterYSize=\"4\"", "rasterYSize=\"4\" subClass=\"VRTWarpedDataset\"")
                  .find("is computed (VRTWarped"),
              std::string::npos);
    EXPECT_NE(
        refusal("band=\"1\"", "band=\"1\" subClass=\"VRTDerivedRasterBand\"").find("a band that is computed"),
        std::string::npos);
    EXPECT_NE(
        refusal("<DstRect xOff=\"0\" yOff=\"0\" xSize=\"3\"", "<DstRect xOff=\"0\" yOff=\"0\" xSize=\"6\"")
            .find("3 x 4 cells of 'west.tif' drawn as 6 x 4"),
        std::string::npos);
    EXPECT_NE(refusal("xOff=\"1\"", "xOff=\"1.5\"").find("whole cells"), std::string::npos);
    EXPECT_NE(refusal("<NODATA>-32768</NODATA>", "<ScaleRatio>0.1</ScaleRatio>")
                  .find("a source with ScaleRatio 0.1"),
              std::string::npos);
    EXPECT_NE(refusal("<SourceBand>1<", "<SourceBand>2<").find("band 2 of a source"), std::string::npos);
    EXPECT_NE(refusal("west.tif", "/vsizip/a.zip/west.tif").find("a file on this disk"), std::string::npos);
    EXPECT_NE(refusal("</VRTRasterBand>", "</VRTRasterBand><VRTRasterBand band=\"2\"></VRTRasterBand>")
                  .find("several bands"),
              std::string::npos);
    EXPECT_NE(refusal("0.0000000000000000e+00,  2.02", "0.1,  2.02").find("rotated"), std::string::npos);
    EXPECT_NE(refusal("GeoTransform>  ", "GeoTransform>  x").find("GeoTransform with"), std::string::npos);
    EXPECT_NE(refusal("<SimpleSource>", "<KernelFilteredSource>").find("ends before it begins"),
              std::string::npos);
    EXPECT_NE(refusal("  <GeoTransform>", "  <Other>").find("ends before it begins"), std::string::npos);
}

TEST(ElementsOfXml, AreRefusedWhereTheTextEndsEarly) {
    const std::string text = two_tiles;
    for (const std::size_t length : {10U, 60U, 200U, 700U, 1000U}) {
        EXPECT_NE(refusal_of([&] { elements_of_xml(text.substr(0, length), "all.vrt"); }), "") << length;
    }
    std::string deep;
    for (int level = 0; level < 1000; ++level) {
        deep += "<a>";
    }
    EXPECT_NE(refusal_of([&] { elements_of_xml(deep, "deep.vrt"); }).find("too many"), std::string::npos);
    EXPECT_NE(refusal_of([&] { elements_of_xml("no XML", "x.vrt"); }), "");
    const auto elements =
        elements_of_xml("<a b='1 > 0'><!-- <c> --><![CDATA[x < y]]> &lt;z&#62;</a>", "x.vrt");
    ASSERT_EQ(elements.size(), 1U);
    EXPECT_EQ(elements[0].attribute("b"), "1 > 0");
    EXPECT_EQ(elements[0].text, "x < y <z>");
}

}  // namespace
}  // namespace coupling::grids::vrt_test
