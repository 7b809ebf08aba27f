#pragma once

#include <cstdint>
#include <optional>

#include "config/random/stream.hpp"
#include "rockfall/laws/contact.hpp"
#include "rockfall/laws/groove.hpp"
#include "rockfall/laws/rock.hpp"
#include "rockfall/motion/pir3d/impact.hpp"
#include "rockfall/motion/pir3d/law.hpp"
#include "rockfall/motion/pir3d/sliding.hpp"
#include "rockfall/slope/slope.hpp"

namespace rockfall::pir3d {

/// One rock under the motion model of PiR3D: a point without spin. What a model must offer is in
/// models.hpp. Every ground type needs a soil.
class Motion {
public:
    static constexpr bool slides = true;

    Motion(const Law& law, const config::StreamKey& key, const Rock& rock)
        : law_{law},
          least_hop_m_{law.least_hop * rock.radius_m},
          ground_draws_{key, config::Purpose::ground_impact},
          sliding_draws_{key, config::Purpose::rolling},
          loss_factor_{loss_factor(law.losses, rock)} {}

    config::FourUniforms next_draws() { return ground_draws_.uniforms_of(contacts_++); }

    Contact touch(const Eigen::Vector3d& velocity_mps, double, const Eigen::Vector3d& normal,
                  const SurfaceType& surface, const config::FourUniforms& draws) const;

    /// The friction of a stretch of sliding comes from one draw, of the width at the speed with which it
    /// begins.
    void begin_rolling(double speed_mps) {
        friction_draw_ = deviate(sliding_draws_.uniforms_of(slides_++)[0], law_.spread);
        first_speed_mps_ = speed_mps;
    }

    [[nodiscard]] static double rolling_spin_radps(double) { return 0.0; }
    static std::optional<Eigen::Vector3d> lift_off(const Eigen::Vector3d&, const Eigen::Vector3d&,
                                                   const SurfaceType&) {
        return std::nullopt;
    }

    [[nodiscard]] SlidingPiece next_piece(const Terrain& terrain, std::uint32_t triangle, const Face& face,
                                          const Eigen::Vector3d& position_m,
                                          const Eigen::Vector3d& velocity_mps,
                                          const SurfaceType& surface) const {
        return slide(terrain, triangle, face, position_m, velocity_mps, friction(surface),
                     law_.position_tolerance_m);
    }

    static std::optional<double> caught_on_the_way(const SurfaceType&, const RollingPiece&) {
        return std::nullopt;
    }

    [[nodiscard]] static EdgeWay way_over_edge(const Eigen::Vector3d& velocity_mps,
                                               const Eigen::Vector3d& next_normal,
                                               const SurfaceType& surface);

    [[nodiscard]] GrooveLaw groove_law(const SurfaceType& surface) const {
        return {friction(surface), 1.0, true};
    }
    [[nodiscard]] std::uint32_t most_impacts() const { return law_.most_impacts; }

private:
    /// Not below 0.
    [[nodiscard]] double friction(const SurfaceType& surface) const;

    const Law& law_;
    double least_hop_m_;
    config::RandomStream ground_draws_;
    config::RandomStream sliding_draws_;
    std::uint32_t contacts_ = 0;
    std::uint32_t slides_ = 0;
    double loss_factor_;
    double friction_draw_ = 0.0;
    double first_speed_mps_ = 0.0;
};

}  // namespace rockfall::pir3d
