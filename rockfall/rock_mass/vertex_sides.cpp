#include "rockfall/rock_mass/vertex_sides.hpp"

#include <algorithm>

namespace rockfall::rock_mass {

void find_sides(const PlacedBlock& foundation, const PlacedBlock& body, VertexSides& sides) {
    std::fill_n(sides.outside.begin(), body.vertices_m.size(), 0);
    std::array<double, most_faces> highest_m;
    for (std::size_t f = 0; f < foundation.faces.size(); ++f) {
        const Plane3& face = foundation.faces[f];
        // The sphere says most of it.
        const double centre_m = face.height_m(body.centre_m);
        highest_m[f] = centre_m + body.radius_m;
        double lowest_m = centre_m - body.radius_m;
        if (highest_m[f] <= 0.0) {
            sides.separation_m = std::max(sides.separation_m, lowest_m);
            continue;
        }
        lowest_m = std::numeric_limits<double>::infinity();
        highest_m[f] = -lowest_m;
        for (std::size_t v = 0; v < body.vertices_m.size(); ++v) {
            const double height_m = face.height_m(body.vertices_m[v]);
            lowest_m = std::min(lowest_m, height_m);
            highest_m[f] = std::max(highest_m[f], height_m);
            sides.outside[v] |= static_cast<std::uint64_t>(height_m > 0.0) << f;
        }
        if (lowest_m > sides.separation_m) {
            sides.second_separation_m = sides.separation_m;
            sides.second_face = sides.highest_face;
            sides.separation_m = lowest_m;
            sides.highest_face = static_cast<std::uint16_t>(f);
            if (lowest_m >= 0.0) {
                return;
            }
        } else if (lowest_m > sides.second_separation_m) {
            sides.second_separation_m = lowest_m;
            sides.second_face = static_cast<std::uint16_t>(f);
        }
    }
    for (std::size_t f = 0; f < foundation.faces.size(); ++f) {
        sides.near |= static_cast<std::uint64_t>(highest_m[f] >= sides.separation_m) << f;
    }
}

}  // namespace rockfall::rock_mass
