#include "rockfall/solids/hull.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <string>
#include <utility>

namespace rockfall::solids {
namespace {

using Eigen::Vector3d;
using HalfEdge = std::pair<std::uint32_t, std::uint32_t>;

/// A triangle of the growing hull with the points that lie above it and above no earlier one.
struct Facet {
    std::array<std::uint32_t, 3> corners;
    Vector3d normal;
    double offset_m;
    std::vector<std::uint32_t> outside{};
    bool alive = true;

    [[nodiscard]] double height_m(const Vector3d& point_m) const { return normal.dot(point_m) - offset_m; }
};

/// The hull while it grows: triangles and the owner of each directed edge.
class GrowingHull {
public:
    GrowingHull(std::span<const Vector3d> points_m, double tolerance_m)
        : points_m_{points_m}, tolerance_m_{tolerance_m} {}

    void grow_from(const std::array<std::uint32_t, 4>& first) {
        const Vector3d middle_m =
            0.25 * (points_m_[first[0]] + points_m_[first[1]] + points_m_[first[2]] + points_m_[first[3]]);
        std::vector<std::uint32_t> faces;
        for (std::size_t left_out = 0; left_out < 4; ++left_out) {
            std::array<std::uint32_t, 3> corners{first[(left_out + 1) % 4], first[(left_out + 2) % 4],
                                                 first[(left_out + 3) % 4]};
            if (facet_of(corners).height_m(middle_m) > 0.0) {
                std::swap(corners[1], corners[2]);
            }
            faces.push_back(add(corners));
        }
        std::vector<std::uint32_t> all(points_m_.size());
        std::iota(all.begin(), all.end(), 0U);
        share_out(all, faces);
        // Facets are added at the end while the loop runs.
        for (std::size_t i = 0; i < facets_.size(); ++i) {
            if (facets_[i].alive && !facets_[i].outside.empty()) {
                add_highest_point_of(static_cast<std::uint32_t>(i));
            }
        }
    }

    [[nodiscard]] std::vector<std::array<std::uint32_t, 3>> triangles() const {
        std::vector<std::array<std::uint32_t, 3>> result;
        for (const Facet& facet : facets_) {
            if (facet.alive) {
                result.push_back(facet.corners);
            }
        }
        return result;
    }

private:
    [[nodiscard]] Facet facet_of(const std::array<std::uint32_t, 3>& corners) const {
        const Vector3d& a = points_m_[corners[0]];
        const Vector3d normal =
            (points_m_[corners[1]] - a).cross(points_m_[corners[2]] - a).stableNormalized();
        return {corners, normal, normal.dot(a)};
    }

    std::uint32_t add(const std::array<std::uint32_t, 3>& corners) {
        const auto index = static_cast<std::uint32_t>(facets_.size());
        facets_.push_back(facet_of(corners));
        for (std::size_t k = 0; k < 3; ++k) {
            owner_[{corners[k], corners[(k + 1) % 3]}] = index;
        }
        return index;
    }

    void share_out(const std::vector<std::uint32_t>& points, const std::vector<std::uint32_t>& faces) {
        for (const std::uint32_t point : points) {
            for (const std::uint32_t face : faces) {
                if (facets_[face].height_m(points_m_[point]) > tolerance_m_) {
                    facets_[face].outside.push_back(point);
                    break;
                }
            }
        }
    }

