#include "config/geometry/shape.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace config {

namespace {

/// Whether an edge crosses the height y; its lower end counts, its upper one does not.
bool crosses(Point2 a, Point2 b, double y_m) {
    return (a.y_m > y_m) != (b.y_m > y_m);
}

/// Where the edge from a to b crosses the height y. The same from b to a, to the last bit.
double crossing_x_m(Point2 a, Point2 b, double y_m) {
    const auto [low, high] = a.y_m < b.y_m ? std::pair{a, b} : std::pair{b, a};
    return low.x_m + (y_m - low.y_m) / (high.y_m - low.y_m) * (high.x_m - low.x_m);
}

/// Where the rings of a polygon cross the height y, from west to east.
std::vector<double> crossings_x_m(const Shape& polygon, double y_m) {
    std::vector<double> crossings;
    for (const std::vector<Point2>& ring : polygon.parts) {
        for (std::size_t i = 1; i < ring.size(); ++i) {
            if (crosses(ring[i - 1], ring[i], y_m)) {
                crossings.push_back(crossing_x_m(ring[i - 1], ring[i], y_m));
            }
        }
    }
    std::sort(crossings.begin(), crossings.end());
    return crossings;
}

/// First column whose centre lies at x or east of it.
int first_column_from(const GridFrame& frame, double x_m) {
    const double guess = std::ceil((x_m - frame.x_west_m) / frame.cell_width_m - 0.5);
    int column = static_cast<int>(std::clamp(guess, 0.0, static_cast<double>(frame.columns)));
    while (column > 0 && frame.x_centre_m(column - 1) >= x_m) {
        --column;
    }
    while (column < frame.columns && frame.x_centre_m(column) < x_m) {
        ++column;
    }
    return column;
}

/// Rows whose centres may lie in a polygon: [first, last).
std::pair<int, int> rows_of(const GridFrame& frame, const Shape& polygon) {
    double lowest_m = frame.y_north_m();
    double highest_m = frame.y_south_m;
    for (const std::vector<Point2>& ring : polygon.parts) {
        for (const Point2& point : ring) {
            lowest_m = std::min(lowest_m, point.y_m);
            highest_m = std::max(highest_m, point.y_m);
        }
    }
    const double rows = frame.rows;
    const double first = std::floor((frame.y_north_m() - highest_m) / frame.cell_height_m);
    const double last = std::ceil((frame.y_north_m() - lowest_m) / frame.cell_height_m);
    return {static_cast<int>(std::clamp(first, 0.0, rows)), static_cast<int>(std::clamp(last, 0.0, rows))};
}

void fill(Raster<double>& raster, const CodedPolygon& coded) {
    const GridFrame& frame = raster.frame;
    const auto [first_row, last_row] = rows_of(frame, coded.polygon);
    for (int row = first_row; row < last_row; ++row) {
        const std::vector<double> crossings = crossings_x_m(coded.polygon, frame.y_centre_m(row));
        for (std::size_t i = 1; i < crossings.size(); i += 2) {
            const int end = first_column_from(frame, crossings[i]);
            for (int column = first_column_from(frame, crossings[i - 1]); column < end; ++column) {
                raster.at({column, row}) = coded.code;
            }
        }
    }
}

double distance_m(Point2 a, Point2 b) {
    return std::hypot(b.x_m - a.x_m, b.y_m - a.y_m);
}

Point2 between(Point2 a, Point2 b, double share) {
    return {a.x_m + share * (b.x_m - a.x_m), a.y_m + share * (b.y_m - a.y_m)};
}

/// Share of the way from a to b at which it is nearest to a point [-].
double nearest_share(Point2 a, Point2 b, Point2 point) {
    const double dx_m = b.x_m - a.x_m;
    const double dy_m = b.y_m - a.y_m;
    const double squared = dx_m * dx_m + dy_m * dy_m;
    if (squared <= 0.0) {
        return 0.0;
    }
    return std::clamp(((point.x_m - a.x_m) * dx_m + (point.y_m - a.y_m) * dy_m) / squared, 0.0, 1.0);
}

/// The cells of one straight piece, row by row from its start.
class CellsOfSegment {
public:
    CellsOfSegment(const GridFrame& frame, Point2 from, Point2 to)
        : frame_{frame},
          from_column_{column_at(from.x_m)},
          to_column_{column_at(to.x_m)},
          from_row_{row_at(from.y_m)},
          to_row_{row_at(to.y_m)} {}

