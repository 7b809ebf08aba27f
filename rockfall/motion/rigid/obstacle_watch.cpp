#include "rockfall/motion/rigid/obstacle_watch.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "rockfall/motion/rigid/extent.hpp"

namespace rockfall::rigid {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// So near a block touches an obstacle.
constexpr double touching_m = 1e-3;

/// Step of time while a block is within its ball's reach of an obstacle: so much of the radius.
constexpr double look_again = 0.05;

}  // namespace

ObstacleWatch::ObstacleWatch(const Obstacles& obstacles, const TreeImpactLaw& tree_law,
                             const LogImpactLaw& log_law, const config::StreamKey& key, const Rock& rock,
                             const solids::Solid& solid)
    : obstacles_{obstacles},
      tree_law_{tree_law},
      log_law_{log_law},
      tree_draws_{key, config::Purpose::tree_impact},
      rock_{rock},
      solid_{solid} {}

void ObstacleWatch::forget_left(const Body& body, const Vector3d& normal) {
    const double radius_m = solid_.bounding_radius_m;
    if (obstacles_.stems != nullptr) {
        stems_.forget_if(
            [&](std::uint32_t stem) { return obstacles_.stems->is_left(stem, body.centre_m, radius_m); });
    }
    if (obstacles_.logs != nullptr) {
        const Vector3d under_m = body.centre_m - radius_m * normal;
        logs_.forget_if([&](std::uint32_t log) { return obstacles_.logs->is_left(log, under_m, radius_m); });
    }
}

/// The stem as the block touches it where it is; none if it does not, or moves away.
std::optional<StemHit> ObstacleWatch::touches(const Body& body, std::uint32_t number) const {
    const PlacedStem& stem = obstacles_.stems->placed()[number];
    const Vector2d plan_mps = body.velocity_mps.head<2>();
    const double plan_speed_mps = plan_mps.norm();
    const Vector2d to_axis_m = Vector2d{stem.x_m, stem.y_m} - body.centre_m.head<2>();
    if (plan_speed_mps < 1e-9 || plan_mps.dot(to_axis_m) <= 0.0) {
        return std::nullopt;
    }
    const double height_m = body.centre_m.z() - stem.ground_m;
    const double underside_m = height_m - reach_m(solid_, body, -Vector3d::UnitZ());
    if (underside_m >= stem.top_m) {
        return std::nullopt;
    }
    const double radius_m = tree_law_.taper
                                ? stem.breast_radius_m * taper(std::min(height_m, stem.top_m), stem.height_m)
                                : stem.breast_radius_m;
    if (plan_distance_m(solid_, body, {stem.x_m, stem.y_m}) > radius_m + touching_m) {
        return std::nullopt;
    }
    const Vector2d along = plan_mps / plan_speed_mps;
    const double offset_m = along.x() * to_axis_m.y() - along.y() * to_axis_m.x();
    const double side = offset_m >= 0.0 ? 1.0 : -1.0;
    const double beside_m = reach_m(solid_, body, side * Vector3d{-along.y(), along.x(), 0.0});
    return StemHit{number, 0.0, offset_m, beside_m + radius_m, std::max(0.0, height_m)};
}

std::optional<LogHit> ObstacleWatch::touches_log(const Body& body, std::uint32_t number) const {
    const LogPiece& piece = obstacles_.logs->pieces()[number];
    const Vector3d off_m = body.centre_m - piece.nearest_to(body.centre_m);
    const double distance_m = off_m.norm();
    if (distance_m <= 0.0 || body.velocity_mps.dot(off_m) >= 0.0 ||
        distance_m > solid_.bounding_radius_m + piece.radius_m + touching_m ||
        distance_from_piece_m(solid_, body, piece.first_m, piece.first_m + piece.along) >
            piece.radius_m + touching_m) {
        return std::nullopt;
    }
    return LogHit{piece.log, number, 0.0, off_m / distance_m};
}

/// From where the ball around the block comes near each stem the block itself is watched until it has passed.
template <class BodyAt>
void ObstacleWatch::first_stem(const BodyAt& body_at, const Flight& flight, double until_s,
                               std::optional<Encounter>& found) const {
    const double radius_m = solid_.bounding_radius_m;
    std::vector<std::uint32_t> passed{stems_.numbers().begin(), stems_.numbers().end()};
    const Flight under{flight.start_m - Vector3d{0.0, 0.0, radius_m}, flight.velocity_mps};
    while (const auto near = obstacles_.stems->first_hit(under, until_s, radius_m, passed, obstacles_.gone)) {
        const PlacedStem& stem = obstacles_.stems->placed()[near->stem];
        const double widest_m = radius_m + taper_at_ground * stem.breast_radius_m;
        for (double time_s = near->time_s; time_s <= until_s;) {
            const Body body = body_at(time_s);
            if (auto hit = touches(body, near->stem)) {
                hit->time_s = time_s;
                found = {time_s, *hit, std::nullopt};
                until_s = time_s;
                break;
            }
            const Vector2d to_m = Vector2d{stem.x_m, stem.y_m} - body.centre_m.head<2>();
            if (to_m.norm() > widest_m + touching_m && body.velocity_mps.head<2>().dot(to_m) <= 0.0) {
                break;
            }
            const double fastest_mps =
                body.velocity_mps.norm() + body.spin_radps(solid_).norm() * radius_m + 1e-6;
            const double gap_m =
                plan_distance_m(solid_, body, {stem.x_m, stem.y_m}) - taper_at_ground * stem.breast_radius_m;
            time_s += std::max(gap_m, look_again * radius_m) / fastest_mps;
        }
        passed.push_back(near->stem);
    }
}

