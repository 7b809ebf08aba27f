#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "coupling/assessments/collapse/collapse_results.hpp"
#include "coupling/results/report/map/map_window.hpp"
#include "coupling/results/report/scene.hpp"
#include "coupling/results/report/scene_mass.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::collapse {
namespace {

using report::page_text;

/// Blocks and times of which a page keeps a size that browsers take.
constexpr std::size_t most_blocks_in_space = 4000;
constexpr std::size_t most_times_in_space = 41;

/// The largest blocks, by number.
std::vector<std::size_t> blocks_in_space(const CollapseResults& results) {
    std::vector<std::size_t> numbers(results.site.count.free);
    std::iota(numbers.begin(), numbers.end(), std::size_t{0});
    if (numbers.size() > most_blocks_in_space) {
        std::stable_sort(numbers.begin(), numbers.end(), [&](std::size_t a, std::size_t b) {
            return results.mass.blocks()[a].volume_m3 > results.mass.blocks()[b].volume_m3;
        });
        numbers.resize(most_blocks_in_space);
        std::sort(numbers.begin(), numbers.end());
    }
    return numbers;
}

report::SceneMass mass_in_space(const CollapseResults& results) {
    report::SceneMass mass;
    mass.all_blocks = results.site.count.free;
    const std::vector<std::size_t> blocks = blocks_in_space(results);
    for (const std::size_t i : blocks) {
        mass.blocks.push_back(results.site.blocks[i].solid.hull);
    }
    const std::size_t frames = results.record.frames.size();
    // At equal intervals, and the end.
    const std::size_t every =
        std::max<std::size_t>(1, (frames + most_times_in_space - 3) / (most_times_in_space - 1));
    const Eigen::Vector2d origin = results.site.origin_m;
    for (std::size_t k = 0; k < frames + every - 1; k += every) {
        const std::size_t f = std::min(k, frames - 1);
        mass.times_s.push_back(results.record.rows[f].time_s);
        std::vector<report::SceneBlockPlace>& places = mass.frames.emplace_back();
        for (const std::size_t i : blocks) {
            const BlockPlace& block = results.record.frames[f][i];
            report::SceneBlockPlace place{static_cast<double>(block.centre_m[0]) + origin.x(),
                                          static_cast<double>(block.centre_m[1]) + origin.y(),
                                          static_cast<double>(block.centre_m[2]),
                                          {},
                                          block.speed_mps};
            std::copy(std::begin(block.attitude), std::end(block.attitude), std::begin(place.attitude));
            places.push_back(place);
        }
    }
    return mass;
}

}  // namespace

config::Raster<double> dug_out(const CollapseSite& site) {
    config::Raster<double> heights = site.heights;
    for (std::size_t k = 0; k < heights.values.size(); ++k) {
        const config::Cell cell = heights.frame.cell_of(k);
        const double x =
            heights.frame.x_west_m + (cell.column + 0.5) * heights.frame.cell_width_m - site.origin_m.x();
        const double y =
            heights.frame.y_north_m() - (cell.row + 0.5) * heights.frame.cell_height_m - site.origin_m.y();
        double lowest_m = std::numeric_limits<double>::infinity();
        for (const std::uint32_t i : site.ground.prisms_in({x, y}, {x, y})) {
            const rockfall::rock_mass::GroundPrism& prism = site.ground.prisms()[i];
            const bool is_below = std::all_of(prism.sides.begin(), prism.sides.end(), [&](const auto& side) {
                return side.height_m({x, y, 0.0}) <= 1e-9;
            });
            if (is_below) {
                const Eigen::Vector3d& n = prism.top.normal;
                lowest_m = std::min(lowest_m, (prism.top.offset_m - n.x() * x - n.y() * y) / n.z());
            }
        }
        heights.values[k] = std::min(heights.values[k], lowest_m);
    }
    return heights;
}

std::string scene_of_page(const CollapseResults& results) {
    const config::Raster<double> ground = dug_out(results.site);
    const report::MapWindow window = report::window_around(ground.frame, [&](config::Cell cell) {
        const double x = ground.frame.x_west_m + (cell.column + 0.5) * ground.frame.cell_width_m;
        const double y = ground.frame.y_north_m() - (cell.row + 0.5) * ground.frame.cell_height_m;
        const config::Cell on_map = results.site.map_frame.cell_at(x, y);
        return results.site.map_frame.contains(on_map) &&
               results.record.cell_blocks[results.site.map_frame.index(on_map)] > 0.0;
    });
    const config::Raster<double> heights = report::part_of(ground, window);
    report::Scene scene{
        .heights = heights, .targets = results.site.targets, .origin_m = results.site.origin_m};
    const report::SceneMass mass = mass_in_space(results);
    scene.mass = &mass;
    scene.picture = results.site.picture.get();
    return report::scene_figure(scene,
                                page_text("This view needs scripts and WebGL; the views from the side and "
                                          "the maps show the mass without them."));
}

}  // namespace coupling::collapse
