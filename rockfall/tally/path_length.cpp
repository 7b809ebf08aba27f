#include "rockfall/tally/path_length.hpp"

#include <cmath>

#include "config/math/elementary.hpp"
#include "config/units/constants.hpp"

namespace rockfall {
namespace {

/// atanh(u) / u for 0 <= u < 1, given `gap` = 1 - u^2, which u close to 1 has lost.
double atanh_share(double u, double gap) {
    constexpr double few_terms_below = 0.1;
    if (u < few_terms_below) {
        const double q = u * u;
        return 1.0 + q * (1.0 / 3 + q * (1.0 / 5 + q * (1.0 / 7 + q * (1.0 / 9 + q * (1.0 / 11)))));
    }
    // atanh(u) = ln((1 + u) / (1 - u)) / 2 = ln(1 + u) - ln(1 - u^2) / 2
    return (config::ln_of(1.0 + u) - 0.5 * config::ln_of(gap)) / u;
}

}  // namespace

double path_length_m(const Flight& flight, double until_s) {
    const double plan2 =
        flight.velocity_mps.x() * flight.velocity_mps.x() + flight.velocity_mps.y() * flight.velocity_mps.y();
    const double change_mps = config::gravity_mps2 * until_s;
    const double rising0_mps = flight.velocity_mps.z();
    const double rising1_mps = rising0_mps - change_mps;
    const double speed0_mps = std::sqrt(plan2 + rising0_mps * rising0_mps);
    const double speed1_mps = std::sqrt(plan2 + rising1_mps * rising1_mps);
    const double speeds_mps = speed0_mps + speed1_mps;
    if (speeds_mps == 0.0) {
        return 0.0;
    }
    const double rises_mps = rising0_mps + rising1_mps;
    const double straight = 0.5 * (speeds_mps + rises_mps * rises_mps / speeds_mps);
    if (plan2 == 0.0) {
        return 0.5 * until_s * straight;
    }
    // (s0 + s1)^2 - (g t)^2 = 2 h^2 + 2 (s0 s1 + w0 w1), whose last sum cancels where the rock turns down.
    const double speed_product = speed0_mps * speed1_mps;
    const double rise_product = rising0_mps * rising1_mps;
    const double last_sum = rise_product >= 0.0
                                ? speed_product + rise_product
                                : plan2 * (plan2 + rising0_mps * rising0_mps + rising1_mps * rising1_mps) /
                                      (speed_product - rise_product);
    const double gap = 2.0 * (plan2 + last_sum) / (speeds_mps * speeds_mps);
    const double curved = 2.0 * plan2 / speeds_mps * atanh_share(change_mps / speeds_mps, gap);
    return 0.5 * until_s * (straight + curved);
}

}  // namespace rockfall
