#include "rockfall/obstacles/nets/net_impact.hpp"

#include <cassert>
#include <cmath>

namespace rockfall {

NetOutcome meet_net(const Net& net, const Rock& rock, double underside_m, double energy_j) {
    if (underside_m + rock.radius_m > net.height_m) {
        return NetOutcome::over;
    }
    if (underside_m + rock.diameter_m <= net.gap_m) {
        return NetOutcome::below;
    }
    return energy_j > net.capacity_j ? NetOutcome::broke : NetOutcome::held;
}

double speed_factor_behind(const Net& net, double energy_j) {
    assert(energy_j > net.capacity_j);
    return std::sqrt((energy_j - net.capacity_j) / energy_j);
}

}  // namespace rockfall
