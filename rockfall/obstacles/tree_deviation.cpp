#include "rockfall/obstacles/tree_deviation.hpp"

#include <algorithm>
#include <cmath>

namespace rockfall {
namespace {

/// Even a scratch turns the path a little: the limit on the angle sees at least this share of the stem's
/// energy.
constexpr double least_share_for_turning = 0.02;

}  // namespace

config::Angle drawn_deviation(HitType type, const DeviationMatrix& matrix, double class_draw,
                              double angle_draw) {
    const std::array<double, 3>& shares = matrix.shares[static_cast<std::size_t>(type)];
    std::size_t k = 0;
    while (k < 2 && class_draw >= shares[k]) {
        class_draw -= shares[k];
        ++k;
    }
    const double low_rad = matrix.limits[k].in_radians();
    const double high_rad = matrix.limits[k + 1].in_radians();
    return config::Angle::from_radians(low_rad + angle_draw * (high_rad - low_rad));
}

config::SinCos limited_turn(config::SinCos turn, double available_j, double strength_j, double energy_j) {
    const double largest_squared_sine =
        std::min(1.0, std::max(available_j, least_share_for_turning * strength_j) / energy_j);
    if (turn.sin * turn.sin > largest_squared_sine) {
        return {std::sqrt(largest_squared_sine), std::sqrt(1.0 - largest_squared_sine)};
    }
    return turn;
}

}  // namespace rockfall
