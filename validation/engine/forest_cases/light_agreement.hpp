#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "validation/engine/forest_cases/mapped_stand.hpp"

namespace coupling::validation::forest_cases {

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

/// Two places always lie on a line.
inline constexpr std::size_t least_places_of_correlation = 3;

/// Why light has no correlation with a reference; "" where it has.
[[nodiscard]] std::string why_no_correlation(const std::vector<double>& reference);

/// The same of the sensors of a slope in columns of a width. Requires sensors with light on the slope.
[[nodiscard]] std::string why_no_correlation(const MappedStand& stand, const MappedSlope& slope,
                                             double column_m);

}  // namespace coupling::validation::forest_cases
