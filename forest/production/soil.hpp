#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/table/table.hpp"

namespace forest {

/// What a fine soil is made of [% of mass]; the three sum to 100.
struct SoilTexture {
    double sand_percent = 0.0;
    double silt_percent = 0.0;
    double clay_percent = 0.0;
};

/// Throws config::InputError (data) for shares outside 0-100 or a sum away from 100 by more than 1.
void check(const SoilTexture& texture, const config::Place& place);

/// How strongly a soil holds its water: suction rises as a power of drying.
struct SoilRetention {
    double saturated_potential_kpa = 0.0;  ///< below 0
    double exponent = 0.0;
    double saturated_water = 0.0;  ///< water content [m3/m3]

    /// Matric potential [kPa] at a water content [m3/m3] above 0.
    [[nodiscard]] double potential_kpa(double water) const;
    /// Water content [m3/m3] at a potential [kPa] below 0; never more than the soil can hold.
    [[nodiscard]] double water_at(double potential_kpa) const;
};

/// Retention by texture [Cosby et al. 1984, Water Resour. Res. 20:682-690].
SoilRetention retention_of(const SoilTexture& texture);

/// Water that plants can take from a soil [mm]: between field capacity (-15 kPa) and wilting (-4000 kPa)
/// [iLand], over the depth that roots use, stones taken off.
double available_water_mm(const SoilTexture& texture, double depth_cm, double stone_share);

/// 3-PG's soil class of a texture: 1 sand, 2 sandy loam, 3 clay loam, 4 clay [choice of borders].
int soil_class_of(const SoilTexture& texture);

/// A soil by name, for where nothing better is known.
struct SoilType {
    std::string name;
    double water_capacity_mm = 0.0;
    int soil_class = 3;
    double fertility = 0.0;  ///< [0, 1]
};

/// Reads name,water_capacity (mm),soil_class,fertility. Throws InputError (data).
std::vector<SoilType> read_soil_types(const config::Table& table);
/// Those of config/data/forest_soils.csv.
std::vector<SoilType> shipped_soil_types();

}  // namespace forest
