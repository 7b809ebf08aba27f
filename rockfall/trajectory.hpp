#pragma once

#include <cstdint>
#include <utility>

#include "config/random/stream.hpp"
#include "rockfall/laws/flight.hpp"
#include "rockfall/laws/groove.hpp"
#include "rockfall/laws/leaving.hpp"
#include "rockfall/laws/moving_rock.hpp"
#include "rockfall/laws/on_face.hpp"
#include "rockfall/laws/resting_place.hpp"
#include "rockfall/laws/rock.hpp"
#include "rockfall/laws/rolling.hpp"
#include "rockfall/motion/bare_twin.hpp"
#include "rockfall/motion/fall.hpp"
#include "rockfall/motion/models.hpp"
#include "rockfall/motion/own_loops.hpp"
#include "rockfall/obstacles/meetings.hpp"
#include "rockfall/obstacles/nets/net_watch.hpp"
#include "rockfall/slope/slope.hpp"

namespace rockfall {

/// One rock from release to rest: a loop of named events, compiled for each motion model (motion/models.hpp)
/// that has no loop of its own (motion/own_loops.hpp).
///
/// Chance comes from streams keyed by the rock and counted by its contacts, so a fall depends on nothing but
/// the key, the start, the slope and the obstacles. Each flight, roll, impact (with the code of its ground)
/// and hit is reported to the observer; it cannot influence the fall.
///
/// A fall through the forest may have a twin over the bare slope, from the first stem or log on.
template <class Motion, class Observer>
class Fall {
public:
    Fall(const SlopeView& slope, const Obstacles& obstacles, const FallLaw& law, Motion motion,
         const config::StreamKey& key, const RockStart& start, FallScratch& scratch, Observer& observer,
         BareTwin<Observer>* twin = nullptr)
        : slope_{slope},
          rock_{start.rock},
          meetings_{obstacles, law.tree, law.log, key, start.rock},
          nets_{obstacles.nets, start.rock, scratch.nets},
          resting_place_{start.rock.radius_m},
          scratch_{scratch},
          observer_{&observer},
          twin_{twin},
          now_{std::move(motion), start.position_m, start.velocity_mps, start.triangle, start.rolling} {
        if (now_.rolling) {
            now_.begin_rolling();
        }
    }

    FallEnd run() {
        while (!stopped_) {
            now_.rolling ? roll_on() : fly_on();
        }
        end_.position_m = now_.position_m;
        end_.triangle = now_.triangle;
        return end_;
    }

private:
    void stop(StopReason reason) {
        stopped_ = true;
        end_.reason = reason;
    }

    /// The twin takes over all that was common to both and falls on to its end; `go_on` has it follow the
    /// flight or piece on which they part. Not inlined, as it happens once for a rock.
    template <class GoOn>
    [[gnu::noinline]] void part(const GoOn& go_on) {
        if constexpr (FollowsTwin<Observer>) {
            BareTwin<Observer>& twin = *std::exchange(twin_, nullptr);
            twin.kept = scratch_;
            twin.observer.go_on_from(*observer_);
            Fall bare{*this};
            bare.observer_ = &twin.observer;
            bare.meetings_.leave_forest();
            go_on(bare);
            twin.end = bare.run();
            std::swap(scratch_, twin.kept);
        }
    }

    void fly_on() {
        const Flight flight{now_.position_m, now_.velocity_mps};
        const Landing landing = fly(slope_.terrain(), flight, now_.triangle, scratch_.stretches);
        end_.crossings += static_cast<std::uint32_t>(scratch_.stretches.size());
        follow_flight(flight, landing);
    }

    void follow_flight(const Flight& flight, const Landing& landing) {
        if (meets_obstacle_flying(flight, landing)) {
            return;
        }
        if constexpr (Motion::slides) {
            if (landing.end == FlightEnd::ground && strikes_in_turn_.once_more(landing.time_s)) {
                slide_on_along_edge(landing);
                return;
            }
        }
        observer_->flew(rock_, flight, landing.time_s, scratch_.stretches, now_.spin_radps);
        now_.position_m = flight.position_m(landing.time_s);
        now_.velocity_mps = flight.velocity_at(landing.time_s);
        now_.triangle = landing.triangle;
        if (landing.end == FlightEnd::left_terrain) {
            stop(StopReason::left_terrain);
            return;
        }
        now_.position_m.z() = scratch_.stretches.back().ground_end_m;
        touch_ground(now_.keep_face(landing.plane).normal);
    }

