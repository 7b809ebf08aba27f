#include "rockfall/terrain/tin.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "rockfall/terrain/borders.hpp"
#include "rockfall/terrain/edges.hpp"
#include "rockfall/terrain/flatten.hpp"
#include "rockfall/terrain/joining.hpp"
#include "rockfall/terrain/upright.hpp"

namespace rockfall {
namespace {

Eigen::Vector3d middle_of(const Tin& tin, const TinFace& face) {
    return (tin.vertices_m[face.corners[0]] + tin.vertices_m[face.corners[1]] +
            tin.vertices_m[face.corners[2]]) /
           3.0;
}

Eigen::Vector3d middle_of(const Tin& tin, TinSide side) {
    const auto& corners = tin.faces[side.face].corners;
    return 0.5 * (tin.vertices_m[corners[side.side]] + tin.vertices_m[corners[(side.side + 1) % 3]]);
}

/// The findings of a check, each kind counted with the place of its first.
class Findings {
public:
    void add(TinFault fault, const Eigen::Vector3d& place_m, std::size_t size = 0) {
        const auto known = std::find_if(list_.begin(), list_.end(),
                                        [&](const TinFinding& finding) { return finding.fault == fault; });
        if (known == list_.end()) {
            list_.push_back({fault, 1, place_m, size});
        } else {
            ++known->count;
        }
    }
    [[nodiscard]] bool has_faults() const {
        return std::any_of(list_.begin(), list_.end(),
                           [](const TinFinding& finding) { return !is_doubt(finding.fault); });
    }
    [[nodiscard]] std::vector<TinFinding> list() && { return std::move(list_); }

private:
    std::vector<TinFinding> list_;
};

void find_doubled(const Tin& tin, Findings& findings) {
    std::vector<std::pair<std::array<std::uint32_t, 3>, std::uint32_t>> sorted;
    for (std::uint32_t f = 0; f < tin.faces.size(); ++f) {
        auto corners = tin.faces[f].corners;
        std::sort(corners.begin(), corners.end());
        sorted.emplace_back(corners, f);
    }
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t i = 1; i < sorted.size(); ++i) {
        if (sorted[i].first == sorted[i - 1].first) {
            findings.add(TinFault::doubled, middle_of(tin, tin.faces[sorted[i].second]));
        }
    }
}

void find_no_area(const Tin& tin, Findings& findings) {
    for (const TinFace& face : tin.faces) {
        const Eigen::Vector3d& a = tin.vertices_m[face.corners[0]];
        const double longest_m2 = std::max((tin.vertices_m[face.corners[1]] - a).squaredNorm(),
                                           (tin.vertices_m[face.corners[2]] - a).squaredNorm());
        if (!(area2_of(tin, face).norm() > 1e-12 * longest_m2)) {
            findings.add(TinFault::no_area, middle_of(tin, face));
        }
    }
}

/// Which faces look down, but for upright ones.
std::vector<bool> looking_down(const Tin& tin) {
    std::vector<bool> down(tin.faces.size());
    for (std::size_t f = 0; f < tin.faces.size(); ++f) {
        down[f] = area2_of(tin, tin.faces[f]).z() <= 0.0 && !is_upright(tin, tin.faces[f]);
    }
    return down;
}

/// Faces that cannot be seen from above once walls lean: they looked down before, or leaning turned them
/// over.
void find_overhangs(const Tin& tin, const std::vector<bool>& looked_down, Findings& findings) {
    constexpr double least_rise = 1e-7;
    for (std::size_t f = 0; f < tin.faces.size(); ++f) {
        const Eigen::Vector3d area2 = area2_of(tin, tin.faces[f]);
        if (!(area2.z() > least_rise * area2.norm())) {
            findings.add(looked_down[f] ? TinFault::overhang : TinFault::not_leaned,
                         middle_of(tin, tin.faces[f]));
        }
    }
}

/// Ground just outside a border, or borders that cross: then places have more than one height, or faces meet
/// in a seam whose vertices are not joined.
void find_overlaps(const Tin& tin, const TinEdges& edges, Findings& findings) {
    const Terrain terrain = terrain_of(tin);
    constexpr double outside_m = 1e-6;
    std::vector<PlanSegment> segments;
    for (const TinSide& side : edges.borders) {
        const auto& corners = tin.faces[side.face].corners;
        const Eigen::Vector2d from = tin.vertices_m[corners[side.side]].head<2>();
        const Eigen::Vector2d to = tin.vertices_m[corners[(side.side + 1) % 3]].head<2>();
        segments.push_back({from, to});
        const Eigen::Vector2d along = (to - from).normalized();
        const Eigen::Vector2d beside =
            0.5 * (from + to) + outside_m * Eigen::Vector2d{along.y(), -along.x()} - terrain.origin_m();
        if (terrain.locate(beside.x(), beside.y())) {
            findings.add(TinFault::overlap, middle_of(tin, side));
        }
    }
    constexpr std::size_t most = 1000;
    const auto add = [&](const PlanCrossing& meeting) {
        const Eigen::Vector3d middle = middle_of(tin, edges.borders[meeting.first]);
        findings.add(TinFault::overlap, {meeting.place_m.x(), meeting.place_m.y(), middle.z()});
    };
    for (const PlanCrossing& crossing : crossings_of(segments, most)) {
        add(crossing);
    }
    // Sheets of the same plan: no border of one lies inside the other, all lie over each other.
    for (const PlanCrossing& over : laid_over_each_other(segments, outside_m, most)) {
        add(over);
    }
}

void find_holes(const Tin& tin, const TinEdges& edges, Findings& findings) {
    for (const BorderLoop& loop : border_loops(tin, edges)) {
        if (loop.around_hole) {
            Eigen::Vector3d sum = Eigen::Vector3d::Zero();
            for (const TinSide& side : loop.sides) {
                sum += middle_of(tin, side);
            }
            findings.add(TinFault::hole, sum / static_cast<double>(loop.sides.size()), loop.sides.size());
        }
    }
}

void find_parts(const Tin& tin, const TinEdges& edges, Findings& findings) {
    const std::vector<std::uint32_t> part = parts_of(edges);
    std::vector<std::pair<std::size_t, std::size_t>> size_and_first;
    for (std::size_t f = 0; f < part.size(); ++f) {
        if (part[f] >= size_and_first.size()) {
            size_and_first.emplace_back(0, f);
        }
        ++size_and_first[part[f]].first;
    }
    const auto largest = std::max_element(size_and_first.begin(), size_and_first.end(),
                                          [](const auto& a, const auto& b) { return a.first < b.first; });
    for (auto it = size_and_first.begin(); it != size_and_first.end(); ++it) {
        if (it != largest) {
            findings.add(TinFault::parts, middle_of(tin, tin.faces[it->second]), it->first);
        }
    }
}

}  // namespace

