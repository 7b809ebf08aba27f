#include "rockfall/terrain/grid_mesh.hpp"

#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "rockfall/terrain/hilbert.hpp"

namespace rockfall {
namespace {

/// Corners of a square between four neighbouring cell centres, counter-clockwise from the south-west; side s
/// leads from corner s to the next one: south, east, north, west.
constexpr std::array<config::Cell, 4> corner_offsets{{{0, 1}, {1, 1}, {1, 0}, {0, 0}}};
constexpr std::array<config::Cell, 4> across_side{{{0, 1}, {1, 0}, {0, -1}, {-1, 0}}};

/// A triangle by its square and its half of it: half 0 has the right angle in the south-west, half 1 in the
/// north-east; the only triangle of a square without one of its corners is half 0.
struct Half {
    std::size_t square;
    std::uint32_t half;
};

/// Which triangles of a grid are ground, and what they touch.
class Squares {
public:
    explicit Squares(const config::Raster<double>& heights)
        : frame_{heights.frame},
          columns_{heights.frame.columns - 1},
          rows_{heights.frame.rows - 1},
          known_(columns_ > 0 && rows_ > 0
                     ? static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)
                     : 0) {
        for (std::size_t square = 0; square < known_.size(); ++square) {
            const config::Cell place = place_of(square);
            std::uint8_t known = 0;
            for (std::size_t corner = 0; corner < 4; ++corner) {
                known = static_cast<std::uint8_t>(
                    known |
                    (std::isfinite(heights.at(moved(place, corner_offsets[corner]))) ? 1U << corner : 0U));
            }
            known_[square] = known;
        }
    }

    [[nodiscard]] std::size_t size() const { return known_.size(); }
    [[nodiscard]] std::uint32_t triangles_in(std::size_t square) const {
        constexpr std::array<std::uint8_t, 16> by_known_corners{0, 0, 0, 0, 0, 0, 0, 1,
                                                                0, 0, 0, 1, 0, 1, 1, 2};
        return by_known_corners[known_[square]];
    }
    /// The cells at the corners of a triangle, counter-clockwise from the right angle.
    [[nodiscard]] std::array<std::size_t, 3> cells_of(Half triangle) const {
        const config::Cell place = place_of(triangle.square);
        const std::size_t first = right_angle_of(triangle);
        const auto cell = [&](std::size_t corner) {
            return frame_.index(moved(place, corner_offsets[corner % 4]));
        };
        return {cell(first), cell(first + 1), cell(first + 3)};
    }
    /// Calls visit(edge, triangle) for each triangle across an edge.
    template <class Visit>
    void for_each_neighbour(Half triangle, Visit visit) const {
        const std::size_t first = right_angle_of(triangle);
        if (triangles_in(triangle.square) == 2) {
            visit(1, Half{triangle.square, 1 - triangle.half});
        }
        for (const auto& [edge, side] : {std::pair{0, first}, {2, (first + 3) % 4}}) {
            const config::Cell place = moved(place_of(triangle.square), across_side[side]);
            if (place.column < 0 || place.column >= columns_ || place.row < 0 || place.row >= rows_) {
                continue;
            }
            const std::size_t square = index_of(place);
            if (triangles_in(square) == 2) {
                // The side lies opposite to its own name there: north and east belong to half 1.
                visit(edge, Half{square, side == 0 || side == 3 ? 1U : 0U});
            } else if (triangles_in(square) == 1) {
                visit(edge, Half{square, 0});  // both ends of the side are known, so it is one of its legs
            }
        }
    }

private:
    static config::Cell moved(config::Cell place, config::Cell by) {
        return {place.column + by.column, place.row + by.row};
    }
    [[nodiscard]] config::Cell place_of(std::size_t square) const {
        // Numbers of 32 bits, which are divided several times faster.
        const auto number = static_cast<std::uint32_t>(square);
        const auto columns = static_cast<std::uint32_t>(columns_);
        return {static_cast<int>(number % columns), static_cast<int>(number / columns)};
    }
    [[nodiscard]] std::size_t index_of(config::Cell place) const {
        return static_cast<std::size_t>(place.row) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(place.column);
    }
    [[nodiscard]] std::size_t right_angle_of(Half triangle) const {
        constexpr unsigned all = 0xFU;
        const unsigned missing = all & ~static_cast<unsigned>(known_[triangle.square]);
        return missing == 0 ? 2 * triangle.half
                            : (static_cast<std::size_t>(std::countr_zero(missing)) + 2) % 4;
    }

