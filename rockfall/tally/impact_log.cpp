#include "rockfall/tally/impact_log.hpp"

namespace rockfall {

namespace {

/// A velocity against a face; `sign` is 1 for off it, -1 for into it.
Speeds speeds_of(const Eigen::Vector3d& velocity_mps, const Eigen::Vector3d& normal, double sign) {
    const double off_mps = velocity_mps.dot(normal);
    return {(velocity_mps - off_mps * normal).norm(), sign * off_mps};
}

}  // namespace

void ImpactLog::flew(const Rock& rock, const Flight& flight, double until_s,
                     std::span<const Stretch> stretches, double spin_radps) {
    go_on(GroundImpact::Onward::jumps, flight.velocity_mps);
    jumps_.flew(rock, flight, until_s, stretches, spin_radps);
    in_flight_ = !stretches.empty();
    if (in_flight_) {
        arriving_mps_ = flight.velocity_at(until_s);
        triangle_ = stretches.back().triangle;
        normal_ = slope_->terrain.plane_of(triangle_).normal();
    }
}

void ImpactLog::rolled(const Rock& rock, const RollingPiece& piece, std::uint32_t triangle) {
    go_on(GroundImpact::Onward::rolls, piece.velocity_mps);
    jumps_.rolled(rock, piece, triangle);
    in_flight_ = false;
}

void ImpactLog::impacted(const Eigen::Vector3d& place_m, int ground) {
    jumps_.impacted(place_m, ground);
    if (!in_flight_) {
        return;  // a rolling rock that runs into rising ground
    }
    in_flight_ = false;
    GroundImpact impact;
    impact.place_m = place_m;
    impact.ground = ground;
    impact.before = speeds_of(arriving_mps_, normal_, -1.0);
    impact.jump = jumps_.jumps().back();
    impacts_.push_back(impact);
    open_ = true;
}

void ImpactLog::met_stem(const Eigen::Vector3d& position_m, const StemHit& hit, const TreeImpact& impact,
                         double energy_j) {
    jumps_.met_stem(position_m, hit, impact, energy_j);
    in_flight_ = false;
}

void ImpactLog::met_log(const Eigen::Vector3d& position_m, const LogHit& hit, const LogImpact& impact,
                        double energy_j) {
    jumps_.met_log(position_m, hit, impact, energy_j);
    in_flight_ = false;
}

void ImpactLog::go_on(GroundImpact::Onward onward, const Eigen::Vector3d& velocity_mps) {
    if (!open_) {
        return;
    }
    open_ = false;
    GroundImpact& impact = impacts_.back();
    impact.onward = onward;
    impact.after = onward == GroundImpact::Onward::jumps ? speeds_of(velocity_mps, normal_, 1.0)
                                                         : Speeds{velocity_mps.norm(), 0.0};
}

}  // namespace rockfall
