#pragma once

#include <cstdint>
#include <optional>

#include "config/random/stream.hpp"
#include "rockfall/laws/contact.hpp"
#include "rockfall/laws/groove.hpp"
#include "rockfall/laws/rock.hpp"
#include "rockfall/motion/classical/law.hpp"
#include "rockfall/motion/pir3d/sliding.hpp"
#include "rockfall/slope/slope.hpp"

namespace rockfall::classical {

/// One rock under the classical model: a point without spin, restitution that knows no speed, sliding with
/// one angle of friction. What a model must offer is in
/// models.hpp.
class Motion {
public:
    static constexpr bool slides = true;

    Motion(const Law& law, const config::StreamKey& key, const Rock& rock)
        : law_{law},
          least_hop_m_{law.least_hop * rock.radius_m},
          loss_factor_{loss_factor(law.losses, rock)},
          ground_draws_{key, config::Purpose::ground_impact} {}

    config::FourUniforms next_draws() { return ground_draws_.uniforms_of(contacts_++); }

    /// V' = r_t V_t - r_n V_n, turned sideways in the face.
    [[nodiscard]] Contact touch(const Eigen::Vector3d& velocity_mps, double, const Eigen::Vector3d& normal,
                                const SurfaceType& surface, const config::FourUniforms& draws) const;

    static void begin_rolling(double) {}
    [[nodiscard]] static double rolling_spin_radps(double) { return 0.0; }
    static std::optional<Eigen::Vector3d> lift_off(const Eigen::Vector3d&, const Eigen::Vector3d&,
                                                   const SurfaceType&) {
        return std::nullopt;
    }

    [[nodiscard]] pir3d::SlidingPiece next_piece(const Terrain& terrain, std::uint32_t triangle,
                                                 const Face& face, const Eigen::Vector3d& position_m,
                                                 const Eigen::Vector3d& velocity_mps,
                                                 const SurfaceType& surface) const {
        return pir3d::slide(terrain, triangle, face, position_m, velocity_mps, friction(surface),
                            law_.position_tolerance_m);
    }

    static std::optional<double> caught_on_the_way(const SurfaceType&, const RollingPiece&) {
        return std::nullopt;
    }

    [[nodiscard]] EdgeWay way_over_edge(const Eigen::Vector3d& velocity_mps,
                                        const Eigen::Vector3d& next_normal, const SurfaceType&) const;

    [[nodiscard]] GrooveLaw groove_law(const SurfaceType& surface) const {
        return {friction(surface), 1.0, true};
    }
    [[nodiscard]] std::uint32_t most_impacts() const { return law_.most_impacts; }

private:
    /// Coefficient of sliding friction [-].
    [[nodiscard]] double friction(const SurfaceType& surface) const;

    const Law& law_;
    double least_hop_m_;
    double loss_factor_;
    config::RandomStream ground_draws_;
    std::uint32_t contacts_ = 0;
};

}  // namespace rockfall::classical
