#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "rockfall/obstacles/nets/net_passage.hpp"

namespace rockfall {

/// Memory that falls past nets reuse.
struct NetScratch {
    std::vector<NetLineCrossing> lines;
    std::vector<NetPassage> on_piece;
};

/// The nets on the way of one rock: reports each that it crosses to the observer, and to the event loop those
/// that act on it.
class NetWatch {
public:
    /// `nets` may be null: none.
    NetWatch(const NetIndex* nets, const Rock& rock, NetScratch& scratch)
        : nets_{nets}, rock_{rock}, scratch_{scratch} {}

    /// Reports the nets that a flight crosses; the first that acts on the rock is the last, and comes back.
    template <class Observer>
    std::optional<NetPassage> on_flight(const Flight& flight, double until_s, double spin_radps,
                                        const Terrain& terrain, std::span<const Stretch> stretches,
                                        Observer& observer) const {
        std::optional<NetPassage> acting;
        if (nets_ == nullptr) {
            return acting;
        }
        std::size_t stretch = 0;
        const auto ground_m = [&](double time_s, const Eigen::Vector3d& place_m) {
            while (stretch + 1 < stretches.size() && stretches[stretch].end_s < time_s) {
                ++stretch;
            }
            return terrain.plane_of(stretches[stretch].triangle).height_m(place_m.x(), place_m.y());
        };
        each_passage(*nets_, rock_, flight, until_s, spin_radps, scratch_.lines, ground_m,
                     [&](const NetPassage& passage) {
                         if (is_behind(passage)) {
                             return true;
                         }
                         observer.crossed_net(passage.position_m, passage.crossing);
                         if (acts(passage.crossing.outcome)) {
                             acting = passage;
                             acting->time_s = end_s(passage.crossing, passage.time_s, flight.velocity_mps);
                         }
                         return !acting.has_value();
                     });
        return acting;
    }

    /// Finds the nets on a piece on the ground, for report(); the first that acts on the rock cuts
    /// the piece and comes back.
    template <class Piece>
    std::optional<NetCrossing> cut(Piece& piece) {
        std::optional<NetCrossing> acting;
        if (nets_ == nullptr) {
            return acting;
        }
        each_passage(*nets_, rock_, StraightWay::of(piece), scratch_.lines, [&](NetPassage passage) {
            if (is_behind(passage)) {
                return true;
            }
            passage.time_s = piece.time_along_s(passage.time_s);
            scratch_.on_piece.push_back(passage);
            if (acts(passage.crossing.outcome)) {
                acting = passage.crossing;
            }
            return !acting.has_value();
        });
        if (acting) {
            piece.end_after(scratch_.on_piece.back().time_s);
        }
        return acting;
    }

    /// Reports the nets on a piece that ended, by whatever, after `duration_s`.
    template <class Observer>
    void report(double duration_s, Observer& observer) {
        for (const NetPassage& passage : scratch_.on_piece) {
            if (passage.time_s <= duration_s) {
                observer.crossed_net(passage.position_m, passage.crossing);
            }
        }
        scratch_.on_piece.clear();
    }

    /// When a rock that reaches a net at a time ends its piece: a held one a millimetre upslope, so that a
    /// target along the same line is not reached.
    static double end_s(const std::optional<NetCrossing>& crossing, double time_s,
                        const Eigen::Vector3d& velocity_mps) {
        constexpr double upslope_m = 1e-3;
        const double plan_mps = velocity_mps.head<2>().norm();
        return crossing && crossing->outcome == NetOutcome::held && plan_mps > 0.0
                   ? std::max(0.0, time_s - upslope_m / plan_mps)
                   : time_s;
    }

    /// The rock breaks through here. Speed and spin behind the net divided by those before.
    double break_through(const NetCrossing& crossing, const Eigen::Vector3d& place_m) {
        broken_ = crossing.net;
        broken_m_ = place_m;
        return speed_factor_behind((*nets_)[crossing.net], crossing.energy_j);
    }

private:
    /// A rock that broke through a net starts again close to it: it has met it already. On the ground nets
    /// are found on the chord of a piece, which lies up to some centimetres beside the curve of a sliding
    /// rock.
    [[nodiscard]] bool is_behind(const NetPassage& passage) const {
        constexpr double nearby_m = 0.1;
        return passage.crossing.net == broken_ &&
               (passage.position_m - broken_m_).head<2>().squaredNorm() < nearby_m * nearby_m;
    }

    const NetIndex* nets_;
    Rock rock_;
    NetScratch& scratch_;
    std::uint32_t broken_ = 0xFFFFFFFFU;  ///< the last net that it broke, and where; none at first
    Eigen::Vector3d broken_m_ = Eigen::Vector3d::Zero();
};

}  // namespace rockfall
