#include "coupling/inputs/release/terrain_check.hpp"

#include "coupling/inputs/release/release_input.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/inputs/terrain/terrain_input.hpp"

namespace coupling {

void check_terrain(const Scenario& scenario) {
    config::Warnings ignored;
    Reading reading{scenario, ignored};
    if (const std::optional<HeightInput> heights = read_heights(reading)) {
        reading.attempt([&] {
            return build_terrain(*heights, scenario.rockfall.ground,
                                 diameters_of(std::nullopt, scenario.release).mean_m,
                                 scenario.terrain.longest_edge_m, reading);
        });
    }
    scenario.with_paths([&] { reading.problems().throw_if_any(); });
}

}  // namespace coupling
