#pragma once

#include <string>
#include <vector>

#include "config/options/options.hpp"

namespace coupling {

/// How rocks start, as users write it.
struct StartTargets {
    double& height_m;  ///< of the underside above ground
    double& speed_mps;
    double& dip_deg;  ///< of the direction, below the horizon
};

/// Declares section.start_height_m, start_speed_mps and start_dip_deg: scenarios and validation cases share
/// them. Speed, height and direction have the needs.
void declare_start(config::Options& options, const std::string& section, const StartTargets& start,
                   const std::vector<config::Need>& needs = {});

/// Declares section.density_kgpm3.
void declare_density(config::Options& options, const std::string& section, double& density_kgpm3);

}  // namespace coupling
