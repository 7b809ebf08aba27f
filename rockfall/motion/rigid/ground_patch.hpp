#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "rockfall/motion/rigid/bumps.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace rockfall::rigid {

/// A triangle of the ground near a block, with its plane and its edges in plan.
struct NearTriangle {
    Eigen::Vector3d normal;  ///< unit, upwards
    double offset_m;         ///< the plane is normal . x = offset_m
    /// Signed distance in plan of a point from edge k, positive inside: x . edges[k].head<2>() +
    /// edges[k].z().
    Eigen::Vector3d edges[3];
    Eigen::Vector3d corners_m[3];
    std::uint32_t corners[3];  ///< the same number is the same place, within a patch
    std::uint32_t number;      ///< of the terrain's triangle

    [[nodiscard]] double gap_m(const Eigen::Vector3d& point_m) const {
        return normal.dot(point_m) - offset_m;
    }
    /// How far a point lies outside in plan; negative inside [m].
    [[nodiscard]] double outside_m(const Eigen::Vector3d& point_m) const {
        const double a = edges[0].x() * point_m.x() + edges[0].y() * point_m.y() + edges[0].z();
        const double b = edges[1].x() * point_m.x() + edges[1].y() * point_m.y() + edges[1].z();
        const double c = edges[2].x() * point_m.x() + edges[2].y() * point_m.y() + edges[2].z();
        return -(a < b ? (a < c ? a : c) : (b < c ? b : c));
    }
};

/// An edge of the ground that bends outwards, where an edge of a block can cross it.
struct NearRidge {
    Eigen::Vector3d from_m;
    Eigen::Vector3d along_m;  ///< from there to the other end
    Eigen::Vector3d left_normal;
    Eigen::Vector3d right_normal;
    std::uint32_t triangle;  ///< of the terrain, on its left
};

/// A vertex of the ground at which some edge bends outwards, where a face of a block can rest.
struct NearPeak {
    Eigen::Vector3d point_m;
    std::uint32_t first_neighbour;  ///< in the list of neighbours
    std::uint32_t neighbours;
    std::uint32_t triangle;
};

/// Memory that patches reuse: which triangles were looked at.
struct PatchMarks {
    std::vector<std::uint32_t> marks;
    std::uint32_t present = 0;
    std::vector<std::uint32_t> queue;

    void begin(std::size_t triangles) {
        if (marks.size() != triangles || ++present == 0) {
            marks.assign(triangles, 0);
            present = 1;
        }
    }
    bool first_look(std::uint32_t triangle) {
        if (marks[triangle] == present) {
            return false;
        }
        marks[triangle] = present;
        return true;
    }
};

/// Calls visit(number, triangle) for each triangle that comes within `reach_m` in plan of the straight piece
/// between two points, found from the triangle under the first. Holes of the terrain may hide triangles
/// beyond them.
template <class Visit>
void each_triangle_near(const Terrain& terrain, std::uint32_t under, const Eigen::Vector2d& from_m,
                        const Eigen::Vector2d& to_m, double reach_m, PatchMarks& memory, Visit&& visit);

/// The ground around a block: triangles, ridges and peaks within a circle in plan.
class GroundPatch {
public:
    /// Requires `under`: the triangle under the centre.
    void gather(const Terrain& terrain, const Bumps& bumps, std::uint32_t under,
                const Eigen::Vector2d& centre_m, double radius_m, PatchMarks& memory);

    /// Whether a circle lies within the patch.
    [[nodiscard]] bool covers(const Eigen::Vector2d& centre_m, double radius_m) const {
        const double spare_m = radius_m_ - radius_m;
        return spare_m >= 0.0 && (centre_m - centre_m_).squaredNorm() <= spare_m * spare_m;
    }
    /// Forgets what was gathered.
    void clear() { radius_m_ = -1.0; }

