#include "coupling/inputs/terrain/contact_notes.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"

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

}  // namespace

void note_contact_zone(const HeightInput& heights, const GroundMap& ground, const rockfall::ContactLaw& law,
                       Reading& reading) {
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
        if (const NoiseOfGround& of = grounds[id]; of.cells > 0) {
            reading.note(config::joined("noise of the heights on ", ground.types[id].label, ": ",
                                        hundredths(of.noise_m, of.cells),
                                        " m; rocks feel the ground there as a plane within ",
                                        hundredths(of.radius_m, of.cells), " m"));
        }
    }
}

}  // namespace coupling
