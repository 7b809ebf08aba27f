#include "forest/production/snow.hpp"

#include "forest/climate/normal.hpp"

namespace forest {

namespace {

constexpr double scatter_k = 4.0;
constexpr double snow_below_degc = 0.5;
constexpr double melt_mm_per_degree_day = 0.7;

}  // namespace

double snow_share(double tave_degc) {
    return normal_probability((snow_below_degc - tave_degc) / scatter_k);
}

double melt_capacity_mm(double tave_degc, double days) {
    return melt_mm_per_degree_day * days * mean_above(tave_degc, 0.0, scatter_k);
}

}  // namespace forest
