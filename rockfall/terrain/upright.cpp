#include "rockfall/terrain/upright.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

namespace rockfall {
namespace {

/// Vertices that hang together, by union of sets.
class Walls {
public:
    explicit Walls(std::size_t vertices) : above_(vertices) {
        std::iota(above_.begin(), above_.end(), std::uint32_t{0});
    }
    std::uint32_t of(std::uint32_t vertex) {
        while (above_[vertex] != vertex) {
            above_[vertex] = above_[above_[vertex]];
            vertex = above_[vertex];
        }
        return vertex;
    }
    void join(std::uint32_t a, std::uint32_t b) { above_[of(a)] = of(b); }

private:
    std::vector<std::uint32_t> above_;
};

struct Heights {
    double low_m = std::numeric_limits<double>::infinity();
    double high_m = -std::numeric_limits<double>::infinity();
};

}  // namespace

Eigen::Vector3d area2_of(const Tin& tin, const TinFace& face) {
    const Eigen::Vector3d& a = tin.vertices_m[face.corners[0]];
    const Eigen::Vector3d ab = tin.vertices_m[face.corners[1]] - a;
    const Eigen::Vector3d ac = tin.vertices_m[face.corners[2]] - a;
    return {ab.y() * ac.z() - ab.z() * ac.y(), ab.z() * ac.x() - ab.x() * ac.z(),
            ab.x() * ac.y() - ab.y() * ac.x()};
}

bool is_upright(const Tin& tin, const TinFace& face) {
    // What leans outwards however little, but more than rounding does, is steep ground and stays as it is.
    constexpr double rounding = 1e-6;
    const Eigen::Vector3d area2 = area2_of(tin, face);
    const double length = area2.norm();
    return area2.z() <= rounding * length && area2.z() >= -upright_tolerance * length;
}

void lean_upright_faces(Tin& tin, TinChanges& changes) {
    std::vector<std::uint32_t> upright;
    for (std::uint32_t f = 0; f < tin.faces.size(); ++f) {
        if (is_upright(tin, tin.faces[f])) {
            upright.push_back(f);
        }
    }
    changes.leaned = upright.size();
    if (upright.empty()) {
        return;
    }
    Walls walls{tin.vertices_m.size()};
    std::map<std::uint32_t, Eigen::Vector2d> outwards;  // by vertex, sum over its upright faces by area
    for (const std::uint32_t f : upright) {
        const TinFace& face = tin.faces[f];
        const Eigen::Vector2d normal = area2_of(tin, face).head<2>();
        for (const std::uint32_t corner : face.corners) {
            walls.join(corner, face.corners[0]);
            outwards.try_emplace(corner, Eigen::Vector2d::Zero()).first->second += normal;
        }
    }
    std::map<std::uint32_t, Heights> heights;
    for (const auto& [vertex, normal] : outwards) {
        Heights& wall = heights[walls.of(vertex)];
        wall.low_m = std::min(wall.low_m, tin.vertices_m[vertex].z());
        wall.high_m = std::max(wall.high_m, tin.vertices_m[vertex].z());
    }
    for (const auto& [vertex, normal] : outwards) {
        const Heights& wall = heights[walls.of(vertex)];
        const double length = normal.norm();
        const double height_m = wall.high_m - wall.low_m;
        if (length > 0.0 && height_m > 0.0) {
            const double lean_m = upright_lean_m * (tin.vertices_m[vertex].z() - wall.low_m) / height_m;
            tin.vertices_m[vertex].head<2>() -= lean_m / length * normal;
            changes.largest_lean_m = std::max(changes.largest_lean_m, lean_m);
        }
    }
}

}  // namespace rockfall