    config::GridFrame frame_;
    int columns_;  ///< of squares
    int rows_;
    std::vector<std::uint8_t> known_;  ///< of each square a bit for each corner whose height is known
};

/// Places in metres from the origin, and the curve through those that count.
class Places {
public:
    Places(const config::GridFrame& frame, const Eigen::Vector2d& origin_m) : frame_{frame} {
        frame_.x_west_m -= origin_m.x();
        frame_.y_south_m -= origin_m.y();
    }
    [[nodiscard]] Eigen::Vector2d of_cell(std::size_t cell) const {
        const config::Cell place = frame_.cell_of(cell);
        return {frame_.x_centre_m(place.column), frame_.y_centre_m(place.row)};
    }
    [[nodiscard]] Eigen::Vector2d of_triangle(const std::array<std::size_t, 3>& cells) const {
        Eigen::Vector2d sum_m = Eigen::Vector2d::Zero();
        for (const std::size_t cell : cells) {
            sum_m += of_cell(cell);
        }
        return sum_m / 3.0;
    }

private:
    config::GridFrame frame_;
};

/// Numbers along the curve, for items that `for_each` names as (number, place).
template <class ForEach>
std::vector<std::uint32_t> along_curve(ForEach for_each) {
    PlanExtent extent;
    std::size_t count = 0;
    for_each([&](std::uint32_t, const Eigen::Vector2d& place) {
        extent.add(place);
        ++count;
    });
    const HilbertCurve curve{extent};
    std::vector<CurveKey> keys;
    keys.reserve(count);
    for_each([&](std::uint32_t number, const Eigen::Vector2d& place) {
        keys.push_back(curve.key_of(place, number));
    });
    return numbers_along(std::move(keys));
}

std::vector<std::uint32_t> ranks_of(const std::vector<std::uint32_t>& order, std::size_t size) {
    std::vector<std::uint32_t> ranks(size, no_triangle);
    for (std::size_t i = 0; i < order.size(); ++i) {
        ranks[order[i]] = static_cast<std::uint32_t>(i);
    }
    return ranks;
}

std::uint32_t number_of(Half triangle) {
    return static_cast<std::uint32_t>(2 * triangle.square) + triangle.half;
}

Half half_of(std::uint32_t number) {
    return {number / 2, number % 2};
}

/// Of the cells that a triangle has as a corner.
std::vector<std::uint32_t> cells_along_curve(const Squares& squares, const Places& places,
                                             std::size_t cells) {
    std::vector<bool> is_used(cells, false);
    for (std::size_t square = 0; square < squares.size(); ++square) {
        for (std::uint32_t half = 0; half < squares.triangles_in(square); ++half) {
            for (const std::size_t cell : squares.cells_of({square, half})) {
                is_used[cell] = true;
            }
        }
    }
    return along_curve([&](auto visit) {
        for (std::size_t cell = 0; cell < cells; ++cell) {
            if (is_used[cell]) {
                visit(static_cast<std::uint32_t>(cell), places.of_cell(cell));
            }
        }
    });
}

std::vector<std::uint32_t> triangles_along_curve(const Squares& squares, const Places& places) {
    return along_curve([&](auto visit) {
        for (std::size_t square = 0; square < squares.size(); ++square) {
            for (std::uint32_t half = 0; half < squares.triangles_in(square); ++half) {
                const Half triangle{square, half};
                visit(number_of(triangle), places.of_triangle(squares.cells_of(triangle)));
            }
        }
    });
}

/// The used cells along the curve as vertices. Sets the vertex of each cell.
std::vector<Vertex> vertices_along_curve(const config::Raster<double>& heights, const Squares& squares,
                                         const Places& places, std::vector<std::uint32_t>& vertex_of) {
    const std::vector<std::uint32_t> cells = cells_along_curve(squares, places, heights.values.size());
    vertex_of = ranks_of(cells, heights.values.size());
    std::vector<Vertex> vertices;
    vertices.reserve(cells.size());
    for (const std::uint32_t cell : cells) {
        const Eigen::Vector2d place_m = places.of_cell(cell);
        vertices.push_back({place_m.x(), place_m.y(), heights.values[cell]});
    }
    return vertices;
}

std::vector<Triangle> faces_along_curve(const Squares& squares, const Places& places,
                                        const std::vector<std::uint32_t>& vertex_of) {
    const std::vector<std::uint32_t> numbers = triangles_along_curve(squares, places);
    const std::vector<std::uint32_t> triangle_of = ranks_of(numbers, 2 * squares.size());
    std::vector<Triangle> triangles;
    triangles.reserve(numbers.size());
    for (const std::uint32_t number : numbers) {
        Triangle triangle{.corners = {}, .neighbours = {no_triangle, no_triangle, no_triangle}};
        const std::array<std::size_t, 3> cells = squares.cells_of(half_of(number));
        for (std::size_t corner = 0; corner < 3; ++corner) {
            triangle.corners[corner] = vertex_of[cells[corner]];
        }
        squares.for_each_neighbour(half_of(number), [&](int edge, Half across) {
            triangle.neighbours[edge] = triangle_of[number_of(across)];
        });
        triangles.push_back(triangle);
    }
    return triangles;
}

}  // namespace

Terrain mesh_of_every_cell(const config::Raster<double>& heights) {
    assert(heights.values.size() <= std::size_t{1} << 31U);
    const Eigen::Vector2d origin_m =
        Eigen::Vector2d{heights.frame.x_west_m, heights.frame.y_south_m}.array().floor();
    std::vector<Vertex> vertices;
    std::vector<Triangle> triangles;
    {  // What was only for the way is gone before the terrain adds its own.
        const Places places{heights.frame, origin_m};
        const Squares squares{heights};
        std::vector<std::uint32_t> vertex_of;
        vertices = vertices_along_curve(heights, squares, places, vertex_of);
        triangles = faces_along_curve(squares, places, vertex_of);
    }
    return Terrain{origin_m, std::move(vertices), std::move(triangles)};
}

}  // namespace rockfall
