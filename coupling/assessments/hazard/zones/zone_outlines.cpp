#include "coupling/assessments/hazard/zones/zone_outlines.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>

namespace coupling::hazard::zones {
namespace {

using config::Point2;
using Levels = config::Raster<std::uint8_t>;

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

/// Sides of cells: first the horizontal ones row by row, then the vertical ones.
class Sides {
public:
    explicit Sides(const config::GridFrame& frame)
        : columns_{static_cast<std::size_t>(frame.columns)}, rows_{static_cast<std::size_t>(frame.rows)} {}
    [[nodiscard]] std::size_t count() const { return columns_ * (rows_ + 1) + (columns_ + 1) * rows_; }
    /// Above a row, under a column.
    [[nodiscard]] std::size_t horizontal(std::size_t column, std::size_t row) const {
        return row * columns_ + column;
    }
    /// West of a column.
    [[nodiscard]] std::size_t vertical(std::size_t column, std::size_t row) const {
        return columns_ * (rows_ + 1) + row * (columns_ + 1) + column;
    }
    [[nodiscard]] bool is_horizontal(std::size_t side) const { return side < columns_ * (rows_ + 1); }
    [[nodiscard]] std::size_t corner(std::size_t column, std::size_t row) const {
        return row * (columns_ + 1) + column;
    }
    [[nodiscard]] std::size_t corners() const { return (columns_ + 1) * (rows_ + 1); }
    [[nodiscard]] std::array<std::size_t, 2> ends_of(std::size_t side) const {
        if (is_horizontal(side)) {
            const std::size_t row = side / columns_;
            const std::size_t column = side % columns_;
            return {corner(column, row), corner(column + 1, row)};
        }
        const std::size_t rest = side - columns_ * (rows_ + 1);
        const std::size_t row = rest / (columns_ + 1);
        const std::size_t column = rest % (columns_ + 1);
        return {corner(column, row), corner(column, row + 1)};
    }
    /// The sides at a corner: north, east, south, west; `none` beyond the map.
    [[nodiscard]] std::array<std::size_t, 4> at(std::size_t corner) const {
        const std::size_t column = corner % (columns_ + 1);
        const std::size_t row = corner / (columns_ + 1);
        return {row > 0 ? vertical(column, row - 1) : none,
                column < columns_ ? horizontal(column, row) : none,
                row < rows_ ? vertical(column, row) : none, column > 0 ? horizontal(column - 1, row) : none};
    }
    /// The cells around a corner: north-west, north-east, south-east, south-west; `none` beyond the map.
    [[nodiscard]] std::array<std::size_t, 4> cells_at(std::size_t corner) const {
        const std::size_t column = corner % (columns_ + 1);
        const std::size_t row = corner / (columns_ + 1);
        const auto cell = [&](std::size_t c, std::size_t r) {
            return c < columns_ && r < rows_ ? r * columns_ + c : none;  // 0 - 1 lies beyond too
        };
        return {cell(column - 1, row - 1), cell(column, row - 1), cell(column, row), cell(column - 1, row)};
    }
    /// The cells on both sides; `none` beyond the map.
    [[nodiscard]] std::array<std::size_t, 2> cells_of(std::size_t side) const {
        const auto ends = ends_of(side);
        const std::size_t column = ends[0] % (columns_ + 1);
        const std::size_t row = ends[0] / (columns_ + 1);
        if (is_horizontal(side)) {
            return {row > 0 ? (row - 1) * columns_ + column : none,
                    row < rows_ ? row * columns_ + column : none};
        }
        return {column > 0 ? row * columns_ + column - 1 : none,
                column < columns_ ? row * columns_ + column : none};
    }

private:
    std::size_t columns_;
    std::size_t rows_;
};

/// How outlines go through a corner: for each of its four sides the side at which they go on; `none` where
/// zones meet or where no outline comes.
using Turns = std::array<std::size_t, 4>;

/// Which cells are one zone across a corner: 0 none, 1 north-west and south-east, 2 the others.
int joined_across(const std::array<int, 4>& levels) {
    const auto [nw, ne, se, sw] = levels;
    const bool first = nw == se && nw != ne && nw != sw;
    const bool second = ne == sw && ne != nw && ne != se;
    return first && second ? (nw > ne ? 1 : 2) : first ? 1 : second ? 2 : 0;
}

class Outliner {
public:
    explicit Outliner(const Levels& cells) : levels_{cells}, sides_{cells.frame} {
        find_zones();
        find_arcs();
    }
    [[nodiscard]] std::vector<ZoneOutline> outlines() const;

private:
    struct Arc {
        std::vector<std::size_t> corners;  ///< one more than sides; a closed one ends where it begins
        bool closed = false;
        std::vector<Point2> points;  ///< smoothed; the first is the last of a closed one
    };

