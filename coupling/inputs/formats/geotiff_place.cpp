#include "coupling/inputs/formats/geotiff_place.hpp"

#include <xtiffio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string_view>

#include "config/errors/input_error.hpp"
#include "config/text/coordinates.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/formats/geotiff_tags.hpp"

namespace coupling::formats {
namespace {

using config::joined;

/// Numbers of a tag of GeoTIFF; none where it is missing.
std::span<const double> doubles_of(TIFF* tiff, std::uint32_t tag) {
    std::uint16_t count = 0;
    const double* values = nullptr;
    if (TIFFGetField(tiff, tag, &count, &values) != 1 || values == nullptr) {
        return {};
    }
    return {values, count};
}

/// Coordinates of the north-western corner and the size of a cell, southward positive.
struct CornerAndCell {
    double x_m, y_m, width_m, height_m;
    bool is_of_world_file = false;  ///< which names centres of cells in any case
};

/// The first six words of a world file; those that are missing are empty.
std::array<std::string_view, 6> words_of_world_file(std::string_view text) {
    std::array<std::string_view, 6> words;
    std::size_t at = 0;
    for (std::string_view& word : words) {
        at = std::min(text.find_first_not_of(" \t\r\n", at), text.size());
        const std::size_t end = std::min(text.find_first_of(" \t\r\n", at), text.size());
        word = text.substr(at, end - at);
        at = end;
    }
    return words;
}

/// The six lines of a world file, which name the centre of the north-western cell.
CornerAndCell corner_of_world_file(std::string_view text, const std::string& file) {
    std::array<double, 6> lines{};
    const auto words = words_of_world_file(text);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const auto number = config::parse_number(words[i]);
        if (!number) {
            refuse_tiff(file, joined("a world file beside it with ", config::in_quotes(words[i])),
                        "six lines of numbers", "export the grid as GeoTIFF");
        }
        lines[i] = *number;
    }
    if (lines[1] != 0.0 || lines[2] != 0.0) {
        refuse_tiff(file, "a rotated grid", "rows that run from west to east",
                    "resample it to north up (QGIS: Warp)");
    }
    return {lines[4] - 0.5 * lines[0], lines[5] - 0.5 * lines[3], lines[0], -lines[3], true};
}

CornerAndCell corner_and_cell(TIFF* tiff, std::string_view world_file, const std::string& file) {
    const auto matrix = doubles_of(tiff, TIFFTAG_GEOTRANSMATRIX);
    if (matrix.size() == 16) {
        if (matrix[1] != 0.0 || matrix[4] != 0.0) {
            refuse_tiff(file, "a rotated grid", "rows that run from west to east",
                        "resample it to north up (QGIS: Warp)");
        }
        return {matrix[3], matrix[7], matrix[0], -matrix[5]};
    }
    const auto scale = doubles_of(tiff, TIFFTAG_GEOPIXELSCALE);
    const auto tie = doubles_of(tiff, TIFFTAG_GEOTIEPOINTS);
    if (scale.size() < 2 && tie.size() < 6 && !world_file.empty()) {
        return corner_of_world_file(world_file, file);
    }
    if (scale.size() < 2 || tie.size() < 6) {
        refuse_tiff(file, "no place on the map",
                    "a GeoTIFF, which says where its cells lie, or its .tfw beside it",
                    "export it as GeoTIFF from QGIS");
    }
    if (tie.size() > 6) {
        refuse_tiff(file, joined(std::to_string(tie.size() / 6), " tie points"),
                    "one corner and a size of cells", "resample it to north up (QGIS: Warp)");
    }
    return {tie[3] - tie[0] * scale[0], tie[4] + tie[1] * scale[1], scale[0], scale[1]};
}

/// The coordinate without what a sum of decimal numbers leaves in the last bits, as the text of a grid would
/// have it: the nearest millionth of a metre where that is nearer than a thousandth of it.
double without_rounding(double value) {
    constexpr double per_m = 1e6;
    constexpr double close = 1e-3;
    const double scaled = value * per_m;
    return std::abs(scaled - std::round(scaled)) < close ? std::round(scaled) / per_m : value;
}

/// The six numbers of a world file, where it holds them.
std::optional<std::array<double, 6>> numbers_of_world_file(std::string_view text) {
    std::array<double, 6> lines{};
    const auto words = words_of_world_file(text);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const auto number = config::parse_number(words[i]);
        if (!number) {
            return std::nullopt;
        }
        lines[i] = *number;
    }
    return lines;
}

}  // namespace

