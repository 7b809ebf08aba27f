#include "coupling/inputs/plausible/heights.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "config/grid/holes.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/systems/coordinate_systems.hpp"

namespace coupling::plausible {
namespace {

using config::joined;

constexpr double lowest_ground_m = -500.0;   // the Dead Sea lies at -430 m
constexpr double highest_ground_m = 9000.0;  // Mount Everest: 8849 m

bool stands_for_nodata(double height_m) {
    return height_m <= -9999.0 || height_m >= 1e30;
}

/// Median slope of the squares between four known neighbours [-]; 0 without any. The same of a turned grid.
double median_gradient(const config::Raster<double>& grid) {
    std::vector<double> gradients;
    for (int row = 1; row < grid.frame.rows; ++row) {
        for (int column = 1; column < grid.frame.columns; ++column) {
            const double north_west_m = grid.at({column - 1, row - 1});
            const double north_east_m = grid.at({column, row - 1});
            const double south_west_m = grid.at({column - 1, row});
            const double south_east_m = grid.at({column, row});
            const double east = 0.5 * (north_east_m - north_west_m + south_east_m - south_west_m);
            const double north = 0.5 * (north_west_m - south_west_m + north_east_m - south_east_m);
            const double gradient =
                std::hypot(east / grid.frame.cell_width_m, north / grid.frame.cell_height_m);
            if (!std::isnan(gradient)) {
                gradients.push_back(gradient);
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

/// Ground that comes down to 0, such as a shore, has other low cells too; a 0 that stands for "unknown" lies
/// alone below the rest: by more than this [choice].
constexpr double gap_above_zero_m = 10.0;

/// Cells of height 0 that hang together, known ground that is higher by `gap_above_zero_m` all around.
struct ZeroPit {
    std::size_t first_cell = 0;
    std::size_t cells = 0;
};

/// The pits of zeros of a grid: rocks would end in them.
std::vector<ZeroPit> zero_pits(const config::Raster<double>& grid) {
    const auto columns = static_cast<std::size_t>(grid.frame.columns);
    std::vector<bool> is_seen(grid.values.size(), false);
    std::vector<ZeroPit> pits;
    std::vector<std::size_t> cells;
    for (std::size_t first = 0; first < grid.values.size(); ++first) {
        if (grid.values[first] != 0.0 || is_seen[first]) {
            continue;
        }
        bool is_pit = true;
        cells.assign(1, first);
        is_seen[first] = true;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const int row = static_cast<int>(cells[i] / columns);
            const int column = static_cast<int>(cells[i] % columns);
            for (int r = row - 1; r <= row + 1; ++r) {
                for (int c = column - 1; c <= column + 1; ++c) {
                    if (!grid.frame.contains({c, r})) {
                        is_pit = false;
                        continue;
                    }
                    const std::size_t other = grid.frame.index({c, r});
                    const double height_m = grid.values[other];
                    if (height_m == 0.0) {
                        if (!is_seen[other]) {
                            is_seen[other] = true;
                            cells.push_back(other);
                        }
                    } else {
                        is_pit = is_pit && height_m > gap_above_zero_m;  // not of NaN
                    }
                }
            }
        }
        if (is_pit) {
            pits.push_back({first, cells.size()});
        }
    }
    return pits;
}

void judge_zeros(const config::Raster<double>& grid, const std::string& file, Reading& reading) {
    if (const std::vector<ZeroPit> pits = zero_pits(grid); !pits.empty()) {
        const std::size_t cells =
            std::accumulate(pits.begin(), pits.end(), std::size_t{0},
                            [](std::size_t sum, const ZeroPit& pit) { return sum + pit.cells; });
        reading.refuse(
            {file},
            joined(counted(cells, "cell"), " of height 0 amid higher ground, from ",
                   cell_in_words(grid.frame, pits.front().first_cell), ": a pit in which rocks would end"),
            "NODATA where the ground is not known",
            "declare 0 as NODATA_value, or fill the pit in a GIS program");
        return;
    }
    std::vector<double> heights;
    std::copy_if(grid.values.begin(), grid.values.end(), std::back_inserter(heights),
                 [](double height_m) { return !std::isnan(height_m); });
    const auto zeros = static_cast<std::size_t>(std::count(heights.begin(), heights.end(), 0.0));
    const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
    std::nth_element(heights.begin(), middle, heights.end());
    const bool is_apart = std::none_of(heights.begin(), heights.end(), [](double height_m) {
        return height_m != 0.0 && std::abs(height_m) < gap_above_zero_m;
    });
    if (zeros == 0 || *middle <= 100.0 || !is_apart) {
        return;
    }
    reading.warn({file},
                 joined(counted(zeros, "cell"), " of height 0 where half of them lie above ",
                        config::to_text(*middle), " m"),
                 "NODATA where the ground is not known",
                 "declare 0 as NODATA_value if it stands for unknown ground");
}

void refuse_with(const terrain::Finding& finding, const std::string& file, Reading& reading) {
    reading.refuse({file}, finding.found, finding.expected, finding.advice);
}

[[noreturn]] void fail_with(const terrain::Finding& finding, const std::string& file) {
    config::fail(config::ExitCode::data, {file}, finding.found, finding.expected, finding.advice);
}

/// A wrong terrain makes the answer wrong.
void warn_with(const terrain::Finding& finding, const std::string& file, Reading& reading) {
    reading.warn({file}, finding.found, finding.expected, finding.advice, config::Effect::answer);
}

}  // namespace

void check_height_range(double low_m, double high_m, const std::string& file) {
    if (low_m >= lowest_ground_m && high_m <= highest_ground_m) {
        return;
    }
    const bool nodata = stands_for_nodata(low_m) || stands_for_nodata(high_m);
    const bool turned = high_m < lowest_ground_m && -low_m <= highest_ground_m;
    config::fail(config::ExitCode::data, {file},
                 joined("heights from ", config::to_text(low_m), " to ", config::to_text(high_m)),
                 "metres above sea level, -500 to 9000",
                 nodata ? "declare the value of unknown ground as NODATA_value"
                 : turned
                     ? "change the sign of the heights: these are depths, or upside down"
                     : "write the heights in metres (these may be decimetres, centimetres or millimetres)");
}

std::vector<terrain::Verdict> refuse_impossible_heights(const config::Raster<double>& grid,
                                                        const std::string& file) {
    const terrain::HeightField field = terrain::field_of(grid);
    const terrain::Values values = terrain::values_of(field);
    check_height_range(values.low_m, values.high_m, file);
    constexpr double steepest = 5.7;  // tan 80 degrees
    if (const double gradient = median_gradient(grid); gradient > steepest) {
        config::fail(config::ExitCode::data, {file},
                     joined("half of the cells steeper than ",
                            config::to_text(std::floor(std::atan(gradient) * 180.0 / M_PI)), " degrees"),
                     "heights and cell size in metres",
                     "write both in metres (heights may be centimetres, or cells kilometres)");
    }
    std::vector<terrain::Verdict> verdicts = terrain::judge_heights(field);
    for (const terrain::Verdict& verdict : verdicts) {
        if (verdict.finding.is_error) {
            fail_with(verdict.finding, file);
        }
    }
    return verdicts;
}

void check_grid_heights(const config::Raster<double>& grid, const std::string& file, Reading& reading) {
    for (const terrain::Verdict& verdict : refuse_impossible_heights(grid, file)) {
        warn_with(verdict.finding, file, reading);
    }
    judge_zeros(grid, file, reading);
}

void check_sampled_heights(const config::Raster<double>& samples, const std::string& file, Reading& reading) {
    for (const terrain::Verdict& verdict : terrain::judge_heights(terrain::field_of(samples))) {
        if (verdict.finding.is_error) {
            refuse_with(verdict.finding, file, reading);
        } else {
            warn_with(verdict.finding, file, reading);
        }
    }
}

void check_highest_of_system(double high_m, const std::string& projection, const std::string& file) {
    constexpr double mont_blanc_m = 4810.0;  // the highest ground of the known systems [lit]
    const std::optional<Projection> read = read_projection(projection);
    const KnownSystem* system = read ? system_of(*read, projection) : nullptr;
    if (system != nullptr && high_m > mont_blanc_m) {
        config::fail(config::ExitCode::data, {file},
                     joined("heights up to ", config::to_text(std::round(high_m)), " m in ", system->name),
                     "at most 4810 m, the height of Mont Blanc",
                     "write the heights in metres: multiply feet by 0.3048, divide decimetres by 10");
    }
}

/// Degrees and feet make every slope wrong: they are said before any slope is judged.
void refuse_system_without_metres(const config::GridFrame& frame, const std::string& projection,
                                  const std::string& file) {
    std::optional<Contradiction> wrong = contradiction_of(projection, extent_of(frame), file);
    if (const auto unit = wrong ? std::nullopt : height_unit_in(projection)) {
        wrong = contradiction_of_heights(*unit);
    }
    if (wrong) {
        config::fail(config::ExitCode::data, {file}, wrong->found, wrong->expected, wrong->advice);
    }
}

void refuse_wrong_heights(const config::Raster<double>& grid, const std::string& projection,
                          const std::string& file) {
    const terrain::Values values = terrain::values_of(terrain::field_of(grid));
    if (values.known > 0) {
        refuse_system_without_metres(grid.frame, projection, file);
        refuse_impossible_heights(grid, file);
        check_highest_of_system(values.high_m, projection, file);
    }
}

void check_ground_at_trees(const config::Raster<double>& heights, std::span<const terrain::ListedTree> trees,
                           const std::string& file, Reading& reading) {
    if (const std::optional<terrain::Finding> finding = terrain::judge_crowns(heights, trees)) {
        if (finding->is_error) {
            refuse_with(*finding, file, reading);
        } else {
            warn_with(*finding, file, reading);
        }
    }
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