template <class BodyAt>
void ObstacleWatch::first_log(const BodyAt& body_at, const Flight& flight, double until_s,
                              const Vector3d& normal, std::optional<Encounter>& found) const {
    // The ground below a log may be tilted otherwise than that below the block: the ball is made wider.
    const double radius_m = 1.2 * solid_.bounding_radius_m;
    std::vector<std::uint32_t> passed{logs_.numbers().begin(), logs_.numbers().end()};
    const Flight under{flight.start_m - radius_m * normal, flight.velocity_mps};
    const auto pieces = obstacles_.logs->pieces();
    while (const auto near =
               obstacles_.logs->first_hit(under, until_s, radius_m, passed, obstacles_.logs_gone)) {
        const std::uint32_t first = near->piece >= 2 ? near->piece - 2 : 0;
        const std::uint32_t last = std::min(near->piece + 2, static_cast<std::uint32_t>(pieces.size()) - 1);
        for (double time_s = near->time_s; time_s <= until_s;) {
            const Body body = body_at(time_s);
            bool is_near = false;
            for (std::uint32_t number = first; number <= last; ++number) {
                if (pieces[number].log != near->log) {
                    continue;
                }
                if (auto hit = touches_log(body, number)) {
                    hit->time_s = time_s;
                    found = {time_s, std::nullopt, *hit};
                    until_s = time_s;
                    break;
                }
                const Vector3d off_m = body.centre_m - pieces[number].nearest_to(body.centre_m);
                is_near = is_near || off_m.norm() < 2.0 * radius_m + pieces[number].radius_m;
            }
            if (!is_near || (found && found->log && found->time_s == time_s)) {
                break;
            }
            const double fastest_mps =
                body.velocity_mps.norm() + body.spin_radps(solid_).norm() * solid_.bounding_radius_m + 1e-6;
            time_s += look_again * solid_.bounding_radius_m / fastest_mps;
        }
        passed.push_back(near->log);
    }
}

template <class BodyAt>
std::optional<Encounter> ObstacleWatch::first(const BodyAt& body_at, const Flight& flight, double until_s,
                                              const Vector3d& normal) {
    std::optional<Encounter> found;
    forget_left(body_at(0.0), normal);
    if (obstacles_.stems != nullptr) {
        first_stem(body_at, flight, until_s, found);
    }
    if (obstacles_.logs != nullptr) {
        first_log(body_at, flight, found ? found->time_s : until_s, normal, found);
    }
    return found;
}

std::optional<Encounter> ObstacleWatch::next(Block& block, const Flight& flight, double until_s,
                                             const Vector3d& normal) {
    return first([&](double time_s) { return block.flown(time_s); }, flight, until_s, normal);
}

std::optional<Encounter> ObstacleWatch::touched(const Body& body, const Vector3d& normal) {
    return first([&](double) { return body; }, Flight{body.centre_m, body.velocity_mps}, 0.0, normal);
}

TreeImpact ObstacleWatch::meet(const StemHit& hit, double energy_j) {
    const TreeImpact impact = meet_stem(energy_j, hit, obstacles_.stems->placed()[hit.stem], tree_law_,
                                        tree_draws_.uniforms_of(tree_hits_++));
    stems_.remember(hit.stem);
    if (impact.broken && tree_law_.remove_broken && !obstacles_.gone.empty()) {
        obstacles_.gone[hit.stem] = 1;
    }
    return impact;
}

LogImpact ObstacleWatch::meet(const LogHit& hit, double energy_j, const Body& body) {
    const LogPiece& piece = obstacles_.logs->pieces()[hit.piece];
    // A sphere that touches where the block does: its radius is what the block reaches towards the axis.
    Rock rock = rock_;
    rock.radius_m = std::max(1e-3, (body.centre_m - piece.nearest_to(body.centre_m)).norm() - piece.radius_m);
    const LogImpact impact = meet_log(energy_j, body.velocity_mps, rock, hit, piece, log_law_);
    if (impact.outcome == LogOutcome::turned) {
        if (turned_at_log_ == hit.log &&
            (body.centre_m - turned_at_m_).squaredNorm() < rock_.radius_m * rock_.radius_m) {
            return rest_at(energy_j);
        }
        turned_at_log_ = hit.log;
        turned_at_m_ = body.centre_m;
        return impact;
    }
    logs_.remember(hit.log);
    if (impact.outcome == LogOutcome::broke && tree_law_.remove_broken && !obstacles_.logs_gone.empty()) {
        obstacles_.logs_gone[hit.log] = 1;
    }
    return impact;
}

}  // namespace rockfall::rigid
