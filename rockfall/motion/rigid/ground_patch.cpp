#include "rockfall/motion/rigid/ground_patch.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "rockfall/solids/ground_contact.hpp"

namespace rockfall::rigid {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

Vector3d place_of_vertex(const Terrain& terrain, std::uint32_t number) {
    const Vertex& v = terrain.vertices()[number];
    return {v.x_m, v.y_m, v.z_m};
}

Vector3d normal_of(const Vector3d (&corners_m)[3]) {
    return (corners_m[1] - corners_m[0]).cross(corners_m[2] - corners_m[0]).normalized();
}

/// The same number from both sides of an edge, up to its sign: no point falls between two triangles.
void set_edges(NearTriangle& near) {
    for (int k = 0; k < 3; ++k) {
        const bool forward = near.corners[k] < near.corners[(k + 1) % 3];
        const Vector3d& a = near.corners_m[forward ? k : (k + 1) % 3];
        const Vector3d& b = near.corners_m[forward ? (k + 1) % 3 : k];
        const Vector2d inwards = Vector2d{a.y() - b.y(), b.x() - a.x()}.normalized();
        const Vector3d line{inwards.x(), inwards.y(), -(inwards.x() * a.x() + inwards.y() * a.y())};
        near.edges[k] = forward ? line : Vector3d{-line};
    }
}

/// A corner of a facet in plan and in the axes of the lattice of bumps.
struct FacetCorner {
    Vector2d plan_m = Vector2d::Zero();
    Bumps::Place at{0.0, 0.0};
};

/// A convex polygon of few corners that is cut by straight lines in place.
class Facet {
public:
    void add(const FacetCorner& corner) { corners_[size_++] = corner; }
    [[nodiscard]] std::size_t size() const { return size_; }
    const FacetCorner& operator[](std::size_t i) const { return corners_[i]; }

    /// Keeps what has a distance from the line of at least 0.
    template <class Distance>
    void keep(const Distance& distance_of) {
        const Facet whole = *this;
        size_ = 0;
        for (std::size_t i = 0; i < whole.size_; ++i) {
            const FacetCorner& from = whole.corners_[i];
            const FacetCorner& to = whole.corners_[(i + 1) % whole.size_];
            const double here = distance_of(from.at), there = distance_of(to.at);
            if (here >= 0.0) {
                add(from);
            }
            if ((here > 0.0 && there < 0.0) || (here < 0.0 && there > 0.0)) {
                const double share = here / (here - there);
                add({from.plan_m + share * (to.plan_m - from.plan_m),
                     {from.at.u + share * (to.at.u - from.at.u), from.at.v + share * (to.at.v - from.at.v)}});
            }
        }
    }

private:
    static constexpr std::size_t most = 9;  ///< three lines cut at most three corners more off a triangle
    std::array<FacetCorner, most> corners_{};
    std::size_t size_ = 0;
};

/// One triangle of the lattice of bumps: the lower or the upper half of a mesh between four nodes.
struct Half {
    int u, v;
    bool upper;

    [[nodiscard]] double height_m(const Bumps::Nodes& nodes, const Bumps::Place& at) const {
        return nodes.at(u + 1, v) + slope_m(nodes).dot(Vector2d{at.u - (u + 1), at.v - v});
    }
    /// How the height changes with u and v.
    [[nodiscard]] Vector2d slope_m(const Bumps::Nodes& nodes) const {
        const double right = nodes.at(u + 1, v), left = nodes.at(u, v + 1);
        const double other = upper ? nodes.at(u + 1, v + 1) : nodes.at(u, v);
        return upper ? Vector2d{other - left, other - right} : Vector2d{right - other, left - other};
    }
    /// What of a facet lies in it.
    void cut(Facet& facet) const {
        const double sign = upper ? -1.0 : 1.0;
        const int side = upper ? 1 : 0;
        facet.keep([&](const Bumps::Place& p) { return sign * (p.u - u - side); });
        facet.keep([&](const Bumps::Place& p) { return sign * (p.v - v - side); });
        facet.keep([&](const Bumps::Place& p) { return sign * (u + v + 1 - p.u - p.v); });
    }
};

}  // namespace

void GroundPatch::add_triangle(const Terrain& terrain, std::uint32_t number) {
    const Triangle& t = terrain.triangles()[number];
    NearTriangle near;
    near.number = number;
    for (int k = 0; k < 3; ++k) {
        near.corners[k] = t.corners[k];
        near.corners_m[k] = place_of_vertex(terrain, t.corners[k]);
    }
    near.normal = normal_of(near.corners_m);
    near.offset_m = near.normal.dot(near.corners_m[0]);
    set_edges(near);
    triangles_.push_back(near);
}

/// The number of a corner: that of one at the same place in plan, up to rounding.
std::uint32_t GroundPatch::welded(const Vector3d& corner_m) {
    constexpr double same_m = 1e-8;
    const auto found = std::find_if(corners_m_.begin(), corners_m_.end(), [&](const Vector3d& other_m) {
        return (other_m - corner_m).head<2>().squaredNorm() < same_m * same_m;
    });
    if (found == corners_m_.end()) {
        corners_m_.push_back(corner_m);
        return static_cast<std::uint32_t>(corners_m_.size() - 1);
    }
    return static_cast<std::uint32_t>(found - corners_m_.begin());
}

