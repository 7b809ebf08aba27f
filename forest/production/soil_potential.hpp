#pragma once

namespace forest {

// How hard a soil holds its water, and how trees close their stomata then.

/// Water potential of a soil class between field capacity and wilting.
struct SoilPotential {
    double exponent = 0.0;       ///< b of psi = psi_fc (theta / theta_fc)^-b [-]
    double wilting_share = 0.0;  ///< water content at wilting / at field capacity [-]
};

/// Field capacity and wilting [MPa]: the limits of the water that plants can take [iLand].
inline constexpr double field_capacity_mpa = -0.015;
inline constexpr double wilting_mpa = -4.0;

/// The class of a soil: 1 sand, 2 sandy loam, 3 clay loam, 4 clay. Exponents of Clapp & Hornberger 1978
/// (Water Resour. Res. 14:601): 4.05, 4.9, 8.52, 11.4.
SoilPotential soil_potential_of(int soil_class);

/// Water potential [MPa] when `filling` [0, 1] of the available water is left.
double potential_mpa(const SoilPotential& soil, double filling);

/// Opening of stomata, and growth, at a water potential: (psi - least) / (field capacity - least), within 0
/// and 1 [iLand]. `least_mpa` is the species' threshold, where growth stops; requires it below field
/// capacity.
double water_response(double potential_mpa, double least_mpa);

}  // namespace forest
