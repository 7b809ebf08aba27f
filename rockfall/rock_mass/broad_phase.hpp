#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace rockfall::rock_mass {

/// A box along the axes. Low above high: nowhere.
struct Box3 {
    Eigen::Vector3d low_m;
    Eigen::Vector3d high_m;

    [[nodiscard]] bool is_nowhere() const { return low_m.x() > high_m.x(); }
    [[nodiscard]] bool meets(const Box3& other) const {
        return (low_m.array() <= other.high_m.array()).all() && (other.low_m.array() <= high_m.array()).all();
    }
};

/// Pairs of boxes that meet, the lower number first, ascending; at least one of a pair `moves`.
///
/// Sizes differ up to twentyfold, so boxes lie on levels of cells, each twice as wide as the last; a box
/// looks into its own level and those of larger cells.
std::vector<std::pair<std::uint32_t, std::uint32_t>> meeting_pairs(std::span<const Box3> boxes,
                                                                   std::span<const std::uint8_t> moves);

}  // namespace rockfall::rock_mass
