#include "rockfall/tally/jump_log.hpp"

#include <algorithm>
#include <cmath>

#include "rockfall/tally/ground_below.hpp"

namespace rockfall {

void JumpLog::flew(const Rock&, const Flight& flight, double until_s, std::span<const Stretch> stretches,
                   double) {
    in_flight_ = false;
    if (stretches.empty()) {
        return;
    }
    GroundBelow ground{
        flight, stretches,
        terrain_->plane_of(stretches.front().triangle).height_m(flight.start_m.x(), flight.start_m.y())};
    double highest_m = 0.0;
    double time_s = 0.0;
    while (true) {
        const double end_s = ground.last() ? until_s : std::min(ground.end_s(), until_s);
        highest_m = std::max(highest_m, ground.highest_m(time_s, end_s));
        time_s = end_s;
        if (time_s >= until_s) {
            break;
        }
        ground.next();
    }
    jumps_.push_back({flight.start_m, flight.position_m(until_s), highest_m,
                      std::sqrt(flight.squared_speed_at(0.0)), std::sqrt(flight.squared_speed_at(until_s)),
                      until_s, false});
    in_flight_ = true;
}

void JumpLog::impacted(const Eigen::Vector3d&, int) {
    // A rolling rock too may run into the ground: that ends no jump.
    if (in_flight_) {
        jumps_.back().landed = true;
        in_flight_ = false;
    }
}

}  // namespace rockfall
