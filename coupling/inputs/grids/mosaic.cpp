#include "coupling/inputs/grids/mosaic.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "config/errors/input_error.hpp"
#include "config/text/coordinates.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/tables/words.hpp"

namespace coupling::grids {
namespace {

using config::joined;

constexpr double cell_slack = 0.01;  // of a cell, as for grids on one frame (config::same_place)
constexpr std::size_t most_cells = 400'000'000;

void refuse_two(const TilePlace& one, const TilePlace& other, std::string found, std::string expected,
                std::string advice) {
    config::fail(config::ExitCode::data, {one.file}, std::move(found),
                 joined(expected, ", as ", other.file, " has them"), std::move(advice));
}

std::string cells_in_words(const config::GridFrame& frame) {
    std::string size = config::metres_in_words(frame.cell_width_m);
    if (frame.cell_width_m != frame.cell_height_m) {
        size += joined(" x ", config::metres_in_words(frame.cell_height_m));
    }
    return joined("cells of ", size, " m");
}

bool has_other_cells(const config::GridFrame& a, const config::GridFrame& b) {
    return std::abs(a.cell_width_m - b.cell_width_m) * std::max(a.columns, b.columns) >
               cell_slack * a.cell_width_m ||
           std::abs(a.cell_height_m - b.cell_height_m) * std::max(a.rows, b.rows) >
               cell_slack * a.cell_height_m;
}

/// How many cells lie between two places, and how far that is from a whole number of them.
struct Steps {
    double whole = 0.0;
    double off = 0.0;
};
Steps steps_between(double from_m, double to_m, double cell_m) {
    const double steps = (to_m - from_m) / cell_m;
    return {std::round(steps), std::abs(steps - std::round(steps))};
}

/// The edges of tiles along one axis, and between which of them a tile reaches.
std::vector<int> edges_of(const std::vector<std::pair<int, int>>& spans, int end) {
    std::vector<int> edges{0, end};
    for (const auto& [first, last] : spans) {
        edges.push_back(std::clamp(first, 0, end));
        edges.push_back(std::clamp(last, 0, end));
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

std::size_t place_of(const std::vector<int>& edges, int edge) {
    return static_cast<std::size_t>(
        std::lower_bound(edges.begin(), edges.end(), std::clamp(edge, 0, edges.back())) - edges.begin());
}

/// Which of the rectangles between edges tiles reach.
struct Reach {
    std::vector<int> columns;
    std::vector<int> rows;
    std::vector<std::uint8_t> is_reached;

    [[nodiscard]] std::size_t width() const { return columns.size() - 1; }
    [[nodiscard]] std::size_t height() const { return rows.size() - 1; }
    [[nodiscard]] bool at(std::size_t column, std::size_t row) const {
        return is_reached[row * width() + column] != 0;
    }
};

/// The first and the last reached rectangle of each row or column.
struct Ends {
    std::size_t first = std::numeric_limits<std::size_t>::max();
    std::size_t last = 0;
    void take(std::size_t place) {
        first = std::min(first, place);
        last = std::max(last, place);
    }
    [[nodiscard]] bool enclose(std::size_t place) const { return first < place && place < last; }
};

Reach reach_of(const MosaicPlan& plan) {
    std::vector<std::pair<int, int>> across;
    std::vector<std::pair<int, int>> down;
    for (const TilePlace& tile : plan.tiles) {
        across.emplace_back(tile.first.column, tile.first.column + tile.frame.columns);
        down.emplace_back(tile.first.row, tile.first.row + tile.frame.rows);
    }
    Reach reach{edges_of(across, plan.frame.columns), edges_of(down, plan.frame.rows), {}};
    reach.is_reached.assign(reach.width() * reach.height(), 0);
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
        const std::size_t last_row = place_of(reach.rows, down[i].second);
        const std::size_t last_column = place_of(reach.columns, across[i].second);
        for (std::size_t row = place_of(reach.rows, down[i].first); row < last_row; ++row) {
            for (std::size_t column = place_of(reach.columns, across[i].first); column < last_column;
                 ++column) {
                reach.is_reached[row * reach.width() + column] = 1;
            }
        }
    }
    return reach;
}

void refuse_other_cells(const std::vector<TilePlace>& tiles) {
    const TilePlace& first = tiles.front();
    for (const TilePlace& tile : tiles) {
        if (has_other_cells(first.frame, tile.frame)) {
            refuse_two(tile, first, cells_in_words(tile.frame), cells_in_words(first.frame),
                       "list the tiles of one size of cells alone, in a text file with a name in each line");
        }
    }
}

/// Gives each tile its place on the lattice of all of them, whose frame comes back.
config::GridFrame place_tiles(std::vector<TilePlace>& tiles) {
    config::GridFrame frame = tiles.front().frame;
    for (const TilePlace& tile : tiles) {
        frame.x_west_m = std::min(frame.x_west_m, tile.frame.x_west_m);
        frame.y_south_m = std::min(frame.y_south_m, tile.frame.y_south_m);
    }
    double columns = 0.0;
    double rows = 0.0;
    double known = 0.0;                                  // cells of all tiles
    std::vector<std::pair<double, double>> from_corner;  // columns from the west, rows from the south
    for (const TilePlace& tile : tiles) {
        const Steps east = steps_between(frame.x_west_m, tile.frame.x_west_m, frame.cell_width_m);
        const Steps north = steps_between(frame.y_south_m, tile.frame.y_south_m, frame.cell_height_m);
        if (const double off = std::max(east.off, north.off); off > cell_slack) {
            refuse_two(tile, tiles.front(),
                       joined("cells that are shifted by ", config::to_text(std::round(100.0 * off) / 100.0),
                              " of their size"),
                       "cells on one lattice",
                       "correct the place of the tile (half a cell is the difference between the corner and "
                       "the centre of a cell), or resample it to the lattice of the others (gdalwarp -tap)");
        }
        from_corner.emplace_back(east.whole, north.whole);
        known += static_cast<double>(tile.frame.size());
        columns = std::max(columns, east.whole + tile.frame.columns);
        rows = std::max(rows, north.whole + tile.frame.rows);
    }
    constexpr double most_of_side = 1e9;
    constexpr double most_times_tiles = 1000.0;  // the area that all tiles have [choice]
    if (columns > most_of_side || rows > most_of_side || columns * rows > most_times_tiles * known) {
        const config::GridFrame& last = tiles.back().frame;
        refuse_two(tiles.back(), tiles.front(),
                   joined("a corner at ", config::place_in_words(last.x_west_m, last.y_south_m)),
                   "places near each other", "take the tile out that lies elsewhere");
    }
    frame.columns = static_cast<int>(columns);
    frame.rows = static_cast<int>(rows);
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        tiles[i].first = {static_cast<int>(from_corner[i].first),
                          frame.rows - static_cast<int>(from_corner[i].second) - tiles[i].frame.rows};
    }
    return frame;
}

/// Requires tiles in the order of their places.
void refuse_same_place(const std::vector<TilePlace>& tiles) {
    for (std::size_t i = 1; i < tiles.size(); ++i) {
        const TilePlace& before = tiles[i - 1];
        if (before.first == tiles[i].first && before.frame.columns == tiles[i].frame.columns &&
            before.frame.rows == tiles[i].frame.rows) {
            config::fail(
                config::ExitCode::data, {tiles[i].file}, joined("the very place of ", before.file),
                "one tile for each place",
                "take one of the two out: they may be of two years, or one of them surface or shading");
        }
    }
}

}  // namespace

CellWindow cells_in(const config::GridFrame& frame, const MapWindow& window, const std::string& file) {
    // A centre on the border of the window is inside.
    const auto first_at = [](double steps) { return std::ceil(steps - 0.5 - 1e-9); };
    const auto last_at = [](double steps) { return std::floor(steps - 0.5 + 1e-9); };
    const double first_column =
        std::max(0.0, first_at((window.west_m - frame.x_west_m) / frame.cell_width_m));
    const double last_column =
        std::min(frame.columns - 1.0, last_at((window.east_m - frame.x_west_m) / frame.cell_width_m));
    const double first_row =
        std::max(0.0, first_at((frame.y_north_m() - window.north_m) / frame.cell_height_m));
    const double last_row =
        std::min(frame.rows - 1.0, last_at((frame.y_north_m() - window.south_m) / frame.cell_height_m));
    constexpr double least = 3.0;
    if (last_column - first_column + 1.0 < least || last_row - first_row + 1.0 < least) {
        config::fail(config::ExitCode::data, {file},
                     joined(to_string(frame), ", of which terrain.extent_m takes fewer than 3 x 3 cells"),
                     "west, south, east, north of a part of this grid",
                     "correct terrain.extent_m, or leave it out: the whole grid is taken then");
    }
    return {{static_cast<int>(first_column), static_cast<int>(first_row)},
            static_cast<int>(last_column - first_column) + 1,
            static_cast<int>(last_row - first_row) + 1};
}

config::GridFrame frame_of(const config::GridFrame& frame, const CellWindow& cells) {
    config::GridFrame part = frame;
    part.columns = cells.columns;
    part.rows = cells.rows;
    part.x_west_m = frame.x_west_m + cells.first.column * frame.cell_width_m;
    part.y_south_m = frame.y_south_m + (frame.rows - cells.first.row - cells.rows) * frame.cell_height_m;
    return part;
}

config::Raster<double> cut_out(const config::Raster<double>& grid, const CellWindow& cells) {
    config::Raster<double> part{frame_of(grid.frame, cells)};
    for (int row = 0; row < cells.rows; ++row) {
        const auto from =
            grid.values.begin() +
            static_cast<std::ptrdiff_t>(grid.frame.index({cells.first.column, cells.first.row + row}));
        std::copy_n(from, cells.columns,
                    part.values.begin() + static_cast<std::ptrdiff_t>(part.frame.index({0, row})));
    }
    return part;
}

MosaicPlan plan_mosaic(std::vector<TilePlace> tiles) {
    std::sort(tiles.begin(), tiles.end(), [](const TilePlace& a, const TilePlace& b) {
        return std::tuple{-a.frame.y_north_m(), a.frame.x_west_m, a.file} <
               std::tuple{-b.frame.y_north_m(), b.frame.x_west_m, b.file};
    });
    refuse_other_cells(tiles);
    MosaicPlan plan;
    plan.frame = place_tiles(tiles);
    // In whole cells: corners in metres may differ by their last digits.
    std::stable_sort(tiles.begin(), tiles.end(), [](const TilePlace& a, const TilePlace& b) {
        return std::tuple{a.first.row, a.first.column, a.frame.columns, a.frame.rows, a.file} <
               std::tuple{b.first.row, b.first.column, b.frame.columns, b.frame.rows, b.file};
    });
    refuse_same_place(tiles);
    plan.tiles = std::move(tiles);
    return plan;
}

MosaicPlan plan_of(MosaicPlan plan, const CellWindow& cells) {
    plan.frame = frame_of(plan.frame, cells);
    for (TilePlace& tile : plan.tiles) {
        tile.first.column -= cells.first.column;
        tile.first.row -= cells.first.row;
    }
    std::erase_if(plan.tiles, [&](const TilePlace& tile) {
        return tile.first.column >= cells.columns || tile.first.row >= cells.rows ||
               tile.first.column + tile.frame.columns <= 0 || tile.first.row + tile.frame.rows <= 0;
    });
    return plan;
}

MosaicGaps gaps_of(const MosaicPlan& plan) {
    const Reach reach = reach_of(plan);
    std::vector<Ends> of_rows(reach.height());
    std::vector<Ends> of_columns(reach.width());
    for (std::size_t row = 0; row < reach.height(); ++row) {
        for (std::size_t column = 0; column < reach.width(); ++column) {
            if (reach.at(column, row)) {
                of_rows[row].take(column);
                of_columns[column].take(row);
            }
        }
    }
    MosaicGaps gaps;
    for (std::size_t row = 0; row < reach.height(); ++row) {
        for (std::size_t column = 0; column < reach.width(); ++column) {
            if (reach.at(column, row)) {
                continue;
            }
            const auto cells = static_cast<std::size_t>(reach.columns[column + 1] - reach.columns[column]) *
                               static_cast<std::size_t>(reach.rows[row + 1] - reach.rows[row]);
            if (!of_rows[row].enclose(column) && !of_columns[column].enclose(row)) {
                gaps.beside += cells;
            } else {
                if (gaps.between == 0) {
                    gaps.first_between = plan.frame.index({reach.columns[column], reach.rows[row]});
                }
                gaps.between += cells;
            }
        }
    }
    return gaps;
}

Mosaic::Mosaic(const MosaicPlan& plan, const std::string& file) : plan_{plan} {
    if (plan.frame.size() > most_cells) {
        config::fail(config::ExitCode::data, {file}, joined("tiles of together ", to_string(plan.frame)),
                     "at most 400 million cells",
                     "take the part that matters: terrain.extent_m = west, south, east, north");
    }
    grid_ = config::Raster<double>{plan.frame, std::numeric_limits<double>::quiet_NaN()};
}

void Mosaic::lay(std::size_t number, const config::Raster<double>& tile) {
    const TilePlace& place = plan_.tiles[number];
    for (int row = 0; row < tile.frame.rows; ++row) {
        for (int column = 0; column < tile.frame.columns; ++column) {
            const config::Cell cell{place.first.column + column, place.first.row + row};
            const double value = tile.at({column, row});
            if (!plan_.frame.contains(cell) || std::isnan(value)) {
                continue;
            }
            const std::size_t index = plan_.frame.index(cell);
            double& laid = grid_.values[index];
            if (std::isnan(laid)) {
                laid = value;
                continue;
            }
            ++overlap_.cells;
            if (const double difference = std::abs(laid - value); difference > 0.0) {
                ++overlap_.different;
                overlap_.sum_of_differences += difference;
                if (difference > overlap_.largest) {
                    overlap_.largest = difference;
                    overlap_.first = index;
                    overlap_.file = place.file;
                }
            }
        }
    }
}

}  // namespace coupling::grids
