#pragma once

#include <span>
#include <string>
#include <vector>

#include "rockfall/laws/fall_factors.hpp"
#include "rockfall/laws/settings.hpp"
#include "rockfall/motion/classical/law.hpp"
#include "rockfall/motion/classical/motion.hpp"
#include "rockfall/motion/seam/description.hpp"

namespace rockfall::classical {

/// Constant restitution (Stevens 1998) as an entry of the list of motion models.
struct Model {
    using Law = classical::Law;
    using Written = classical::Written;
    using Motion = classical::Motion;

    static const ModelDescription& description();
    static std::span<const GroundColumn<Law>> ground_columns();
    static SidewaysTurn sideways_turn(const Written& written);
    static std::vector<std::string> doubts(const Slope& slope, double drop_m, const Law& law);

    // Settings: section [classical].
    static void declare(config::Options& options, Law& law, Written& written);
    static void take_over(const Written& written, const SharedSettings& shared, Law& law,
                          const config::Options& options, config::Problems& problems);
    static void stay_in_plane(Law& law, Written& written);
    static void take_factors(Law& law, const FallFactors& factors);
};

}  // namespace rockfall::classical
