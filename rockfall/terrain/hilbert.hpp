#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

namespace rockfall {

/// Cells along one side of the grid that the Hilbert curve runs through.
inline constexpr std::uint32_t hilbert_side = 1U << 16U;

/// Place of a cell along the Hilbert curve (Hilbert 1891) through a grid of hilbert_side x hilbert_side
/// cells. Cells that follow each other share a side. Requires column, row < hilbert_side.
[[nodiscard]] std::uint32_t hilbert_index(std::uint32_t column, std::uint32_t row);

/// Indices of the points in the order in which the curve meets them, stretched over their extent with the
/// same scale in x and y. Points in one cell of the curve keep their order.
[[nodiscard]] std::vector<std::uint32_t> hilbert_order(std::span<const Eigen::Vector2d> points);

}  // namespace rockfall