    [[nodiscard]] std::span<const NearTriangle> triangles() const { return triangles_; }
    [[nodiscard]] std::span<const NearRidge> ridges() const { return ridges_; }
    [[nodiscard]] std::span<const NearPeak> peaks() const { return peaks_; }
    [[nodiscard]] std::span<const Eigen::Vector3d> neighbours(const NearPeak& peak) const {
        return std::span{neighbours_}.subspan(peak.first_neighbour, peak.neighbours);
    }

private:
    void add_triangle(const Terrain& terrain, std::uint32_t number);
    void add_with_bumps(const Terrain& terrain, const Bumps& bumps, std::uint32_t number);
    void add_facet(std::span<const Eigen::Vector3d> polygon_m, const Eigen::Vector3d& normal,
                   std::uint32_t number);
    std::uint32_t welded(const Eigen::Vector3d& corner_m);
    void find_ridges();
    void find_peaks();

    Eigen::Vector2d centre_m_ = Eigen::Vector2d::Zero();
    double radius_m_ = -1.0;
    std::vector<NearTriangle> triangles_;
    std::vector<NearRidge> ridges_;
    std::vector<NearPeak> peaks_;
    std::vector<Eigen::Vector3d> neighbours_;
    std::vector<std::uint32_t> ridge_ends_;   ///< numbers of corners
    std::vector<Eigen::Vector3d> corners_m_;  ///< of facets with bumps, by their number
    Bumps::Nodes nodes_;
};

/// Squared distance of a point from a straight piece in plan.
inline double squared_distance_m2(const Eigen::Vector2d& point_m, const Eigen::Vector2d& from_m,
                                  const Eigen::Vector2d& to_m) {
    const Eigen::Vector2d along_m = to_m - from_m;
    const double squared_length = along_m.squaredNorm();
    const double share = squared_length > 0.0 ? along_m.dot(point_m - from_m) / squared_length : 0.0;
    return (point_m - from_m - (share <= 0.0 ? 0.0 : share >= 1.0 ? 1.0 : share) * along_m).squaredNorm();
}

/// Whether two straight pieces in plan come within a distance of each other.
inline bool come_near(const Eigen::Vector2d& a_m, const Eigen::Vector2d& b_m, const Eigen::Vector2d& c_m,
                      const Eigen::Vector2d& d_m, double distance_m) {
    const auto side = [](const Eigen::Vector2d& p, const Eigen::Vector2d& q, const Eigen::Vector2d& r) {
        return (q.x() - p.x()) * (r.y() - p.y()) - (q.y() - p.y()) * (r.x() - p.x());
    };
    if (side(a_m, b_m, c_m) * side(a_m, b_m, d_m) < 0.0 && side(c_m, d_m, a_m) * side(c_m, d_m, b_m) < 0.0) {
        return true;
    }
    const double squared = distance_m * distance_m;
    return squared_distance_m2(a_m, c_m, d_m) <= squared || squared_distance_m2(b_m, c_m, d_m) <= squared ||
           squared_distance_m2(c_m, a_m, b_m) <= squared || squared_distance_m2(d_m, a_m, b_m) <= squared;
}

template <class Visit>
void each_triangle_near(const Terrain& terrain, std::uint32_t under, const Eigen::Vector2d& from_m,
                        const Eigen::Vector2d& to_m, double reach_m, PatchMarks& memory, Visit&& visit) {
    const std::span<const Triangle> triangles = terrain.triangles();
    const std::span<const Vertex> vertices = terrain.vertices();
    memory.begin(triangles.size());
    memory.queue.clear();
    memory.queue.push_back(under);
    memory.first_look(under);
    for (std::size_t next = 0; next < memory.queue.size(); ++next) {
        const std::uint32_t number = memory.queue[next];
        const Triangle& triangle = triangles[number];
        visit(number, triangle);
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t beyond = triangle.neighbours[k];
            if (beyond == no_triangle || memory.marks[beyond] == memory.present) {
                continue;
            }
            const Vertex& a = vertices[triangle.corners[k]];
            const Vertex& b = vertices[triangle.corners[(k + 1) % 3]];
            if (come_near({a.x_m, a.y_m}, {b.x_m, b.y_m}, from_m, to_m, reach_m)) {
                memory.first_look(beyond);
                memory.queue.push_back(beyond);
            }
        }
    }
}

}  // namespace rockfall::rigid
