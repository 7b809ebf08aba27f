#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "coupling/results/figures/colours.hpp"

namespace coupling::qgis {

// How QGIS draws a layer of points, lines or areas, as XML (<renderer-v2>). Size and width are in mm and grow
// with the class as the colours grow darker, so that classes stay apart in black and white.

enum class Mark { point, line, area };

struct Symbol {
    std::string label;
    Colour colour;
    double size_mm = 0.3;  ///< diameter of a point, width of a line or of an outline (0: none)
};

/// A class of values: above `low` up to `high`.
struct Range {
    double low = 0.0;
    double high = 0.0;
    Symbol symbol;
};

/// A value as it stands in the column.
struct Category {
    std::string value;
    Symbol symbol;
};

std::string single(Mark mark, const Symbol& symbol);
std::string graduated(Mark mark, std::string_view column, const std::vector<Range>& ranges);
std::string categorised(Mark mark, std::string_view column, const std::vector<Category>& categories);

/// Energies [kJ] in the classes of intensity, below 30, to 300 and above; `none` comes before them for values
/// of 0.
std::string by_energy(Mark mark, std::string_view column, double least_size_mm, const Symbol* none = nullptr);

}  // namespace coupling::qgis
