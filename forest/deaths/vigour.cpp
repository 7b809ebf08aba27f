#include "forest/deaths/vigour.hpp"

#include <algorithm>

#include "config/math/elementary.hpp"

namespace forest {

double vigour(const Vigour& law, double relative_height, double relative_age) {
    constexpr double nearly_all = 0.999;  // of height or life: nothing is left, but no division by 0
    const double height_left = 1.0 - std::clamp(relative_height, 0.0, nearly_all);
    const double life_left = 1.0 - std::clamp(relative_age, 0.0, nearly_all);
    const double spent = 1.0 - 2.0 / (1.0 / height_left + 1.0 / life_left);
    if (spent <= 0.0) {
        return 1.0;
    }
    return 1.0 / (1.0 + config::pow_of(spent / law.half, law.power));
}

}  // namespace forest
