#include "coupling/commands/estimate.hpp"

#include <algorithm>
#include <limits>

#include "rockfall/obstacles/stem_index.hpp"
#include "rockfall/tally/cell_histograms.hpp"
#include "rockfall/tally/ensemble_tally.hpp"

namespace coupling {

namespace {

/// A rock touches the ground about once in this length of path, at the jumps of the model on middle slopes.
constexpr double path_per_impact_m = 6.0;
/// Sine of the mean slope of a whole path, near the usual energy-line angle.
constexpr double path_steepness = 0.55;
/// Time of an impact with the flight before it and its entries in the maps, measured on the shipped example.
constexpr double seconds_per_impact = 0.6e-6;

/// Mean height of the sources over the lowest ground.
double mean_drop_m(const Site& site) {
    double lowest_m = std::numeric_limits<double>::infinity();
    for (const rockfall::Vertex& vertex : site.slope.terrain.vertices()) {
        lowest_m = std::min(lowest_m, vertex.z_m);
    }
    double sum_m = 0.0;
    std::size_t found = 0;
    for (const rockfall::ReleaseSource& source : site.sources) {
        const Eigen::Vector2d middle_m = 0.5 * (source.first_m + source.last_m);
        if (const auto height_m = site.slope.terrain.height_m(middle_m.x(), middle_m.y())) {
            sum_m += *height_m - lowest_m;
            ++found;
        }
    }
    return found == 0 ? 0.0 : sum_m / static_cast<double>(found);
}

std::uint64_t terrain_bytes(const Site& site) {
    const auto triangles = site.slope.terrain.triangles().size();
    constexpr std::size_t bytes_of_start_grid = 24;  // a triangle in about three lists, and the lists' heads
    return site.slope.terrain.vertices().size() * sizeof(rockfall::Vertex) +
           triangles * (sizeof(rockfall::Triangle) + bytes_of_start_grid) +
           site.heights.values.size() * (sizeof(double) + 2 * sizeof(std::uint8_t)) +
           site.trees.size() * (sizeof(TreeRecord) + sizeof(rockfall::PlacedStem) + sizeof(rockfall::Stem)) +
           site.sources.size() * sizeof(rockfall::ReleaseSource);
}

}  // namespace

Estimate estimate_of(const Scenario& scenario, const Site& site, int threads) {
    Estimate estimate;
    estimate.rocks = site.sources.empty() ? 0 : site.sources.back().first_rock + site.sources.back().rocks;
    estimate.covers = site.trees.empty() ? 1 : 2;
    const auto covers = static_cast<std::uint64_t>(estimate.covers);
    estimate.terrain_bytes = terrain_bytes(site);
    // Every worker has sums for both covers, and all of them are added up once more.
    estimate.map_bytes = site.map_frame.size() * sizeof(rockfall::CellSums) * rockfall::covers *
                         (static_cast<std::uint64_t>(threads) + 1);
    estimate.percentile_bytes =
        scenario.percentiles ? covers * rockfall::CellHistograms::largest_bytes(site.map_frame) : 0;
    const double impacts = mean_drop_m(site) / path_steepness / path_per_impact_m;
    estimate.seconds = static_cast<double>(estimate.rocks * covers) * impacts * seconds_per_impact / threads;
    return estimate;
}

}  // namespace coupling
