#include "rockfall/virtual_surface/throws.hpp"

#include "config/math/elementary.hpp"
#include "config/random/stream.hpp"
#include "rockfall/virtual_surface/sweep.hpp"

namespace rockfall {

namespace {

/// A rock that goes on after touches is let go after so many [choice]; few meet more than five.
constexpr int most_legs = 64;

enum Event : std::uint32_t { thrown = 0, rolled = 1 };

double sine_of(config::Angle angle) {
    return config::sin_cos_of(angle.in_radians()).sin;
}

/// The flight direction after a touch: mirrored at the block, with part of the normal speed.
Eigen::Vector3d deflected(const Eigen::Vector3d& direction, const Eigen::Vector3d& towards, double kept) {
    return (direction - (1.0 + kept) * direction.dot(towards) * towards).normalized();
}

/// A throw leg by leg.
class Flyer {
public:
    Flyer(const Sweep& sweep, double longest_leg_m, const ThrowStart& start, const ThrowLaw& law,
          double central_sine)
        : sweep_{sweep},
          longest_leg_m_{longest_leg_m},
          law_{law},
          central_sine_{central_sine},
          centre_m_{start.x_m, start.y_m, sweep.clear_height_m()} {
        const config::SinCos fall = config::sin_cos_of(start.below_horizon.in_radians());
        direction_ = {fall.cos, 0.0, -fall.sin};
    }

    ThrowEnd fly() {
        for (int leg = 0; leg < most_legs; ++leg) {
            const double length_m = leg_length_m();
            const auto contact = sweep_.first_contact(centre_m_, direction_, length_m);
            if (contact) {
                if (is_central(*contact)) {
                    return ThrowEnd::stopped;
                }
                if (!law_.goes_on_after_a_touch) {
                    return ThrowEnd::touched;
                }
                centre_m_ += contact->along_m * direction_;
                direction_ = deflected(direction_, contact->towards, law_.normal_kept);
            } else if (direction_.z() < 0.0) {
                centre_m_ += length_m * direction_;
                direction_.z() = -direction_.z();
            } else {
                return ThrowEnd::passed;
            }
        }
        return ThrowEnd::passed;
    }

private:
    /// To the ground, or until the rock is clear of all blocks.
    [[nodiscard]] double leg_length_m() const {
        const double rise_m = direction_.z() < 0.0 ? sweep_.radius_m() - centre_m_.z()
                                                   : sweep_.clear_height_m() - centre_m_.z();
        return rise_m / direction_.z() < longest_leg_m_ ? rise_m / direction_.z() : longest_leg_m_;
    }
    [[nodiscard]] bool is_central(const BlockContact& contact) const {
        const double cosine = contact.towards.dot(direction_);
        return cosine > 0.0 && 1.0 - cosine * cosine < central_sine_ * central_sine_;
    }

    const Sweep& sweep_;
    double longest_leg_m_;
    const ThrowLaw& law_;
    double central_sine_;
    Eigen::Vector3d centre_m_;
    Eigen::Vector3d direction_;
};

/// As far as a flat leg may go: the surface repeats itself after one side of the patch.
double longest_leg_m(const BlockCover& cover) {
    return 4.0 * cover.side_m();
}

}  // namespace

ThrowEnd throw_rock(const BlockCover& cover, double diameter_m, const ThrowStart& start,
                    const ThrowLaw& law) {
    const Sweep sweep{cover, diameter_m};
    return Flyer{sweep, longest_leg_m(cover), start, law, sine_of(law.central)}.fly();
}

ThrowTally throw_rocks(const BlockCover& cover, double diameter_m, const ThrowLaw& law, const SurfaceKey& key,
                       std::uint32_t throws) {
    const Sweep sweep{cover, diameter_m};
    const double central_sine = sine_of(law.central);
    const double flattest_rad = law.flattest.in_radians();
    const double spread_rad = law.steepest.in_radians() - flattest_rad;
    ThrowTally tally;
    for (std::uint32_t i = 0; i < throws; ++i) {
        const config::RandomStream stream{{key.seed, key.number, 0, i}, config::Purpose::rock_throw};
        const config::FourUniforms u = stream.uniforms_of(Event::thrown);
        const ThrowStart start{u[0] * cover.side_m(), u[1] * cover.side_m(),
                               config::Angle::from_radians(flattest_rad + u[2] * spread_rad)};
        const ThrowEnd end = Flyer{sweep, longest_leg_m(cover), start, law, central_sine}.fly();
        ++tally.throws;
        tally.touched += end == ThrowEnd::passed ? 0U : 1U;
        tally.stopped += end == ThrowEnd::stopped ? 1U : 0U;
    }
    return tally;
}

RollTally roll_rocks(const BlockCover& cover, double diameter_m, const ThrowLaw& law, const SurfaceKey& key,
                     std::uint32_t rolls) {
    const Sweep sweep{cover, diameter_m};
    const double central_sine = sine_of(law.central);
    RollTally tally;
    for (std::uint32_t i = 0; i < rolls; ++i) {
        const config::RandomStream stream{{key.seed, key.number, 0, i}, config::Purpose::rock_throw};
        const config::FourUniforms u = stream.uniforms_of(Event::rolled);
        const Eigen::Vector3d centre_m{u[0] * cover.side_m(), u[1] * cover.side_m(), sweep.radius_m()};
        const auto hit =
            sweep.first_contact(centre_m, Eigen::Vector3d::UnitX(), watched_roll_m, central_sine);
        ++tally.rolls;
        tally.stopped += hit ? 1U : 0U;
        tally.length_m += hit ? hit->along_m : watched_roll_m;
    }
    return tally;
}

}  // namespace rockfall