    void add_highest_point_of(std::uint32_t seen_first) {
        const Facet& facet = facets_[seen_first];
        const std::uint32_t apex = *std::max_element(
            facet.outside.begin(), facet.outside.end(), [&](std::uint32_t a, std::uint32_t b) {
                return facet.height_m(points_m_[a]) < facet.height_m(points_m_[b]);
            });

        // The facets that the point sees are connected; their border is the horizon.
        std::vector<std::uint32_t> seen{seen_first};
        facets_[seen_first].alive = false;
        std::vector<HalfEdge> horizon;
        std::vector<std::uint32_t> orphans;
        for (std::size_t i = 0; i < seen.size(); ++i) {
            const std::array<std::uint32_t, 3> corners = facets_[seen[i]].corners;
            for (std::size_t k = 0; k < 3; ++k) {
                const HalfEdge edge{corners[k], corners[(k + 1) % 3]};
                Facet& neighbour = facets_[owner_.at({edge.second, edge.first})];
                if (neighbour.alive && neighbour.height_m(points_m_[apex]) > tolerance_m_) {
                    neighbour.alive = false;
                    seen.push_back(owner_.at({edge.second, edge.first}));
                }
            }
        }
        for (const std::uint32_t index : seen) {
            const Facet& gone = facets_[index];
            for (std::size_t k = 0; k < 3; ++k) {
                const HalfEdge edge{gone.corners[k], gone.corners[(k + 1) % 3]};
                if (facets_[owner_.at({edge.second, edge.first})].alive) {
                    horizon.push_back(edge);
                }
            }
            orphans.insert(orphans.end(), gone.outside.begin(), gone.outside.end());
        }
        std::vector<std::uint32_t> faces;
        for (const HalfEdge& edge : horizon) {
            faces.push_back(add({edge.first, edge.second, apex}));
        }
        std::erase(orphans, apex);
        share_out(orphans, faces);
    }

