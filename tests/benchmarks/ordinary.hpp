#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "config/grid/raster.hpp"
#include "rockfall/obstacles/stem.hpp"
#include "rockfall/trajectory.hpp"
#include "tests/benchmarks/counters.hpp"

namespace benchmarks::ordinary {

/// How the ordinary program is run.
struct Mode {
    bool hinted = false;       ///< CGAL looks for the next face from the last one
    bool with_forest = false;  ///< trees, cell statistics and a record of each rock
};

/// The same physics, written the way such programs are usually written: the measure of ours.
///
/// CGAL finds the triangle under the rock at each step of 0.01 s; terrain, rebound and forest are abstract
/// classes; chance comes from one std::mt19937 with the distributions of the standard library; powers and
/// angles from <cmath>; trees are shared pointers in patches of 10 m, nine of which are searched. It takes
/// care where care costs nothing: parabolas are exact within a step, nothing is allocated per step.
class Program {
public:
    /// Points of the terrain, stems and the frame of the maps in absolute coordinates.
    Program(std::span<const Eigen::Vector3d> terrain, std::span<const rockfall::Stem> stems,
            const config::GridFrame& maps, const rockfall::FallLaw& law, const rockfall::SurfaceType& ground);
    ~Program();

    /// Lets rocks fall; their starts are given relative to `origin_m`.
    Totals run(std::span<const rockfall::RockStart> starts, const Eigen::Vector2d& origin_m, Mode mode);

private:
    struct World;
    std::unique_ptr<World> world_;
};

}  // namespace benchmarks::ordinary
