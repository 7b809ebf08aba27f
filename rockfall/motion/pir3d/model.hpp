#pragma once

#include <span>
#include <string>
#include <vector>

#include "rockfall/laws/settings.hpp"
#include "rockfall/motion/pir3d/law.hpp"
#include "rockfall/motion/pir3d/motion.hpp"
#include "rockfall/motion/seam/description.hpp"

namespace rockfall::pir3d {

/// PiR3D (Cottaz et al. 2010) as an entry of the list of motion models.
struct Model {
    using Law = pir3d::Law;
    using Written = NothingWritten;
    using Motion = pir3d::Motion;

    static const ModelDescription& description();
    static std::span<const GroundColumn<Law>> ground_columns();
    static SidewaysTurn sideways_turn(const Written& written);
    static std::vector<std::string> doubts(const Slope& slope, double drop_m, const Law& law);

    // Settings: section [pir3d].
    static void declare(config::Options& options, Law& law, Written& written);
    static void take_over(const Written& written, const SharedSettings& shared, Law& law,
                          const config::Options& options, config::Problems& problems);
    static void stay_in_plane(Law& law, Written& written);
};

}  // namespace rockfall::pir3d