    std::span<const Vector3d> points_m_;
    double tolerance_m_;
    std::vector<Facet> facets_{};
    std::map<HalfEdge, std::uint32_t> owner_{};
};

double extent_of(std::span<const Vector3d> points_m) {
    Vector3d low = points_m[0], high = points_m[0];
    for (const Vector3d& point : points_m) {
        if (!point.allFinite()) {
            throw NoSolid{"a coordinate is no finite number"};
        }
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    return (high - low).maxCoeff();
}

/// The index of the point for which `size` is largest, and that size.
template <typename Size>
std::pair<std::uint32_t, double> largest(std::span<const Vector3d> points_m, const Size& size) {
    std::pair<std::uint32_t, double> best{0, -1.0};
    for (std::uint32_t i = 0; i < points_m.size(); ++i) {
        if (const double here = size(points_m[i]); here > best.second) {
            best = {i, here};
        }
    }
    return best;
}

std::array<std::uint32_t, 4> first_tetrahedron(std::span<const Vector3d> points_m, double tolerance_m) {
    const auto need = [&](const std::pair<std::uint32_t, double>& found, const char* what) {
        if (!(found.second > tolerance_m)) {
            throw NoSolid{what};
        }
        return found.first;
    };
    const std::uint32_t a =
        largest(points_m, [&](const Vector3d& p) { return (p - points_m[0]).norm(); }).first;
    const std::uint32_t b =
        need(largest(points_m, [&](const Vector3d& p) { return (p - points_m[a]).norm(); }),
             "all points coincide");
    const Vector3d line = (points_m[b] - points_m[a]).normalized();
    const std::uint32_t c =
        need(largest(points_m, [&](const Vector3d& p) { return line.cross(p - points_m[a]).norm(); }),
             "all points lie on one line");
    const Vector3d normal = line.cross(points_m[c] - points_m[a]).normalized();
    const std::uint32_t d =
        need(largest(points_m, [&](const Vector3d& p) { return std::abs(normal.dot(p - points_m[a])); }),
             "all points lie in one plane");
    return {a, b, c, d};
}

/// The corners of a polygon from its directed edges. Requires a closed loop.
std::vector<std::uint32_t> loop_of(const std::map<std::uint32_t, std::uint32_t>& next) {
    std::vector<std::uint32_t> loop;
    std::uint32_t at = next.begin()->first;
    do {
        loop.push_back(at);
        at = next.at(at);
    } while (at != next.begin()->first && loop.size() <= next.size());
    return loop;
}

/// Normal of a polygon whose length is twice its area (Newell).
Vector3d area_vector(std::span<const Vector3d> points_m, const std::vector<std::uint32_t>& corners) {
    Vector3d sum = Vector3d::Zero();
    const Vector3d& first = points_m[corners[0]];
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
        sum += (points_m[corners[k]] - first).cross(points_m[corners[k + 1]] - first);
    }
    return sum;
}

/// Joins triangles that lie in one plane.
std::vector<std::vector<std::uint32_t>> polygons_of(
    std::span<const Vector3d> points_m, const std::vector<std::array<std::uint32_t, 3>>& triangles,
    double tolerance_m) {
    std::map<HalfEdge, std::size_t> owner;
    std::vector<Vector3d> areas;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            owner[{triangles[i][k], triangles[i][(k + 1) % 3]}] = i;
        }
        areas.push_back(area_vector(points_m, {triangles[i].begin(), triangles[i].end()}));
    }
    // The largest triangle defines the plane of its face: slivers have normals of chance.
    std::vector<std::size_t> by_area(triangles.size());
    std::iota(by_area.begin(), by_area.end(), std::size_t{0});
    std::stable_sort(by_area.begin(), by_area.end(), [&](std::size_t a, std::size_t b) {
        return areas[a].squaredNorm() > areas[b].squaredNorm();
    });
    constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> face_of(triangles.size(), none);
    std::size_t faces = 0;
    for (const std::size_t seed : by_area) {
        if (face_of[seed] != none) {
            continue;
        }
        const Vector3d normal = areas[seed].stableNormalized();
        const double offset_m = normal.dot(points_m[triangles[seed][0]]);
        std::vector<std::size_t> members{seed};
        face_of[seed] = faces;
        for (std::size_t i = 0; i < members.size(); ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                const std::array<std::uint32_t, 3> corners = triangles[members[i]];
                const std::size_t neighbour = owner.at({corners[(k + 1) % 3], corners[k]});
                const bool in_plane = std::all_of(
                    triangles[neighbour].begin(), triangles[neighbour].end(), [&](std::uint32_t corner) {
                        return std::abs(normal.dot(points_m[corner]) - offset_m) <= 4.0 * tolerance_m;
                    });
                if (face_of[neighbour] == none && in_plane) {
                    face_of[neighbour] = faces;
                    members.push_back(neighbour);
                }
            }
        }
        ++faces;
    }
    std::vector<std::map<std::uint32_t, std::uint32_t>> borders(faces);
    std::map<std::uint32_t, std::uint32_t> faces_at;
    for (const auto& [edge, triangle] : owner) {
        if (face_of[owner.at({edge.second, edge.first})] != face_of[triangle]) {
            borders[face_of[triangle]][edge.first] = edge.second;
            ++faces_at[edge.first];
        }
    }
    std::vector<std::vector<std::uint32_t>> polygons;
    for (const auto& border : borders) {
        std::vector<std::uint32_t> polygon = loop_of(border);
        // A point in the middle of an edge belongs to two faces only.
        std::erase_if(polygon, [&](std::uint32_t corner) { return faces_at.at(corner) < 3; });
        polygons.push_back(std::move(polygon));
    }
    return polygons;
}

/// Numbers the used points anew and adds planes and edges. Requires faces that close.
Hull assemble(std::span<const Vector3d> points_m, const std::vector<std::vector<std::uint32_t>>& polygons) {
    constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> number(points_m.size(), unused);
    Hull hull;
    for (const auto& polygon : polygons) {
        for (const std::uint32_t corner : polygon) {
            number[corner] = 0;
        }
    }
    for (std::size_t i = 0; i < points_m.size(); ++i) {
        if (number[i] != unused) {
            number[i] = static_cast<std::uint32_t>(hull.vertices_m.size());
            hull.vertices_m.push_back(points_m[i]);
        }
    }
    std::map<HalfEdge, std::uint32_t> owner;
    for (const auto& polygon : polygons) {
        Face face{{}, area_vector(points_m, polygon).stableNormalized(), 0.0};
        for (const std::uint32_t corner : polygon) {
            face.corners.push_back(number[corner]);
            face.offset_m += face.normal.dot(points_m[corner]) / static_cast<double>(polygon.size());
        }
        for (std::size_t k = 0; k < face.corners.size(); ++k) {
            const HalfEdge edge{face.corners[k], face.corners[(k + 1) % face.corners.size()]};
            if (!owner.try_emplace(edge, static_cast<std::uint32_t>(hull.faces.size())).second) {
                throw NoSolid{"two faces share an edge in the same direction: faces are doubled or inverted"};
            }
        }
        hull.faces.push_back(std::move(face));
    }
    for (const auto& [edge, left] : owner) {
        const auto back = owner.find({edge.second, edge.first});
        if (back == owner.end()) {
            throw NoSolid{"the faces leave a hole"};
        }
        if (edge.first < edge.second) {
            hull.edges.push_back({edge.first, edge.second, left, back->second});
        }
    }
    return hull;
}

}  // namespace

