#include "rockfall/laws/stopping.hpp"

#include <algorithm>
#include <cassert>

#include "config/math/elementary.hpp"

namespace rockfall {

StopCurve::StopCurve(std::vector<std::pair<double, double>> knots) : knots_{std::move(knots)} {
    for (auto& [diameter_m, value] : knots_) {
        assert(diameter_m > 0.0 && value >= 0.0);
        diameter_m = config::ln_of(diameter_m);
    }
}

double StopCurve::at(double diameter_m) const {
    if (knots_.empty()) {
        return 0.0;
    }
    const double ln_diameter = config::ln_of(diameter_m);
    if (ln_diameter <= knots_.front().first) {
        return knots_.front().second;
    }
    for (std::size_t i = 1; i < knots_.size(); ++i) {
        const auto& [x0, y0] = knots_[i - 1];
        const auto& [x1, y1] = knots_[i];
        if (ln_diameter <= x1) {
            return y0 + (y1 - y0) * (ln_diameter - x0) / (x1 - x0);
        }
    }
    return knots_.back().second;
}

StopCurve StopCurve::times(double factor, double most) const {
    assert(factor >= 0.0);
    StopCurve scaled = *this;
    for (auto& [ln_diameter, value] : scaled.knots_) {
        value = std::min(most, factor * value);
    }
    return scaled;
}

}  // namespace rockfall
