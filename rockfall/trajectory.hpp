#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "config/random/stream.hpp"
#include "rockfall/fall.hpp"
#include "rockfall/motion/flight.hpp"
#include "rockfall/motion/groove.hpp"
#include "rockfall/motion/models.hpp"
#include "rockfall/motion/resting_place.hpp"
#include "rockfall/motion/rolling.hpp"
#include "rockfall/obstacles/log_impact.hpp"
#include "rockfall/obstacles/nets/net_watch.hpp"
#include "rockfall/obstacles/obstacles.hpp"
#include "rockfall/obstacles/tree_impact.hpp"
#include "rockfall/rock.hpp"
#include "rockfall/slope.hpp"

namespace rockfall {

/// One rock from release to rest: a loop of named events, compiled for each motion model (motion/models.hpp).
///
/// Chance comes from streams keyed by the rock and counted by its contacts, so a fall depends on nothing but
/// the key, the start, the slope and the obstacles. The observer is told of each flight, roll, impact and
/// hit; it cannot influence the fall.
template <class Motion, class Observer>
class Fall {
public:
    Fall(const Slope& slope, const Obstacles& obstacles, const FallLaw& law, Motion motion,
         const config::StreamKey& key, const RockStart& start, FallScratch& scratch, Observer& observer)
        : slope_{slope},
          obstacles_{obstacles},
          law_{law},
          motion_{std::move(motion)},
          tree_draws_{key, config::Purpose::tree_impact},
          rock_{start.rock},
          scratch_{scratch},
          observer_{observer},
          position_m_{start.position_m},
          velocity_mps_{start.velocity_mps},
          triangle_{start.triangle},
          rolling_{start.rolling},
          resting_place_{start.rock.radius_m},
          encounters_{obstacles, start.rock.radius_m},
          nets_{obstacles.nets, start.rock, scratch.nets} {
        if (rolling_) {
            begin_rolling();
        }
    }

    FallEnd run() {
        while (!stopped_) {
            rolling_ ? roll_on() : fly_on();
        }
        end_.position_m = position_m_;
        return end_;
    }

private:
    void stop(StopReason reason) {
        stopped_ = true;
        end_.reason = reason;
    }

    void fly_on() {
        const Flight flight{position_m_, velocity_mps_};
        const Landing landing = fly(slope_.terrain, flight, triangle_, scratch_.stretches);
        end_.crossings += static_cast<std::uint32_t>(scratch_.stretches.size());
        if (!obstacles_.none() && !scratch_.stretches.empty()) {
            const auto encounter = encounters_.next(flight, landing.time_s);
            const double until_s = encounter ? encounter->time_s : landing.time_s;
            if (const auto net = nets_.on_flight(flight, until_s, spin_radps_, slope_.terrain,
                                                 scratch_.stretches, observer_)) {
                end_flight_at(flight, net->time_s);
                meet(net->crossing);
                return;
            }
            if (encounter) {
                end_flight_at(flight, encounter->time_s);
                meet(*encounter);
                return;
            }
        }
        if constexpr (Motion::slides) {
            if (landing.end == FlightEnd::ground && strikes_in_turn_.once_more(landing.time_s)) {
                slide_on_along_edge(landing);
                return;
            }
        }
        observer_.flew(rock_, flight, landing.time_s, scratch_.stretches, spin_radps_);
        position_m_ = flight.position_m(landing.time_s);
        velocity_mps_ = flight.velocity_at(landing.time_s);
        triangle_ = landing.triangle;
        if (landing.end == FlightEnd::left_terrain) {
            stop(StopReason::left_terrain);
            return;
        }
        position_m_.z() = scratch_.stretches.back().ground_end_m;
        touch_ground(landing.plane);
    }

    /// Tells of a piece as far as it came, and of the nets on it.
    void tell_rolled(const RollingPiece& piece, std::uint32_t triangle) {
        nets_.tell(piece.duration_s, observer_);
        observer_.rolled(rock_, piece, triangle);
    }

    void end_flight_at(const Flight& flight, double time_s) {
        cut(scratch_.stretches, slope_.terrain, flight, time_s);
        position_m_ = flight.position_m(time_s);
        velocity_mps_ = flight.velocity_at(time_s);
        triangle_ = scratch_.stretches.back().triangle;
        observer_.flew(rock_, flight, time_s, scratch_.stretches, spin_radps_);
    }

