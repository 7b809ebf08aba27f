#include "validation/engine/forest_cases/shared/level_forest.hpp"

#include <array>
#include <cassert>
#include <vector>

namespace coupling::validation::forest_cases {

forest::PatchGrid level_patches(int side_patches, const forest::Soil& soil) {
    const config::GridFrame frame{.columns = side_patches,
                                  .rows = side_patches,
                                  .cell_width_m = forest::patch_side_m,
                                  .cell_height_m = forest::patch_side_m};
    std::vector<forest::Patch> patches(frame.size());
    for (std::size_t i = 0; i < patches.size(); ++i) {
        patches[i].cell = frame.cell_of(i);
        patches[i].soil = soil;
    }
    return {frame, patches};
}

forest::Site level_site(const forest::PatchGrid& grid, config::Angle latitude,
                        std::span<const forest::ClimateYear> years) {
    assert(!years.empty());
    std::array<double, 12> daily_mjpm2{};
    for (const forest::ClimateYear& year : years) {
        for (std::size_t m = 0; m < daily_mjpm2.size(); ++m) {
            daily_mjpm2[m] += year.months[m].radiation_mjpm2 / static_cast<double>(years.size());
        }
    }
    forest::SkySettings settings;
    settings.latitude = latitude;
    const forest::Sky sky{settings, forest::split_radiation(latitude, daily_mjpm2)};
    const forest::LightGround ground{.elevation_m = config::Raster<double>{grid.frame()},
                                     .edges = forest::Edges::torus};
    return {grid, latitude, {sky, ground, {forest::Horizon{}}}};
}

}  // namespace coupling::validation::forest_cases