std::string judge_world_file(const config::GridFrame& frame, std::string_view world_file,
                             const std::string& file) {
    const auto lines = numbers_of_world_file(world_file);
    if (!lines) {
        return {};
    }
    constexpr double slack = 0.01;      // of a cell [choice]
    constexpr double half_cell = 0.51;  // half a cell is the usual slip
    const double x_m = frame.x_centre_m(0);
    const double y_m = frame.y_centre_m(0);
    const double off = std::max(std::abs((*lines)[4] - x_m) / frame.cell_width_m,
                                std::abs((*lines)[5] - y_m) / frame.cell_height_m);
    const bool is_other_cell =
        std::abs((*lines)[0] - frame.cell_width_m) * frame.columns > slack * frame.cell_width_m ||
        std::abs(-(*lines)[3] - frame.cell_height_m) * frame.rows > slack * frame.cell_height_m;
    if (is_other_cell || off > half_cell) {
        refuse_tiff(file,
                    joined("a world file (.tfw) beside it with cells of ", config::to_text((*lines)[0]),
                           " m, the first at ", config::place_in_words((*lines)[4], (*lines)[5])),
                    joined("what its own tags say: cells of ", config::to_text(frame.cell_width_m),
                           " m, the first at ", config::place_in_words(x_m, y_m)),
                    "delete the world file if the tags are right; if it is right, take the place off the "
                    "tags (gdal_edit.py -unsetgt)");
    }
    return off > slack
               ? joined("its world file (.tfw) lies ", config::to_text(std::round(100.0 * off) / 100.0),
                        " cells beside the place of its own tags, which counts")
               : std::string{};
}

namespace {

/// The frame of a grid with such a corner, refused where the numbers cannot be meant.
config::GridFrame checked_frame(const CornerAndCell& found, std::uint32_t columns, std::uint32_t rows,
                                const std::string& file) {
    constexpr double largest_cell_m = 100e3;
    constexpr double farthest_m = 1e9;
    const auto is_cell = [](double size) { return size > 0.0 && size <= largest_cell_m; };
    const auto is_near = [](double at) { return std::abs(at) <= farthest_m; };
    if (!is_cell(found.width_m) || !is_cell(found.height_m) || !is_near(found.x_m) || !is_near(found.y_m)) {
        refuse_tiff(
            file,
            joined("cells of ", config::to_text(found.width_m), " x ", config::to_text(found.height_m),
                   " with a corner at ", config::place_in_words(found.x_m, found.y_m)),
            "rows from north to south, cells above 0 and up to 100 km, corners up to 1e9 m",
            "resample it to north up (QGIS: Warp)");
    }
    config::GridFrame frame;
    frame.columns = static_cast<int>(columns);
    frame.rows = static_cast<int>(rows);
    frame.cell_width_m = found.width_m;
    frame.cell_height_m = found.height_m;
    frame.x_west_m = without_rounding(found.x_m);
    frame.y_south_m = without_rounding(found.y_m - frame.rows * found.height_m);
    return frame;
}

}  // namespace

config::GridFrame frame_of_tiff(TIFF* tiff, std::uint32_t columns, std::uint32_t rows, bool cells_are_points,
                                std::string_view world_file, const std::string& file) {
    CornerAndCell found = corner_and_cell(tiff, world_file, file);
    if (cells_are_points && !found.is_of_world_file) {
        found.x_m -= 0.5 * found.width_m;
        found.y_m += 0.5 * found.height_m;
    }
    return checked_frame(found, columns, rows, file);
}

config::GridFrame frame_of_world_file(std::string_view world_file, std::uint32_t columns, std::uint32_t rows,
                                      const std::string& file) {
    return checked_frame(corner_of_world_file(world_file, file), columns, rows, file);
}

}  // namespace coupling::formats
