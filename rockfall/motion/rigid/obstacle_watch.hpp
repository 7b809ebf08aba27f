#pragma once

#include <cstdint>
#include <optional>

#include "config/random/stream.hpp"
#include "rockfall/motion/rigid/block.hpp"
#include "rockfall/obstacles/log_impact.hpp"
#include "rockfall/obstacles/obstacles.hpp"
#include "rockfall/obstacles/touched.hpp"
#include "rockfall/obstacles/tree_impact.hpp"

namespace rockfall::rigid {

/// The stems and logs on the way of one block.
///
/// An obstacle counts where the block itself, as it is turned, touches it: the ball around it only finds
/// which ones are near. Energy, eccentricity, breaking and turning are the laws of the other models; of a
/// block the eccentricity is the distance of the stem's axis from the path by what the block and the stem
/// reach on that side.
class ObstacleWatch {
public:
    ObstacleWatch(const Obstacles& obstacles, const TreeImpactLaw& tree_law, const LogImpactLaw& log_law,
                  const config::StreamKey& key, const Rock& rock, const solids::Solid& solid);

    /// From now on neither stems nor logs are in the way. Requires that the block has met neither.
    void leave_forest() { in_forest_ = false; }

    [[nodiscard]] bool none() const {
        return !in_forest_ || (obstacles_.stems == nullptr && obstacles_.logs == nullptr);
    }

    /// The first obstacle on a flight of the block before `until_s`. `normal` is that of the ground below.
    std::optional<Encounter> next(Block& block, const Flight& flight, double until_s,
                                  const Eigen::Vector3d& normal);

    /// Whether the block touches an obstacle where it is, moving towards it.
    std::optional<Encounter> touched(const Body& body, const Eigen::Vector3d& normal);

    TreeImpact meet(const StemHit& hit, double energy_j);
    LogImpact meet(const LogHit& hit, double energy_j, const Body& body);

private:
    void forget_left(const Body& body, const Eigen::Vector3d& normal);
    [[nodiscard]] std::optional<StemHit> touches(const Body& body, std::uint32_t stem) const;
    [[nodiscard]] std::optional<LogHit> touches_log(const Body& body, std::uint32_t piece) const;
    template <class BodyAt>
    void first_stem(const BodyAt& body_at, const Flight& flight, double until_s,
                    std::optional<Encounter>& found) const;
    template <class BodyAt>
    void first_log(const BodyAt& body_at, const Flight& flight, double until_s, const Eigen::Vector3d& normal,
                   std::optional<Encounter>& found) const;
    template <class BodyAt>
    std::optional<Encounter> first(const BodyAt& body_at, const Flight& flight, double until_s,
                                   const Eigen::Vector3d& normal);

    const Obstacles& obstacles_;
    const TreeImpactLaw& tree_law_;
    const LogImpactLaw& log_law_;
    config::RandomStream tree_draws_;
    Rock rock_;
    const solids::Solid& solid_;
    Touched stems_;
    Touched logs_;
    bool in_forest_ = true;
    std::uint32_t tree_hits_ = 0;
    std::uint32_t turned_at_log_ = no_log;
    Eigen::Vector3d turned_at_m_ = Eigen::Vector3d::Zero();
};

}  // namespace rockfall::rigid
