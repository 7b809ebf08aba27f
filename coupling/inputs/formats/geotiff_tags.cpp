#include "coupling/inputs/formats/geotiff_tags.hpp"

#include <xtiffio.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/text/reading.hpp"

namespace coupling::formats {
namespace {

using config::joined;

/// An item of GDAL's metadata with a role, such as `scale`; empty where there is none.
std::string metadata_item(TIFF* tiff, const std::string& role) {
    constexpr std::uint32_t gdal_metadata = 42112;
    const std::string metadata = text_of_tag(tiff, gdal_metadata);
    const std::size_t at = metadata.find("role=\"" + role + "\"");
    const std::size_t begin = at == std::string::npos ? at : metadata.find('>', at);
    const std::size_t end = begin == std::string::npos ? begin : metadata.find('<', begin);
    return end == std::string::npos ? std::string{} : metadata.substr(begin + 1, end - begin - 1);
}

/// Where GDAL keeps a number by which all cells are to be multiplied, or which is to be added.
void refuse_packed_numbers(TIFF* tiff, const std::string& file) {
    for (const auto& [role, plain] :
         std::array<std::pair<std::string, double>, 2>{{{"scale", 1.0}, {"offset", 0.0}}}) {
        const std::string value = metadata_item(tiff, role);
        if (!value.empty() && config::parse_number(value) != plain) {
            refuse_tiff(file, joined("cells with a ", role, " of ", config::in_quotes(value)),
                        "cells that hold the values themselves",
                        "unpack them (gdal_translate -unscale -ot Float32)");
        }
    }
}

/// The unit that GDAL names for the cells: lengths in another one than metres are refused, other units named.
void look_at_unit(TIFF* tiff, const std::string& file, std::vector<std::string>& remarks) {
    const std::string unit = metadata_item(tiff, "unittype");
    const std::string low = config::in_lower_case(config::trimmed(unit));
    constexpr std::array metres{"", "m", "metre", "metres", "meter", "meters"};
    if (std::find(metres.begin(), metres.end(), low) != metres.end()) {
        return;
    }
    struct Length {
        const char* name;
        const char* in_metres;
    };
    constexpr std::array others{Length{"ft", "0.3048"},
                                Length{"foot", "0.3048"},
                                Length{"feet", "0.3048"},
                                Length{"us-ft", "0.304800609601"},
                                Length{"us survey foot", "0.304800609601"},
                                Length{"ftus", "0.304800609601"},
                                Length{"cm", "0.01"},
                                Length{"mm", "0.001"},
                                Length{"dm", "0.1"},
                                Length{"km", "1000"}};
    for (const Length& other : others) {
        if (low == other.name) {
            refuse_tiff(file, joined("cells in ", config::in_quotes(unit)), "cells in metres",
                        joined("convert them (gdal_calc.py -A IN --calc=\"A*", other.in_metres,
                               "\" --type=Float32 --outfile=metres.tif)"));
        }
    }
    remarks.push_back(
        joined("names ", config::in_quotes(unit), " as the unit of its cells, which is not used"));
}

/// Cells that number colours are codes at best: of a picture they are no values.
void look_at_colours(TIFF* tiff, std::vector<std::string>& remarks) {
    std::uint16_t photometric = PHOTOMETRIC_MINISBLACK;
    TIFFGetField(tiff, TIFFTAG_PHOTOMETRIC, &photometric);
    if (photometric == PHOTOMETRIC_PALETTE) {
        remarks.emplace_back("has a table of colours, which is not used: its cells are taken as codes");
    }
}

/// A mask says which cells are known; a grid of ours says so by its NODATA. Smaller copies for drawing are
/// passed over; other images of the file are named.
void look_at_other_images(TIFF* tiff, const std::string& file, std::vector<std::string>& remarks) {
    constexpr int most_directories = 50;  // overviews, of each perhaps a mask
    int others = 0;
    for (int i = 0; i < most_directories && TIFFReadDirectory(tiff) == 1; ++i) {
        std::uint32_t kind = 0;
        TIFFGetFieldDefaulted(tiff, TIFFTAG_SUBFILETYPE, &kind);
        if ((kind & FILETYPE_MASK) != 0) {
            refuse_tiff(file, "a mask beside the cells", "NODATA as a value of cells",
                        "write it so (gdalwarp -dstnodata -9999)");
        }
        others += (kind & FILETYPE_REDUCEDIMAGE) == 0 ? 1 : 0;
    }
    TIFFSetDirectory(tiff, 0);
    if (others > 0) {
        remarks.push_back(
            joined("holds ", std::to_string(others + 1), " grids, of which the first is taken"));
    }
}

}  // namespace

void refuse_tiff(const std::string& file, std::string found, std::string expected, std::string advice) {
    config::fail(config::ExitCode::data, {file}, std::move(found), std::move(expected), std::move(advice));
}

std::string text_of_tag(TIFF* tiff, std::uint32_t tag) {
    const TIFFField* field = TIFFFindField(tiff, tag, TIFF_ANY);
    if (field == nullptr || TIFFFieldDataType(field) != TIFF_ASCII || TIFFFieldPassCount(field) == 0 ||
        TIFFFieldReadCount(field) != TIFF_VARIABLE2) {
        return {};
    }
    std::uint32_t count = 0;
    const char* text = nullptr;
    if (TIFFGetField(tiff, tag, &count, &text) != 1 || text == nullptr) {
        return {};
    }
    return std::string{text, strnlen(text, count)};
}

void look_at_other_parts(TIFF* tiff, const std::string& file, std::vector<std::string>& remarks) {
    refuse_packed_numbers(tiff, file);
    look_at_colours(tiff, remarks);
    look_at_unit(tiff, file, remarks);
    look_at_other_images(tiff, file, remarks);
}

}  // namespace coupling::formats
