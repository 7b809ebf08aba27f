#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "rockfall/laws/flight.hpp"
#include "rockfall/laws/rock.hpp"
#include "rockfall/laws/rolling.hpp"
#include "rockfall/obstacles/nets/net_impact.hpp"
#include "rockfall/obstacles/nets/net_index.hpp"

namespace rockfall {

/// A rock in the plane of a net: when, and where its underside is.
struct NetPassage {
    double time_s;  ///< since the start of the flight or piece
    Eigen::Vector3d position_m;
    NetCrossing crossing;
};

/// A rolling piece as far as nets ask: the straight way between its ends, on which the square of the speed
/// and a block's own energy of rotation change evenly. That is exact for constant acceleration along the way.
struct StraightWay {
    Eigen::Vector3d start_m;
    Eigen::Vector3d end_m;
    double squared_speed_start;  ///< [m2/s2]
    double squared_speed_end;
    bool slides;                     ///< without spin
    double rotation_start_j = -1.0;  ///< of a block with a motion of its own; else below 0
    double rotation_end_j = -1.0;

    static StraightWay of(const RollingPiece& piece) {
        return {piece.start_m,
                piece.position_m(piece.duration_s),
                piece.squared_speed_start(),
                piece.squared_speed_end(),
                piece.slides,
                piece.own_start.rotation_j,
                piece.own_end.rotation_j};
    }
};

/// A crossing in numbers. `underside_m`: height of the rock above the ground.
inline NetCrossing net_crossing(const NetIndex& nets, const NetLineCrossing& line, const Rock& rock,
                                double underside_m, double squared_speed, double rotation_j) {
    const double translational_j = 0.5 * rock.mass_kg * squared_speed;
    const double energy_j = translational_j + rotation_j;
    return {line.net,
            line.along_m,
            underside_m + rock.radius_m,
            rock.radius_m,
            energy_j,
            translational_j,
            std::sqrt(squared_speed),
            meet_net(nets[line.net], rock, underside_m, energy_j)};
}

/// Calls take(passage) for the nets that a flight crosses before `until_s`, in their order, until it returns
/// false. Time, height and energy are those of the parabola in the plane of the net, in closed form.
/// `ground_m(time_s, place_m)`: height of the ground under the flight.
template <class Ground, class Take>
void each_passage(const NetIndex& nets, const Rock& rock, const Flight& flight, double until_s,
                  double spin_radps, std::vector<NetLineCrossing>& memory, const Ground& ground_m,
                  const Take& take) {
    nets.find_crossings(flight.start_m.head<2>(), flight.position_m(until_s).head<2>(), memory);
    for (const NetLineCrossing& line : memory) {
        const double time_s = line.share * until_s;
        const Eigen::Vector3d place_m = flight.position_m(time_s);
        const double underside_m = std::max(0.0, place_m.z() - ground_m(time_s, place_m));
        const double rotation_j = 0.5 * rock.inertia_kgm2 * spin_radps * spin_radps;
        if (!take(NetPassage{
                time_s, place_m,
                net_crossing(nets, line, rock, underside_m, flight.squared_speed_at(time_s), rotation_j)})) {
            return;
        }
    }
}

/// The same on the ground; `time_s` of a passage is the share of the way [0, 1].
template <class Take>
void each_passage(const NetIndex& nets, const Rock& rock, const StraightWay& way,
                  std::vector<NetLineCrossing>& memory, const Take& take) {
    nets.find_crossings(way.start_m.head<2>(), way.end_m.head<2>(), memory);
    for (const NetLineCrossing& line : memory) {
        const double squared_speed = std::max(
            0.0, way.squared_speed_start + line.share * (way.squared_speed_end - way.squared_speed_start));
        const double own_j = way.rotation_start_j + line.share * (way.rotation_end_j - way.rotation_start_j);
        const double rotation_j = rotation_on_ground_j(rock, way.slides, own_j, squared_speed);
        if (!take(NetPassage{line.share, way.start_m + line.share * (way.end_m - way.start_m),
                             net_crossing(nets, line, rock, 0.0, squared_speed, rotation_j)})) {
            return;
        }
    }
}

}  // namespace rockfall
