#pragma once

#include <cstdint>
#include <string>

#include "coupling/inputs/nets/barrier_cost.hpp"
#include "rockfall/ensemble.hpp"
#include "rockfall/obstacles/nets/net.hpp"

namespace coupling {

/// A net of the user's list.
struct NetRecord {
    std::string name;
    std::string energy_class;  ///< as net_classes.csv names it; empty where the capacity was given
    rockfall::Net net;         ///< coordinates of the terrain
    BarrierCost cost{};
};

/// A crossing of the table of crossings, small enough that a run keeps all of them.
struct NetRow {
    std::uint64_t rock = 0;
    rockfall::Cover cover = rockfall::Cover::bare;
    rockfall::NetCrossingRecord crossing{};
};

}  // namespace coupling