    [[nodiscard]] int level_of(std::size_t cell) const { return cell == none ? 0 : levels_.values[cell]; }
    [[nodiscard]] std::array<int, 4> levels_at(std::size_t corner) const {
        const auto cells = sides_.cells_at(corner);
        return {level_of(cells[0]), level_of(cells[1]), level_of(cells[2]), level_of(cells[3])};
    }
    [[nodiscard]] bool is_outline(std::size_t side) const {
        const auto cells = sides_.cells_of(side);
        return level_of(cells[0]) != level_of(cells[1]);
    }
    /// Whether the side between two corners lies on the border of the map.
    [[nodiscard]] bool is_border(std::size_t from, std::size_t to) const {
        const auto columns = static_cast<std::size_t>(levels_.frame.columns);
        const auto rows = static_cast<std::size_t>(levels_.frame.rows);
        const std::size_t across = columns + 1;
        const bool along_row = from / across == to / across;
        const std::size_t place = along_row ? from / across : from % across;
        return place == 0 || place == (along_row ? rows : columns);
    }
    [[nodiscard]] std::size_t go_on(std::size_t side, std::size_t corner) const;
    void find_zones();
    void find_arcs();
    void follow(std::size_t side, std::size_t from, bool closed);
    void smooth(Arc& arc) const;
    [[nodiscard]] Point2 place_of(std::size_t corner) const;
    [[nodiscard]] std::size_t root(std::size_t cell);
    [[nodiscard]] std::vector<std::vector<Point2>> rings_of(const std::vector<std::size_t>& arcs,
                                                            std::size_t zone) const;

