#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "config/math/elementary.hpp"
#include "config/random/stream.hpp"
#include "rockfall/laws/contact.hpp"
#include "rockfall/laws/groove.hpp"
#include "rockfall/laws/hop.hpp"
#include "rockfall/laws/losses.hpp"
#include "rockfall/laws/rolling.hpp"
#include "rockfall/motion/picus/facet.hpp"
#include "rockfall/motion/picus/ground_contact.hpp"
#include "rockfall/motion/picus/law.hpp"
#include "rockfall/slope/slope.hpp"
#include "rockfall/slope/surface_stops.hpp"

namespace rockfall::picus {

/// The coefficients of a ground type that the law asks for.
inline Restitution restitution_of(const SurfaceType& surface, const RestitutionLaw& law) {
    return law.fitted ? surface.restitution : surface.as_published();
}

/// One rock under the motion model of PICUS Rock'n'Roll; what a model must offer is in
/// models.hpp.
class Motion {
public:
    static constexpr bool slides = false;

    Motion(const Law& law, const config::StreamKey& key, const Rock& rock)
        : law_{law},
          rock_{rock},
          ground_draws_{key, config::Purpose::ground_impact},
          rolling_draws_{key, config::Purpose::rolling},
          surface_stops_{rock.diameter_m},
          loss_factor_{loss_factor(law.losses, rock)} {
        if (law.noise == NoiseScope::rock) {
            constexpr std::uint32_t once_per_rock = 0xFFFFFF;
            noise_of_rock_ = 2.0 * ground_draws_.uniforms_of(once_per_rock)[0] - 1.0;
        }
    }

    Contact touch(const Eigen::Vector3d& velocity_mps, double spin_radps, const Eigen::Vector3d& normal,
                  const SurfaceType& surface, const ContactDraws& draws) {
        const Restitution restitution = with_losses(restitution_of(surface, law_.restitution), loss_factor_);
        return meet_ground(velocity_mps, spin_radps, normal, restitution, surface_stops_.probability(surface),
                           rock_, law_, draws, surface.jump_angle_factor, friction_on(surface));
    }

    ContactDraws next_draws() {
        ContactDraws draws = contact_draws(ground_draws_.uniforms_of(contacts_++), law_);
        if (law_.noise == NoiseScope::rock) {
            draws.noise = noise_of_rock_;
        }
        return draws;
    }

    void begin_rolling(double) {
        const double u = rolling_draws_.uniforms_of(rolls_++)[0];
        rolling_until_caught_ = -config::ln_of(1.0 - u);  // unit exponential: used up at the surface's rate
    }

    [[nodiscard]] double rolling_spin_radps(double speed_mps) const { return speed_mps / rock_.radius_m; }

    /// Past the launch speed, a hop longer than the radius lifts a rolling rock off.
    std::optional<Eigen::Vector3d> lift_off(const Eigen::Vector3d& velocity_mps,
                                            const Eigen::Vector3d& normal, const SurfaceType&) {
        // Without a law for the angle nothing lifts a rolling rock off even ground.
        if (velocity_mps.norm() < launch_mps(normal) * (1.0 - 1e-9) ||
            law_.angle == ReboundAngle::geometric) {
            return std::nullopt;
        }
        const Eigen::Vector3d leaving_mps = picus::lift_off(velocity_mps, normal, law_, next_draws(), 1.0);
        return hops_far(leaving_mps, normal, rock_.radius_m) ? std::optional{leaving_mps} : std::nullopt;
    }

    RollingPiece next_piece(const Terrain& terrain, std::uint32_t triangle, const Face& face,
                            const Eigen::Vector3d& position_m, const Eigen::Vector3d& velocity_mps,
                            const SurfaceType& surface) {
        // Past the launch speed but with hops too short to matter: rolls on in pieces.
        const double next_launch_mps = std::max(launch_mps(face.normal), velocity_mps.norm() * 1.1);
        return roll(terrain, triangle, face, position_m, velocity_mps, friction_on(surface), next_launch_mps);
    }

    /// The share of a piece [0, 1] after which the ground catches the rock, if it does.
    std::optional<double> caught_on_the_way(const SurfaceType& surface, const RollingPiece& piece) {
        const double rate = surface_stops_.rolling_rate(surface);
        if (rate <= 0.0 || !law_.stopping.by_chance || !law_.stopping.catches_rolling) {
            return std::nullopt;
        }
        const double length_m = (piece.position_m(piece.duration_s) - piece.start_m).norm();
        if (length_m * rate < rolling_until_caught_) {
            rolling_until_caught_ -= length_m * rate;
            return std::nullopt;
        }
        return rolling_until_caught_ / (length_m * rate);
    }

    [[nodiscard]] EdgeWay way_over_edge(const Eigen::Vector3d& velocity_mps,
                                        const Eigen::Vector3d& next_normal, const SurfaceType&) const {
        const double off_mps = velocity_mps.dot(next_normal);
        const double along_mps = (velocity_mps - off_mps * next_normal).norm();
        if (std::abs(off_mps) <= law_.rolling.edge_angle_tangent * along_mps) {
            return EdgeWay::goes_on;
        }
        return off_mps > 0.0 ? EdgeWay::takes_off : EdgeWay::runs_into;
    }

    [[nodiscard]] GrooveLaw groove_law(const SurfaceType& surface) const {
        return {friction_on(surface), rolling_mass_factor, false};
    }
    [[nodiscard]] std::uint32_t most_impacts() const { return law_.stopping.most_impacts; }

private:
    /// Of rolling: the ground type's own, else that of the law. It changes only with the surface.
    [[nodiscard]] double friction_on(const SurfaceType& surface) const {
        if (&surface != friction_of_) {
            friction_of_ = &surface;
            friction_ = rolling_friction(surface, law_, loss_factor_);
        }
        return friction_;
    }
    /// Changes only with the face.
    [[nodiscard]] double launch_mps(const Eigen::Vector3d& normal) const {
        if (normal.z() != launch_of_z_) {
            launch_of_z_ = normal.z();
            launch_mps_ = law_.rolling.launch_factor * rolling_speed_scale_mps(normal.z(), rock_.radius_m);
        }
        return launch_mps_;
    }

    const Law& law_;
    Rock rock_;
    config::RandomStream ground_draws_;
    config::RandomStream rolling_draws_;
    SurfaceStops surface_stops_;
    double loss_factor_;
    std::uint32_t contacts_ = 0;
    std::uint32_t rolls_ = 0;
    double noise_of_rock_ = 0.0;
    double rolling_until_caught_ = 0.0;
    mutable const SurfaceType* friction_of_ = nullptr;
    mutable double friction_ = 0.0;
    mutable double launch_of_z_ = 0.0;  ///< of no face: their normals point up
    mutable double launch_mps_ = 0.0;
};

}  // namespace rockfall::picus
