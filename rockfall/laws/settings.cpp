#include "rockfall/laws/settings.hpp"

#include "config/math/elementary.hpp"
#include "config/units/angle.hpp"

namespace rockfall {

double tangent_of_deg(double angle_deg) {
    const config::SinCos of = config::sin_cos_of(config::Angle::from_degrees(angle_deg).in_radians());
    return of.sin / of.cos;
}

double SharedSettings::edge_angle_tangent() const {
    return tangent_of_deg(rolling_edge_deg);
}

}  // namespace rockfall