    const Levels& levels_;
    Sides sides_;
    std::vector<std::size_t> zone_of_;  ///< by cell, the first cell of its zone
    std::vector<std::size_t> arc_of_;   ///< by side
    std::vector<Arc> arcs_;
};

std::size_t Outliner::go_on(std::size_t side, std::size_t corner) const {
    const auto at = sides_.at(corner);
    const auto levels = levels_at(corner);
    const std::array<bool, 4> drawn{levels[0] != levels[1], levels[1] != levels[2], levels[2] != levels[3],
                                    levels[3] != levels[0]};  // north, east, south, west
    const auto here = static_cast<std::size_t>(std::find(at.begin(), at.end(), side) - at.begin());
    const auto count = std::count(drawn.begin(), drawn.end(), true);
    if (count == 2) {
        for (std::size_t i = 0; i < 4; ++i) {
            if (i != here && drawn[i]) {
                return at[i];
            }
        }
    }
    const int across = count == 4 ? joined_across(levels) : 0;
    if (across == 0) {
        return none;
    }
    // Joined north-west and south-east: outlines go around the north-east (north, east) and the south-west.
    constexpr std::array<std::size_t, 4> first{1, 0, 3, 2};
    constexpr std::array<std::size_t, 4> second{3, 2, 1, 0};
    return at[(across == 1 ? first : second)[here]];
}

std::size_t Outliner::root(std::size_t cell) {
    while (zone_of_[cell] != cell) {
        zone_of_[cell] = zone_of_[zone_of_[cell]];
        cell = zone_of_[cell];
    }
    return cell;
}

void Outliner::find_zones() {
    zone_of_.resize(levels_.values.size());
    std::iota(zone_of_.begin(), zone_of_.end(), std::size_t{0});
    const auto join = [&](std::size_t a, std::size_t b) {
        const std::size_t ra = root(a);
        const std::size_t rb = root(b);
        zone_of_[std::max(ra, rb)] = std::min(ra, rb);
    };
    for (std::size_t side = 0; side < sides_.count(); ++side) {
        const auto cells = sides_.cells_of(side);
        if (cells[0] != none && cells[1] != none && level_of(cells[0]) == level_of(cells[1])) {
            join(cells[0], cells[1]);
        }
    }
    for (std::size_t corner = 0; corner < sides_.corners(); ++corner) {
        const auto cells = sides_.cells_at(corner);
        const int across = joined_across(levels_at(corner));
        const std::array<std::size_t, 2> pair =
            across == 1 ? std::array{cells[0], cells[2]} : std::array{cells[1], cells[3]};
        if (across != 0 && pair[0] != none && pair[1] != none) {
            join(pair[0], pair[1]);
        }
    }
    for (std::size_t cell = 0; cell < zone_of_.size(); ++cell) {
        zone_of_[cell] = root(cell);
    }
}

/// From a node, or from anywhere on a closed outline, to the next node.
void Outliner::follow(std::size_t side, std::size_t from, bool closed) {
    Arc arc;
    arc.closed = closed;
    arc.corners.push_back(from);
    const std::size_t number = arcs_.size();
    while (side != none && arc_of_[side] == none) {
        arc_of_[side] = number;
        const auto ends = sides_.ends_of(side);
        from = ends[0] == from ? ends[1] : ends[0];
        arc.corners.push_back(from);
        side = go_on(side, from);
    }
    smooth(arc);
    arcs_.push_back(std::move(arc));
}

void Outliner::find_arcs() {
    arc_of_.assign(sides_.count(), none);
    for (std::size_t side = 0; side < sides_.count(); ++side) {
        if (!is_outline(side) || arc_of_[side] != none) {
            continue;
        }
        for (const std::size_t end : sides_.ends_of(side)) {
            if (arc_of_[side] == none && go_on(side, end) == none) {
                follow(side, end, false);
            }
        }
    }
    for (std::size_t side = 0; side < sides_.count(); ++side) {
        if (is_outline(side) && arc_of_[side] == none) {
            follow(side, sides_.ends_of(side)[0], true);
        }
    }
}

Point2 Outliner::place_of(std::size_t corner) const {
    const config::GridFrame& frame = levels_.frame;
    const auto across = static_cast<std::size_t>(frame.columns) + 1;
    return {frame.x_west_m + static_cast<double>(corner % across) * frame.cell_width_m,
            frame.y_north_m() - static_cast<double>(corner / across) * frame.cell_height_m};
}

Point2 between(const Point2& a, const Point2& b, double share) {
    return {a.x_m + share * (b.x_m - a.x_m), a.y_m + share * (b.y_m - a.y_m)};
}

/// Corners cut at a quarter and three quarters of each side; the ends of an open line stay.
std::vector<Point2> corners_cut(const std::vector<Point2>& points, bool closed) {
    constexpr double quarter = 0.25;
    std::vector<Point2> cut;
    if (!closed) {
        cut.push_back(points.front());
    }
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        cut.push_back(between(points[i], points[i + 1], quarter));
        cut.push_back(between(points[i], points[i + 1], 1.0 - quarter));
    }
    cut.push_back(closed ? cut.front() : points.back());
    return cut;
}

void Outliner::smooth(Arc& arc) const {
    std::vector<Point2> points;
    if (!arc.closed) {
        points.push_back(place_of(arc.corners.front()));
    }
    for (std::size_t i = 0; i + 1 < arc.corners.size(); ++i) {
        // Along the border of the map outlines stay on it; an open one has its first corner already.
        if ((arc.closed || i > 0) && is_border(arc.corners[i], arc.corners[i + 1])) {
            points.push_back(place_of(arc.corners[i]));
        }
        points.push_back(between(place_of(arc.corners[i]), place_of(arc.corners[i + 1]), 0.5));
    }
    points.push_back(arc.closed ? points.front() : place_of(arc.corners.back()));
    arc.points = corners_cut(corners_cut(points, arc.closed), arc.closed);
}

/// Rings of a zone, arc by arc: at a node each zone goes on at the one other arc that it has there.
std::vector<std::vector<Point2>> Outliner::rings_of(const std::vector<std::size_t>& arcs,
                                                    std::size_t zone) const {
    std::vector<bool> used(arcs.size(), false);
    std::vector<std::vector<Point2>> rings;
    const auto touches = [&](std::size_t side) {
        const auto cells = sides_.cells_of(side);
        return (cells[0] != none && zone_of_[cells[0]] == zone) ||
               (cells[1] != none && zone_of_[cells[1]] == zone);
    };
    for (std::size_t first = 0; first < arcs.size(); ++first) {
        if (used[first]) {
            continue;
        }
        std::vector<Point2> ring = arcs_[arcs[first]].points;
        used[first] = true;
        const Arc& begin = arcs_[arcs[first]];
        std::size_t at = begin.corners.back();
        std::size_t current = arcs[first];
        while (!begin.closed && at != begin.corners.front()) {
            std::size_t next = none;
            for (const std::size_t side : sides_.at(at)) {
                if (side != none && arc_of_[side] != none && arc_of_[side] != current && touches(side)) {
                    next = arc_of_[side];
                }
            }
            assert(next != none);
            const auto place =
                static_cast<std::size_t>(std::find(arcs.begin(), arcs.end(), next) - arcs.begin());
            used[place] = true;
            const Arc& arc = arcs_[next];
            std::vector<Point2> points = arc.points;
            if (arc.corners.front() != at) {
                std::reverse(points.begin(), points.end());
            }
            ring.insert(ring.end(), points.begin() + 1, points.end());
            at = arc.corners.front() == at ? arc.corners.back() : arc.corners.front();
            current = next;
        }
        rings.push_back(std::move(ring));
    }
    return rings;
}

double signed_area_m2(const std::vector<Point2>& ring) {
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
        sum += (ring[i].x_m - ring[0].x_m) * (ring[i + 1].y_m - ring[0].y_m) -
               (ring[i + 1].x_m - ring[0].x_m) * (ring[i].y_m - ring[0].y_m);
    }
    return 0.5 * sum;
}

