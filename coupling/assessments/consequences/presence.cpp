#include "coupling/assessments/consequences/presence.hpp"

#include <cassert>

namespace coupling::consequences {

namespace {
constexpr double hours_in_a_day = 24.0;
constexpr double m_in_a_km = 1000.0;
}  // namespace

double vehicles_in_the_way(double vehicles_per_day, double vehicle_length_m, double block_diameter_m,
                           double speed_kmph) {
    assert(speed_kmph > 0.0);
    return vehicles_per_day * (vehicle_length_m + block_diameter_m) /
           (hours_in_a_day * m_in_a_km * speed_kmph);
}

double share_of_day(double hours_per_day) {
    return hours_per_day / hours_in_a_day;
}

}  // namespace coupling::consequences
