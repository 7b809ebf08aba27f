#include "rockfall/laws/losses.hpp"

#include <algorithm>

#include "config/math/elementary.hpp"

namespace rockfall {

double loss_factor(const LossLaw& law, const Rock& rock) {
    return config::exp_of(law.by_elongation * config::ln_of(rock.elongation / usual_elongation) +
                          law.scatter * rock.own_losses);
}

Restitution with_losses(Restitution usual, double factor) {
    return {usual.normal, std::clamp(1.0 - factor * (1.0 - usual.tangential), 0.0, largest_restitution)};
}

}  // namespace rockfall
