#include "rockfall/terrain/hilbert.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace rockfall {

std::uint32_t hilbert_index(std::uint32_t column, std::uint32_t row) {
    assert(column < hilbert_side && row < hilbert_side);
    std::uint32_t index = 0;
    for (std::uint32_t half = hilbert_side / 2; half > 0; half /= 2) {
        const std::uint32_t right = (column & half) != 0 ? 1 : 0;
        const std::uint32_t upper = (row & half) != 0 ? 1 : 0;
        index += half * half * ((3 * right) ^ upper);
        // Turn the quadrant so that the curve through it starts at its own lower left corner.
        if (upper == 0) {
            if (right == 1) {
                column = hilbert_side - 1 - column;
                row = hilbert_side - 1 - row;
            }
            std::swap(column, row);
        }
    }
    return index;
}

HilbertCurve::HilbertCurve(const PlanExtent& extent) : low_{extent.low} {
    const double side = (extent.high - extent.low).maxCoeff();
    scale_ = side > 0.0 ? (hilbert_side - 1) / side : 0.0;
}

CurveKey HilbertCurve::key_of(const Eigen::Vector2d& point, std::uint32_t number) const {
    const Eigen::Vector2d place = scale_ * (point - low_);
    const CurveKey index =
        hilbert_index(static_cast<std::uint32_t>(place.x()), static_cast<std::uint32_t>(place.y()));
    return (index << 32U) | number;
}

std::vector<std::uint32_t> numbers_along(std::vector<CurveKey> keys) {
    std::sort(keys.begin(), keys.end());
    std::vector<std::uint32_t> numbers(keys.size());
    std::transform(keys.begin(), keys.end(), numbers.begin(),
                   [](CurveKey key) { return static_cast<std::uint32_t>(key); });
    return numbers;
}

std::vector<std::uint32_t> hilbert_order(std::span<const Eigen::Vector2d> points) {
    PlanExtent extent;
    for (const Eigen::Vector2d& point : points) {
        extent.add(point);
    }
    const HilbertCurve curve{extent};
    std::vector<CurveKey> keys(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        keys[i] = curve.key_of(points[i], static_cast<std::uint32_t>(i));
    }
    return numbers_along(std::move(keys));
}

}  // namespace rockfall
