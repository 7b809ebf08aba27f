#pragma once

#include <optional>
#include <string>

namespace coupling::formats {

/// In what a file counts its heights.
struct HeightUnit {
    std::string name;       ///< of the system of heights, or of the unit where it names none
    double metres = 1.0;    ///< of one unit
    bool is_depth = false;  ///< counted downwards

    [[nodiscard]] bool is_metres_upwards() const {
        return metres > 1.0 - 1e-6 && metres < 1.0 + 1e-6 && !is_depth;
    }
};

/// Of the system of heights with a code of EPSG, such as 6360 (NAVD88 height in US survey feet). Nothing
/// where the tables of PROJ do not have it.
std::optional<HeightUnit> height_unit_of_system(int epsg);

/// Of the unit of length with a code of EPSG, such as 9003 (US survey foot).
std::optional<HeightUnit> height_unit_of_unit(int epsg);

/// As GDAL writes it beside a band: "m", "metre", "ft", "US survey foot". Nothing for other words.
std::optional<HeightUnit> height_unit_in_words(const std::string& word);

/// As ESRI writes it behind the system of the plan: VERTCS["...",...,UNIT["...",0.3048]].
std::string vertical_text(const HeightUnit& unit);

}  // namespace coupling::formats
