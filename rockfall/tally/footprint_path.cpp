// The drawn path of a footprint.

#include <algorithm>
#include <cmath>

#include "rockfall/tally/footprint.hpp"

namespace rockfall {

void Footprint::draw_piece(const PathPoint& from, const PathPoint& to, double duration_s, bool joins) {
    const std::size_t corners = path_.size();
    if (joins && joins_ && corners >= 2 &&
        (to.position_m - path_[corners - 2].position_m).norm() < radius_m_) {
        path_.pop_back();
    } else if (!joins || !joins_) {
        path_.push_back(from);
        wait_for_pose(0.0);
    }
    path_.push_back(to);
    wait_for_pose(duration_s);
    joins_ = joins;
}

void Footprint::draw(const Flight& flight, double until_s, std::span<const Stretch> stretches,
                     const Rock& rock, double rotation_j) {
    constexpr int most_pieces = 8;
    const double length_m = (flight.position_m(until_s) - flight.start_m).norm();
    const int pieces = is_block_
                           ? std::clamp(static_cast<int>(std::ceil(length_m / radius_m_)), 1, most_pieces)
                           : most_pieces;
    GroundBelow ground = ground_below(flight, stretches);
    const auto corner_at = [&](double time_s) {
        while (!ground.last() && ground.end_s() < time_s) {
            ground.next();
        }
        const double energy_j = 0.5 * rock.mass_kg * flight.squared_speed_at(time_s) + rotation_j;
        const double height_m = std::max(0.0, flight.height_m(time_s) - ground.at(time_s));
        return PathPoint{flight.position_m(time_s), static_cast<float>(energy_j),
                         static_cast<float>(height_m)};
    };
    if (is_block_ && length_m < 0.5 * radius_m_) {
        const PathPoint from = corner_at(0.0);
        draw_piece(from, corner_at(until_s), until_s, true);
        return;
    }
    joins_ = false;
    for (int i = 0; i <= pieces; ++i) {
        const double time_s = until_s * i / pieces;
        path_.push_back(corner_at(time_s));
        wait_for_pose(time_s);
    }
}

}  // namespace rockfall
