#include "coupling/inputs/plausible/heights.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "config/grid/holes.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"

namespace coupling::plausible {
namespace {

using config::joined;

constexpr double lowest_m = -500.0;   // the Dead Sea lies at -430 m
constexpr double highest_m = 9000.0;  // Mount Everest: 8849 m

bool stands_for_nodata(double height_m) {
    return height_m <= -9999.0 || height_m >= 1e30;
}

/// Median of the ratio of height to distance between neighbours in a row; 0 without any.
double median_gradient(const config::Raster<double>& grid) {
    std::vector<double> gradients;
    for (int row = 0; row < grid.frame.rows; ++row) {
        for (int column = 1; column < grid.frame.columns; ++column) {
            const double step_m = grid.at({column, row}) - grid.at({column - 1, row});
            if (!std::isnan(step_m)) {
                gradients.push_back(std::abs(step_m) / grid.frame.cell_width_m);
            }
        }
    }
    if (gradients.empty()) {
        return 0.0;
    }
    const auto middle = gradients.begin() + static_cast<std::ptrdiff_t>(gradients.size() / 2);
    std::nth_element(gradients.begin(), middle, gradients.end());
    return *middle;
}

void doubt_zeros(std::vector<double> heights, const std::string& file, Reading& reading) {
    const auto zeros = static_cast<std::size_t>(std::count(heights.begin(), heights.end(), 0.0));
    const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
    std::nth_element(heights.begin(), middle, heights.end());
    if (zeros > 0 && *middle > 100.0) {
        reading.warn({file},
                     joined(counted(zeros, "cell"), " of height 0 where half of them lie above ",
                            config::to_text(*middle), " m"),
                     "NODATA where the ground is not known",
                     "declare 0 as NODATA_value if it stands for unknown ground");
    }
}

}  // namespace

void check_height_range(double low_m, double high_m, const std::string& file) {
    if (low_m >= lowest_m && high_m <= highest_m) {
        return;
    }
    const bool nodata = stands_for_nodata(low_m) || stands_for_nodata(high_m);
    config::fail(config::ExitCode::data, {file},
                 joined("heights from ", config::to_text(low_m), " to ", config::to_text(high_m)),
                 "metres above sea level, -500 to 9000",
                 nodata
                     ? "declare the value of unknown ground as NODATA_value"
                     : "write the heights in metres (these may be decimetres, centimetres or millimetres)");
}

void check_grid_heights(const config::Raster<double>& grid, const std::string& file, Reading& reading) {
    std::vector<double> known;
    std::copy_if(grid.values.begin(), grid.values.end(), std::back_inserter(known),
                 [](double height_m) { return !std::isnan(height_m); });
    const auto [low, high] = std::minmax_element(known.begin(), known.end());
    check_height_range(*low, *high, file);
    constexpr double steepest = 5.7;  // tan 80 degrees
    if (const double gradient = median_gradient(grid); gradient > steepest) {
        config::fail(config::ExitCode::data, {file},
                     joined("half of the cells steeper than ",
                            config::to_text(std::floor(std::atan(gradient) * 180.0 / M_PI)), " degrees"),
                     "heights and cell size in metres",
                     "write both in metres (heights may be centimetres, or cells kilometres)");
    }
    doubt_zeros(std::move(known), file, reading);
}

void doubt_holes(const config::Raster<double>& grid, const std::string& file, config::Effect effect,
                 Reading& reading) {
    const std::vector<config::Hole> holes = config::holes_of(grid);
    if (holes.empty()) {
        return;
    }
    std::size_t cells = 0;
    for (const config::Hole& hole : holes) {
        cells += hole.cells;
    }
    const config::Hole& largest =
        *std::max_element(holes.begin(), holes.end(),
                          [](const config::Hole& a, const config::Hole& b) { return a.cells < b.cells; });
    reading.warn({file},
                 counted(holes.size(), "hole") + " of NODATA, together " + counted(cells, "cell") +
                     ", the largest of " + counted(largest.cells, "cell") + " from " +
                     cell_in_words(grid.frame, largest.first_cell) +
                     "; rocks that come there leave the terrain",
                 "heights everywhere inside the rim", "fill the holes in a GIS program", effect);
}

}  // namespace coupling::plausible