bool CheckedTin::is_sound() const {
    return !tin.faces.empty() && std::all_of(findings.begin(), findings.end(), [](const TinFinding& finding) {
        return is_doubt(finding.fault);
    });
}

CheckedTin checked(Tin given) {
    CheckedTin result;
    result.tin = std::move(given);
    Tin& tin = result.tin;
    Findings findings;
    join_vertices(tin, result.changes);
    drop_unused_vertices(tin);
    turn_over_if_all_look_down(tin, result.changes);
    find_no_area(tin, findings);
    find_doubled(tin, findings);
    const TinEdges edges = edges_of(tin.faces);
    for (const TinSide& side : edges.crowded) {
        findings.add(TinFault::crowded, middle_of(tin, side));
    }
    for (const std::uint32_t face : flipped_faces(edges)) {
        findings.add(TinFault::flipped, middle_of(tin, tin.faces[face]));
    }
    // What follows reads neighbours and senses, which hold only where nothing was found so far.
    if (!findings.has_faults()) {
        const std::vector<bool> looked_down = looking_down(tin);
        lean_upright_faces(tin, result.changes);
        find_overhangs(tin, looked_down, findings);
    }
    if (!findings.has_faults() && !tin.faces.empty()) {
        find_overlaps(tin, edges, findings);
        find_holes(tin, edges, findings);
        find_parts(tin, edges, findings);
    }
    result.findings = std::move(findings).list();
    return result;
}

Terrain terrain_of(const Tin& tin) {
    Eigen::Vector2d corner_m = tin.vertices_m[tin.faces.front().corners[0]].head<2>();
    for (const TinFace& face : tin.faces) {
        for (const std::uint32_t corner : face.corners) {
            corner_m = corner_m.cwiseMin(tin.vertices_m[corner].head<2>());
        }
    }
    const Eigen::Vector2d origin_m = corner_m.array().floor();
    std::vector<Vertex> vertices;
    vertices.reserve(tin.vertices_m.size());
    for (const Eigen::Vector3d& vertex : tin.vertices_m) {
        vertices.push_back({vertex.x() - origin_m.x(), vertex.y() - origin_m.y(), vertex.z()});
    }
    const TinEdges edges = edges_of(tin.faces);
    std::vector<Triangle> triangles;
    triangles.reserve(tin.faces.size());
    for (std::size_t f = 0; f < tin.faces.size(); ++f) {
        const auto& [a, b, c] = tin.faces[f].corners;
        const auto& [ab, bc, ca] = edges.neighbours[f];
        triangles.push_back({{a, b, c}, {ab, bc, ca}, 0.0F, tin.faces[f].surface});
    }
    return along_hilbert_curve(origin_m, vertices, triangles);
}

}  // namespace rockfall
