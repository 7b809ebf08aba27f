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

std::vector<std::uint32_t> hilbert_order(std::span<const Eigen::Vector2d> points) {
    if (points.empty()) {
        return {};
    }
    Eigen::Vector2d low = points.front();
    Eigen::Vector2d high = points.front();
    for (const Eigen::Vector2d& point : points) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    const double extent = (high - low).maxCoeff();
    const double scale = extent > 0.0 ? (hilbert_side - 1) / extent : 0.0;

    // Key and index in one number: one plain sort, and equal keys stay in their order.
    std::vector<std::uint64_t> keys(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Eigen::Vector2d place = scale * (points[i] - low);
        const std::uint64_t key =
            hilbert_index(static_cast<std::uint32_t>(place.x()), static_cast<std::uint32_t>(place.y()));
        keys[i] = (key << 32U) | i;
    }
    std::sort(keys.begin(), keys.end());

    std::vector<std::uint32_t> order(points.size());
    std::transform(keys.begin(), keys.end(), order.begin(),
                   [](std::uint64_t key) { return static_cast<std::uint32_t>(key); });
    return order;
}

}  // namespace rockfall