    template <class Visit>
    void visit(Visit&& visit_cell) const {
        const bool southward = to_row_ >= from_row_;
        const double start = std::floor(from_row_);
        const double end = std::floor(to_row_);
        const double southmost = frame_.rows - 1;
        if (std::max(start, end) < 0.0 || std::min(start, end) > southmost) {
            return;
        }
        const double first = std::clamp(start, 0.0, southmost);
        const double last = std::clamp(end, 0.0, southmost);
        for (int row = static_cast<int>(first); southward ? row <= last : row >= last;
             row += southward ? 1 : -1) {
            const double enters_at = row == start ? from_column_ : column_on(southward ? row : row + 1);
            const double leaves_at = row == end ? to_column_ : column_on(southward ? row + 1 : row);
            visit_columns(row, std::floor(enters_at), std::floor(leaves_at), visit_cell);
        }
    }

private:
    [[nodiscard]] double column_at(double x_m) const { return (x_m - frame_.x_west_m) / frame_.cell_width_m; }
    [[nodiscard]] double row_at(double y_m) const {
        return (frame_.y_north_m() - y_m) / frame_.cell_height_m;
    }

    /// Where the piece crosses the northern edge of a row, in columns.
    [[nodiscard]] double column_on(int row) const {
        const double share = std::clamp((row - from_row_) / (to_row_ - from_row_), 0.0, 1.0);
        return share < 1.0 ? from_column_ + share * (to_column_ - from_column_) : to_column_;
    }

    template <class Visit>
    void visit_columns(int row, double first, double last, Visit& visit_cell) const {
        const bool eastward = last >= first;
        const double outside = frame_.columns;
        const int begin = static_cast<int>(std::clamp(first, -1.0, outside));
        const int end = static_cast<int>(std::clamp(last, -1.0, outside));
        for (int column = begin; eastward ? column <= end : column >= end; column += eastward ? 1 : -1) {
            visit_cell(Cell{column, row});
        }
    }

    const GridFrame& frame_;
    double from_column_;
    double to_column_;
    double from_row_;
    double to_row_;
};

}  // namespace

bool point_in_polygon(const Shape& polygon, Point2 point) {
    assert(polygon.kind == Shape::Kind::polygon);
    bool inside = false;
    for (const double x_m : crossings_x_m(polygon, point.y_m)) {
        inside = inside != (x_m <= point.x_m);
    }
    return inside;
}

double length_m(std::span<const Point2> line) {
    double sum_m = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        sum_m += distance_m(line[i - 1], line[i]);
    }
    return sum_m;
}

LinePosition position_along(std::span<const Point2> line, Point2 point) {
    assert(!line.empty());
    LinePosition best{0.0, distance_m(line.front(), point)};
    double before_m = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const double piece_m = distance_m(line[i - 1], line[i]);
        const double share = nearest_share(line[i - 1], line[i], point);
        const double offset_m = distance_m(between(line[i - 1], line[i], share), point);
        if (offset_m < best.offset_m) {
            best = {before_m + share * piece_m, offset_m};
        }
        before_m += piece_m;
    }
    return best;
}

Point2 point_along(std::span<const Point2> line, double along_m) {
    assert(!line.empty());
    double left_m = std::max(along_m, 0.0);
    for (std::size_t i = 1; i < line.size(); ++i) {
        const double piece_m = distance_m(line[i - 1], line[i]);
        if (left_m < piece_m) {
            return between(line[i - 1], line[i], left_m / piece_m);
        }
        left_m -= piece_m;
    }
    return line.back();
}

Raster<double> rasterise_polygons(const GridFrame& frame, std::span<const CodedPolygon> polygons,
                                  double background) {
    Raster<double> raster{frame, background};
    for (const CodedPolygon& coded : polygons) {
        assert(coded.polygon.kind == Shape::Kind::polygon);
        fill(raster, coded);
    }
    return raster;
}

std::vector<Cell> cells_along_line(const GridFrame& frame, std::span<const Point2> line) {
    std::vector<Cell> cells;
    std::vector<bool> seen(frame.size());
    const auto note = [&](Cell cell) {
        if (frame.contains(cell) && !seen[frame.index(cell)]) {
            seen[frame.index(cell)] = true;
            cells.push_back(cell);
        }
    };
    for (std::size_t i = 1; i < line.size(); ++i) {
        CellsOfSegment{frame, line[i - 1], line[i]}.visit(note);
    }
    return cells;
}

}  // namespace config
