#include "coupling/inputs/grids/vrt.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/text/reading.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/inputs/formats/system_text.hpp"
#include "coupling/inputs/grids/xml_elements.hpp"

namespace coupling::grids {
namespace {

using config::joined;

constexpr double most_cells_of_side = 4e8;  // of a side

[[noreturn]] void refuse(const std::string& file, std::size_t line, std::string found, std::string expected) {
    config::fail(config::ExitCode::data, {file, line}, std::move(found), std::move(expected),
                 "write it out as one grid (gdal_translate IN.vrt dem.tif)");
}

/// A virtual raster while it is read.
class VrtReader {
public:
    VrtReader(std::string_view bytes, const std::string& file)
        : elements_{elements_of_xml(bytes, file)}, file_{file} {}

    VirtualRaster read() {
        const XmlElement& root = elements_.front();
        if (!root.attribute("subClass").empty()) {
            refuse(file_, root.line,
                   joined("a virtual raster that is computed (", root.attribute("subClass"), ")"),
                   "one that puts tiles side by side");
        }
        VirtualRaster raster;
        raster.frame = frame_of(root);
        std::vector<double> none;
        const std::size_t band = band_number();
        for (std::size_t i = 1; i < elements_.size(); ++i) {
            const XmlElement& element = elements_[i];
            if (element.parent == 0 && element.name == "SRS") {
                raster.system = system_of(element.text);
            } else if (element.parent == 0 && element.name == "MaskBand") {
                refuse(file_, element.line, "a virtual raster with a mask", "NODATA where nothing is known");
            } else if (element.parent == band && element.name == "NoDataValue") {
                none = no_data_of(element);
            } else if (element.parent == band && element.name.ends_with("Source")) {
                raster.sources.push_back(source_of(i));
            } else if (element.parent == band && (element.name == "Scale" || element.name == "Offset") &&
                       number_of(element, element.text) != (element.name == "Scale" ? 1.0 : 0.0)) {
                refuse(file_, element.line, joined("a virtual raster with ", element.name, " ", element.text),
                       "values as they are");
            }
        }
        for (VrtSource& source : raster.sources) {
            source.none.insert(source.none.end(), none.begin(), none.end());
        }
        if (raster.sources.empty()) {
            refuse(file_, root.line, "a virtual raster without sources", "at least one SourceFilename");
        }
        return raster;
    }

private:
    double number_of(const XmlElement& element, std::string_view text) const {
        const auto number = config::parse_number(config::trimmed(text));
        if (!number) {
            refuse(file_, element.line, joined(element.name, " with ", config::in_quotes(text)), "a number");
        }
        return *number;
    }
    int cells_of(const XmlElement& element, const char* attribute, double least) const {
        const double number = number_of(element, element.attribute(attribute));
        constexpr double slack = 1e-3;  // of a cell: gdalbuildvrt writes 999.9999999 for 1000
        if (std::abs(number - std::round(number)) > slack || std::round(number) < least ||
            number > most_cells_of_side) {
            refuse(file_, element.line,
                   joined(element.name, " with ", attribute, " ",
                          config::in_quotes(element.attribute(attribute))),
                   "whole cells: what lies between them would be computed anew");
        }
        return static_cast<int>(std::round(number));
    }
    config::GridFrame frame_of(const XmlElement& root) const {
        config::GridFrame frame;
        frame.columns = cells_of(root, "rasterXSize", 1.0);
        frame.rows = cells_of(root, "rasterYSize", 1.0);
        const auto found = std::find_if(
            elements_.begin() + 1, elements_.end(),
            [](const XmlElement& element) { return element.parent == 0 && element.name == "GeoTransform"; });
        std::array<double, 6> numbers{};
        if (found == elements_.end()) {
            refuse(file_, root.line, "a virtual raster without a place on the map", "a GeoTransform");
        }
        std::string_view text = found->text;
        for (double& number : numbers) {
            const std::size_t comma = std::min(text.find(','), text.size());
            number = number_of(*found, text.substr(0, comma));
            text.remove_prefix(std::min(comma + 1, text.size()));
        }
        if (numbers[2] != 0.0 || numbers[4] != 0.0 || !(numbers[1] > 0.0) || !(numbers[5] < 0.0)) {
            refuse(file_, found->line, "a virtual raster that is rotated or runs northward",
                   "rows from west to east, from north to south");
        }
        frame.cell_width_m = numbers[1];
        frame.cell_height_m = -numbers[5];
        frame.x_west_m = numbers[0];
        frame.y_south_m = numbers[3] - frame.rows * frame.cell_height_m;
        return frame;
    }
    /// The number of the only band.
    std::size_t band_number() const {
        std::size_t band = 0;
        for (std::size_t i = 1; i < elements_.size(); ++i) {
            const XmlElement& element = elements_[i];
            if (element.parent != 0 || element.name != "VRTRasterBand") {
                continue;
            }
            if (band != 0) {
                refuse(file_, element.line, "several bands", "a grid of one band");
            }
            if (const std::string kind = element.attribute("subClass"); !kind.empty()) {
                refuse(file_, element.line, joined("a band that is computed (", kind, ")"),
                       "one that puts tiles side by side");
            }
            band = i;
        }
        if (band == 0) {
            refuse(file_, 1, "a virtual raster without a band", "a grid of one band");
        }
        return band;
    }
    std::string system_of(const std::string& text) const {
        // A code becomes well-known text; text of a file goes no further.
        const bool is_code = text.starts_with("EPSG:") && text.size() < 12;
        return is_code ? formats::esri_text_of(text) : text;
    }
    std::vector<double> no_data_of(const XmlElement& element) const {
        return config::in_lower_case(element.text) == "nan" ? std::vector<double>{}
                                                            : std::vector{number_of(element, element.text)};
    }
    VrtSource source_of(std::size_t number) const {
        const XmlElement& own = elements_[number];
        if (own.name != "SimpleSource" && own.name != "ComplexSource") {
            refuse(file_, own.line, joined("a source that is computed (", own.name, ")"),
                   "SimpleSource or ComplexSource");
        }
        VrtSource source;
        source.line = own.line;
        bool has_windows = false;
        CellWindow to;
        for (std::size_t i = number + 1; i < elements_.size() && elements_[i].parent >= number; ++i) {
            const XmlElement& element = elements_[i];
            if (element.parent != number) {
                continue;
            }
            if (element.name == "SourceFilename") {
                source.file = file_of(element);
            } else if (element.name == "SourceBand" && element.text != "1") {
                refuse(file_, element.line, joined("band ", element.text, " of a source"),
                       "band 1, the only one");
            } else if (element.name == "SrcRect") {
                source.from = window_of(element);
            } else if (element.name == "DstRect") {
                to = window_of(element);
                has_windows = true;
            } else if (element.name == "NODATA") {
                source.none = no_data_of(element);
            } else if (changes_cells(element)) {
                refuse(file_, element.line, joined("a source with ", element.name, " ", element.text),
                       "values as they are");
            }
        }
        if (source.file.empty() || !has_windows || source.from.columns == 0) {
            refuse(file_, own.line, "a source without file or place", "SourceFilename, SrcRect and DstRect");
        }
        if (to.columns != source.from.columns || to.rows != source.from.rows) {
            refuse(file_, own.line,
                   joined(std::to_string(source.from.columns), " x ", std::to_string(source.from.rows),
                          " cells of ", path_in_quotes(source.file), " drawn as ", std::to_string(to.columns),
                          " x ", std::to_string(to.rows)),
                   "cells of one size in all sources: grids are never resampled here");
        }
        source.to = to.first;
        return source;
    }
    bool changes_cells(const XmlElement& element) const {
        const bool is_factor = element.name == "ScaleRatio" && number_of(element, element.text) != 1.0;
        const bool is_offset = element.name == "ScaleOffset" && number_of(element, element.text) != 0.0;
        return is_factor || is_offset || element.name == "LUT" || element.name == "Exponent" ||
               element.name == "UseMaskBand" || element.name == "ColorTableComponent";
    }
    CellWindow window_of(const XmlElement& element) const {
        return {{cells_of(element, "xOff", 0.0), cells_of(element, "yOff", 0.0)},
                cells_of(element, "xSize", 1.0),
                cells_of(element, "ySize", 1.0)};
    }
    std::string file_of(const XmlElement& element) const {
        const std::string& name = element.text;
        if (name.starts_with("/vsi") || name.find("://") != std::string::npos || name.empty()) {
            refuse(file_, element.line, joined("a source ", config::in_quotes(name)), "a file on this disk");
        }
        return name;
    }

    std::vector<XmlElement> elements_;
    const std::string& file_;
};

}  // namespace

bool is_virtual_raster(std::string_view bytes) {
    bytes = config::trimmed(config::without_byte_order_mark(bytes.substr(0, 4096)));
    if (bytes.starts_with("<?xml")) {
        bytes.remove_prefix(std::min(bytes.find("?>"), bytes.size() - 2) + 2);
        bytes = config::trimmed(bytes);
    }
    return bytes.starts_with("<VRTDataset");
}

VirtualRaster read_virtual_raster(std::string_view bytes, const std::string& file) {
    return VrtReader{bytes, file}.read();
}

}  // namespace coupling::grids
