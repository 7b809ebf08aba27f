#pragma once

#include "config/grid/raster.hpp"
#include "forest/stand/patch.hpp"

namespace coupling::decades {

/// The ground under a forest as its patches give it: straight between their centres in both directions. Half
/// a patch beyond the rim it goes on as the patches there slope.
class ForestGround {
public:
    explicit ForestGround(const forest::PatchGrid& grid);

    /// NaN where no patch is near.
    [[nodiscard]] double height_m(double x_m, double y_m) const;
    /// At the centres of patches and of the cells around them; NaN elsewhere.
    [[nodiscard]] const config::Raster<double>& heights() const { return heights_; }

private:
    config::Raster<double> heights_;
};

/// Cells of a forest that a picture shows at a scale at which crowns can be distinguished.
struct StandWindow {
    config::GridFrame frame;
    bool whole = true;  ///< all patches lie in it
};

/// All of a forest of at most 1.5 ha and 200 m; else the square of 100 m with most patches, of equal ones the
/// nearest to the middle. Requires at least one patch.
StandWindow window_of(const forest::PatchGrid& grid);

/// The smallest part of the frame that holds all patches. Requires at least one patch.
config::GridFrame extent_of(const forest::PatchGrid& grid);

/// A strip through a forest along its mean fall line, downwards.
struct Transect {
    double x_m = 0.0;  ///< of its upper end
    double y_m = 0.0;
    double along_x = 1.0;  ///< unit direction on the map
    double along_y = 0.0;
    double length_m = 0.0;  ///< on the map
    bool falls = true;      ///< false: the ground is flat, the strip runs from west to east

    [[nodiscard]] double distance_m(double px_m, double py_m) const {
        return (px_m - x_m) * along_x + (py_m - y_m) * along_y;
    }
    /// Of a point from the middle line, positive on the left of one who looks down.
    [[nodiscard]] double offset_m(double px_m, double py_m) const {
        return (py_m - y_m) * along_x - (px_m - x_m) * along_y;
    }
    [[nodiscard]] double x_at(double distance) const { return x_m + distance * along_x; }
    [[nodiscard]] double y_at(double distance) const { return y_m + distance * along_y; }
};

/// Through the patch nearest to the middle of the window, up to 50 m both ways, as far as there are patches.
Transect transect_of(const forest::PatchGrid& grid, const StandWindow& window);

}  // namespace coupling::decades