    /// A sliding rock that strikes two faces in turn and gets nowhere goes on along their edge.
    void slide_on_along_edge(const Landing& landing) {
        velocity_mps_ =
            along_edge(velocity_mps_, slope_.terrain.plane_of(triangle_).normal(), landing.plane.normal());
        triangle_ = landing.triangle;
        position_m_.z() = scratch_.stretches.back().ground_end_m;
        resting_place_.add_impact();
        begin_rolling();
    }

    /// Between two faces the only way on is along their edge; in a pit there is none.
    void leave_groove_or_rest() {
        auto run = run_along_groove(slope_.terrain, triangle_, position_m_, rock_.radius_m,
                                    motion_.groove_law(surface_here()));
        if (!run) {
            stop(StopReason::at_rest);
            return;
        }
        velocity_mps_.setZero();
        begin_rolling();
        if (meets_obstacle_rolling(*run) || is_caught_rolling(*run)) {
            return;
        }
        tell_rolled(*run, triangle_);
        velocity_mps_ = run->velocity_at(run->duration_s);
        // A centimetre on, clear of the vertex: which triangle lies there the walk tells.
        RollingPiece step{run->position_m(run->duration_s),
                          velocity_mps_,
                          Eigen::Vector3d::Zero(),
                          0.01 / velocity_mps_.norm(),
                          RollingEnd::piece,
                          run->next_triangle,
                          false,
                          run->slides};
        const auto net = nets_.cut(step);
        tell_rolled(step, run->next_triangle);
        position_m_ = step.position_m(step.duration_s);
        if (net) {
            meet(*net);
            if (stopped_) {
                return;
            }
        }
        const auto beyond = slope_.terrain.locate(position_m_.x(), position_m_.y(), run->next_triangle);
        if (!beyond) {
            stop(StopReason::left_terrain);
            return;
        }
        triangle_ = *beyond;
        enter_face(slope_.terrain.plane_of(triangle_));
    }

    /// Puts the rock on a face and turns its motion into it, speed kept.
    void enter_face(const Plane& plane) {
        position_m_.z() = plane.height_m(position_m_.x(), position_m_.y());
        const Eigen::Vector3d normal = plane.normal();
        const Eigen::Vector3d along = velocity_mps_ - velocity_mps_.dot(normal) * normal;
        const double along_mps = along.norm();
        velocity_mps_ = along_mps > 0.0 ? Eigen::Vector3d{velocity_mps_.norm() / along_mps * along}
                                        : Eigen::Vector3d::Zero();
        spin_radps_ = motion_.rolling_spin_radps(velocity_mps_.norm());
    }

    void touch_ground(const Plane& plane) {
        const Eigen::Vector3d normal = plane.normal();
        if (resting_place_.holds(position_m_)) {
            leave_groove_or_rest();
            return;
        }
        if (end_.ground_impacts >= motion_.most_impacts()) {
            stop(StopReason::gave_up);
            return;
        }
        const SurfaceType& surface = surface_here();
        const auto draws = motion_.next_draws();
        ++end_.ground_impacts;
        resting_place_.add_impact();
        observer_.impacted(position_m_);
        if (velocity_mps_.dot(normal) >= 0.0) {
            return;  // grazes along a facet it does not press on: flies on
        }
        const Contact contact = motion_.touch(velocity_mps_, spin_radps_, normal, surface, draws);
        velocity_mps_ = contact.velocity_mps;
        spin_radps_ = contact.spin_radps;
        switch (contact.onward) {
            case Onward::flies:
                rolling_ = false;
                break;
            case Onward::rolls:
                begin_rolling();
                break;
            case Onward::rests:
                stop(StopReason::at_rest);
                break;
            case Onward::caught:
                stop(StopReason::caught);
                break;
        }
    }

    [[nodiscard]] const SurfaceType& surface_here() const {
        return slope_.type_at(triangle_, position_m_.x(), position_m_.y());
    }

    void begin_rolling() {
        rolling_ = true;
        spin_radps_ = motion_.rolling_spin_radps(velocity_mps_.norm());
        motion_.begin_rolling();
    }

