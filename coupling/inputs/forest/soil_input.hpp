#pragma once

#include <map>
#include <optional>
#include <string>

#include "config/grid/raster.hpp"
#include "config/table/declared.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "forest/stand/patch.hpp"

namespace coupling {

/// Which soil lies where.
struct SoilCover {
    std::optional<config::Raster<double>> map;  ///< of codes, on a frame of its own
    std::map<double, forest::Soil> types;       ///< by code
    std::optional<forest::Soil> elsewhere;      ///< where the map says nothing
    std::string file;                           ///< of the map, in messages

    /// The soil at a place; nothing where no code and no soil.type says, or the code has no type.
    [[nodiscard]] std::optional<forest::Soil> at(double x_m, double y_m) const;
    /// The code at a place; NaN where the map has none.
    [[nodiscard]] double code_at(double x_m, double y_m) const;
};

struct ForestSoilRow;
const config::Schema<ForestSoilRow>& soil_columns();

/// Reads soil.map, soil.types, soil.type. Refuses codes of the map without a type.
std::optional<SoilCover> read_soils(Reading& reading);

}  // namespace coupling
