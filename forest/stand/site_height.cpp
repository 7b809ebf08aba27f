#include "forest/stand/site_height.hpp"

#include <algorithm>

#include "config/math/elementary.hpp"

namespace forest {

double site_height_m(const HeightGrowth& law, double usual_degree_days) {
    constexpr double slower = 1.75;  // than the height at a given diameter, which rises with tau alone
    return law.max_height_m * (1.0 - config::exp_of(-usual_degree_days / (slower * law.degree_days_tau)));
}

double height_room(double height_m, double site_height_m) {
    if (height_m >= site_height_m) {
        return 0.0;
    }
    const double share = height_m / site_height_m;
    return 1.0 - share * share * share * share;
}

UsualWarmth after_year(UsualWarmth usual, double degree_days) {
    constexpr int remembered_years = 30;
    usual.years = std::min(usual.years + 1, remembered_years);
    usual.degree_days += (degree_days - usual.degree_days) / usual.years;
    return usual;
}

}  // namespace forest