    void roll_on() {
        if (resting_place_.holds(position_m_)) {
            leave_groove_or_rest();
            return;
        }
        if (++rolling_pieces_ > most_rolling_pieces) {
            stop(StopReason::gave_up);
            return;
        }
        const Plane plane = slope_.terrain.plane_of(triangle_);
        if (const auto leaving_mps = motion_.lift_off(velocity_mps_, plane.normal())) {
            velocity_mps_ = *leaving_mps;
            rolling_ = false;
            return;
        }
        auto piece =
            motion_.next_piece(slope_.terrain, triangle_, plane, position_m_, velocity_mps_, surface_here());
        if (meets_obstacle_rolling(piece) || is_caught_rolling(piece)) {
            return;
        }
        tell_rolled(piece, triangle_);
        resting_place_.add_rolling(piece.duration_s);
        position_m_ = piece.position_m(piece.duration_s);
        velocity_mps_ = piece.velocity_at(piece.duration_s);
        position_m_.z() = plane.height_m(position_m_.x(), position_m_.y());
        spin_radps_ = motion_.rolling_spin_radps(velocity_mps_.norm());
        if (piece.end == RollingEnd::standstill) {
            stop(StopReason::at_rest);
        } else if (piece.end == RollingEnd::edge) {
            roll_over_edge(piece);
        }
    }

    /// The triangle in which a piece ends that ran over an edge; a short piece may have run on a little.
    std::uint32_t triangle_beyond(const RollingPiece& piece) const {
        if (piece.next_triangle == no_triangle || !piece.ran_over) {
            return piece.next_triangle;
        }
        return slope_.terrain.locate(position_m_.x(), position_m_.y(), piece.next_triangle)
            .value_or(no_triangle);
    }

    void roll_over_edge(const RollingPiece& piece) {
        const std::uint32_t beyond = triangle_beyond(piece);
        if (beyond == no_triangle) {
            stop(StopReason::left_terrain);
            return;
        }
        triangle_ = beyond;
        const Plane next = slope_.terrain.plane_of(triangle_);
        position_m_.z() = next.height_m(position_m_.x(), position_m_.y());
        switch (motion_.way_over_edge(velocity_mps_, next.normal(), surface_here())) {
            case EdgeWay::goes_on:
                enter_face(next);
                break;
            case EdgeWay::takes_off:
                rolling_ = false;
                break;
            case EdgeWay::runs_into:
                touch_ground(next);
                break;
        }
    }

    bool is_caught_rolling(RollingPiece& piece) {
        const auto share = motion_.caught_on_the_way(surface_here(), piece);
        if (!share) {
            return false;
        }
        piece.duration_s = piece.time_along_s(*share);
        tell_rolled(piece, triangle_);
        position_m_ = piece.position_m(piece.duration_s);
        stop(StopReason::caught);
        return true;
    }

    template <class Piece>
    bool meets_obstacle_rolling(Piece& piece) {
        if (obstacles_.none() || piece.duration_s <= 0.0) {
            return false;
        }
        const auto encounter = encounters_.next(piece);
        if (encounter) {
            piece.duration_s = piece.time_along_s(encounter->time_s / piece.duration_s);
        }
        const auto net = nets_.cut(piece);
        if (!encounter && !net) {
            return false;
        }
        if (is_caught_rolling(piece)) {
            return true;  // caught on the way to the obstacle
        }
        nets_.tell(piece.duration_s, observer_);
        piece.duration_s = NetWatch::end_s(net, piece.duration_s, piece.velocity_at(piece.duration_s));
        observer_.rolled(rock_, piece, triangle_);
        position_m_ = piece.position_m(piece.duration_s);
        velocity_mps_ = piece.velocity_at(piece.duration_s);
        spin_radps_ = motion_.rolling_spin_radps(velocity_mps_.norm());
        net ? meet(*net) : meet(*encounter);
        return true;
    }

    void meet(const NetCrossing& crossing) {
        if (crossing.outcome == NetOutcome::held) {
            rest_at_foot(StopReason::net);
            return;
        }
        const double factor = nets_.break_through(crossing, position_m_);
        velocity_mps_ *= factor;
        spin_radps_ *= factor;
    }

    void meet(const Encounter& encounter) {
        const double energy_j = kinetic_energy_j(rock_, velocity_mps_.squaredNorm(), spin_radps_);
        if (energy_j <= 0.0) {
            stop(encounter.stem ? StopReason::tree : StopReason::log);  // leans on it
        } else if (encounter.stem) {
            meet(*encounter.stem, energy_j);
        } else {
            meet(*encounter.log, energy_j);
        }
    }

