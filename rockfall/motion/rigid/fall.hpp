#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "rockfall/laws/on_face.hpp"
#include "rockfall/motion/bare_twin.hpp"
#include "rockfall/motion/fall.hpp"
#include "rockfall/motion/rigid/block.hpp"
#include "rockfall/motion/rigid/extent.hpp"
#include "rockfall/motion/rigid/ground_piece.hpp"
#include "rockfall/motion/rigid/motion.hpp"
#include "rockfall/motion/rigid/obstacle_watch.hpp"
#include "rockfall/motion/rigid/rest_watch.hpp"
#include "rockfall/motion/rigid/start.hpp"
#include "rockfall/obstacles/nets/net_watch.hpp"

namespace rockfall {

template <class Motion, class Observer>
class Fall;

/// One rigid block from release to rest: free flights and steps on the ground, with what stands in the way.
///
/// The observer is shown the point one radius of the sphere of equal volume below the centroid, as the
/// underside of that sphere, with a spin that gives the block's energy of rotation.
template <class Observer>
class Fall<rigid::Motion, Observer> {
public:
    Fall(const SlopeView& slope, const Obstacles& obstacles, const FallLaw& law, rigid::Motion motion,
         const config::StreamKey& key, const RockStart& start, FallScratch& scratch, Observer& observer,
         BareTwin<Observer>* twin = nullptr)
        : Fall{slope, obstacles, law,      std::move(motion),      key,
               start, scratch,   observer, rigid::solid_for(start)} {
        twin_ = twin;
    }

    FallEnd run() { return run_until(std::numeric_limits<double>::infinity()); }

    /// Up to a time since the start: the events are those of the whole fall, of which only the last flight or
    /// step on the ground is shorter. A fall that has not ended then has no reason for its end.
    FallEnd run_until(double until_s) {
        until_s_ = until_s;
        while (!stopped_ && time_s_ < until_s_) {
            if (time_s_ > law_.longest_s || contacts_ >= law_.most_impacts) {
                stop(StopReason::gave_up);
                break;
            }
            on_ground_ ? move_on_ground() : fly_on();
            rest_if_still();
        }
        end_.position_m = underside_m(block_.body().centre_m);
        end_.triangle = under_;
        if (stopped_ && came_to_rest(end_.reason)) {
            end_.reason == StopReason::at_rest || end_.reason == StopReason::caught
                ? block_.rest_on_ground()
                : block_.rest_at_obstacle();
            end_.position_m = rigid::on_ground(slope_.terrain(), end_.position_m, under_);
        }
        end_.dissipated_j = block_.ledger().dissipated_j();
        end_.residual_j = block_.residual_j();
        end_.corrected_j = block_.ledger().correction_j;
        end_.unsolved = block_.unsolved();
        end_.percussions = block_.percussions();
        return end_;
    }

    [[nodiscard]] const rigid::Block& block() const { return block_; }
    [[nodiscard]] bool has_ended() const { return stopped_; }  ///< false where it only went up to a time

private:
    Fall(const SlopeView& slope, const Obstacles& obstacles, const FallLaw& law, rigid::Motion motion,
         const config::StreamKey& key, const RockStart& start, FallScratch& scratch, Observer& observer,
         std::shared_ptr<const solids::Solid> solid)
        : Fall{slope,
               obstacles,
               law,
               std::move(motion),
               key,
               start,
               scratch,
               observer,
               solid,
               rigid::start_of_block(
                   slope, law.motion.of<rigid::Model>(), start, *solid, scratch.of<rigid::Model>(),
                   rigid::Bumps{slope, law.motion.of<rigid::Model>(), solid->diameter_m(), key}),
               key} {}

public:
    /// A block that is under way already: `begin` counts, and of `start` the rock alone. `ground_key` keys
    /// the bumps of the ground, `key` its chance at what stands there.
    Fall(const SlopeView& slope, const Obstacles& obstacles, const FallLaw& law, rigid::Motion motion,
         const config::StreamKey& key, const RockStart& start, FallScratch& scratch, Observer& observer,
         std::shared_ptr<const solids::Solid> solid, const rigid::BlockStart& begin,
         const config::StreamKey& ground_key)
        : slope_{slope},
          law_{law.motion.of<rigid::Model>()},
          solid_{std::move(solid)},
          rock_{start.rock},
          watch_{obstacles, law.tree, law.log, key, start.rock, *solid_},
          nets_{obstacles.nets, rock_, scratch.nets},
          has_nets_{obstacles.nets != nullptr},
          scratch_{scratch},
          observer_{&observer},
          block_{slope,
                 law_,
                 *solid_,
                 begin.body,
                 begin.triangle,
                 scratch.of<rigid::Model>(),
                 rigid::Bumps{slope, law_, solid_->diameter_m(), ground_key}},
          rest_{law_, *solid_},
          chance_stops_{law_, std::move(motion), start.rock.diameter_m},
          on_ground_{begin.on_ground},
          under_{begin.triangle} {
        rock_.mass_kg = solid_->mass_kg;
        begin_piece();
    }

private:
    void stop(StopReason reason) {
        stopped_ = true;
        end_.reason = reason;
    }

