#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>

#include "config/random/stream.hpp"
#include "rockfall/laws/rock.hpp"
#include "rockfall/obstacles/log_impact.hpp"
#include "rockfall/obstacles/obstacles.hpp"
#include "rockfall/obstacles/tree_impact.hpp"

namespace rockfall {

/// The stems and logs that one rock meets on its way: which is next, what the hit does, and what of it stays:
/// what the rock touched, and what it broke and no longer stands or lies there for the rocks after it.
class Meetings {
public:
    Meetings(const Obstacles& obstacles, const TreeImpactLaw& tree_law, const LogImpactLaw& log_law,
             const config::StreamKey& key, const Rock& rock)
        : obstacles_{obstacles},
          tree_law_{tree_law},
          log_law_{log_law},
          tree_draws_{key, config::Purpose::tree_impact},
          rock_{rock},
          encounters_{obstacles, rock.radius_m} {}

    /// From now on neither stems nor logs are in the way, and nets are as before. Requires that the rock has
    /// met neither.
    void leave_forest() { in_forest_ = false; }

    [[nodiscard]] bool none() const { return in_forest_ ? obstacles_.none() : obstacles_.nets == nullptr; }

    /// The first obstacle on a flight before `until_s`.
    std::optional<Encounter> next(const Flight& flight, double until_s) {
        return in_forest_ ? encounters_.next(flight, until_s) : std::nullopt;
    }
    /// The same on a piece of rolling.
    std::optional<Encounter> next(const RollingPiece& piece) {
        return in_forest_ ? encounters_.next(piece) : std::nullopt;
    }

    TreeImpact meet(const StemHit& hit, double energy_j) {
        const TreeImpact impact = meet_stem(energy_j, hit, obstacles_.stems->placed()[hit.stem], tree_law_,
                                            tree_draws_.uniforms_of(tree_hits_++));
        encounters_.remember(hit);
        if (impact.broken && tree_law_.remove_broken && !obstacles_.gone.empty()) {
            obstacles_.gone[hit.stem] = 1;
        }
        return impact;
    }

    /// A rock that a log would turn once more within the rock's radius of where it did so last is pressed
    /// against the log and rests there.
    LogImpact meet(const LogHit& hit, double energy_j, const Eigen::Vector3d& position_m,
                   const Eigen::Vector3d& velocity_mps) {
        const LogPiece& piece = obstacles_.logs->pieces()[hit.piece];
        const LogImpact impact = meet_log(energy_j, velocity_mps, rock_, hit, piece, log_law_);
        if (impact.outcome == LogOutcome::turned) {
            if (turned_at_log_ == hit.log &&
                (position_m - turned_at_m_).squaredNorm() < rock_.radius_m * rock_.radius_m) {
                return rest_at(energy_j);
            }
            turned_at_log_ = hit.log;
            turned_at_m_ = position_m;
            return impact;
        }
        encounters_.remember(hit);
        if (impact.outcome == LogOutcome::broke && tree_law_.remove_broken && !obstacles_.logs_gone.empty()) {
            obstacles_.logs_gone[hit.log] = 1;
        }
        return impact;
    }

private:
    const Obstacles& obstacles_;
    const TreeImpactLaw& tree_law_;
    const LogImpactLaw& log_law_;
    config::RandomStream tree_draws_;
    Rock rock_;
    std::uint32_t tree_hits_ = 0;
    Encounters encounters_;
    bool in_forest_ = true;
    std::uint32_t turned_at_log_ = no_log;
    Eigen::Vector3d turned_at_m_ = Eigen::Vector3d::Zero();
};

}  // namespace rockfall
