#pragma once

#include <cstdint>
#include <type_traits>

#include "rockfall/motion/classical/motion.hpp"
#include "rockfall/motion/picus_motion.hpp"
#include "rockfall/motion/pir3d/motion.hpp"

namespace rockfall {

/// The list of motion models. A new one is a room of its own below motion/, an entry in each of the lists
/// below, and what its grounds need in SurfaceType.
///
/// A model is a class made for one rock from its law, the rock's stream key and the rock. It offers:
///   next_draws()                        what chance gives to the next ground contact
///   touch(velocity, spin, normal, surface, draws) -> Contact   meets the ground
///   begin_rolling(speed)                the rock now moves on the ground
///   rolling_spin_radps(speed)           its spin there
///   lift_off(velocity, normal)          the velocity with which it leaves even ground by itself, if it does
///   next_piece(terrain, triangle, plane, position, velocity, surface)
///                                       moves on: a RollingPiece or one's heir
///   caught_on_the_way(surface, piece)   the share of the piece after which the ground catches it, if it does
///   way_over_edge(velocity, next_normal, surface) -> EdgeWay
///   slides                              whether rocks slide on the ground or roll; a groove whose faces a
///                                       sliding rock strikes in turn leads it on
///   groove_law(surface), most_impacts()
/// The event loop (trajectory.hpp) does all else and is compiled once for each model: no call is virtual.
enum class MotionModel : std::uint8_t { picus, pir3d, classical };

/// The name of a model in settings and results.
constexpr const char* name_of(MotionModel model) {
    switch (model) {
        case MotionModel::pir3d:
            return "pir3d";
        case MotionModel::classical:
            return "classical";
        case MotionModel::picus:
            break;
    }
    return "picus";
}

/// Whether rocks spin under a model; without spin their energy is that of translation alone.
constexpr bool spins(MotionModel model) {
    return model == MotionModel::picus;
}

/// Which model moves the rocks, and the settings of all.
struct MotionLaws {
    MotionModel model = MotionModel::picus;
    PicusLaw picus;
    pir3d::Law pir3d;
    classical::Law classical;
};

/// Calls `with` with the type of the chosen model and its law.
template <class With>
auto with_model(const MotionLaws& laws, With&& with) {
    switch (laws.model) {
        case MotionModel::pir3d:
            return with(std::type_identity<pir3d::Motion>{}, laws.pir3d);
        case MotionModel::classical:
            return with(std::type_identity<classical::Motion>{}, laws.classical);
        case MotionModel::picus:
            break;
    }
    return with(std::type_identity<PicusMotion>{}, laws.picus);
}

}  // namespace rockfall
