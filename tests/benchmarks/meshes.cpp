#include "config/random/stream.hpp"
#include "rockfall/terrain/mesh.hpp"
#include "tests/benchmarks/scene.hpp"

// What needs CGAL stands apart, so that programs without it can link the rest of the scene.

namespace benchmarks {

const rockfall::Slope& bench_slope() {
    constexpr double tolerance_m = 0.35;  // leaves half of the cells
    static const rockfall::Slope slope = slope_of(rockfall::triangulate(bench_heights(), tolerance_m));
    return slope;
}

const rockfall::Slope& full_bench_slope() {
    static const rockfall::Slope slope = slope_of(rockfall::triangulate(bench_heights(), 0.0));
    return slope;
}

rockfall::Terrain thinned_rough_plane(double length_m, double width_m, double cell_m) {
    const config::Raster<double> heights = rough_plane(length_m, width_m, cell_m);
    config::RandomStream stream{key_of(2), config::Purpose::test};
    std::vector<Eigen::Vector3d> points;
    for (std::size_t i = 0; i < heights.values.size(); ++i) {
        const config::Cell cell = heights.frame.cell_of(i);
        const bool is_corner = (cell.row == 0 || cell.row == heights.frame.rows - 1) &&
                               (cell.column == 0 || cell.column == heights.frame.columns - 1);
        if (is_corner || stream.uniform() < 0.5) {
            points.emplace_back(heights.frame.x_centre_m(cell.column), heights.frame.y_centre_m(cell.row),
                                heights.values[i]);
        }
    }
    return rockfall::triangulate(points, 0.0);
}

}  // namespace benchmarks