    bool meets_obstacle_flying(const Flight& flight, const Landing& landing) {
        if (meetings_.none() || scratch_.stretches.empty()) {
            return false;
        }
        const auto encounter = meetings_.next(flight, landing.time_s);
        if (encounter && twin_ != nullptr) {
            part([&](Fall& bare) { bare.follow_flight(flight, landing); });
        }
        const double until_s = encounter ? encounter->time_s : landing.time_s;
        const auto net = nets_.on_flight(flight, until_s, now_.spin_radps, slope_.terrain(),
                                         scratch_.stretches, *observer_);
        if (net) {
            end_flight_at(flight, net->time_s);
            meet(net->crossing);
        } else if (encounter) {
            end_flight_at(flight, encounter->time_s);
            meet(*encounter);
        }
        return net || encounter;
    }

    /// Reports a piece as far as it came, and of the nets on it.
    void report_rolled(const RollingPiece& piece, std::uint32_t triangle) {
        nets_.report(piece.duration_s, *observer_);
        observer_->rolled(rock_, piece, triangle);
    }

    void end_flight_at(const Flight& flight, double time_s) {
        cut(scratch_.stretches, slope_.terrain(), flight, time_s);
        now_.position_m = flight.position_m(time_s);
        now_.velocity_mps = flight.velocity_at(time_s);
        now_.triangle = scratch_.stretches.back().triangle;
        observer_->flew(rock_, flight, time_s, scratch_.stretches, now_.spin_radps);
    }

    /// A sliding rock that strikes two faces in turn and gets nowhere goes on along their edge.
    void slide_on_along_edge(const Landing& landing) {
        now_.velocity_mps = along_edge(now_.velocity_mps, face_here().normal, landing.plane.normal());
        now_.triangle = landing.triangle;
        now_.position_m.z() = scratch_.stretches.back().ground_end_m;
        resting_place_.add_impact();
        now_.begin_rolling();
    }

    /// Between two faces the only way on is along their edge; in a pit there is none.
    void leave_groove_or_rest() {
        auto run = run_along_groove(slope_.terrain(), now_.triangle, now_.position_m, rock_.radius_m,
                                    now_.motion.groove_law(surface_here()));
        if (!run) {
            stop(StopReason::at_rest);
            return;
        }
        now_.velocity_mps.setZero();
        now_.begin_rolling();
        follow_groove(*run);
    }

    void follow_groove(RollingPiece run) {
        const SurfaceType& surface = surface_here();
        const auto go_on = [&](Fall& bare) { bare.follow_groove(run); };
        if (meets_obstacle_rolling(run, surface, go_on) || is_caught_rolling(run, surface)) {
            return;
        }
        report_rolled(run, now_.triangle);
        resting_place_.add_rolling(run.duration_s);
        now_.go_to_end_of(run);
        if (run.end == RollingEnd::standstill) {
            now_.velocity_mps.setZero();
            if (run.duration_s == 0.0) {
                stop(StopReason::at_rest);
            }
            return;
        }
        RollingPiece step = centimetre_on(run);
        const auto net = nets_.cut(step);
        report_rolled(step, run.next_triangle);
        now_.go_to_end_of(step);
        if (net) {
            meet(*net);
            if (stopped_) {
                return;
            }
        }
        const auto beyond =
            slope_.terrain().locate(now_.position_m.x(), now_.position_m.y(), run.next_triangle);
        if (moves_into(beyond.value_or(no_triangle))) {
            roll_into_face_here();
        }
    }

    /// Beyond the border there is no triangle: the rock has left.
    bool moves_into(std::uint32_t triangle) {
        if (triangle == no_triangle) {
            stop(StopReason::left_terrain);
            return false;
        }
        now_.triangle = triangle;
        return true;
    }

