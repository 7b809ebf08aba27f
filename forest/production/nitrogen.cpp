#include "forest/production/nitrogen.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include "config/math/elementary.hpp"

namespace forest {

double nitrogen_response(double nitrogen_class, double nitrogen_kg_per_ha_year) {
    struct Demand {
        double steepness;
        double least_kg;
    };
    constexpr std::array<Demand, 3> demands{{{0.045, 10.0}, {0.055, 25.0}, {0.065, 40.0}}};
    const double place = std::clamp(nitrogen_class, 1.0, 3.0) - 1.0;
    const std::size_t low = place < 1.0 ? 0 : 1;
    const double part = place - static_cast<double>(low);
    const double steepness =
        demands[low].steepness + part * (demands[low + 1].steepness - demands[low].steepness);
    const double least_kg =
        demands[low].least_kg + part * (demands[low + 1].least_kg - demands[low].least_kg);
    return std::max(0.0, 1.0 - config::exp_of(-steepness * (nitrogen_kg_per_ha_year - least_kg)));
}

double nitrogen_advantage(double nitrogen_class, double nitrogen_kg_per_ha_year) {
    constexpr double usual_class = 2.0;
    constexpr double least_kg = 30.0;
    const double nitrogen_kg = std::max(nitrogen_kg_per_ha_year, least_kg);
    return nitrogen_response(nitrogen_class, nitrogen_kg) / nitrogen_response(usual_class, nitrogen_kg);
}

}  // namespace forest
