// One rock falls down a slope: over bare ground, with a thin tree in its way, with a thick one.
//
// For those who build on the library `bannwald_rockfall`: no files, no settings, nothing of the program.
// The exit code is 1 if the rock gained energy or missed a tree.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <span>
#include <utility>
#include <vector>

#include "rockfall/parameters.hpp"
#include "rockfall/terrain/mesh.hpp"
#include "rockfall/trajectory.hpp"

using namespace rockfall;

/// Prints each impact and hit, and keeps the energy: translation, rotation and height.
struct Printer : NoObserver {
    std::vector<Eigen::Vector3d> impacts_m{};
    double speed_mps = 0.0;
    double energy_j = 0.0;
    double largest_rise_j = 0.0;

    void enter(const Rock& rock, double kinetic_j, double height_m) {
        const double now_j = kinetic_j + rock.mass_kg * config::gravity_mps2 * height_m;
        largest_rise_j = std::max(largest_rise_j, now_j - energy_j);
        energy_j = now_j;
    }
    void flew(const Rock& rock, const Flight& flight, double until_s, std::span<const Stretch>, double spin) {
        enter(rock, kinetic_energy_j(rock, flight.squared_speed_at(0.0), spin), flight.height_m(0.0));
        enter(rock, kinetic_energy_j(rock, flight.squared_speed_at(until_s), spin), flight.height_m(until_s));
        speed_mps = std::sqrt(flight.squared_speed_at(until_s));
    }
    void rolled(const Rock& rock, const RollingPiece& piece, std::uint32_t) {
        const double squared = piece.squared_speed_end();
        const double rotation_j = rotation_on_ground_j(rock, piece.slides, piece.own_end.rotation_j, squared);
        enter(rock, kinetic_energy_j(rock, squared, 0.0) + rotation_j,
              piece.position_m(piece.duration_s).z());
        speed_mps = std::sqrt(squared);
    }
    void impacted(const Eigen::Vector3d& place_m, int) {
        impacts_m.push_back(place_m);
        std::printf("%8zu %9.1f %8.1f %8.1f %9.1f\n", impacts_m.size(), place_m.x(), place_m.y(), place_m.z(),
                    speed_mps);
    }
    void met_stem(const Eigen::Vector3d&, const StemHit& hit, const TreeImpact& impact, double before_j) {
        std::printf("    tree: hit %.1f m above its foot, takes %.0f of %.0f kJ, %s\n", hit.height_m,
                    impact.loss_j / 1e3, before_j / 1e3, impact.broken ? "breaks" : "stands");
    }
};

int main() {
    // 1. The terrain: heights on a grid of 5 m. A slope of 36 degrees with humps of 0.4 m, 100 m long, then
    //    level ground. The triangles count metres from `terrain.origin_m()`.
    config::Raster<double> heights{{.columns = 60, .rows = 20, .cell_width_m = 5.0, .cell_height_m = 5.0}};
    for (std::size_t i = 0; i < heights.values.size(); ++i) {
        const config::Cell cell = heights.frame.cell_of(i);
        const double x_m = heights.frame.x_centre_m(cell.column);
        const double hump_m = 0.4 * std::sin(x_m / 8.0) * std::cos(0.5 * cell.row);
        heights.values[i] = 1000.0 - 0.73 * std::min(x_m, 120.0) + hump_m;
    }

    // 2. The ground: one type, fine debris, where one impact in a hundred stops a rock.
    SurfaceType debris;
    debris.restitution = {.normal = 0.30, .tangential = 0.75};
    debris.stopping = StopCurve{{{1.0, 0.01}}};  // one knot: the same for any diameter
    const Slope slope{triangulate(heights, 0.0), SurfaceMap::uniform(SurfaceId{0}), {debris}};
    const Terrain& terrain = slope.terrain;

    // 3. The laws of motion and of trees, as the program has them by default.
    const FallLaw law = Parameters{}.fall;

    // 4. The rock: a sphere of 0.8 m, released 1 m above the ground at walking pace.
    RockStart start;
    start.rock = Rock::sphere(0.8, 2700.0);
    const Eigen::Vector2d place_m = Eigen::Vector2d{20.0, 50.0} - terrain.origin_m();
    start.triangle = terrain.locate(place_m.x(), place_m.y()).value();
    start.position_m = {place_m.x(), place_m.y(), terrain.height_m(place_m.x(), place_m.y()).value() + 1.0};
    start.velocity_mps = {1.5, 0.0, 0.0};

    // 5. One fall. Chance depends on this key alone: the same key gives the same fall.
    const config::StreamKey key{.seed = 1, .replicate = 0, .year = 0, .id = start.id};
    FallScratch scratch;
    const auto simulate_fall = [&](const Obstacles& obstacles) {
        Printer printer;
        printer.energy_j = kinetic_energy_j(start.rock, start.velocity_mps.squaredNorm(), 0.0) +
                           start.rock.mass_kg * config::gravity_mps2 * start.position_m.z();
        std::printf("  impact       x_m      y_m      z_m speed_mps\n");
        const FallEnd end = fall(slope, obstacles, law, key, start, scratch, printer);
        std::printf("    end: x = %.1f m, y = %.1f m, hits on trees: %u\n", end.position_m.x(),
                    end.position_m.y(), end.tree_hits);
        return std::pair{end, printer};
    };
    std::puts("without tree");
    const auto [bare_end, bare] = simulate_fall({});

    // 6. A tree stands where that rock touched the ground for the fifth time. Stems have coordinates of the
    //    map; the index finds them by place.
    const Eigen::Vector2d foot_m = bare.impacts_m.at(4).head<2>() + terrain.origin_m();
    double largest_rise_j = bare.largest_rise_j;
    bool is_hit = true;
    for (const double dbh_cm : {12.0, 50.0}) {
        std::printf("with a tree of %.0f cm\n", dbh_cm);
        const std::vector<Stem> stems{
            {.x_m = foot_m.x(), .y_m = foot_m.y(), .dbh_cm = dbh_cm, .height_m = 0.6 * dbh_cm}};
        const StemIndex index{stems, terrain, start.rock.radius_m, law.tree.taper};
        const auto [end, among_trees] = simulate_fall({.stems = &index});
        largest_rise_j = std::max(largest_rise_j, among_trees.largest_rise_j);
        is_hit = is_hit && end.tree_hits > 0;
    }

    // 7. What must hold: ground and trees only take energy. The bound is rounding, at seven million joules.
    const bool is_right = largest_rise_j < 1e-3 && is_hit && bare_end.tree_hits == 0;
    std::printf("largest rise of energy: %.0e J: %s\n", largest_rise_j, is_right ? "right" : "WRONG");
    return is_right ? 0 : 1;
}
