#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "config/grid/raster.hpp"
#include "rockfall/obstacles/stem.hpp"
#include "rockfall/release/release.hpp"
#include "rockfall/slope/slope.hpp"
#include "rockfall/trajectory.hpp"

namespace benchmarks {

/// Where rocks begin and under which law they fall, common to every program that is compared.
///
/// The law is that of performance.md section 2, which is the preset `strict` with the chance to stop:
/// r_n 0.30, r_t 0.75 +- 0.05, damping with v^-1/4 above 10 m/s, jump angle 80 v^-0.74 deg capped at 60,
/// lateral turn within +- 10 deg, 2 % of the impacts stop the rock, rolling friction 0.5; stems of DBH at
/// every height. No contact zone, no scatter of the jump angle, no blend of steep impacts.
rockfall::FallLaw compared_law();
rockfall::SurfaceType compared_ground();
/// 0.95 m, 2700 kg/m3, 1.5 m above ground, 3 m/s down the fall line.
rockfall::StartLaw compared_start();

/// The files of data/bench_slope.
config::Raster<double> bench_heights();
std::vector<rockfall::Stem> bench_trees();
/// Its release points in coordinates of the terrain; 10 000 rocks, 625 from each.
std::vector<rockfall::ReleaseSource> bench_sources(const rockfall::Terrain& terrain);

/// A slope of the compared ground over a terrain.
rockfall::Slope slope_of(rockfall::Terrain terrain);
/// bench_slope as a TIN of about half of its cells, those that matter most, which is the mesh that the goals
/// speak of. Built once.
const rockfall::Slope& bench_slope();
/// bench_slope with every cell as a vertex, as the program does it by default. Built once.
const rockfall::Slope& full_bench_slope();

/// The starts of all rocks of the sources.
std::vector<rockfall::RockStart> starts_of(const rockfall::Slope& slope,
                                           const std::vector<rockfall::ReleaseSource>& sources);

/// A slope of 38 deg that falls towards +x, with independent roughness of 0.3 m on every cell, as
/// bench_slope.
config::Raster<double> rough_plane(double length_m, double width_m, double cell_m);
/// The same with half of its cells, chosen at random, as vertices.
rockfall::Terrain thinned_rough_plane(double length_m, double width_m, double cell_m);
/// Stems at random places over such a plane, with the diameters of bench_slope.
std::vector<rockfall::Stem> random_trees(double length_m, double width_m, std::size_t count);
/// Points every 5 m along the upper edge of such a plane, in coordinates of the terrain.
std::vector<rockfall::ReleaseSource> edge_sources(const rockfall::Terrain& terrain, double width_m,
                                                  std::uint64_t rocks);

/// The key of every random number of a rock.
inline config::StreamKey key_of(std::uint64_t rock) {
    return {20260101, 0, 0, rock};
}

/// The cells of the maps: those of a raster, in coordinates of the terrain.
config::GridFrame map_frame(const config::GridFrame& frame, const rockfall::Terrain& terrain);

}  // namespace benchmarks
