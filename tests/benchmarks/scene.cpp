#include "tests/benchmarks/scene.hpp"

#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include "config/grid/ascii_grid.hpp"
#include "config/random/stream.hpp"
#include "config/table/table.hpp"
#include "rockfall/parameters.hpp"

namespace benchmarks {
namespace {

constexpr std::uint64_t rocks_of_bench_slope = 10'000;
constexpr double slope_deg = 38.0;
constexpr double roughness_m = 0.3;

std::string text_of(const std::string& name) {
    const std::string path = std::string{BENCHMARK_DATA_DIR} + "/bench_slope/" + name;
    std::ifstream in{path};
    std::ostringstream text;
    text << in.rdbuf();
    if (!in) {
        throw std::runtime_error{"cannot read " + path};
    }
    return text.str();
}

/// Columns of numbers of a table of bench_slope.
std::vector<std::vector<double>> numbers_of(const std::string& name,
                                            const std::vector<std::string>& columns) {
    std::istringstream in{text_of(name)};
    const config::Table table = config::Table::read(in, name);
    std::vector<std::vector<double>> rows(table.rows());
    for (std::size_t row = 0; row < table.rows(); ++row) {
        for (const std::string& column : columns) {
            rows[row].push_back(std::stod(table.text(row, column)));
        }
    }
    return rows;
}

/// Height of the fir of bench_slope with a DBH.
double tree_height_m(double dbh_cm) {
    const double ratio = dbh_cm / (1.5 + 0.17 * dbh_cm);
    return 1.3 + ratio * ratio * ratio;
}

rockfall::ReleaseSource point_source(double x_m, double y_m, const rockfall::Terrain& terrain) {
    rockfall::ReleaseSource source;
    source.kind = rockfall::ReleaseSource::Kind::line;
    source.first_m = source.last_m = Eigen::Vector2d{x_m, y_m} - terrain.origin_m();
    return source;
}

config::RandomStream chance(std::uint64_t id) {
    return {key_of(id), config::Purpose::test};
}

}  // namespace

rockfall::FallLaw compared_law() {
    const auto degrees = [](double angle_deg) { return config::Angle::from_degrees(angle_deg); };
    rockfall::FallLaw law;
    law.motion.of<rockfall::picus::Model>().jump_angle.scatter = 0.0;
    law.motion.of<rockfall::picus::Model>().blend_steep_impacts = false;
    law.motion.of<rockfall::picus::Model>().lateral = {degrees(10.0), degrees(10.0), 10.0};
    law.tree.taper = false;
    law.tree.height_effect = false;
    law.tree.deviation = rockfall::shipped_deviation_matrix();
    return law;
}

rockfall::SurfaceType compared_ground() {
    rockfall::SurfaceType ground;
    ground.code = 1;
    ground.label = "bench ground";
    ground.restitution = {0.30, 0.75};
    ground.stopping = rockfall::StopCurve{{{1.0, 0.02}}};
    return ground;
}

rockfall::StartLaw compared_start() {
    rockfall::StartLaw start;
    start.diameter = rockfall::DiameterLaw::fixed(0.95);
    return start;
}

config::Raster<double> bench_heights() {
    return config::read_ascii_grid(text_of("dem.asc"), "dem.asc");
}

std::vector<rockfall::Stem> bench_trees() {
    std::vector<rockfall::Stem> stems;
    for (const auto& row : numbers_of("trees.csv", {"x", "y", "dbh_cm"})) {
        stems.push_back({row[0], row[1], row[2], tree_height_m(row[2]), 1.0});
    }
    return stems;
}

std::vector<rockfall::ReleaseSource> bench_sources(const rockfall::Terrain& terrain) {
    std::vector<rockfall::ReleaseSource> sources;
    for (const auto& row : numbers_of("release.csv", {"x", "y"})) {
        sources.push_back(point_source(row[0], row[1], terrain));
    }
    rockfall::allot(sources, rocks_of_bench_slope);
    return sources;
}

rockfall::Slope slope_of(rockfall::Terrain terrain) {
    return {std::move(terrain), rockfall::SurfaceMap::uniform(rockfall::SurfaceId{0}), {compared_ground()}};
}

std::vector<rockfall::RockStart> starts_of(const rockfall::Slope& slope,
                                           const std::vector<rockfall::ReleaseSource>& sources) {
    const rockfall::StartLaw law = compared_start();
    std::vector<rockfall::RockStart> starts;
    for (std::uint32_t i = 0; i < sources.size(); ++i) {
        for (std::uint32_t k = 0; k < sources[i].rocks; ++k) {
            starts.push_back(
                rockfall::start_of(slope, sources[i], i, law, key_of(sources[i].first_rock + k)).value());
        }
    }
    return starts;
}

config::Raster<double> rough_plane(double length_m, double width_m, double cell_m) {
    const double fall = std::tan(config::Angle::from_degrees(slope_deg).in_radians());
    config::Raster<double> heights{
        {static_cast<int>(length_m / cell_m), static_cast<int>(width_m / cell_m), 0.0, 0.0, cell_m, cell_m}};
    config::RandomStream stream = chance(1);
    for (std::size_t i = 0; i < heights.values.size(); ++i) {
        // Box and Muller: one normal deviate from two uniform ones.
        const double radius = std::sqrt(-2.0 * std::log(1.0 - stream.uniform()));
        const double normal = radius * std::cos(2.0 * std::numbers::pi * stream.uniform());
        const double x_m = heights.frame.x_centre_m(heights.frame.cell_of(i).column);
        heights.values[i] = 1500.0 - fall * x_m + roughness_m * normal;
    }
    return heights;
}

std::vector<rockfall::Stem> random_trees(double length_m, double width_m, std::size_t count) {
    const std::vector<rockfall::Stem> models = bench_trees();
    config::RandomStream stream = chance(3);
    std::vector<rockfall::Stem> stems;
    for (std::size_t i = 0; i < count; ++i) {
        rockfall::Stem stem = models[i % models.size()];
        stem.x_m = length_m * stream.uniform();
        stem.y_m = width_m * stream.uniform();
        stems.push_back(stem);
    }
    return stems;
}

std::vector<rockfall::ReleaseSource> edge_sources(const rockfall::Terrain& terrain, double width_m,
                                                  std::uint64_t rocks) {
    std::vector<rockfall::ReleaseSource> sources;
    for (double y_m = 52.5; y_m < width_m - 50.0; y_m += 5.0) {
        sources.push_back(point_source(11.25, y_m, terrain));
    }
    rockfall::allot(sources, rocks);
    return sources;
}

config::GridFrame map_frame(const config::GridFrame& frame, const rockfall::Terrain& terrain) {
    config::GridFrame shifted = frame;
    shifted.x_west_m -= terrain.origin_m().x();
    shifted.y_south_m -= terrain.origin_m().y();
    return shifted;
}

}  // namespace benchmarks
