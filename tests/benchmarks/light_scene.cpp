#include "tests/benchmarks/light_scene.hpp"

#include <cmath>

#include "config/random/stream.hpp"
#include "tests/benchmarks/scene.hpp"

namespace benchmarks {
namespace {

constexpr int columns = 80;
constexpr int rows = 50;
constexpr int trees = 40'000;
constexpr double column_m = 10.0;

config::RandomStream chance(std::uint64_t id) {
    return {key_of(id), config::Purpose::test};
}

}  // namespace

LightScene light_scene(bool deciduous) {
    LightScene scene;
    scene.ground.elevation_m = config::Raster<double>{{columns, rows, 0.0, 0.0, column_m, column_m}};
    const config::GridFrame& frame = scene.ground.elevation_m.frame;
    config::RandomStream stream = chance(31);
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            // 35 degrees facing south, with ribs and half a metre of roughness.
            const double along_m = frame.x_centre_m(column);
            scene.ground.elevation_m.at({column, row}) =
                0.7 * frame.y_centre_m(row) + 8.0 * std::sin(along_m / 60.0) + 0.5 * stream.uniform();
        }
    }
    for (int i = 0; i < trees; ++i) {
        forest::LightTree tree;
        tree.x_m = frame.x_east_m() * stream.uniform();
        tree.y_m = frame.y_north_m() * stream.uniform();
        // Tall and small trees in patches of half a hectare.
        const double group = 0.5 + 0.5 * std::sin(tree.x_m / 35.0) * std::sin(tree.y_m / 35.0);
        tree.height_m = 4.0 + 30.0 * group * stream.uniform();
        tree.crown_base_m = tree.height_m * (0.2 + 0.4 * stream.uniform());
        tree.crown_radius_m = 0.8 + 0.08 * tree.height_m;
        tree.leaf_area_m2 = 0.12 * tree.height_m * tree.height_m;
        tree.extinction = 0.55;
        tree.deciduous = deciduous && i % 3 == 0;
        scene.trees.push_back(tree);
    }
    for (std::size_t month = 0; month < 12; ++month) {
        scene.year.radiation.diffuse_mjpm2[month] =
            100.0 + 25.0 * std::min(static_cast<double>(month), 11.0 - static_cast<double>(month));
        scene.year.radiation.direct_mjpm2[month] =
            90.0 + 35.0 * std::min(static_cast<double>(month), 11.0 - static_cast<double>(month));
    }
    return scene;
}

forest::Sky light_sky(const LightScene& scene, double zone_height_deg) {
    forest::SkySettings settings;
    settings.latitude = config::Angle::from_degrees(47.0);
    settings.zone_height = config::Angle::from_degrees(zone_height_deg);
    return {settings, scene.year.radiation};
}

}  // namespace benchmarks
