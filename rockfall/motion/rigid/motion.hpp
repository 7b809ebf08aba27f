#pragma once

#include "config/random/stream.hpp"
#include "rockfall/laws/rock.hpp"
#include "rockfall/motion/rigid/law.hpp"

namespace rockfall::rigid {

/// What the event loop of rigid blocks (fall.hpp) takes from settings and chance.
struct Motion {
    Motion(const Law& settings, const config::StreamKey& key, const Rock&)
        : law{&settings}, ground_draws{key, config::Purpose::ground_impact} {}

    const Law* law;
    config::RandomStream ground_draws;
};

}  // namespace rockfall::rigid
