#include "forest/production/soil_potential.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>

#include "config/math/elementary.hpp"

namespace forest {

SoilPotential soil_potential_of(int soil_class) {
    constexpr std::array<double, 4> exponents{4.05, 4.9, 8.52, 11.4};
    const double exponent = exponents[static_cast<std::size_t>(std::clamp(soil_class, 1, 4) - 1)];
    return {exponent, config::pow_of(field_capacity_mpa / wilting_mpa, 1.0 / exponent)};
}

double potential_mpa(const SoilPotential& soil, double filling) {
    const double share = soil.wilting_share + std::clamp(filling, 0.0, 1.0) * (1.0 - soil.wilting_share);
    return field_capacity_mpa * config::pow_of(share, -soil.exponent);
}

double water_response(double potential_mpa, double least_mpa) {
    assert(least_mpa < field_capacity_mpa);
    return std::clamp((potential_mpa - least_mpa) / (field_capacity_mpa - least_mpa), 0.0, 1.0);
}

}  // namespace forest
