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

/// Two places always lie on a line.
inline constexpr std::size_t least_places_of_correlation = 3;

/// Why light has no correlation with a reference; "" where it has.
[[nodiscard]] std::string why_no_correlation(const std::vector<double>& reference);

/// The same of the sensors of a slope in columns of a width. Requires sensors with light on the slope.
[[nodiscard]] std::string why_no_correlation(const MappedStand& stand, const MappedSlope& slope,
                                             double column_m);

/// What the reference looked at.
struct LightMonths {
    int first = 1;                  ///< [1, 12] of the months that light is a mean of
    int last = 12;                  ///< [first, 12]
    double least_angle_deg = 10.0;  ///< light flatter than this to the ground does not count
};

/// How our light is computed for the comparison.
struct MappedSettings {
    double column_m = 10.0;  ///< a divisor of the side of the stand
    double extinction = forest::effective_extinction;
    int ground_points = 1;
    LightMonths months{};
};

/// Ours against the reference on one slope.
struct LightAgreement {
    double energy_direct_ratio = 0.0;      ///< ours / reference
    double energy_diffuse_ratio = 0.0;     ///< ours / reference
    double ground_light = 0.0;             ///< mean over the area
    double ground_light_difference = 0.0;  ///< ours - reference
    double tree_light_correlation = 0.0;   ///< Pearson's r over the trees; NaN where one side is even
    double tree_light_bias = 0.0;          ///< mean of ours - reference
    double tree_light_rmse = 0.0;
    double sensor_correlation = 0.0;  ///< the same over the sensors
    double sensor_bias = 0.0;
    double sensor_rmse = 0.0;
    std::vector<double> tree_light;  ///< ours, of each tree [0, 1]
    std::vector<double>
        sensor_light;  ///< ours at each sensor: of the column of light that it stands in [0, 1]
};

/// Light of the stand on a slope against that of the reference, SamsaRaLight (Courbaud et al. 2003), which
/// follows 500 rays through explicit crowns, or against sensors. What is not under test follows the
/// reference: the beam of a month in all half hours of the sun in proportion to its sine, leaves in all
/// months that count, means over these months. Figures without a reference are 0.
[[nodiscard]] LightAgreement compare_light(const MappedStand& stand, const MappedSlope& slope,
                                           const MappedSettings& settings = {});

}  // namespace coupling::validation::forest_cases
