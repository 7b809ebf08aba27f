#include <algorithm>
#include <cmath>

#include "coupling/assessments/nets/figures/net_paths.hpp"

namespace coupling {
namespace {

bool has_corners(const rockfall::Triangle& triangle, std::span<const rockfall::Vertex> vertices) {
    return std::all_of(std::begin(triangle.corners), std::end(triangle.corners),
                       [&](std::uint32_t corner) { return corner < vertices.size(); });
}

/// Whether what lies across each edge is no triangle, or one that has this triangle as a neighbour.
bool has_neighbours(std::uint32_t number, std::span<const rockfall::Triangle> triangles) {
    return std::all_of(std::begin(triangles[number].neighbours), std::end(triangles[number].neighbours),
                       [&](std::uint32_t other) {
                           if (other == rockfall::no_triangle) {
                               return true;
                           }
                           if (other >= triangles.size()) {
                               return false;
                           }
                           const auto& back = triangles[other].neighbours;
                           return std::find(std::begin(back), std::end(back), number) != std::end(back);
                       });
}

}  // namespace

bool is_whole_terrain(std::span<const rockfall::Vertex> vertices,
                      std::span<const rockfall::Triangle> triangles) {
    if (triangles.empty() || std::any_of(vertices.begin(), vertices.end(), [](const rockfall::Vertex& v) {
            return !std::isfinite(v.x_m) || !std::isfinite(v.y_m) || !std::isfinite(v.z_m);
        })) {
        return false;
    }
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        if (!has_corners(triangles[i], vertices) || !has_neighbours(i, triangles)) {
            return false;
        }
    }
    return true;
}

bool is_whole_design(const DesignSettings& design) {
    const auto lies_within = [](double value, double low, double high) {
        return value >= low && value <= high;
    };
    return design.rule <= DesignRule::own && lies_within(design.percentile, 50.0, 99.99) &&
           lies_within(design.energy_factor, 1.0, 5.0) && lies_within(design.height_factor, 1.0, 5.0) &&
           lies_within(design.freeboard_m, 0.0, 10.0) && !design.sold_heights_m.empty() &&
           std::all_of(design.sold_heights_m.begin(), design.sold_heights_m.end(),
                       [&](double height_m) { return lies_within(height_m, 0.1, 50.0); });
}

bool is_whole_path(const StoredPath& path, std::size_t triangles) {
    const rockfall::Rock& rock = path.body;
    const auto is_positive = [](double value) { return value > 0.0 && std::isfinite(value); };
    return static_cast<std::size_t>(path.cover) < rockfall::covers && is_positive(rock.diameter_m) &&
           is_positive(rock.radius_m) && is_positive(rock.mass_kg) && is_positive(rock.inertia_kgm2) &&
           std::all_of(path.pieces.begin(), path.pieces.end(), [&](const StoredPiece& piece) {
               return piece.triangle < triangles && piece.start_m.allFinite() && piece.other.allFinite() &&
                      std::isfinite(piece.first) && std::isfinite(piece.second) &&
                      std::isfinite(piece.rotation_start_j) && std::isfinite(piece.rotation_end_j);
           });
}

}  // namespace coupling
