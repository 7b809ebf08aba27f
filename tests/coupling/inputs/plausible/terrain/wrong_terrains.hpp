#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "coupling/inputs/plausible/terrain/height_field.hpp"

/// Synthetic ground, and the wrong terrains that people make of it.
namespace coupling::plausible::terrain {

/// Heights of their own, which a field only looks at.
struct Ground {
    int rows = 0;
    int columns = 0;
    double cell_m = 1.0;
    std::vector<double> heights_m;

    Ground(int rows_in, int columns_in, double cell_m_in,
           const std::function<double(int row, int column)>& height_m)
        : rows{rows_in}, columns{columns_in}, cell_m{cell_m_in} {
        for (int row = 0; row < rows; ++row) {
            for (int column = 0; column < columns; ++column) {
                heights_m.push_back(height_m(row, column));
            }
        }
    }

    [[nodiscard]] HeightField field() const {
        return {.rows = rows,
                .columns = columns,
                .column_spacing_m = cell_m,
                .row_spacing_m = cell_m,
                .heights_m = heights_m.data()};
    }
    [[nodiscard]] double at(int row, int column) const { return field().at(row, column); }
    [[nodiscard]] Ground changed(
        const std::function<double(double height_m, int row, int column)>& change) const {
        return {rows, columns, cell_m,
                [&](int row, int column) { return change(at(row, column), row, column); }};
    }
    /// Turned by 90 degrees.
    [[nodiscard]] Ground turned() const {
        return {columns, rows, cell_m, [&](int row, int column) { return at(column, columns - 1 - row); }};
    }
    [[nodiscard]] Ground mirrored() const {
        return {rows, columns, cell_m, [&](int row, int column) { return at(row, columns - 1 - column); }};
    }
};

/// A number in [-1, 1] that belongs to a node of a lattice.
inline double node(int octave, int row, int column) {
    std::uint64_t x = static_cast<std::uint64_t>(octave) * 0x9E3779B97F4A7C15ULL +
                      static_cast<std::uint64_t>(row + 1000) * 0xBF58476D1CE4E5B9ULL +
                      static_cast<std::uint64_t>(column + 1000) * 0x94D049BB133111EBULL;
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ULL;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBULL;
    x ^= x >> 31;
    return static_cast<double>(x >> 11) / static_cast<double>(1ULL << 52) - 1.0;
}

/// Smooth between the nodes, so that slopes go on from cell to cell.
inline double octave_m(int octave, double wave_cells, int row, int column) {
    const double y = row / wave_cells;
    const double x = column / wave_cells;
    const int r = static_cast<int>(std::floor(y));
    const int c = static_cast<int>(std::floor(x));
    const auto smooth = [](double t) { return t * t * t * (10.0 + t * (6.0 * t - 15.0)); };
    const double v = smooth(y - r);
    const double u = smooth(x - c);
    return (1.0 - v) * ((1.0 - u) * node(octave, r, c) + u * node(octave, r, c + 1)) +
           v * ((1.0 - u) * node(octave, r + 1, c) + u * node(octave, r + 1, c + 1));
}

/// A mountainside of 5 m cells: about 30 degrees steep, with spurs, gullies and rough ground, as the measured
/// terrains are (README.md of the rules).
inline Ground mountainside() {
    return {120, 150, 5.0, [](int row, int column) {
                double height_m = 900.0 + 2.6 * row + 0.7 * column;
                double wave_cells = 64.0;
                double size_m = 45.0;
                for (int octave = 0; octave < 6; ++octave, wave_cells *= 0.5, size_m *= 0.42) {
                    height_m += size_m * octave_m(octave, wave_cells, row, column);
                }
                return height_m;
            }};
}

/// Hills on a plain that drains, at uneven distances: closed summits and no closed hollow.
inline Ground hills() {
    return {120, 120, 10.0, [](int row, int column) {
                double hill_m = 0.0;
                for (int r = row / 24 - 1; r <= row / 24 + 1; ++r) {
                    for (int c = column / 24 - 1; c <= column / 24 + 1; ++c) {
                        const double y = 24.0 * r + 12.0 + 6.0 * node(30, r, c);
                        const double x = 24.0 * c + 12.0 + 6.0 * node(31, r, c);
                        const double away = std::hypot(row - y, column - x) / (11.0 + 2.0 * node(32, r, c));
                        hill_m = std::max(hill_m, 60.0 * (1.0 - away));
                    }
                }
                return 500.0 + 1.5 * row + hill_m + 1.5 * octave_m(3, 9.0, row, column);
            }};
}

/// A slope without rough ground, as meadows and forest soil are: what stands out by a few metres is wrong.
inline Ground smooth_slope() {
    return {100, 110, 5.0, [](int row, int column) {
                return 700.0 + 2.2 * row + 0.4 * column + 6.0 * octave_m(7, 22.0, row, column);
            }};
}

inline double rounded(double height_m, double step_m) {
    return std::round(height_m / step_m) * step_m;
}

/// A wrong terrain and the rule that has to see it.
struct Wrong {
    std::string what;
    std::string rule;
    bool is_error;
    Ground ground;
};

inline std::vector<Wrong> wrong_terrains() {
    const Ground real = mountainside();
    const Ground high = hills();
    const auto block = [&](double, int row, int column) { return real.at(row / 5 * 5, column / 5 * 5); };
    const auto with_crowns = [&](double height_m, int row, int column) {
        const double crown = node(20, row / 2, column / 2);
        return crown > 0.0 ? height_m + 18.0 * crown + 3.0 * node(21, row, column) : height_m;
    };
    const auto shade = [&](double, int row, int column) {
        const int next_row = std::min(row + 1, real.rows - 1);
        const int next_column = std::min(column + 1, real.columns - 1);
        const double along = real.at(next_row, column) - real.at(row, column);
        const double across = real.at(row, next_column) - real.at(row, column);
        return std::clamp(std::round(128.0 + 60.0 * across - 40.0 * along), 1.0, 254.0);
    };
    const auto speed = [&](double, int row, int column) {
        return 22.0 * std::abs(std::sin(0.35 * row + 0.31 * column));
    };
    const auto spike = [](double height_m, int row, int column) {
        return row % 31 == 7 && column % 29 == 11 ? height_m + 150.0 : height_m;
    };
    const double low_m = *std::min_element(high.heights_m.begin(), high.heights_m.end());
    const double high_m = *std::max_element(high.heights_m.begin(), high.heights_m.end());
    return {
        {"feet", "steepness", false, real.changed([](double z, int, int) { return z / 0.3048; })},
        {"decimetres", "steepness", true, real.changed([](double z, int, int) { return 10.0 * z; })},
        {"crowns", "unevenness", true, real.changed(with_crowns)},
        {"nearest neighbour", "steps", true, real.changed(block)},
        {"terraces of 10 m", "steps", true,
         real.changed([](double z, int, int) { return rounded(z, 10.0); })},
        {"terraces of 5 m", "steps", true, real.changed([](double z, int, int) { return rounded(z, 5.0); })},
        {"stripes of 4 m", "stripes", true,
         real.changed([](double z, int row, int) { return z + (row / 2 % 2 == 0 ? 4.0 : 0.0); })},
        {"stripes of 1 m", "stripes", true,
         real.changed([](double z, int, int column) { return z + (column % 2 == 0 ? 1.0 : 0.0); })},
        {"long stripes", "stripes", false,
         real.changed([](double z, int row, int) { return z + (row / 6 % 2 == 0 ? 1.0 : 0.0); })},
        {"oblique stripes", "stripes", true, real.changed([](double z, int row, int column) {
             return z + 2.0 * std::sin(1.0 * (row + column));
         })},
        {"spikes", "spikes", false, real.changed(spike)},
        {"pits", "spikes", false,
         real.changed([&](double z, int row, int column) { return 2.0 * z - spike(z, row, column); })},
        {"spikes of 2 x 2 cells", "spikes", false, real.changed([](double z, int row, int column) {
             return row % 31 / 2 == 3 && column % 29 / 2 == 5 ? z + 80.0 : z;
         })},
        {"spikes at the corners", "spikes", false, real.changed([&](double z, int row, int column) {
             const int from_row = std::min(row, real.rows - 1 - row);
             return from_row < 2 && std::min(column, real.columns - 1 - column) < 2 ? z + 80.0 : z;
         })},
        {"a peak of 8 m in smooth ground", "spikes", false,
         smooth_slope().changed(
             [](double z, int row, int column) { return row == 61 && column == 37 ? z + 8.0 : z; })},
        {"pits of 4 m in smooth ground", "spikes", false,
         smooth_slope().changed([](double z, int row, int column) {
             return row % 37 == 20 && column % 41 == 18 ? z - 4.0 : z;
         })},
        {"hillshade", "picture", true, real.changed(shade)},
        {"heights in 8 bits", "picture", true, high.changed([&](double z, int, int) {
             return std::clamp(std::round((z - low_m) / (high_m - low_m) * 255.0), 0.0, 255.0);
         })},
        {"speeds", "ups_and_downs", true, real.changed(speed)},
        {"speeds in few known cells", "unevenness", true, real.changed([&](double, int row, int column) {
             return node(5, row / 20, column / 20) > 0.6 ? 11.0 + 11.0 * node(6, row, column) : not_known;
         })},
        {"upside down", "upside_down", false, high.changed([&](double z, int, int) { return 1500.0 - z; })},
        {"cells of 30 m", "cell_size", false,
         Ground{60, 60, 30.0,
                [](int row, int column) { return 900.0 + 9.0 * row + octave_m(1, 9.0, row, column); }}},
    };
}

}  // namespace coupling::plausible::terrain
