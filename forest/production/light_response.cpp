#include "forest/production/light_response.hpp"

#include <algorithm>

#include "config/math/elementary.hpp"

namespace forest {

double light_response(double response_class, double light_ratio) {
    const double tolerant = 1.0 - config::exp_of(-4.64 * (light_ratio - 0.05));
    const double intolerant = 2.24 * (1.0 - config::exp_of(-1.136 * (light_ratio - 0.08)));
    const double response = tolerant + (response_class - 1.0) / 8.0 * (intolerant - tolerant);
    return std::clamp(response, 0.0, 1.0);
}

}  // namespace forest
