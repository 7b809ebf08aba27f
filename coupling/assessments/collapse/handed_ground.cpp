#include "coupling/assessments/collapse/handed_ground.hpp"

#include <algorithm>

#include "coupling/inputs/ground/surface_types.hpp"
#include "coupling/inputs/terrain/mesh_input.hpp"

namespace coupling::collapse {
namespace {

std::vector<std::uint8_t> dug_triangles(const rockfall::Terrain& before, const rockfall::Terrain& after) {
    std::vector<std::uint8_t> dug;
    for (const rockfall::Triangle& triangle : before.triangles()) {
        dug.push_back(std::any_of(std::begin(triangle.corners), std::end(triangle.corners),
                                  [&](std::uint32_t corner) {
                                      return after.vertices()[corner].z_m != before.vertices()[corner].z_m;
                                  })
                          ? 1
                          : 0);
    }
    return dug;
}

std::vector<rockfall::Stem> stems_of(const std::vector<TreeRecord>& trees) {
    std::vector<rockfall::Stem> stems;
    for (const TreeRecord& tree : trees) {
        stems.push_back(tree.stem);
    }
    return stems;
}

}  // namespace

HandedGround::HandedGround(rockfall::Slope slope, const rockfall::Terrain& without_mass,
                           const std::vector<TreeRecord>& trees, double largest_radius_m, bool taper)
    : slope_{std::move(slope)},
      dug_{dug_triangles(slope_.terrain, without_mass)},
      stems_{stems_of(trees), slope_.terrain, largest_radius_m, taper} {}

bool HandedGround::is_untouched(const rockfall::rock_mass::Ground& ground, const Eigen::Vector2d& centre_m,
                                double radius_m) const {
    const Eigen::Vector2d reach{radius_m, radius_m};
    const std::vector<std::uint32_t> prisms = ground.prisms_in(centre_m - reach, centre_m + reach);
    return !prisms.empty() &&
           std::none_of(prisms.begin(), prisms.end(), [&](std::uint32_t prism) { return dug_[prism] != 0; });
}

GroundOfBlocks read_ground_of_blocks(const CollapseScenario& scenario, HeightInput& heights,
                                     Reading& reading) {
    const double least_m = scenario.settings.least_block_m;
    const double mean_m = std::max(least_m, scenario.settings.block_size_m);
    GroundOfBlocks ground;
    ground.types = read_surface_types({least_m, mean_m, mean_m}, reading);
    ground.cover = read_ground_cover(reading);
    if (heights.has_codes && ground.types) {
        meshes::name_ground(heights, *ground.types, reading);
    }
    return ground;
}

std::optional<rockfall::Slope> slope_of_blocks(GroundOfBlocks ground, const HeightInput& heights,
                                               const rockfall::Terrain& terrain, Reading& reading) {
    if (!ground.cover || !ground.types) {
        return std::nullopt;
    }
    std::optional<GroundMap> map =
        match_ground(heights, terrain, *ground.cover, std::move(*ground.types), reading);
    if (!map) {
        return std::nullopt;
    }
    rockfall::SurfaceMap surface = surface_map(*map, terrain.origin_m());
    return rockfall::Slope{terrain, std::move(surface), std::move(map->types)};
}

}  // namespace coupling::collapse