    void touch_ground(const Eigen::Vector3d& normal) {
        if (resting_place_.holds(now_.position_m)) {
            leave_groove_or_rest();
            return;
        }
        if (end_.ground_impacts >= now_.motion.most_impacts()) {
            stop(StopReason::gave_up);
            return;
        }
        const SurfaceType& surface = surface_here();
        const auto draws = now_.motion.next_draws();
        ++end_.ground_impacts;
        resting_place_.add_impact();
        observer_->impacted(now_.position_m, surface.code);
        if (now_.velocity_mps.dot(normal) >= 0.0) {
            return;  // grazes along a facet it does not press on: flies on
        }
        const Contact contact = now_.motion.touch(now_.velocity_mps, now_.spin_radps, normal, surface, draws);
        now_.velocity_mps = contact.velocity_mps;
        now_.spin_radps = contact.spin_radps;
        if (contact.onward == Onward::flies) {
            now_.rolling = false;
        } else if (contact.onward == Onward::rolls) {
            now_.begin_rolling();
        } else {
            stop(contact.onward == Onward::rests ? StopReason::at_rest : StopReason::caught);
        }
    }

    [[nodiscard]] const Face& face_here() { return now_.face(slope_.terrain()); }

    [[nodiscard]] const SurfaceType& surface_here() const {
        return slope_.type_at(now_.triangle, now_.position_m.x(), now_.position_m.y());
    }

    void roll_on() {
        if (resting_place_.holds(now_.position_m)) {
            leave_groove_or_rest();
            return;
        }
        if (++rolling_pieces_ > most_rolling_pieces) {
            stop(StopReason::gave_up);
            return;
        }
        const Face& face = face_here();
        const SurfaceType& surface = surface_here();
        if (const auto leaving_mps = now_.motion.lift_off(now_.velocity_mps, face.normal, surface)) {
            now_.velocity_mps = *leaving_mps;
            now_.rolling = false;
            return;
        }
        follow_piece(now_.motion.next_piece(slope_.terrain(), now_.triangle, face, now_.position_m,
                                            now_.velocity_mps, surface),
                     surface);
    }

    template <class Piece>
    void follow_piece(Piece piece, const SurfaceType& surface) {
        const auto go_on = [&](Fall& bare) { bare.follow_piece(piece, surface); };
        if (meets_obstacle_rolling(piece, surface, go_on) || is_caught_rolling(piece, surface)) {
            return;
        }
        report_rolled(piece, now_.triangle);
        resting_place_.add_rolling(piece.duration_s);
        now_.go_to_end_of(piece);
        now_.put_on(face_here().plane);
        if (piece.end == RollingEnd::standstill) {
            stop(StopReason::at_rest);
        } else if (piece.end == RollingEnd::edge) {
            roll_over_edge(piece);
        }
    }

    void roll_over_edge(const RollingPiece& piece) {
        const std::uint32_t from = now_.triangle;
        if (!moves_into(triangle_beyond(slope_.terrain(), piece))) {
            return;
        }
        if (roll_into_face_here() == EdgeWay::goes_on && !piece.ran_over) {
            const auto run = run_if_pressed(slope_.terrain(), from, now_.triangle, now_.position_m,
                                            now_.velocity_mps, now_.motion.groove_law(surface_here()));
            if (run) {
                follow_groove(*run);
            }
        }
    }

    EdgeWay roll_into_face_here() {
        const Face& face = face_here();
        now_.put_on(face.plane);
        const EdgeWay way = now_.motion.way_over_edge(now_.velocity_mps, face.normal, surface_here());
        switch (way) {
            case EdgeWay::goes_on:
                now_.enter(face);
                break;
            case EdgeWay::takes_off:
                now_.rolling = false;
                break;
            case EdgeWay::runs_into:
                touch_ground(face.normal);
                break;
        }
        return way;
    }

    bool is_caught_rolling(RollingPiece& piece, const SurfaceType& surface) {
        const auto share = now_.motion.caught_on_the_way(surface, piece);
        if (!share) {
            return false;
        }
        piece.duration_s = piece.time_along_s(*share);
        report_rolled(piece, now_.triangle);
        now_.position_m = piece.position_m(piece.duration_s);
        stop(StopReason::caught);
        return true;
    }

