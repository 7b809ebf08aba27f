#include "rockfall/terrain/terrain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "rockfall/terrain/rim.hpp"

namespace rockfall {
namespace {

/// A walk longer than this costs more than the start grid.
constexpr int longest_walk = 24;

/// Triangles of mean size in a cell of the start grid: a list is then some 18 long, half of which is tried.
constexpr double triangles_per_start_cell = 8.0;

/// Twice the signed area of (a, b, point): positive if the point lies left of a -> b.
///
/// Exchanging a and b changes the sign and no other bit, so a point never lies beyond a shared edge for both
/// of its triangles: the mesh is watertight in floating point.
double side(const Vertex& a, const Vertex& b, double x_m, double y_m) {
    return (a.x_m - x_m) * (b.y_m - y_m) - (a.y_m - y_m) * (b.x_m - x_m);
}

/// Lower and upper end of something along an axis.
struct Range {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void include(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

/// Extent in x of that part of a triangle that lies between two northings; empty (low > high) without such a
/// part.
Range x_between(const Vertex* const (&corners)[3], double y_low_m, double y_high_m) {
    Range x_m;
    for (int i = 0; i < 3; ++i) {
        const Vertex* south = corners[i];
        const Vertex* north = corners[(i + 1) % 3];
        if (south->y_m > north->y_m) {
            std::swap(south, north);
        }
        if (south->y_m > y_high_m || north->y_m < y_low_m) {
            continue;
        }
        const double rise_m = north->y_m - south->y_m;
        const double per_m = rise_m > 0.0 ? (north->x_m - south->x_m) / rise_m : 0.0;
        x_m.include(south->y_m >= y_low_m ? south->x_m : south->x_m + per_m * (y_low_m - south->y_m));
        x_m.include(north->y_m <= y_high_m ? north->x_m : south->x_m + per_m * (y_high_m - south->y_m));
    }
    return x_m;
}

/// Calls visit(index) for each cell that the triangle reaches into, those within a millionth of a cell
/// included.
template <class Visit>
void for_each_cell(const config::GridFrame& frame, const Vertex* const (&corners)[3], Visit visit) {
    const double slack_m = 1e-6 * frame.cell_width_m;
    Range y_m;
    for (const Vertex* corner : corners) {
        y_m.include(corner->y_m);
    }
    const int first_row = std::max(frame.cell_at(0.0, y_m.high + slack_m).row, 0);
    const int last_row = std::min(frame.cell_at(0.0, y_m.low - slack_m).row, frame.rows - 1);
    for (int row = first_row; row <= last_row; ++row) {
        const double y_low_m = frame.y_centre_m(row) - 0.5 * frame.cell_height_m - slack_m;
        const double y_high_m = frame.y_centre_m(row) + 0.5 * frame.cell_height_m + slack_m;
        const Range x_m = x_between(corners, y_low_m, y_high_m);
        if (x_m.low > x_m.high) {
            continue;
        }
        const int first_column = std::max(frame.cell_at(x_m.low - slack_m, 0.0).column, 0);
        const int last_column = std::min(frame.cell_at(x_m.high + slack_m, 0.0).column, frame.columns - 1);
        for (int column = first_column; column <= last_column; ++column) {
            visit(frame.index({column, row}));
        }
    }
}

/// A grid of square cells over all vertices with a small margin.
config::GridFrame start_frame(std::span<const Vertex> vertices, double ground_area_m2,
                              std::size_t triangles) {
    Range x_m;
    Range y_m;
    for (const Vertex& vertex : vertices) {
        x_m.include(vertex.x_m);
        y_m.include(vertex.y_m);
    }
    const double width_m = x_m.high - x_m.low;
    const double height_m = y_m.high - y_m.low;
    const double count = static_cast<double>(triangles);
    // The second bound keeps the grid small where the ground fills little of its extent.
    const double cell_m =
        std::sqrt(std::max(triangles_per_start_cell * ground_area_m2, width_m * height_m) / count);
    return {.columns = static_cast<int>(width_m / cell_m) + 2,
            .rows = static_cast<int>(height_m / cell_m) + 2,
            .x_west_m = x_m.low - 0.5 * cell_m,
            .y_south_m = y_m.low - 0.5 * cell_m,
            .cell_width_m = cell_m,
            .cell_height_m = cell_m};
}

}  // namespace

Terrain::Terrain(Eigen::Vector2d origin_m, std::vector<Vertex> vertices, std::vector<Triangle> triangles)
    : origin_m_{std::move(origin_m)}, vertices_{std::move(vertices)}, triangles_{std::move(triangles)} {
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
        if (!(triangles_[i].normal_z > 0.0F)) {
            triangles_[i].normal_z =
                static_cast<float>(1.0 / std::sqrt(1.0 + plane_of(i).gradient.squaredNorm()));
        }
    }
    if (!triangles_.empty()) {
        fill_start_grid();
    }
    rim_ = std::make_shared<const Rim>(*this);
}

void Terrain::fill_start_grid() {
    double ground_area_m2 = 0.0;
    for (const Triangle& t : triangles_) {
        const Vertex& apex = vertices_[t.corners[2]];
        ground_area_m2 += 0.5 * side(vertices_[t.corners[0]], vertices_[t.corners[1]], apex.x_m, apex.y_m);
    }
    start_frame_ = start_frame(vertices_, ground_area_m2, triangles_.size());

    const auto for_each_entry = [this](auto visit) {
        for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
            const Triangle& t = triangles_[i];
            const Vertex* const corners[3] = {&vertices_[t.corners[0]], &vertices_[t.corners[1]],
                                              &vertices_[t.corners[2]]};
            for_each_cell(start_frame_, corners, [&](std::size_t cell) { visit(cell, i); });
        }
    };
    // Count, add up, fill from the back: the offsets end where each list begins.
    start_offsets_.assign(start_frame_.size() + 1, 0);
    for_each_entry([this](std::size_t cell, std::uint32_t) { ++start_offsets_[cell]; });
    std::uint32_t entries = 0;
    for (std::uint32_t& offset : start_offsets_) {
        entries += offset;
        offset = entries;
    }
    start_triangles_.resize(entries);
    for_each_entry(
        [this](std::size_t cell, std::uint32_t i) { start_triangles_[--start_offsets_[cell]] = i; });
}

std::optional<std::uint32_t> Terrain::locate(double x_m, double y_m, std::uint32_t hint) const {
    std::uint32_t here = hint;
    std::uint32_t came_from = no_triangle;
    for (int step = 0; step < longest_walk && here < triangles_.size(); ++step) {
        const Triangle& t = triangles_[here];
        bool is_inside = true;
        std::uint32_t next = no_triangle;
        for (std::size_t i = 0; i < 3 && next == no_triangle; ++i) {
            const bool was_crossed = t.neighbours[i] == came_from && came_from != no_triangle;
            if (!was_crossed &&
                !(side(vertices_[t.corners[i]], vertices_[t.corners[(i + 1) % 3]], x_m, y_m) >= 0.0)) {
                is_inside = false;
                next = t.neighbours[i];
            }
        }
        if (is_inside) {
            return here;
        }
        came_from = here;
        here = next;
    }
    // Far away, not a number, or beyond a border behind which the terrain may go on.
    return locate(x_m, y_m);
}

std::optional<std::uint32_t> Terrain::locate(double x_m, double y_m) const {
    if (!start_frame_.covers(x_m, y_m)) {
        return std::nullopt;
    }
    const config::Cell cell = start_frame_.cell_at(x_m, y_m);
    if (!start_frame_.contains(cell)) {
        return std::nullopt;  // rounded over the southern edge of the margin
    }
    const std::size_t list = start_frame_.index(cell);
    for (std::uint32_t entry = start_offsets_[list]; entry < start_offsets_[list + 1]; ++entry) {
        const Triangle& t = triangles_[start_triangles_[entry]];
        const Vertex& a = vertices_[t.corners[0]];
        const Vertex& b = vertices_[t.corners[1]];
        const Vertex& c = vertices_[t.corners[2]];
        if (side(a, b, x_m, y_m) >= 0.0 && side(b, c, x_m, y_m) >= 0.0 && side(c, a, x_m, y_m) >= 0.0) {
            return start_triangles_[entry];
        }
    }
    return std::nullopt;
}

std::optional<double> Terrain::height_m(double x_m, double y_m) const {
    const std::optional<std::uint32_t> triangle = locate(x_m, y_m);
    return triangle ? std::optional{plane_of(*triangle).height_m(x_m, y_m)} : std::nullopt;
}

}  // namespace rockfall
