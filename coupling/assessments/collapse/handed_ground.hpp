#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "coupling/inputs/collapse_settings.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/inputs/terrain/surface_input.hpp"
#include "rockfall/obstacles/stem_index.hpp"
#include "rockfall/rock_mass/ground.hpp"
#include "rockfall/slope/slope.hpp"

namespace coupling::collapse {

/// The ground of blocks that go on as single ones: the terrain as it is, with its ground types and trees.
///
/// The mass moves over the same triangles, but dug out where it stood. There, and on the rock that stays
/// around it, a block remains part of the mass.
class HandedGround {
public:
    /// `without_mass`: the terrain as it is dug out, with the same triangles. `largest_radius_m`: of the ball
    /// around any block.
    HandedGround(rockfall::Slope slope, const rockfall::Terrain& without_mass,
                 const std::vector<TreeRecord>& trees, double largest_radius_m, bool taper);

    [[nodiscard]] const rockfall::Slope& slope() const { return slope_; }
    [[nodiscard]] const rockfall::StemIndex& stems() const { return stems_; }

    /// Whether the terrain is as it was within a circle in plan. `ground`: that of the mass.
    [[nodiscard]] bool is_untouched(const rockfall::rock_mass::Ground& ground,
                                    const Eigen::Vector2d& centre_m, double radius_m) const;

private:
    rockfall::Slope slope_;
    std::vector<std::uint8_t> dug_;  ///< by triangle
    rockfall::StemIndex stems_;
};

/// Ground types and where they lie, as read before the terrain is built.
struct GroundOfBlocks {
    std::optional<GroundCover> cover;
    std::optional<std::vector<rockfall::SurfaceType>> types;
};

/// Reads the ground types of a scenario that hands blocks over; names those of faces.
GroundOfBlocks read_ground_of_blocks(const CollapseScenario& scenario, HeightInput& heights,
                                     Reading& reading);

/// The slope of single blocks; nothing where types and cover do not fit, which `reading` then knows.
std::optional<rockfall::Slope> slope_of_blocks(GroundOfBlocks ground, const HeightInput& heights,
                                               const rockfall::Terrain& terrain, Reading& reading);

}  // namespace coupling::collapse
