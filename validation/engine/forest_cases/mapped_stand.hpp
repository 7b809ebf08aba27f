#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "config/errors/warnings.hpp"
#include "config/table/table.hpp"
#include "config/units/angle.hpp"
#include "forest/light/canopy.hpp"
#include "forest/light/sun.hpp"

namespace coupling::validation::forest_cases {

/// A slope that the stand was laid on by the reference program, and what that program found.
struct MappedSlope {
    std::string name;
    config::Angle slope;
    config::Angle aspect;          ///< direction it faces, clockwise from north
    config::Angle y_axis_azimuth;  ///< direction of the y axis of the positions; up or down the slope
    double direct_mjpm2 = 0.0;     ///< reference: energy of a year per area of the slope; 0 where unknown
    double diffuse_mjpm2 = 0.0;
    // Of a reference what it has; the rest is empty.
    std::vector<double> tree_light;    ///< light ratio of each tree [0, 1]
    std::vector<double> ground_light;  ///< light on each ground cell relative to the open slope [0, 1]
    std::vector<double> sensor_light;  ///< the same at each sensor
};

/// A place on the ground where light was measured.
struct LightSensor {
    double x_m = 0.0;
    double y_m = 0.0;
};

/// A square stand with known places of its trees, whose light another program has computed on one or several
/// slopes, or which sensors have measured.
struct MappedStand {
    config::Angle latitude;
    double side_m = 100.0;  ///< the stand repeats itself on all sides
    forest::MonthlyRadiation radiation;
    std::vector<forest::LightTree> trees;  ///< extinction not set
    std::vector<LightSensor> sensors;
    std::vector<MappedSlope> slopes;
};

/// The tables of a case; those of ground and sensors may be missing.
struct MappedTables {
    config::Table trees;
    config::Table leaves;
    config::Table radiation;
    config::Table slopes;
    std::optional<config::Table> ground{};
    std::optional<config::Table> sensors{};
};

/// The stand of validation/forest_light, or another in that form, from its tables. Throws config::InputError
/// for fields that are no numbers or out of range, for missing columns, for slopes and species of leaves that
/// stand twice, for crowns that begin at or above the top of their tree, and for a slope without any
/// reference: no column light_SLOPE in trees, ground or sensors.
[[nodiscard]] MappedStand mapped_stand(const MappedTables& tables);

/// Warns of columns that nothing reads: misspelt ones, and light of slopes that there are not.
void warn_of_unknown_columns(const MappedTables& tables, config::Warnings& warnings);

}  // namespace coupling::validation::forest_cases