    void rest_if_still() {
        if (rest_.rests(block_.body(), time_s_, on_ground_) && !stopped_) {
            stop(StopReason::at_rest);
        }
    }

    /// At the first stem or log the twin over the bare slope takes over all that was common to both and falls
    /// on to its end; `go_on` has it end the flight or step on which they part.
    template <class GoOn>
    void part(const GoOn& go_on) {
        if constexpr (FollowsTwin<Observer>) {
            if (twin_ == nullptr) {
                return;
            }
            BareTwin<Observer>& twin = *std::exchange(twin_, nullptr);
            twin.kept = scratch_;
            twin.observer.go_on_from(*observer_);
            Fall bare{*this};
            bare.observer_ = &twin.observer;
            bare.watch_.leave_forest();
            go_on(bare);
            bare.rest_if_still();
            twin.end = bare.run();
            std::swap(scratch_, twin.kept);
        }
    }

    [[nodiscard]] Eigen::Vector3d underside_m(const Eigen::Vector3d& centre_m) const {
        return centre_m - Eigen::Vector3d{0.0, 0.0, rock_.radius_m};
    }
    [[nodiscard]] double energy_of_rotation_j() const {
        return block_.body().rotation.energy_j(solid_->inertia_kgm2);
    }
    /// That gives a sphere's moment of inertia the block's energy of rotation.
    [[nodiscard]] double spin_radps() const {
        return std::sqrt(2.0 * energy_of_rotation_j() / rock_.inertia_kgm2);
    }
    [[nodiscard]] const SurfaceType& surface_at(std::uint32_t triangle, const Eigen::Vector3d& at_m) const {
        return slope_.type_at(triangle, at_m.x(), at_m.y());
    }

    /// Whether what would last for so long is shortened by the time up to which the fall is simulated.
    [[nodiscard]] bool is_cut(double duration_s) const { return until_s_ - time_s_ < duration_s; }
    void fly_on() {
        rigid::FreeFlight free = block_.fly();
        flight_is_cut_ = is_cut(free.duration_s);
        free.duration_s = flight_is_cut_ ? until_s_ - time_s_ : free.duration_s;
        const Eigen::Vector3d centre_m = block_.body().centre_m;
        const Flight flight{underside_m(centre_m), block_.body().velocity_mps};
        const auto under = slope_.terrain().locate(centre_m.x(), centre_m.y(), under_);
        if (!under) {
            stop(StopReason::left_terrain);
            return;
        }
        under_ = *under;
        std::optional<Encounter> encounter;
        if (!watch_.none()) {
            encounter = watch_.next(block_, {centre_m, flight.velocity_mps}, free.duration_s, normal_below());
        }
        if (encounter) {
            part([&](Fall& bare) { bare.end_flight(free, flight, std::nullopt); });
        }
        end_flight(free, flight, encounter);
    }

    void end_flight(const rigid::FreeFlight& free, const Flight& flight,
                    const std::optional<Encounter>& encounter) {
        const Eigen::Vector3d centre_m = block_.body().centre_m;
        const double until_s = encounter ? encounter->time_s : free.duration_s;
        const Landing landing = pass_over(slope_.terrain(), flight, until_s, under_, scratch_.stretches);
        end_.crossings += static_cast<std::uint32_t>(scratch_.stretches.size());
        std::optional<NetPassage> net;
        if (has_nets_) {
            net = nets_.on_flight(flight, landing.time_s, spin_radps(), slope_.terrain(), scratch_.stretches,
                                  *observer_);
            if (net) {
                cut(scratch_.stretches, slope_.terrain(), flight, net->time_s);
            }
        }
        const double end_s = net ? net->time_s : landing.time_s;
        constexpr double no_flight_s = 1e-9;
        if (end_s > no_flight_s) {
            observer_->flew(rock_, flight, end_s, scratch_.stretches, spin_radps());
            show_poses([&](double time_s) { return block_.flown(time_s); });
        }
        under_ = scratch_.stretches.back().triangle;
        block_.go_on(end_s);
        flown_m_ += (block_.body().centre_m - centre_m).norm();
        time_s_ += end_s;
        if (net) {
            meet(net->crossing);
        } else if (landing.end == FlightEnd::left_terrain) {
            stop(StopReason::left_terrain);
        } else if (encounter) {
            meet(*encounter);
        } else if (flight_is_cut_) {
            time_s_ = until_s_;
        } else if (free.end == rigid::FlightStop::left_terrain) {
            stop(StopReason::left_terrain);
        } else {
            strike();
        }
        begin_piece();
    }

