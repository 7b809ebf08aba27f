#include <cmath>
#include <map>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "rockfall/motion/classical/friction.hpp"
#include "rockfall/motion/classical/model.hpp"

namespace rockfall::classical {
namespace {

using config::joined;

/// Plan area of a ground type, and of its parts that are steeper than its friction angle [m2].
struct GroundArea {
    double whole_m2 = 0.0;
    double steeper_m2 = 0.0;
};

std::map<const SurfaceType*, GroundArea> areas_of(const Slope& slope, const Law& law) {
    std::map<const SurfaceType*, GroundArea> areas;
    const auto vertices = slope.terrain.vertices();
    for (std::uint32_t i = 0; i < slope.terrain.triangles().size(); ++i) {
        const Triangle& triangle = slope.terrain.triangles()[i];
        const Vertex& a = vertices[triangle.corners[0]];
        const Vertex& b = vertices[triangle.corners[1]];
        const Vertex& c = vertices[triangle.corners[2]];
        const double area_m2 =
            0.5 * std::abs((b.x_m - a.x_m) * (c.y_m - a.y_m) - (c.x_m - a.x_m) * (b.y_m - a.y_m));
        const SurfaceType& ground =
            slope.type_at(i, (a.x_m + b.x_m + c.x_m) / 3.0, (a.y_m + b.y_m + c.y_m) / 3.0);
        const double tangent = slope.terrain.plane_of(i).gradient.norm();
        GroundArea& area = areas[&ground];
        area.whole_m2 += area_m2;
        area.steeper_m2 += tangent > friction_of(ground, law) ? area_m2 : 0.0;
    }
    return areas;
}

std::string whole_number(double value) {
    return std::to_string(std::lround(value));
}

}  // namespace

/// Grounds on whose slopes rocks slide without end, and grounds without a friction that the law asks for.
std::vector<std::string> Model::doubts(const Slope& slope, double, const Law& law) {
    std::string endless;
    std::string missing;
    const auto areas = areas_of(slope, law);
    for (const SurfaceType& ground : slope.types) {  // in the order of the list
        const auto found = areas.find(&ground);
        if (found == areas.end() || found->second.whole_m2 <= 0.0) {
            continue;
        }
        const double share = found->second.steeper_m2 / found->second.whole_m2;
        if (law.friction == Friction::from_rt && share > 0.5) {
            const double friction = std::round(100.0 * friction_of(ground, law)) / 100.0;
            endless += joined(endless.empty() ? "" : "; ", ground.label, " ", config::to_text(friction), ", ",
                              whole_number(100.0 * share), " % of it steeper");
        }
        if (law.friction == Friction::ground && !has_own_friction(ground)) {
            missing += joined(missing.empty() ? "" : ", ", ground.label);
        }
    }
    std::vector<std::string> sentences;
    if (!endless.empty()) {
        sentences.push_back(
            joined("classical: rocks that slide never stop on ground steeper than its friction, ", endless,
                   "; many leave the map. Take classical.friction = ground (`bannwald info surfaces`, "
                   "sliding_friction), or an r_t fitted to the site"));
    }
    if (!missing.empty()) {
        sentences.push_back(joined("classical: no sliding_friction and no soil for ", missing,
                                   "; their friction is (1 - r_t) / r_t"));
    }
    return sentences;
}

}  // namespace rockfall::classical
