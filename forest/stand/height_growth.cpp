#include "forest/stand/height_growth.hpp"

#include <algorithm>

#include "config/math/elementary.hpp"

namespace forest {

namespace {

constexpr double tallest_site_factor = 1.37;
/// Thinner trees count as this one: the laws of iLand begin at trees of 4 m.
constexpr double thinnest_cm = 4.0;

}  // namespace

double site_height_factor(const HeightGrowth& law, double degree_days) {
    return tallest_site_factor * (1.0 - config::exp_of(-degree_days / law.degree_days_tau));
}

double height_diameter_ratio(const HeightGrowth& law, double dbh_cm, double light_ratio, double site_factor) {
    const double log2_dbh = config::log2_of(std::max(dbh_cm, thinnest_cm));
    const double low = law.ratio_low.factor * config::exp2_of(law.ratio_low.exponent * log2_dbh);
    const double high = law.ratio_high.factor * config::exp2_of(law.ratio_high.exponent * log2_dbh);
    return std::max(0.0, site_factor * (high - (high - low) * light_ratio));
}

}  // namespace forest
