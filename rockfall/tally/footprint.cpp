#include "rockfall/tally/footprint.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rockfall/tally/cell_steps.hpp"
#include "rockfall/tally/jump_log.hpp"
#include "rockfall/tally/path_length.hpp"

namespace rockfall {
namespace {

/// Smallest squared speed of a flight: at its apex, else at one of its ends.
double least_squared_speed(const Flight& flight, double until_s) {
    const bool has_apex = flight.velocity_mps.z() > 0.0 && flight.velocity_at(until_s).z() < 0.0;
    return has_apex ? flight.velocity_mps.head<2>().squaredNorm()
                    : std::min(flight.squared_speed_at(0.0), flight.squared_speed_at(until_s));
}

/// Largest height of the underside above the ground on a flight.
double highest_m(double until_s, GroundBelow ground) {
    double highest = 0.0;
    for (double from_s = 0.0;; ground.next()) {
        const double to_s = ground.last() ? until_s : std::min(ground.end_s(), until_s);
        highest = std::max(highest, ground.highest_m(from_s, to_s));
        if (to_s >= until_s) {
            return highest;
        }
        from_s = to_s;
    }
}

}  // namespace

Footprint::Footprint(const Terrain& terrain, const config::GridFrame& frame, std::span<const Target> targets)
    : terrain_{terrain},
      frame_{frame},
      targets_{targets},
      target_index_{targets},
      slots_(frame.size()),
      reached_(targets.size(), not_yet),
      has_sides_{std::any_of(targets.begin(), targets.end(),
                             [](const Target& target) { return target.is_hit_by_side; })} {}

void Footprint::forget_arrivals() {
    for (const TargetArrival& last : arrivals_) {
        reached_[last.target] = not_yet;
    }
    arrivals_.clear();
}

void Footprint::begin(const RockStart& start, bool with_path) {
    begin_cells();
    tree_hits_.clear();
    log_hits_.clear();
    net_crossings_.clear();
    path_.clear();
    moments_.clear();
    radius_m_ = start.rock.radius_m;
    if (has_sides_ && radius_m_ > reach_m_) {
        // A little further, so that a slightly larger rock does not need another one. What is found is tested
        // exactly: how far the index reaches changes no result.
        constexpr double spare = 1.25;
        reach_m_ = spare * radius_m_;
        target_index_ = TargetIndex{targets_, reach_m_};
    }
    is_block_ = false;
    joins_ = false;
    with_path_ = with_path;
    deposit_cell_ = frame_.size();
    record_ = {};
    record_.rock = start.id;
    record_.source = start.source;
    record_.diameter_m = static_cast<float>(start.rock.diameter_m);
    least_squared_speed_ = start.velocity_mps.squaredNorm();
    largest_squared_speed_ = 0.0;
    record_.start_m = start.position_m;
    const double energy_j = kinetic_energy_j(start.rock, start.velocity_mps.squaredNorm(), 0.0);
    forget_arrivals();
    for (const std::uint32_t i : target_index_.areas_near(start.position_m.head<2>())) {
        if (is_inside(targets_[i], start.position_m.head<2>())) {
            arrive(i, false, start.position_m.head<2>(), energy_j, energy_j, start.velocity_mps.norm(), 0.0);
        }
    }
}

void Footprint::go_on_from(const Footprint& other) {
    begin_cells();
    for (const CellMaxima& seen : other.maxima_) {
        enter_cell(seen.cell) = seen;
    }
    record_ = other.record_;
    largest_squared_speed_ = other.largest_squared_speed_;
    least_squared_speed_ = other.least_squared_speed_;
    forget_arrivals();
    arrivals_ = other.arrivals_;
    for (const TargetArrival& seen : arrivals_) {
        reached_[seen.target] = seen.arrival.by_side ? by_side : by_centre;
    }
    tree_hits_ = other.tree_hits_;
    log_hits_ = other.log_hits_;
    net_crossings_ = other.net_crossings_;
    path_ = other.path_;
    moments_ = other.moments_;
    radius_m_ = other.radius_m_;
    if (other.reach_m_ > reach_m_) {
        reach_m_ = other.reach_m_;
        target_index_ = TargetIndex{targets_, reach_m_};
    }
    is_block_ = other.is_block_;
    joins_ = other.joins_;
    with_path_ = other.with_path_;
    deposit_cell_ = other.deposit_cell_;
}

void Footprint::finish(const FallEnd& end) {
    record_.reason = end.reason;
    record_.end_m = end.position_m;
    record_.max_speed_mps = std::sqrt(largest_squared_speed_);
    record_.min_speed_mps = std::sqrt(least_squared_speed_);
    finish_cells();
    if (end.reason == StopReason::left_terrain) {
        record_.left_over = terrain_.rim().part_at(terrain_, end.triangle, end.position_m.head<2>(),
                                                   record_.start_m.head<2>());
    }
    record_.ground_impacts = end.ground_impacts;
    record_.tree_hits = end.tree_hits;
    record_.log_hits = end.log_hits;
    record_.dissipated_j = end.dissipated_j;
    record_.residual_j = end.residual_j;
    record_.corrected_j = end.corrected_j;
    record_.unsolved = end.unsolved;
    if (end.reason == StopReason::net) {
        // The side came through the plane of the net before the centre did: the net has kept it from what it
        // touched there.
        const Eigen::Vector2d net_m = end.position_m.head<2>();
        std::erase_if(arrivals_, [&](const TargetArrival& seen) {
            const bool is_behind = seen.arrival.by_side &&
                                   first_touch(targets_[seen.target], net_m, net_m, radius_m_).has_value();
            if (is_behind) {
                reached_[seen.target] = not_yet;
            }
            return is_behind;
        });
    }
    std::sort(arrivals_.begin(), arrivals_.end(),
              [](const TargetArrival& a, const TargetArrival& b) { return a.target < b.target; });
    const config::Cell cell = frame_.cell_at(end.position_m.x(), end.position_m.y());
    if (came_to_rest(end.reason) && frame_.contains(cell)) {
        deposit_cell_ = frame_.index(cell);
    }
}

GroundBelow Footprint::ground_below(const Flight& flight, std::span<const Stretch> stretches) const {
    const Plane first = terrain_.plane_of(stretches.front().triangle);
    return {flight, stretches, first.height_m(flight.start_m.x(), flight.start_m.y())};
}

void Footprint::flew(const Rock& rock, const Flight& flight, double until_s,
                     std::span<const Stretch> stretches, double spin_radps) {
    moments_.clear();
    if (stretches.empty()) {
        return;
    }
    const double rotation_j = 0.5 * rock.inertia_kgm2 * spin_radps * spin_radps;
    GroundBelow ground = ground_below(flight, stretches);
    const double highest_m = keeps_cells() ? walk_cells(rock, flight, until_s, ground, rotation_j)
                                           : rockfall::highest_m(until_s, ground);
    const double squared_speed = std::max(flight.squared_speed_at(0.0), flight.squared_speed_at(until_s));
    largest_squared_speed_ = std::max(largest_squared_speed_, squared_speed);
    least_squared_speed_ = std::min(least_squared_speed_, least_squared_speed(flight, until_s));
    record_.max_energy_j = std::max(record_.max_energy_j, 0.5 * rock.mass_kg * squared_speed + rotation_j);
    record_.max_height_m = std::max(record_.max_height_m, highest_m);
    record_.jump_height_sum_m += highest_m;
    ++record_.jumps;
    measure_jump(flight, until_s);
    record_.path_m += path_length_m(flight, until_s);
    record_.time_s += until_s;
    if (!targets_.empty()) {
        watch_targets(rock, flight, until_s, stretches, rotation_j);
    }
    if (with_path_) {
        draw(flight, until_s, stretches, rock, rotation_j);
    }
}

void Footprint::measure_jump(const Flight& flight, double until_s) {
    const double length_m = (flight.position_m(until_s) - flight.start_m).norm();
    if (length_m < least_jump_m) {
        return;
    }
    const bool is_first = record_.long_jumps++ == 0;
    record_.jump_length_sum_m += length_m;
    record_.min_jump_length_m = is_first ? length_m : std::min(record_.min_jump_length_m, length_m);
    record_.max_jump_length_m = std::max(record_.max_jump_length_m, length_m);
}

void Footprint::impacted(const Eigen::Vector3d&, int ground) {
    for (GroundCount& known : record_.impacts_by_ground) {
        if (known.ground == ground) {
            ++known.impacts;
            return;
        }
    }
    record_.impacts_by_ground.push_back({ground, 1});
}

void Footprint::take(const PosedMoment& moment, const ShownPose& pose) {
    if (moment.is_arrival) {
        Arrival& arrival = arrivals_[moment.place].arrival;
        arrival.top_height_m = arrival.centre_height_m + static_cast<float>(pose.above_centre_m);
        return;
    }
    const Eigen::Quaterniond& q = pose.attitude;
    path_[moment.place].attitude = {static_cast<float>(q.w()), static_cast<float>(q.x()),
                                    static_cast<float>(q.y()), static_cast<float>(q.z())};
}

void Footprint::rolled(const Rock& rock, const RollingPiece& piece, std::uint32_t triangle) {
    moments_.clear();
    const Eigen::Vector3d end = piece.position_m(piece.duration_s);
    const Eigen::Vector3d move = end - piece.start_m;
    const double begin2 = piece.squared_speed_start();
    const double end2 = piece.squared_speed_end();
    const double turns_j = piece.own_start.rotation_j;
    const double gains_j = piece.own_end.rotation_j - turns_j;
    const auto energy_j = [&](double along, double squared_speed) {
        return 0.5 * rock.mass_kg * squared_speed +
               rotation_on_ground_j(rock, piece.slides, turns_j + along * gains_j, squared_speed);
    };
    const double begin_j = energy_j(0.0, begin2);
    const double end_j = energy_j(1.0, end2);

    if (keeps_cells()) {
        walk_cells(rock, piece, end, begin2, end2, begin_j, end_j);
    }
    largest_squared_speed_ = std::max(largest_squared_speed_, std::max(begin2, end2));
    least_squared_speed_ = std::min(least_squared_speed_, std::min(begin2, end2));
    record_.max_energy_j = std::max({record_.max_energy_j, begin_j, end_j});
    record_.path_m += move.norm();
    record_.time_s += piece.duration_s;
    for (const std::uint32_t i : target_index_.near_piece(piece.start_m.head<2>(), end.head<2>())) {
        const std::optional<Meeting> met =
            meeting(i, piece.start_m.head<2>(), end.head<2>(),
                    [&](double on_way) { return energy_j(on_way, begin2 + on_way * (end2 - begin2)); });
        if (!met) {
            continue;
        }
        const double squared_speed = begin2 + met->share * (end2 - begin2);
        const Eigen::Vector3d place_m = piece.start_m + met->share * move;
        // The underside of a sphere is on the ground, that of a block's sphere need not be.
        const double height_m =
            !piece.has_own() ? 0.0
                             : place_m.z() - terrain_.plane_of(triangle).height_m(place_m.x(), place_m.y());
        wait_for_pose(met->share * piece.duration_s,
                      arrive(i, met->by_side, place_m.head<2>(), energy_j(met->share, squared_speed),
                             0.5 * rock.mass_kg * squared_speed, std::sqrt(squared_speed), height_m));
    }
    if (with_path_) {
        const auto corner = [&](const Eigen::Vector3d& place_m, double energy, double squared_speed,
                                double time_s) {
            return PathPoint{place_m, static_cast<float>(energy), 0.0F, static_cast<float>(time_s),
                             static_cast<float>(std::sqrt(squared_speed))};
        };
        draw_piece(corner(piece.start_m, begin_j, begin2, record_.time_s - piece.duration_s),
                   corner(end, end_j, end2, record_.time_s), piece.duration_s, piece.has_own());
    }
}

void Footprint::met_stem(const Eigen::Vector3d& position_m, const StemHit& hit, const TreeImpact& impact,
                         double energy_j) {
    tree_hits_.push_back({hit.stem, position_m, static_cast<float>(hit.height_m),
                          static_cast<float>(energy_j), static_cast<float>(impact.loss_j), impact.type,
                          impact.broken, impact.stopped});
    record_.tree_energy_j += impact.loss_j;
    record_.trees_broken += impact.broken ? 1 : 0;
    const config::Cell cell = frame_.cell_at(position_m.x(), position_m.y());
    if (frame_.contains(cell)) {
        ++maxima_of(frame_.index(cell)).tree_impacts;
    }
}

void Footprint::met_log(const Eigen::Vector3d& position_m, const LogHit& hit, const LogImpact& impact,
                        double energy_j) {
    log_hits_.push_back({hit.log, position_m, static_cast<float>(energy_j), static_cast<float>(impact.loss_j),
                         impact.outcome});
    record_.log_energy_j += impact.loss_j;
    record_.logs_broken += impact.outcome == LogOutcome::broke ? 1 : 0;
}

void Footprint::crossed_net(const Eigen::Vector3d& position_m, const NetCrossing& crossing) {
    const bool first =
        std::none_of(net_crossings_.begin(), net_crossings_.end(),
                     [&](const NetCrossingRecord& other) { return other.net == crossing.net; });
    net_crossings_.push_back({crossing.net, static_cast<float>(position_m.x()),
                              static_cast<float>(position_m.y()), static_cast<float>(crossing.along_m),
                              static_cast<float>(crossing.height_m), static_cast<float>(crossing.radius_m),
                              static_cast<float>(crossing.energy_j),
                              static_cast<float>(crossing.translational_j),
                              static_cast<float>(crossing.speed_mps), crossing.outcome, first});
}

}  // namespace rockfall