    /// For observers that ask: how the block was turned in the flight or piece that was shown last.
    template <class BodyAt>
    void show_poses(const BodyAt& body_at) {
        if constexpr (requires { observer_->turned(body_at); }) {
            observer_->turned([&](double time_s) {
                const rigid::Body body = body_at(time_s);
                return ShownPose{body.rotation.attitude,
                                 rigid::reach_m(*solid_, body, Eigen::Vector3d::UnitZ())};
            });
        }
    }

    void strike() {
        const rigid::Touchdown touchdown = block_.strike();
        on_ground_ = touchdown.lasts;
        if (!touchdown.touched) {
            return;
        }
        ++contacts_;
        // A corner of a block that rolls on is no rebound: that ends a flight of its own.
        if (flown_m_ >= rock_.radius_m) {
            ++end_.ground_impacts;
            observer_->impacted(touchdown.point_m, surface_at(touchdown.triangle, touchdown.point_m).code);
        }
        flown_m_ = 0.0;
        if (is_caught_at_impact(touchdown)) {
            stop(StopReason::caught);
        }
    }

    bool is_caught_at_impact(const rigid::Touchdown& touchdown) {
        return law_.stops_by_chance &&
               chance_stops_.catches_at_impact(touchdown.into_ground_mps,
                                               surface_at(touchdown.triangle, touchdown.point_m));
    }

    /// Steps of lasting contact, reported in pieces.
    void move_on_ground() {
        bool inside = true;
        const rigid::PieceEnd before_step = here();
        const bool is_last = is_cut(law_.step_s);
        const double step_s = is_last ? until_s_ - time_s_ : law_.step_s;
        const rigid::Touchdown touchdown = block_.step(step_s, inside);
        time_s_ = is_last ? until_s_ : time_s_ + step_s;
        piece_s_ += step_s;
        if (!inside) {
            finish_piece(here());
            if (!stopped_) {
                stop(StopReason::left_terrain);
            }
            return;
        }
        const bool strikes = touchdown.touched && touchdown.into_ground_mps > law_.plastic_mps;
        if (strikes) {
            ++contacts_;
            if (end_piece_before(before_step, step_s)) {
                return;
            }
        }
        airborne_steps_ = touchdown.touched ? 0 : airborne_steps_ + 1;
        const bool leaves = touchdown.touched ? !touchdown.lasts : airborne_steps_ >= 2;
        if (!watch_.none()) {
            if (const auto encounter = watch_.touched(block_.body(), normal_below())) {
                part([&](Fall& bare) { bare.end_step(touchdown, strikes, leaves); });
                finish_piece(here());
                if (!stopped_) {
                    meet(*encounter);
                    begin_piece();
                }
                return;
            }
        }
        end_step(touchdown, strikes, leaves);
    }

    /// Ends a step on which nothing stood in the way.
    void end_step(const rigid::Touchdown& touchdown, bool strikes, bool leaves) {
        constexpr double longest_piece_s = 0.02;
        if (leaves) {
            block_.clear_overlap();
        }
        if (strikes || leaves || piece_s_ >= longest_piece_s - 1e-9) {
            finish_piece(here());
            begin_piece();
        }
        if (stopped_) {
            return;
        }
        if (strikes && is_caught_at_impact(touchdown)) {
            stop(StopReason::caught);
            return;
        }
        on_ground_ = !leaves;
    }

    [[nodiscard]] Eigen::Vector3d normal_below() const { return slope_.terrain().plane_of(under_).normal(); }

    [[nodiscard]] rigid::PieceEnd here() const {
        return {underside_m(block_.body().centre_m), block_.body().velocity_mps, energy_of_rotation_j()};
    }