Hull convex_hull(std::span<const Vector3d> points_m) {
    if (points_m.size() < 4) {
        throw NoSolid{"a solid needs at least four points, not " + std::to_string(points_m.size())};
    }
    const double tolerance_m = flatness * extent_of(points_m);
    GrowingHull growing{points_m, tolerance_m};
    growing.grow_from(first_tetrahedron(points_m, tolerance_m));
    return assemble(points_m, polygons_of(points_m, growing.triangles(), tolerance_m));
}

Hull hull_of_faces(std::span<const Vector3d> points_m, std::span<const std::vector<std::uint32_t>> faces) {
    if (points_m.size() < 4 || faces.size() < 4) {
        throw NoSolid{std::to_string(points_m.size()) + " points and " + std::to_string(faces.size()) +
                      " faces make no solid"};
    }
    const double extent_m = extent_of(points_m);
    for (const std::vector<std::uint32_t>& face : faces) {
        if (face.size() < 3 || std::any_of(face.begin(), face.end(),
                                           [&](std::uint32_t corner) { return corner >= points_m.size(); })) {
            throw NoSolid{"a face has fewer than three corners or names a point that does not exist"};
        }
    }
    const Hull given = assemble(points_m, {faces.begin(), faces.end()});
    double six_volumes_m3 = 0.0;
    for (const std::vector<std::uint32_t>& face : faces) {
        six_volumes_m3 += (points_m[face[0]] - points_m[0]).dot(area_vector(points_m, face));
    }
    if (six_volumes_m3 < 0.0) {
        throw NoSolid{"the faces point inwards: their corners run clockwise seen from outside"};
    }
    // Vertices of meshes are rounded to a few digits; a millionth of the extent is no dent.
    for (const Face& face : given.faces) {
        for (const Vector3d& vertex_m : given.vertices_m) {
            if (face.normal.dot(vertex_m) - face.offset_m > 1e-6 * extent_m) {
                throw NoSolid{"the solid is not convex"};
            }
        }
    }
    return convex_hull(given.vertices_m);
}

Hull scaled(const Hull& hull, const Vector3d& factors) {
    assert((factors.array() > 0.0).all());
    Hull result = hull;
    for (Vector3d& vertex_m : result.vertices_m) {
        vertex_m = vertex_m.cwiseProduct(factors);
    }
    for (Face& face : result.faces) {
        face.normal = face.normal.cwiseQuotient(factors).normalized();
        face.offset_m = face.normal.dot(result.vertices_m[face.corners[0]]);
    }
    return result;
}

Hull placed(const Hull& hull, const Eigen::Quaterniond& attitude, const Vector3d& position_m) {
    const Eigen::Matrix3d turn = attitude.toRotationMatrix();
    Hull result = hull;
    for (Vector3d& vertex_m : result.vertices_m) {
        vertex_m = turn * vertex_m + position_m;
    }
    for (Face& face : result.faces) {
        face.normal = turn * face.normal;
        face.offset_m += face.normal.dot(position_m);
    }
    return result;
}

}  // namespace rockfall::solids
