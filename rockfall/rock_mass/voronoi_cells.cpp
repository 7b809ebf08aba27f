#include "rockfall/rock_mass/voronoi_cells.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <voro++/voro++.hh>

#include "config/random/stream.hpp"

namespace rockfall::rock_mass {

using Eigen::Vector3d;

namespace {

/// Places at random; each is drawn again up to ten times where it lies too near to one before.
std::vector<Vector3d> scattered_points(const Vector3d& low_m, const Vector3d& high_m, double size_m,
                                       std::uint64_t seed) {
    const Vector3d sides_m = high_m - low_m;
    const auto count = std::max<std::size_t>(
        2, static_cast<std::size_t>(std::llround(sides_m.prod() / (size_m * size_m * size_m))));
    const double apart_m = size_m / 3.0;
    std::vector<Vector3d> points;
    // Cells as wide as the distance: only neighbours need be looked at.
    Eigen::Vector3i bins;
    for (int k = 0; k < 3; ++k) {
        bins[k] = std::max(1, static_cast<int>(sides_m[k] / apart_m));
    }
    std::vector<std::vector<std::uint32_t>> in_bin(static_cast<std::size_t>(bins.prod()));
    const auto bin_of = [&](const Vector3d& at) {
        Eigen::Vector3i bin;
        for (int k = 0; k < 3; ++k) {
            bin[k] = std::clamp(static_cast<int>((at[k] - low_m[k]) / sides_m[k] * bins[k]), 0, bins[k] - 1);
        }
        return bin;
    };
    const auto list_of = [&](const Eigen::Vector3i& bin) -> std::vector<std::uint32_t>& {
        return in_bin[static_cast<std::size_t>((bin.z() * bins.y() + bin.y()) * bins.x() + bin.x())];
    };
    const auto is_free = [&](const Vector3d& at) {
        const Eigen::Vector3i low = (bin_of(at).array() - 1).max(0);
        const Eigen::Vector3i high = (bin_of(at).array() + 1).min(bins.array() - 1);
        for (int z = low.z(); z <= high.z(); ++z) {
            for (int y = low.y(); y <= high.y(); ++y) {
                for (int x = low.x(); x <= high.x(); ++x) {
                    for (const std::uint32_t other : list_of({x, y, z})) {
                        if ((points[other] - at).norm() < apart_m) {
                            return false;
                        }
                    }
                }
            }
        }
        return true;
    };
    for (std::size_t i = 0; i < count; ++i) {
        config::RandomStream draws{{seed, 0, 0, i}, config::Purpose::block};
        Vector3d at;
        for (int attempt = 0; attempt < 10; ++attempt) {
            for (int k = 0; k < 3; ++k) {
                at[k] = low_m[k] + draws.uniform() * sides_m[k];
            }
            if (is_free(at)) {
                break;
            }
        }
        list_of(bin_of(at)).push_back(static_cast<std::uint32_t>(points.size()));
        points.push_back(at);
    }
    return points;
}

ConvexCell cell_from(voro::voronoicell_neighbor& computed, const Vector3d& about_m) {
    std::vector<double> vertices, normals;
    std::vector<int> corners, neighbours;
    computed.vertices(about_m.x(), about_m.y(), about_m.z(), vertices);
    computed.face_vertices(corners);
    computed.neighbors(neighbours);
    ConvexCell cell;
    std::size_t at = 0;
    for (const int neighbour : neighbours) {
        CellFace face;
        face.made_by = neighbour < 0 ? made_by_border : made_by_cell;
        const auto count = static_cast<std::size_t>(corners[at++]);
        for (std::size_t k = 0; k < count; ++k, ++at) {
            const auto v = 3 * static_cast<std::size_t>(corners[at]);
            face.corners_m.emplace_back(vertices[v], vertices[v + 1], vertices[v + 2]);
        }
        Vector3d area = Vector3d::Zero();
        for (std::size_t k = 1; k + 1 < count; ++k) {
            area += (face.corners_m[k] - face.corners_m[0]).cross(face.corners_m[k + 1] - face.corners_m[0]);
        }
        if (area.norm() < 1e-12) {
            continue;
        }
        // Voro++ does not say which way round it lists them.
        if (area.dot(face.corners_m[0] - about_m) < 0.0) {
            std::reverse(face.corners_m.begin(), face.corners_m.end());
            area = -area;
        }
        face.plane.normal = area.normalized();
        face.plane.offset_m = face.plane.normal.dot(face.corners_m[0]);
        cell.faces.push_back(std::move(face));
    }
    return cell;
}

}  // namespace

std::vector<ConvexCell> voronoi_cells(const Vector3d& low_m, const Vector3d& high_m, double size_m,
                                      std::uint64_t seed) {
    const std::vector<Vector3d> points = scattered_points(low_m, high_m, size_m, seed);
    constexpr double points_per_bin = 5.0;
    const Vector3d sides_m = high_m - low_m;
    const double bin_m = std::cbrt(sides_m.prod() * points_per_bin / static_cast<double>(points.size()));
    const auto bins = [&](double side_m) { return std::max(1, static_cast<int>(side_m / bin_m)); };
    voro::container container{
        low_m.x(),         high_m.x(),        low_m.y(), high_m.y(), low_m.z(), high_m.z(), bins(sides_m.x()),
        bins(sides_m.y()), bins(sides_m.z()), false,     false,      false,     8};
    for (std::size_t i = 0; i < points.size(); ++i) {
        container.put(static_cast<int>(i), points[i].x(), points[i].y(), points[i].z());
    }
    std::vector<ConvexCell> cells(points.size());
    voro::c_loop_all loop{container};
    voro::voronoicell_neighbor computed;
    if (loop.start()) {
        do {
            if (container.compute_cell(computed, loop)) {
                const auto i = static_cast<std::size_t>(loop.pid());
                cells[i] = cell_from(computed, points[i]);
            }
        } while (loop.inc());
    }
    std::erase_if(cells, [](const ConvexCell& cell) { return cell.faces.size() < 4; });
    return cells;
}

}  // namespace rockfall::rock_mass
