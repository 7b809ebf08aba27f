#include "forest/start/diameter_of_height.hpp"

#include "config/math/elementary.hpp"

namespace forest {

double DiameterOfHeight::dbh_cm(double height_m, double normal) const {
    return a_cm * config::pow_of(height_m, b) * config::exp_of(spread * normal);
}

}  // namespace forest