    /// `go_on(bare)` follows the whole piece over the bare slope.
    template <class Piece, class GoOn>
    bool meets_obstacle_rolling(Piece& piece, const SurfaceType& surface, const GoOn& go_on) {
        if (meetings_.none() || piece.duration_s <= 0.0) {
            return false;
        }
        const auto encounter = meetings_.next(piece);
        if (encounter && twin_ != nullptr) {
            part(go_on);
        }
        if (encounter) {
            piece.duration_s = piece.time_along_s(encounter->time_s / piece.duration_s);
        }
        const auto net = nets_.cut(piece);
        if (!encounter && !net) {
            return false;
        }
        if (is_caught_rolling(piece, surface)) {
            return true;  // caught on the way to the obstacle
        }
        nets_.report(piece.duration_s, *observer_);
        piece.duration_s = NetWatch::end_s(net, piece.duration_s, piece.velocity_at(piece.duration_s));
        observer_->rolled(rock_, piece, now_.triangle);
        now_.go_to_end_of(piece);
        net ? meet(*net) : meet(*encounter);
        return true;
    }

    void meet(const NetCrossing& crossing) {
        if (crossing.outcome == NetOutcome::held) {
            rest_at_foot(StopReason::net);
            return;
        }
        now_.slow_down(nets_.break_through(crossing, now_.position_m));
    }

    void meet(const Encounter& encounter) {
        const double energy_j = kinetic_energy_j(rock_, now_.velocity_mps.squaredNorm(), now_.spin_radps);
        if (energy_j <= 0.0) {
            stop(encounter.stem ? StopReason::tree : StopReason::log);  // leans on it
        } else if (encounter.stem) {
            meet(*encounter.stem, energy_j);
        } else {
            meet(*encounter.log, energy_j);
        }
    }

    void meet(const StemHit& hit, double energy_j) {
        const TreeImpact impact = meetings_.meet(hit, energy_j);
        ++end_.tree_hits;
        observer_->met_stem(now_.position_m, hit, impact, energy_j);
        if (impact.stopped) {
            rest_at_foot(StopReason::tree);
            return;
        }
        now_.velocity_mps = turned_in_plan(now_.velocity_mps, impact.turn);
        now_.slow_down(impact.speed_factor);
        stay_on_ground();
    }

    void meet(const LogHit& hit, double energy_j) {
        const LogImpact impact = meetings_.meet(hit, energy_j, now_.position_m, now_.velocity_mps);
        ++end_.log_hits;
        observer_->met_log(now_.position_m, hit, impact, energy_j);
        if (impact.outcome == LogOutcome::stopped) {
            rest_at_foot(StopReason::log);
            return;
        }
        now_.velocity_mps = impact.velocity_mps;
        now_.spin_radps *= impact.spin_factor;
        stay_on_ground();
    }

    /// Drops to the ground at the uphill foot of an obstacle.
    void rest_at_foot(StopReason reason) {
        now_.put_on(face_here().plane);
        now_.velocity_mps.setZero();
        stop(reason);
    }

    /// A rolling rock that was turned follows the rise of its face.
    void stay_on_ground() {
        if (now_.rolling) {
            now_.velocity_mps = rising_with(face_here().plane, now_.velocity_mps);
        }
    }

    static constexpr std::uint32_t most_rolling_pieces = 200'000;

    SlopeView slope_;
    Rock rock_;
    Meetings meetings_;
    NetWatch nets_;
    RestingPlace resting_place_;
    StrikesInTurn strikes_in_turn_;
    FallScratch& scratch_;
    Observer* observer_;
    BareTwin<Observer>* twin_;  ///< not yet parted; may be null

    MovingRock<Motion> now_;
    std::uint32_t rolling_pieces_ = 0;
    bool stopped_ = false;
    FallEnd end_;
};

/// Simulates the fall of a rock under the motion model of the law, which is chosen here, once for the rock.
/// With a `twin` it simulates the fall over the bare slope as well, from where both part.
template <class Observer>
FallEnd fall(const SlopeView& slope, const Obstacles& obstacles, const FallLaw& law,
             const config::StreamKey& key, const RockStart& start, FallScratch& scratch, Observer& observer,
             BareTwin<Observer>* twin = nullptr) {
    return with_model(law.motion, [&]<class Model>(std::type_identity<Model>, const auto& settings) {
        using Motion = typename Model::Motion;
        return Fall<Motion, Observer>{slope,   obstacles, law, Motion{settings, key, start.rock}, key, start,
                                      scratch, observer,  twin}
            .run();
    });
}

}  // namespace rockfall
