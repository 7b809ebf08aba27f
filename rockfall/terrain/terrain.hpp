#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "config/grid/raster.hpp"

namespace rockfall {

/// "No triangle": beyond the border of the terrain.
inline constexpr std::uint32_t no_triangle = 0xFFFFFFFFU;

class Rim;

/// A vertex of the terrain, in metres from the terrain's origin.
struct Vertex {
    double x_m;
    double y_m;
    double z_m;
};

/// A triangle in 32 bytes: corners counter-clockwise in plan; neighbours[i] lies across the edge from
/// corners[i] to corners[(i + 1) % 3].
struct Triangle {
    std::uint32_t corners[3];
    std::uint32_t neighbours[3];
    float normal_z = 0.0F;      ///< z component of the upward unit normal: cosine of the slope [-], (0, 1]
    std::uint32_t surface = 0;  ///< 0: ground as the map says; k > 0: ground type k - 1 of the list of types
};
static_assert(sizeof(Triangle) == 32);

/// Plane of a triangle: height = z_m + gradient . (p - corner).
struct Plane {
    Eigen::Vector3d corner_m;
    Eigen::Vector2d gradient;  ///< dz/dx, dz/dy [-]
    [[nodiscard]] double height_m(double x_m, double y_m) const {
        return corner_m.z() + gradient.x() * (x_m - corner_m.x()) + gradient.y() * (y_m - corner_m.y());
    }
    [[nodiscard]] Eigen::Vector3d normal() const {
        return Eigen::Vector3d{-gradient.x(), -gradient.y(), 1.0}.normalized();
    }
};

/// A triangulated slope as flat arrays, triangles and vertices along a Hilbert curve.
///
/// All coordinates are relative to `origin_m` (easting, northing), which keeps national grid offsets out of
/// the arithmetic. Heights are absolute. Built by mesh.cpp; this class only walks.
class Terrain {
public:
    /// Requires corners and neighbours as Triangle describes them. Computes normal_z where it is not above 0.
    Terrain(Eigen::Vector2d origin_m, std::vector<Vertex> vertices, std::vector<Triangle> triangles);

    [[nodiscard]] Eigen::Vector2d origin_m() const { return origin_m_; }
    [[nodiscard]] std::span<const Vertex> vertices() const { return vertices_; }
    [[nodiscard]] std::span<const Triangle> triangles() const { return triangles_; }

    [[nodiscard]] Plane plane_of(std::uint32_t triangle) const {
        const Triangle& t = triangles_[triangle];
        const Vertex& a = vertices_[t.corners[0]];
        const Vertex& b = vertices_[t.corners[1]];
        const Vertex& c = vertices_[t.corners[2]];
        const double ux = b.x_m - a.x_m, uy = b.y_m - a.y_m, uz = b.z_m - a.z_m;
        const double vx = c.x_m - a.x_m, vy = c.y_m - a.y_m, vz = c.z_m - a.z_m;
        const double area2 = ux * vy - uy * vx;
        return {{a.x_m, a.y_m, a.z_m}, {(uz * vy - vz * uy) / area2, (vz * ux - uz * vx) / area2}};
    }

    /// The triangle under a point (relative coordinates), found by walking from `hint`; nothing outside the
    /// terrain or in a hole. A point on an edge or a corner belongs to any one of the triangles there.
    /// Fast where the hint is a few triangles away; any hint gives an answer, `no_triangle` too.
    [[nodiscard]] std::optional<std::uint32_t> locate(double x_m, double y_m, std::uint32_t hint) const;
    /// The same without a hint, from lists of triangles on a coarse grid: for release points and trees, not
    /// for the inner loop.
    [[nodiscard]] std::optional<std::uint32_t> locate(double x_m, double y_m) const;

    /// Height of the terrain under a point; nothing outside.
    [[nodiscard]] std::optional<double> height_m(double x_m, double y_m) const;

    /// Where the terrain ends: its outline and its holes.
    [[nodiscard]] const Rim& rim() const { return *rim_; }

private:
    void fill_start_grid();

    Eigen::Vector2d origin_m_;
    std::vector<Vertex> vertices_;
    std::vector<Triangle> triangles_;
    config::GridFrame start_frame_;  ///< coarse grid over the extent
    std::vector<std::uint32_t>
        start_offsets_;  ///< where the list of each of its cells begins; one more at the end
    std::vector<std::uint32_t>
        start_triangles_;  ///< every triangle that reaches into a cell, cell after cell
    std::shared_ptr<const Rim> rim_;
};

}  // namespace rockfall
