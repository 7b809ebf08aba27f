#pragma once

#include <span>
#include <string>
#include <vector>

#include "rockfall/laws/fall_factors.hpp"
#include "rockfall/laws/settings.hpp"
#include "rockfall/motion/rigid/block.hpp"
#include "rockfall/motion/rigid/law.hpp"
#include "rockfall/motion/rigid/motion.hpp"
#include "rockfall/motion/seam/description.hpp"

namespace rockfall::rigid {

/// What replaces the figures of all ground types, as users write it: empty for those of the types.
struct Written {
    std::string friction_law = "by_ground";
    std::string friction;
    std::string friction_max;
    std::string slip_kappa_pm;
    std::string slip_beta_ps;
    std::string drag_ps;
    std::string restitution;
    std::string rolling_resistance;
    std::string soil_strength_kpa;
    std::string roughness_m;
};

/// Rigid blocks of real shape (Leine et al. 2014) as an entry of the list of motion models.
struct Model {
    using Law = rigid::Law;
    using Written = rigid::Written;
    using Motion = rigid::Motion;
    using Scratch = BlockScratch;

    static const ModelDescription& description();
    static std::span<const GroundColumn<Law>> ground_columns();
    static SidewaysTurn sideways_turn(const Written& written);

    // Settings: section [rigid].
    static void declare(config::Options& options, Law& law, Written& written);
    static void take_over(const Written& written, const SharedSettings& shared, Law& law,
                          const config::Options& options, config::Problems& problems);
    static void stay_in_plane(Law& law, Written& written);
    static void take_factors(Law& law, const FallFactors& factors);
};

}  // namespace rockfall::rigid
