#pragma once

#include <array>
#include <string>
#include <vector>

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
    double direct_mjpm2 = 0.0;     ///< reference: energy of a year per area of the slope
    double diffuse_mjpm2 = 0.0;
    std::vector<double> tree_light;  ///< reference: light ratio of each tree [0, 1]
    std::vector<double>
        ground_light;  ///< reference: light on each ground cell relative to the open slope [0, 1]
};

/// A stand of one hectare with known places of its trees, whose light another program has computed on several
/// slopes.
struct MappedStand {
    config::Angle latitude;
    double side_m = 100.0;  ///< the stand repeats itself on all sides
    forest::MonthlyRadiation radiation;
    std::vector<forest::LightTree> trees;  ///< extinction not set
    std::vector<MappedSlope> slopes;
};

/// The stand of validation/forest_light from its tables. Throws config::InputError for fields that are no
/// numbers or out of range and for missing columns.
[[nodiscard]] MappedStand mapped_stand(const config::Table& trees, const config::Table& ground,
                                       const config::Table& leaves, const config::Table& radiation,
                                       const config::Table& slopes);

/// How our light is computed for the comparison.
struct MappedSettings {
    double column_m = 10.0;  ///< a divisor of the side of the stand
    double extinction = forest::effective_extinction;
    int ground_points = 1;
};

/// Ours against the reference on one slope.
struct LightAgreement {
    double energy_direct_ratio = 0.0;      ///< ours / reference
    double energy_diffuse_ratio = 0.0;     ///< ours / reference
    double ground_light = 0.0;             ///< mean over the area
    double ground_light_difference = 0.0;  ///< ours - reference
    double tree_light_correlation = 0.0;   ///< Pearson's r over the trees
    double tree_light_bias = 0.0;          ///< mean of ours - reference
    double tree_light_rmse = 0.0;
    std::vector<double> tree_light;  ///< ours, of each tree [0, 1]
};

/// Light of the stand on a slope against that of the reference, SamsaRaLight (Courbaud et al. 2003), which
/// follows 500 rays through explicit crowns. What is not under test follows the reference: no light flatter
/// than 10 degrees to the ground, the beam of a month in all half hours of the sun in proportion to its sine,
/// leaves all the year, means over the whole year.
[[nodiscard]] LightAgreement compare_light(const MappedStand& stand, const MappedSlope& slope,
                                           const MappedSettings& settings = {});

}  // namespace coupling::validation::forest_cases
