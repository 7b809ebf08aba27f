#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>

#include "rockfall/laws/rolling.hpp"

namespace rockfall {

/// Whether a rock has come to rest between faces that each alone would let it go.
///
/// Two steep faces that meet in a pit or a groove hand a rock to and fro in ever smaller steps. A rock that
/// has not left the circle of its own radius in so many impacts, or in so long a time, lies where it is.
class RestingPlace {
public:
    explicit RestingPlace(double rock_radius_m) : squared_radius_{rock_radius_m * rock_radius_m} {}

    bool holds(const Eigen::Vector3d& position_m) {
        constexpr std::uint32_t impacts_at_one_place = 16;
        constexpr double seconds_at_one_place = 10.0;
        if ((position_m - place_m_).squaredNorm() > squared_radius_) {
            place_m_ = position_m;
            impacts_ = 0;
            rolled_s_ = 0.0;
        }
        return impacts_ > impacts_at_one_place || rolled_s_ > seconds_at_one_place;
    }
    void add_impact() { ++impacts_; }
    void add_rolling(double duration_s) {
        rolled_s_ += std::max(duration_s, shortest_rolling_piece_s);  // even if it gets nowhere
    }

private:
    double squared_radius_;
    Eigen::Vector3d place_m_ = Eigen::Vector3d::Constant(1e30);
    std::uint32_t impacts_ = 0;
    double rolled_s_ = 0.0;
};

}  // namespace rockfall
