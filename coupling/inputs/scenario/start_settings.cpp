#include "coupling/inputs/scenario/start_settings.hpp"

namespace coupling {

void declare_start(config::Options& options, const std::string& section, const StartTargets& start,
                   const std::vector<config::Need>& needs) {
    options.number(section + ".start_height_m", start.height_m,
                   {.unit = "m",
                    .low = 0.0,
                    .high = 1000.0,
                    .meaning = "height of the rock's underside above ground; 0 starts rolling",
                    .source = "Rammer et al. 2010 (Vaujany)",
                    .needs = needs});
    options.number(section + ".start_speed_mps", start.speed_mps,
                   {.unit = "m/s",
                    .low = 0.0,
                    .high = 100.0,
                    .meaning = "speed of the rock when it starts",
                    .source = "Rammer et al. 2010 (Vaujany)",
                    .needs = needs});
    options.number(section + ".start_dip_deg", start.dip_deg,
                   {.unit = "deg",
                    .low = -90.0,
                    .high = 90.0,
                    .meaning = "its direction below the horizon",
                    .source = "Rammer et al. 2010 (Vaujany)",
                    .needs = needs});
}

void declare_density(config::Options& options, const std::string& section, double& density_kgpm3) {
    options.number(section + ".density_kgpm3", density_kgpm3,
                   {.unit = "kg/m3",
                    .low = 1000.0,
                    .high = 5000.0,
                    .meaning = "density of the rock",
                    .source = "Rammer et al. 2010"});
}

}  // namespace coupling