/// A plane convex polygon as a fan of triangles.
void GroundPatch::add_facet(std::span<const Vector3d> polygon_m, const Vector3d& normal,
                            std::uint32_t number) {
    std::array<std::uint32_t, 9> ids{};
    for (std::size_t i = 0; i < polygon_m.size(); ++i) {
        ids[i] = welded(polygon_m[i]);
    }
    for (std::size_t i = 1; i + 1 < polygon_m.size(); ++i) {
        NearTriangle near;
        near.number = number;
        near.normal = normal;
        const std::uint32_t corners[3] = {ids[0], ids[i], ids[i + 1]};
        for (int k = 0; k < 3; ++k) {
            near.corners[k] = corners[k];
            near.corners_m[k] = corners_m_[corners[k]];
        }
        const Vector3d ab = near.corners_m[1] - near.corners_m[0], ac = near.corners_m[2] - near.corners_m[0];
        constexpr double sliver_m2 = 1e-12;
        if (ab.x() * ac.y() - ab.y() * ac.x() < sliver_m2) {
            continue;
        }
        near.offset_m = normal.dot(near.corners_m[0]);
        set_edges(near);
        triangles_.push_back(near);
    }
}

/// A triangle of the terrain cut along the lattice of bumps: each piece is plane.
void GroundPatch::add_with_bumps(const Terrain& terrain, const Bumps& bumps, std::uint32_t number) {
    const Triangle& t = terrain.triangles()[number];
    const Plane plane = terrain.plane_of(number);
    Facet whole;
    for (int k = 0; k < 3; ++k) {
        const Vector2d plan_m = place_of_vertex(terrain, t.corners[k]).head<2>();
        whole.add({plan_m, bumps.place_of(plan_m)});
    }
    for (int i = 0; i < 2 * (nodes_.along_u - 1) * (nodes_.along_v - 1); ++i) {
        const int mesh = i / 2;
        const Half half{nodes_.first_u + mesh % (nodes_.along_u - 1),
                        nodes_.first_v + mesh / (nodes_.along_u - 1), i % 2 == 1};
        Facet facet = whole;
        half.cut(facet);
        if (facet.size() < 3) {
            continue;
        }
        std::array<Vector3d, 9> polygon_m;
        for (std::size_t k = 0; k < facet.size(); ++k) {
            const Vector2d& plan_m = facet[k].plan_m;
            polygon_m[k] = {plan_m.x(), plan_m.y(),
                            plane.height_m(plan_m.x(), plan_m.y()) + half.height_m(nodes_, facet[k].at)};
        }
        add_facet({polygon_m.data(), facet.size()}, bumps.normal_of(plane.gradient, half.slope_m(nodes_)),
                  number);
    }
}

void GroundPatch::gather(const Terrain& terrain, const Bumps& bumps, std::uint32_t under,
                         const Vector2d& centre_m, double radius_m, PatchMarks& memory) {
    centre_m_ = centre_m;
    radius_m_ = radius_m;
    triangles_.clear();
    corners_m_.clear();
    nodes_.flat = true;
    if (bumps.highest_m() > 0.0) {
        bumps.find_nodes(centre_m, radius_m, under, nodes_);
    }
    each_triangle_near(
        terrain, under, centre_m, centre_m, radius_m, memory, [&](std::uint32_t number, const Triangle&) {
            nodes_.flat ? add_triangle(terrain, number) : add_with_bumps(terrain, bumps, number);
        });
    find_ridges();
    find_peaks();
}

void GroundPatch::find_ridges() {
    ridges_.clear();
    ridge_ends_.clear();
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
        const NearTriangle& near = triangles_[i];
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t from = near.corners[k], to = near.corners[(k + 1) % 3];
            // Each edge once; beyond the patch nothing is touched.
            const auto beyond =
                std::find_if(triangles_.begin() + static_cast<std::ptrdiff_t>(i) + 1, triangles_.end(),
                             [&](const NearTriangle& other) {
                                 return (other.corners[0] == to && other.corners[1] == from) ||
                                        (other.corners[1] == to && other.corners[2] == from) ||
                                        (other.corners[2] == to && other.corners[0] == from);
                             });
            if (beyond == triangles_.end()) {
                continue;
            }
            const Vector3d along_m = near.corners_m[(k + 1) % 3] - near.corners_m[k];
            if (beyond->normal.dot(along_m.cross(near.normal)) > solids::parallel_sine * along_m.norm()) {
                ridges_.push_back({near.corners_m[k], along_m, near.normal, beyond->normal, near.number});
                ridge_ends_.push_back(from);
                ridge_ends_.push_back(to);
            }
        }
    }
    std::sort(ridge_ends_.begin(), ridge_ends_.end());
    ridge_ends_.erase(std::unique(ridge_ends_.begin(), ridge_ends_.end()), ridge_ends_.end());
}

void GroundPatch::find_peaks() {
    peaks_.clear();
    neighbours_.clear();
    for (const std::uint32_t corner : ridge_ends_) {
        NearPeak peak{Vector3d::Zero(), static_cast<std::uint32_t>(neighbours_.size()), 0, no_triangle};
        for (const NearTriangle& near : triangles_) {
            for (int k = 0; k < 3; ++k) {
                if (near.corners[k] == corner) {
                    peak.point_m = near.corners_m[k];
                    neighbours_.push_back(near.corners_m[(k + 1) % 3]);
                    neighbours_.push_back(near.corners_m[(k + 2) % 3]);
                    peak.triangle = near.number;
                }
            }
        }
        peak.neighbours = static_cast<std::uint32_t>(neighbours_.size()) - peak.first_neighbour;
        peaks_.push_back(peak);
    }
}

}  // namespace rockfall::rigid
