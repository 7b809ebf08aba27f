#pragma once

#include <cstddef>
#include <vector>

#include "config/grid/raster.hpp"
#include "forest/light/direction.hpp"

namespace forest {

/// What lies beyond the border of the area.
enum class Edges {
    open,    ///< ground without trees, level from the second column on
    mirror,  ///< the trees of the mirrored column inside; the ground goes on rising as at the border
    torus,   ///< the opposite side of the area, lifted by the height the ground gains across it
};

/// The ground that trees stand on. Every cell is a column of the canopy, with or without trees.
struct LightGround {
    config::Raster<double> elevation_m;  ///< at the centre of each column; all finite, square cells
    Edges edges = Edges::open;
    double gain_x_m = 0.0;  ///< torus: how much higher the ground is one whole width of the area to the right
    double gain_y_m = 0.0;  ///< torus: and one whole height of the area up the page
};

/// The ground with a margin of columns around it, so that rays run on without asking where the border is.
class PaddedGround {
public:
    /// Requires finite elevations on square cells, at least one of them, and margin >= 1.
    PaddedGround(const LightGround& ground, int margin);

    [[nodiscard]] const config::GridFrame& frame() const { return frame_; }  ///< without the margin
    [[nodiscard]] int margin() const { return margin_; }
    [[nodiscard]] std::size_t stride() const { return stride_; }  ///< columns in a row with the margins
    [[nodiscard]] std::size_t padded_size() const { return elevation_m_.size(); }
    [[nodiscard]] double column_m() const { return frame_.cell_width_m; }

    /// Place of a column, given as in GridFrame::index, in the padded arrays.
    [[nodiscard]] std::size_t padded(std::size_t column) const {
        const auto columns = static_cast<std::size_t>(frame_.columns);
        return (column / columns + static_cast<std::size_t>(margin_)) * stride_ + column % columns +
               static_cast<std::size_t>(margin_);
    }

    /// Height at the centres of all columns above the lowest of the area.
    [[nodiscard]] const std::vector<float>& elevation_m() const { return elevation_m_; }

    /// The column inside whose trees stand on a padded one, or `none`.
    static constexpr std::size_t none = static_cast<std::size_t>(-1);
    [[nodiscard]] std::size_t source(std::size_t padded) const { return source_[padded]; }

    /// How much the ground rises per metre along x and y at the centre of a column, from its neighbours.
    struct Gradient {
        double x = 0.0;
        double y = 0.0;
    };
    [[nodiscard]] Gradient gradient(std::size_t column) const;
    [[nodiscard]] Direction normal(std::size_t column) const;

private:
    config::GridFrame frame_;
    int margin_;
    std::size_t stride_;
    std::vector<float> elevation_m_;
    std::vector<std::size_t> source_;
};

}  // namespace forest
