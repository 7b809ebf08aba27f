#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "forest/deaths/wounds.hpp"
#include "rockfall/ensemble.hpp"

namespace coupling::exchange {

/// A rock that met a tree, as the forest needs it, with the number of the rock.
struct RockHit {
    std::uint64_t rock = 0;
    forest::Impact impact;
};

/// A hit of the simulation seen from the tree. `fracture_energy`: of its species, relative to fir. Energy is
/// relative to what a sound stem takes: the forest itself knows how rotten the tree is.
forest::Impact impact_on(const forest::Tree& tree, const rockfall::TreeHitRecord& hit,
                         const rockfall::PlacedStem& stem, const rockfall::RockRecord& rock,
                         double fracture_energy);

/// Which of the simulated rocks really fall in a year.
struct RealRocks {
    double share = 0.0;  ///< rocks per year / simulated rocks [-]
    std::uint64_t seed = 0;
    std::uint32_t replicate = 0;
    std::int32_t year = 0;
};

/// Rockfall to forest, the list that comes up each year: hits by the rocks that really fall, in rock order.
/// Each rock is drawn by its own number, so neighbours and threads change nothing.
std::vector<forest::Impact> impacts_of(std::span<const RockHit> hits, const RealRocks& real);

}  // namespace coupling::exchange
