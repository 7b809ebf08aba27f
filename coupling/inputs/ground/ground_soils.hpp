#pragma once

#include <optional>
#include <string>
#include <vector>

#include "config/table/declared.hpp"
#include "config/table/table.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "rockfall/laws/soil.hpp"

namespace coupling {

struct GroundSoilRow;
const config::Schema<GroundSoilRow>& ground_soil_columns();

/// The soils of config/data/pir3d_soils.csv.
std::vector<rockfall::Soil> shipped_ground_soils();

/// The shipped soils and those of terrain.soils; one of the same name takes the place of the shipped one.
///
/// A row takes what its columns do not give from the soil in its column `like`. Widths and limit speeds of
/// single parameters (`dr_t_slow_percent`, `limit_angle_mps`, ...) may be left out: they are those of the
/// pair then. Columns without a meaning are refused. Throws InputError (data).
std::vector<rockfall::Soil> read_ground_soils(Reading& reading);

/// The soil whose coefficients of restitution come nearest; null without soils.
const rockfall::Soil* nearest_soil(const rockfall::Restitution& restitution,
                                   const std::vector<rockfall::Soil>& soils);

/// The soil that a field names; nothing, and a problem with the nearest name, for an unknown one.
std::optional<rockfall::Soil> named_soil(const config::Table& table, std::size_t row,
                                         const std::string& column, const std::vector<rockfall::Soil>& soils,
                                         config::Problems& problems);

}  // namespace coupling
