#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "config/grid/raster.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "forest/light/horizon.hpp"
#include "forest/stand/patch.hpp"

namespace coupling {

/// The mean plane of the ground in a square.
struct GroundPlane {
    double height_m = 0.0;  ///< at the centre
    double rise_x = 0.0;    ///< eastwards [-]
    double rise_y = 0.0;    ///< northwards [-]
};

/// Least squares through heights at even spacing in the square, as many as it has cells along a side and
/// three at least. Straight between cell centres, along the border of the grid straight on over half a cell.
/// Nothing where a height is missing.
std::optional<GroundPlane> mean_plane(const config::Raster<double>& heights_m, double x_m, double y_m,
                                      double side_m);

/// Cells of 10 m with corners at multiples of 10 m that lie wholly in a frame; columns or rows may be 0.
config::GridFrame patch_frame(const config::GridFrame& heights);

/// What the maps say about a place: the stand that grows there, its soil. Nothing: no forest.
struct PatchCover {
    std::uint32_t stand = 0;
    forest::Soil soil{};
};

/// The ground of a forest.
struct ForestGround {
    forest::PatchGrid grid;
    config::Raster<double>
        elevation_m;  ///< on its frame, known everywhere; where there is no ground that of the nearest
    std::vector<forest::Horizon> horizons;  ///< of every cell of the frame; level where there is no patch
};

/// The patches: cells of `patch_frame` for which `cover_at` has an answer, with ground everywhere in the cell
/// that is less steep than 80 degrees. The frame is cut to 50 m around them. Tells how much forest has no
/// ground or is too steep. Throws InputError (data) without a single patch; of `stands_file` where no stand
/// lies on the ground at all.
ForestGround make_ground(const config::Raster<double>& heights_m, const std::string& file,
                         const std::string& stands_file,
                         const std::function<std::optional<PatchCover>(double x_m, double y_m)>& cover_at,
                         Reading& reading);

}  // namespace coupling
