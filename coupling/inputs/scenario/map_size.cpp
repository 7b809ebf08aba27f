#include "coupling/inputs/scenario/map_size.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "rockfall/tally/cell_tally.hpp"
#include "rockfall/tally/ensemble_tally.hpp"

namespace coupling {
namespace {

using config::joined;

constexpr double longest_extent_m = 100e3;

/// Rounded, with all its digits: to_text writes large round numbers with an exponent.
std::string whole(double value) {
    std::array<char, 32> text{};
    const int length = std::snprintf(text.data(), text.size(), "%.0f", value);
    return {text.data(), static_cast<std::size_t>(std::clamp(length, 0, 31))};
}

std::string in_mb(double bytes) {
    return whole(std::ceil(bytes / 1e6)) + " MB";
}

std::string extent_in_words(double width_m, double height_m) {
    return joined(whole(width_m), " m x ", whole(height_m), " m");
}

/// What a cell takes at least: heights and ground, and where rocks fall their sums in one worker and in all.
double least_bytes_per_cell(bool has_rocks) {
    const double ground = sizeof(double) + 2 * sizeof(std::uint8_t);
    return ground + (has_rocks ? 2.0 * rockfall::covers * sizeof(rockfall::CellSums) : 0.0);
}

}  // namespace

std::uint64_t physical_memory_bytes() {
    const long pages = ::sysconf(_SC_PHYS_PAGES);
    const long page_bytes = ::sysconf(_SC_PAGESIZE);
    return pages > 0 && page_bytes > 0
               ? static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(page_bytes)
               : 0;
}

void check_map_size(const config::GridFrame& extent, double cell_size_m, const Scenario& scenario) {
    const double width_m = extent.x_east_m() - extent.x_west_m;
    const double height_m = extent.y_north_m() - extent.y_south_m;
    const double cell_width_m = cell_size_m > 0.0 ? cell_size_m : extent.cell_width_m;
    const double cell_height_m = cell_size_m > 0.0 ? cell_size_m : extent.cell_height_m;
    // In floating point: the counts of a frame would overflow where this matters.
    const double cells = std::ceil(width_m / cell_width_m) * std::ceil(height_m / cell_height_m);
    const double bytes = cells * least_bytes_per_cell(has_rocks(scenario));
    const auto memory_bytes = static_cast<double>(physical_memory_bytes());
    const bool too_large = memory_bytes > 0.0 && bytes > memory_bytes;
    if (cells <= most_map_cells && !too_large) {
        return;
    }
    const double fitting =
        too_large ? std::min(most_map_cells, memory_bytes / least_bytes_per_cell(has_rocks(scenario)))
                  : most_map_cells;
    // The smallest size of one digit that fits.
    const double least_m = std::sqrt(width_m * height_m / fitting);
    const double power = std::pow(10.0, std::floor(std::log10(least_m)));
    config::fail(config::ExitCode::settings, scenario.options->place_of("output.cell_size_m"),
                 joined("maps of ", whole(cells), " cells of ", config::to_text(cell_width_m), " m over ",
                        extent_in_words(width_m, height_m), ", which take ", in_mb(bytes), " at least",
                        too_large ? joined(" (this machine has ", in_mb(memory_bytes), ")") : ""),
                 joined("output.cell_size_m of ", config::to_text(power * std::ceil(least_m / power)),
                        " or more, coordinates in metres"));
}

void check_extent(double width_m, double height_m, const std::string& file) {
    if (width_m > longest_extent_m || height_m > longest_extent_m) {
        config::fail(config::ExitCode::data, {file},
                     "an extent of " + extent_in_words(width_m, height_m) + " in plan",
                     "coordinates in metres (not millimetres, not feet) of one slope, up to 100 km");
    }
}

}  // namespace coupling
