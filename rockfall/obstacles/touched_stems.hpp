#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "rockfall/obstacles/stem.hpp"
#include "rockfall/obstacles/stem_index.hpp"

namespace rockfall {

/// The stems that a rock has hit and not yet left: it slides along them and cannot hit them anew.
///
/// Without this memory a rock within reach of two stems would hit one and the other in turn without moving.
class TouchedStems {
public:
    [[nodiscard]] std::span<const std::uint32_t> stems() const { return {stems_.data(), count_}; }

    void remember(std::uint32_t stem) {
        if (count_ == stems_.size()) {  // wedged among many: the first one makes room
            std::move(stems_.begin() + 1, stems_.end(), stems_.begin());
            --count_;
        }
        stems_[count_++] = stem;
    }

    /// A stem counts again once the rock has left it by a centimetre.
    void forget_left_behind(const StemIndex& index, const Eigen::Vector3d& position_m, double rock_radius_m) {
        const auto is_left = [&](std::uint32_t touched) {
            const PlacedStem& stem = index.placed()[touched];
            const double dx = position_m.x() - stem.x_m;
            const double dy = position_m.y() - stem.y_m;
            const double clear_m = rock_radius_m + taper_at_ground * stem.breast_radius_m + 0.01;
            return dx * dx + dy * dy > clear_m * clear_m;
        };
        const auto end = stems_.begin() + static_cast<std::ptrdiff_t>(count_);
        count_ = static_cast<std::size_t>(std::remove_if(stems_.begin(), end, is_left) - stems_.begin());
    }

private:
    std::array<std::uint32_t, 4> stems_{};
    std::size_t count_ = 0;
};

}  // namespace rockfall