    void begin_piece() {
        piece_s_ = 0.0;
        piece_start_ = here();
    }

    /// An impact in the last step: what was before it is reported by itself, so that the speed into the
    /// impact counts. True where the rock stopped there.
    bool end_piece_before(const rigid::PieceEnd& before_step, double step_s) {
        if (piece_s_ > 1.5 * law_.step_s) {
            piece_s_ -= step_s;
            finish_piece(before_step);
            piece_s_ = step_s;
            piece_start_ = before_step;
        }
        return stopped_;
    }

    /// Reports what was covered on the ground since begin_piece, with the nets on it.
    void finish_piece(const rigid::PieceEnd& end) {
        if (piece_s_ <= 0.0) {
            return;
        }
        const Eigen::Vector3d& end_m = end.underside_m;
        const double chord_m = (end_m - piece_start_.underside_m).norm();
        RollingPiece piece = rigid::straight_piece(piece_start_, end, piece_s_);
        const auto under = slope_.terrain().locate(end_m.x(), end_m.y(), under_);
        const std::uint32_t triangle = under.value_or(under_);
        std::optional<NetCrossing> net;
        if (has_nets_) {
            net = nets_.cut(piece);
            nets_.report(piece.duration_s, *observer_);
            piece.end_after(NetWatch::end_s(net, piece.duration_s, piece.velocity_at(piece.duration_s)));
        }
        observer_->rolled(rock_, piece, triangle);
        show_poses([&](double) { return block_.body(); });
        under_ = triangle;
        if (net) {
            meet(*net);
            return;
        }
        if (law_.stops_by_chance && !stopped_ &&
            chance_stops_.catches_on_way(chord_m, surface_at(under_, end_m))) {
            stop(StopReason::caught);
        }
    }

    void meet(const NetCrossing& crossing) {
        if (crossing.outcome == NetOutcome::held) {
            stop(StopReason::net);
            return;
        }
        const double factor = nets_.break_through(crossing, block_.body().centre_m);
        block_.meet_obstacle(factor * block_.body().velocity_mps, factor);
    }

    void meet(const Encounter& encounter) {
        const double energy_j = block_.body().kinetic_j(*solid_);
        if (energy_j <= 0.0) {
            stop(encounter.stem ? StopReason::tree : StopReason::log);
        } else if (encounter.stem) {
            meet(*encounter.stem, energy_j);
        } else {
            meet(*encounter.log, energy_j);
        }
    }

    void meet(const StemHit& hit, double energy_j) {
        const TreeImpact impact = watch_.meet(hit, energy_j);
        ++end_.tree_hits;
        observer_->met_stem(underside_m(block_.body().centre_m), hit, impact, energy_j);
        if (impact.stopped) {
            stop(StopReason::tree);
            return;
        }
        block_.meet_obstacle(impact.speed_factor * turned_in_plan(block_.body().velocity_mps, impact.turn),
                             impact.speed_factor);
    }

    void meet(const LogHit& hit, double energy_j) {
        const LogImpact impact = watch_.meet(hit, energy_j, block_.body());
        ++end_.log_hits;
        observer_->met_log(underside_m(block_.body().centre_m), hit, impact, energy_j);
        if (impact.outcome == LogOutcome::stopped) {
            stop(StopReason::log);
            return;
        }
        block_.meet_obstacle(impact.velocity_mps, impact.spin_factor);
    }

    SlopeView slope_;
    const rigid::Law& law_;
    std::shared_ptr<const solids::Solid> solid_;
    Rock rock_;
    rigid::ObstacleWatch watch_;
    NetWatch nets_;
    bool has_nets_;
    FallScratch& scratch_;
    Observer* observer_;
    BareTwin<Observer>* twin_ = nullptr;  ///< not yet parted
    rigid::Block block_;
    rigid::RestWatch rest_;
    rigid::ChanceStops chance_stops_;
    FallEnd end_;
    bool on_ground_;
    bool stopped_ = false;
    std::uint32_t under_;
    std::uint32_t contacts_ = 0;  ///< that struck, corners of a block that rolls among them
    double flown_m_ = 0.0;        ///< by the centre since it touched anything last
    int airborne_steps_ = 0;
    double time_s_ = 0.0;
    double until_s_ = std::numeric_limits<double>::infinity();
    bool flight_is_cut_ = false;
    double piece_s_ = 0.0;
    rigid::PieceEnd piece_start_;
};

}  // namespace rockfall