std::vector<ZoneOutline> Outliner::outlines() const {
    std::vector<std::vector<std::size_t>> arcs_of_zone(zone_of_.size());
    for (std::size_t side = 0; side < sides_.count(); ++side) {
        if (arc_of_[side] == none) {
            continue;
        }
        for (const std::size_t cell : sides_.cells_of(side)) {
            if (cell != none && levels_.values[cell] > 0) {
                std::vector<std::size_t>& arcs = arcs_of_zone[zone_of_[cell]];
                if (std::find(arcs.begin(), arcs.end(), arc_of_[side]) == arcs.end()) {
                    arcs.push_back(arc_of_[side]);
                }
            }
        }
    }
    std::vector<ZoneOutline> found;
    for (std::size_t zone = 0; zone < arcs_of_zone.size(); ++zone) {
        if (arcs_of_zone[zone].empty()) {
            continue;
        }
        ZoneOutline& outline = found.emplace_back();
        outline.level = levels_.values[zone];
        outline.rings = rings_of(arcs_of_zone[zone], zone);
        double largest_m2 = 0.0;
        double all_m2 = 0.0;
        for (const auto& ring : outline.rings) {
            largest_m2 = std::max(largest_m2, std::abs(signed_area_m2(ring)));
            all_m2 += std::abs(signed_area_m2(ring));
        }
        outline.area_m2 = 2.0 * largest_m2 - all_m2;  // one outer ring, the others are holes in it
    }
    return found;
}

}  // namespace

std::vector<ZoneOutline> outlines_of(const Levels& cells) {
    return Outliner{cells}.outlines();
}

}  // namespace coupling::hazard::zones
