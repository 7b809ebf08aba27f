#include "coupling/inputs/terrain/contact_notes.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/plausible/terrain/limits.hpp"
#include "coupling/inputs/plausible/terrain/walls.hpp"

namespace coupling {
namespace {

/// Sums over the cells of one ground type.
struct NoiseOfGround {
    double noise_m = 0.0;
    double radius_m = 0.0;
    std::size_t cells = 0;
};

std::string hundredths(double sum, std::size_t count) {
    return config::to_text(std::round(100.0 * sum / static_cast<double>(count)) / 100.0);
}

/// Limits of the run, whatever the radius: a wall that its cells lean cannot be set upright.
void warn_of_leaned_walls(const HeightInput& heights, Reading& reading) {
    std::vector<double> noise_m;
    for (const rockfall::PointNoise& patch : heights.noise.patches()) {
        noise_m.push_back(patch.noise_m);
    }
    const auto middle = noise_m.begin() + static_cast<std::ptrdiff_t>(noise_m.size() / 2);
    std::nth_element(noise_m.begin(), middle, noise_m.end());
    const plausible::terrain::HeightField field = plausible::terrain::field_of(*heights.grid);
    const std::size_t walls = plausible::terrain::narrow_walls(field, *middle);
    if (walls >= plausible::terrain::limits::fewest_walls) {
        reading.warn(config::joined(
            heights.file, ": walls rise within one or two cells of ",
            config::to_text(std::round(10.0 * field.cell_m()) / 10.0), " m in ", std::to_string(walls),
            " places, which leans them: rocks may land too far out below; cells of at most 1 m keep walls"));
    }
}

}  // namespace

void note_contact_zone(const HeightInput& heights, const GroundMap& ground, const rockfall::ContactLaw& law,
                       Reading& reading) {
    if (heights.grid) {
        warn_of_leaned_walls(heights, reading);
    }
    if (law.given_radius_m) {
        return;
    }
    std::vector<NoiseOfGround> grounds(ground.types.size());
    const config::GridFrame& frame = ground.ids.frame;
    for (std::size_t i = 0; i < ground.ids.values.size(); ++i) {
        const std::uint8_t id = ground.ids.values[i];
        if (id < grounds.size()) {
            const config::Cell cell = frame.cell_of(i);
            const rockfall::PointNoise noise =
                heights.noise.at(frame.x_centre_m(cell.column), frame.y_centre_m(cell.row));
            grounds[id].noise_m += noise.noise_m;
            grounds[id].radius_m += law.radius_m(noise);
            ++grounds[id].cells;
        }
    }
    for (std::size_t id = 0; id < grounds.size(); ++id) {
        // What a note says has an effect: noise widened the zone beyond the size of the rocks.
        constexpr double rounding = 1.0 + 1e-9;
        if (const NoiseOfGround& of = grounds[id];
            of.radius_m > rounding * law.least_radius_m * static_cast<double>(of.cells)) {
            reading.note(config::joined("noise of the heights on ", config::in_quotes(ground.types[id].label),
                                        ": ", hundredths(of.noise_m, of.cells),
                                        " m; rocks feel the ground there as a plane within ",
                                        hundredths(of.radius_m, of.cells), " m"));
        }
    }
}

}  // namespace coupling