    void meet(const StemHit& hit, double energy_j) {
        const PlacedStem& stem = obstacles_.stems->placed()[hit.stem];
        const TreeImpact impact =
            meet_stem(energy_j, hit, stem, law_.tree, tree_draws_.uniforms_of(end_.tree_hits));
        ++end_.tree_hits;
        encounters_.remember(hit);
        observer_.met_stem(position_m_, hit, impact, energy_j);
        if (impact.broken && law_.tree.remove_broken && !obstacles_.gone.empty()) {
            obstacles_.gone[hit.stem] = 1;
        }
        if (impact.stopped) {
            rest_at_foot(StopReason::tree);
            return;
        }
        turn_and_slow(impact);
    }

    void meet(const LogHit& hit, double energy_j) {
        const LogPiece& piece = obstacles_.logs->pieces()[hit.piece];
        LogImpact impact = meet_log(energy_j, velocity_mps_, rock_, hit, piece, law_.log);
        if (impact.outcome == LogOutcome::turned && turned_at_log_ == hit.log &&
            (position_m_ - turned_at_m_).squaredNorm() < rock_.radius_m * rock_.radius_m) {
            impact = rest_at(energy_j);  // pressed against it once more on the same spot
        }
        ++end_.log_hits;
        observer_.met_log(position_m_, hit, impact, energy_j);
        if (impact.outcome == LogOutcome::stopped) {
            rest_at_foot(StopReason::log);
            return;
        }
        if (impact.outcome == LogOutcome::turned) {
            turned_at_log_ = hit.log;
            turned_at_m_ = position_m_;
        } else {
            encounters_.remember(hit);
        }
        if (impact.outcome == LogOutcome::broke && law_.tree.remove_broken && !obstacles_.logs_gone.empty()) {
            obstacles_.logs_gone[hit.log] = 1;
        }
        velocity_mps_ = impact.velocity_mps;
        spin_radps_ *= impact.spin_factor;
        if (rolling_) {
            stay_in_face();
        }
    }

    /// Drops to the ground at the uphill foot of an obstacle.
    void rest_at_foot(StopReason reason) {
        position_m_.z() = slope_.terrain.plane_of(triangle_).height_m(position_m_.x(), position_m_.y());
        velocity_mps_.setZero();
        stop(reason);
    }

    void turn_and_slow(const TreeImpact& impact) {
        const double vx = velocity_mps_.x();
        const double vy = velocity_mps_.y();
        velocity_mps_.x() = impact.turn.cos * vx - impact.turn.sin * vy;
        velocity_mps_.y() = impact.turn.sin * vx + impact.turn.cos * vy;
        velocity_mps_ *= impact.speed_factor;
        spin_radps_ *= impact.speed_factor;
        if (rolling_) {
            stay_in_face();
        }
    }

    /// After a turn: the speed is kept, the rise follows the plane.
    void stay_in_face() {
        const Plane plane = slope_.terrain.plane_of(triangle_);
        const double speed_mps = velocity_mps_.norm();
        velocity_mps_.z() = plane.gradient.x() * velocity_mps_.x() + plane.gradient.y() * velocity_mps_.y();
        const double tilted_mps = velocity_mps_.norm();
        velocity_mps_ *= tilted_mps > 0.0 ? speed_mps / tilted_mps : 0.0;
    }

    static constexpr std::uint32_t most_rolling_pieces = 200'000;

    const Slope& slope_;
    const Obstacles& obstacles_;
    const FallLaw& law_;
    Motion motion_;
    config::RandomStream tree_draws_;
    Rock rock_;
    FallScratch& scratch_;
    Observer& observer_;

    Eigen::Vector3d position_m_;
    Eigen::Vector3d velocity_mps_;
    double spin_radps_ = 0.0;
    std::uint32_t triangle_;
    bool rolling_;
    bool stopped_ = false;
    FallEnd end_;

    RestingPlace resting_place_;
    StrikesInTurn strikes_in_turn_;
    std::uint32_t rolling_pieces_ = 0;
    Encounters encounters_;
    std::uint32_t turned_at_log_ = no_log;
    Eigen::Vector3d turned_at_m_ = Eigen::Vector3d::Zero();
    NetWatch nets_;
};

/// Lets a rock fall under the motion model of the law, which is chosen here, once for the rock.
template <class Observer>
FallEnd fall(const Slope& slope, const Obstacles& obstacles, const FallLaw& law, const config::StreamKey& key,
             const RockStart& start, FallScratch& scratch, Observer& observer) {
    return with_model(law.motion, [&]<class Motion>(std::type_identity<Motion>, const auto& settings) {
        return Fall<Motion, Observer>{slope, obstacles, law,     Motion{settings, key, start.rock},
                                      key,   start,     scratch, observer}
            .run();
    });
}

}  // namespace rockfall
