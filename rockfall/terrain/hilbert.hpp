#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace rockfall {

/// Cells along one side of the grid that the Hilbert curve runs through.
inline constexpr std::uint32_t hilbert_side = 1U << 16U;

/// Place of a cell along the Hilbert curve (Hilbert 1891) through a grid of hilbert_side x hilbert_side
/// cells. Cells that follow each other share a side. Requires column, row < hilbert_side.
[[nodiscard]] std::uint32_t hilbert_index(std::uint32_t column, std::uint32_t row);

/// The smallest rectangle in plan around points.
struct PlanExtent {
    Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Vector2d high = -low;

    void add(const Eigen::Vector2d& point) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
};

/// A place along the curve and the number of what lies there: sorted, they are in the order of the curve, and
/// those in one of its cells in the order of their numbers.
using CurveKey = std::uint64_t;

/// The curve stretched over an extent with the same scale in x and y.
class HilbertCurve {
public:
    explicit HilbertCurve(const PlanExtent& extent);
    /// Requires a point in the extent.
    [[nodiscard]] CurveKey key_of(const Eigen::Vector2d& point, std::uint32_t number) const;

private:
    Eigen::Vector2d low_;
    double scale_;
};

/// The numbers of keys in the order of the curve.
[[nodiscard]] std::vector<std::uint32_t> numbers_along(std::vector<CurveKey> keys);

/// Indices of the points in the order in which the curve over their extent meets them. Points in one cell of
/// the curve keep their order.
[[nodiscard]] std::vector<std::uint32_t> hilbert_order(std::span<const Eigen::Vector2d> points);

}  // namespace rockfall
