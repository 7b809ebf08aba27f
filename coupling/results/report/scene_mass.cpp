#include "coupling/results/report/scene_mass.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "coupling/page_scripts/json_text.hpp"

namespace coupling::report {
namespace {

using page_scripts::json_numbers;
using page_scripts::json_packed;
using page_scripts::JsonObject;

/// Whole numbers of two bytes that places and attitudes become.
constexpr double most_steps = 65'534.0;

std::uint16_t step_of(double share) {
    return static_cast<std::uint16_t>(std::clamp(std::round(share * most_steps), 0.0, most_steps));
}

/// The range of a coordinate over all frames.
struct PlaceRange {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void add(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    [[nodiscard]] double width() const { return std::max(high - low, 1e-6); }
    [[nodiscard]] std::string json(double from) const {
        return JsonObject{}.number("low", low - from).number("step", width() / most_steps).json();
    }
};

}  // namespace

std::uint8_t block_speed_class(double speed_mps) {
    return static_cast<std::uint8_t>(std::count_if(std::begin(block_speed_bounds_mps),
                                                   std::end(block_speed_bounds_mps),
                                                   [&](double bound) { return speed_mps >= bound; }));
}

std::string hull_json(const rockfall::solids::Hull& hull) {
    std::vector<double> vertices;
    for (const Eigen::Vector3d& vertex_m : hull.vertices_m) {
        for (const double part_m : vertex_m) {
            vertices.push_back(std::round(1e2 * part_m) / 1e2);
        }
    }
    std::vector<double> faces;
    for (const rockfall::solids::Face& face : hull.faces) {
        for (std::size_t k = 1; k + 1 < face.corners.size(); ++k) {
            for (const std::uint32_t corner : {face.corners[0], face.corners[k], face.corners[k + 1]}) {
                faces.push_back(static_cast<double>(corner));
            }
        }
    }
    return JsonObject{}.add("vertices", json_numbers(vertices)).add("faces", json_numbers(faces)).json();
}

std::string mass_json(const SceneMass& mass, double west_m, double south_m, double low_m) {
    std::array<PlaceRange, 3> ranges;
    for (const auto& frame : mass.frames) {
        for (const SceneBlockPlace& place : frame) {
            ranges[0].add(place.x_m);
            ranges[1].add(place.y_m);
            ranges[2].add(place.z_m);
        }
    }
    std::vector<std::uint16_t> places, attitudes;
    std::vector<std::uint8_t> speeds;
    for (const auto& frame : mass.frames) {
        for (const SceneBlockPlace& place : frame) {
            const std::array<double, 3> at{place.x_m, place.y_m, place.z_m};
            for (std::size_t k = 0; k < 3; ++k) {
                places.push_back(step_of((at[k] - ranges[k].low) / ranges[k].width()));
            }
            for (const float part : place.attitude) {
                attitudes.push_back(step_of(0.5 * (static_cast<double>(part) + 1.0)));
            }
            speeds.push_back(block_speed_class(static_cast<double>(place.speed_mps)));
        }
    }
    std::vector<std::string> blocks;
    for (const rockfall::solids::Hull& hull : mass.blocks) {
        blocks.push_back(hull_json(hull));
    }
    return JsonObject{}
        .add("times_s", json_numbers(mass.times_s))
        .add("bounds_mps", json_numbers(block_speed_bounds_mps))
        .add("blocks", page_scripts::json_array(blocks))
        .number("all_blocks", static_cast<double>(mass.all_blocks))
        .add("x", ranges[0].json(west_m))
        .add("y", ranges[1].json(south_m))
        .add("z", ranges[2].json(low_m))
        .add("places", json_packed(places))
        .add("attitudes", json_packed(attitudes))
        .add("speeds", json_packed(speeds))
        .json();
}

}  // namespace coupling::report
