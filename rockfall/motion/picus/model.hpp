#pragma once

#include <span>

#include "rockfall/laws/fall_factors.hpp"
#include "rockfall/laws/settings.hpp"
#include "rockfall/motion/picus/law.hpp"
#include "rockfall/motion/picus/motion.hpp"
#include "rockfall/motion/seam/description.hpp"

namespace rockfall::picus {

/// PICUS Rock'n'Roll (Rammer et al. 2010) as an entry of the list of motion models.
struct Model {
    using Law = picus::Law;
    using Written = picus::Written;
    using Motion = picus::Motion;

    static const ModelDescription& description();
    static std::span<const GroundColumn<Law>> ground_columns();
    static SidewaysTurn sideways_turn(const Written& written);

    // Settings: section [picus].
    static void declare(config::Options& options, Law& law, Written& written);
    static void take_over(const Written& written, const SharedSettings& shared, Law& law,
                          const config::Options& options, config::Problems& problems);
    static void stay_in_plane(Law& law, Written& written);
    static void take_factors(Law& law, const FallFactors& factors);
};

}  // namespace rockfall::picus
