#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "coupling/assessments/stopping/pictures.hpp"
#include "coupling/assessments/stopping/plain_number.hpp"
#include "coupling/results/figures/colours.hpp"

namespace coupling {

namespace {

using Point = std::array<double, 3>;
using Face = std::array<std::size_t, 3>;

/// Above so many blocks spheres get 20 triangles instead of 80, to keep the file readable.
constexpr std::size_t many_blocks = 4000;

struct Sphere {
    std::vector<Point> points;  ///< of unit length
    std::vector<Face> faces;    ///< turning left seen from outside
};

Point unit(const Point& p) {
    const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    return {p[0] / length, p[1] / length, p[2] / length};
}

Sphere icosahedron() {
    const double g = 0.5 * (1.0 + std::sqrt(5.0));
    Sphere sphere;
    sphere.points = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                     {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    for (Point& point : sphere.points) {
        point = unit(point);
    }
    sphere.faces = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    return sphere;
}

/// Each triangle cut into four.
Sphere finer(const Sphere& coarse) {
    Sphere sphere{coarse.points, {}};
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
    const auto middle = [&](std::size_t a, std::size_t b) {
        const auto [place, is_new] = middles.try_emplace(std::minmax(a, b), sphere.points.size());
        if (is_new) {
            const Point& p = sphere.points[a];
            const Point& q = sphere.points[b];
            sphere.points.push_back(unit({p[0] + q[0], p[1] + q[1], p[2] + q[2]}));
        }
        return place->second;
    };
    for (const auto& [a, b, c] : coarse.faces) {
        const std::size_t ab = middle(a, b);
        const std::size_t bc = middle(b, c);
        const std::size_t ca = middle(c, a);
        for (const Face& face : {Face{a, ab, ca}, Face{b, bc, ab}, Face{c, ca, bc}, Face{ab, bc, ca}}) {
            sphere.faces.push_back(face);
        }
    }
    return sphere;
}

void write_vertex(std::ostream& out, double x_m, double y_m, double z_m, Colour colour) {
    out << plain_number(x_m, 3) << ' ' << plain_number(y_m, 3) << ' ' << plain_number(z_m, 3) << ' '
        << int{colour.red} << ' ' << int{colour.green} << ' ' << int{colour.blue} << '\n';
}

}  // namespace

void write_surface_ply(const rockfall::BlockCover& cover, std::ostream& out) {
    const std::vector<rockfall::Block> blocks = shown_blocks(cover);
    const Sphere sphere = blocks.size() > many_blocks ? icosahedron() : finer(icosahedron());
    const std::size_t count = blocks.size();
    out << "ply\nformat ascii 1.0\ncomment virtual surface, metres, z up\nelement vertex "
        << 4 + count * sphere.points.size()
        << "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nproperty uchar "
           "green\nproperty uchar blue\nelement face "
        << 1 + count * sphere.faces.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
    constexpr Colour ground{0xa8, 0xa0, 0x88};
    const double side_m = shown_side_m(cover);
    for (const auto& [x_m, y_m] : {std::pair{0.0, 0.0}, {side_m, 0.0}, {side_m, side_m}, {0.0, side_m}}) {
        write_vertex(out, x_m, y_m, 0.0, ground);
    }
    const double highest_m = std::max(cover.highest_m(), 0.05);
    for (const rockfall::Block& block : blocks) {
        const Colour colour = colour_at(Palette::deposits, 0.2 + 0.8 * block.top_m() / highest_m);
        for (const Point& p : sphere.points) {
            write_vertex(out, block.x_m + block.radius_m * p[0], block.y_m + block.radius_m * p[1],
                         block.z_m + block.radius_m * p[2], colour);
        }
    }
    out << "4 0 1 2 3\n";
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t first = 4 + i * sphere.points.size();
        for (const auto& [a, b, c] : sphere.faces) {
            out << "3 " << first + a << ' ' << first + b << ' ' << first + c << '\n';
        }
    }
}

}  // namespace coupling
