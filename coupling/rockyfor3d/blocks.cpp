#include "coupling/rockyfor3d/blocks.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "config/errors/input_error.hpp"

namespace coupling::rockyfor3d {
namespace {

constexpr int ignored_rim = 2;             ///< rows and columns
constexpr double sizes_per_metre = 100.0;  ///< dividing by it rounds correctly: 115 cm are 1.15 m

bool in_rim(const config::GridFrame& frame, std::size_t index) {
    const config::Cell cell = frame.cell_of(index);
    return cell.column < ignored_rim || cell.row < ignored_rim ||
           cell.column >= frame.columns - ignored_rim || cell.row >= frame.rows - ignored_rim;
}

double diameter_at(const Folder& folder, std::size_t i) {
    return equal_volume_diameter_m(folder.d1.values[i], folder.d2.values[i], folder.d3.values[i],
                                   static_cast<int>(folder.shape.values[i]));
}

}  // namespace

std::size_t Blocks::cells() const {
    std::size_t sum = 0;
    for (const BlockClass& block : classes) {
        sum += block.cells;
    }
    return sum;
}

double Blocks::mean_diameter_m() const {
    double sum_m = 0.0;
    for (const BlockClass& block : classes) {
        sum_m += block.diameter_m * static_cast<double>(block.cells);
    }
    return sum_m / static_cast<double>(cells());
}

double equal_volume_diameter_m(double d1_m, double d2_m, double d3_m, int shape) {
    constexpr double sphere = std::numbers::pi / 6.0;
    const double filled = shape == 1 ? 1.0 : shape == 4 ? std::numbers::pi / 4.0 : sphere;
    return std::cbrt(filled * d1_m * d2_m * d3_m / sphere);
}

Blocks blocks_of(const Folder& folder, std::size_t most_classes) {
    Blocks blocks;
    blocks.zones = config::Raster<double>{folder.dem.frame, 0.0};
    std::vector<std::size_t> sources;
    double density_sum = 0.0;
    for (std::size_t i = 0; i < folder.dem.values.size(); ++i) {
        const double density = folder.rock_density.values[i];
        if (std::isnan(folder.dem.values[i])) {
            blocks.zones.values[i] = std::nan("");
        } else if (density > 0.0 && in_rim(folder.dem.frame, i)) {
            ++blocks.left_out;
        } else if (density > 0.0) {
            blocks.least_density_kgpm3 =
                sources.empty() ? density : std::min(blocks.least_density_kgpm3, density);
            blocks.largest_density_kgpm3 = std::max(blocks.largest_density_kgpm3, density);
            density_sum += density;
            sources.push_back(i);
        }
    }
    if (sources.empty()) {
        config::fail(config::ExitCode::data, {},
                     "sources only in the two outer rows and columns or where the DEM has no height",
                     "sources further inside: Rockyfor3D ignores those as well");
    }
    blocks.density_kgpm3 = density_sum / static_cast<double>(sources.size());

    // By size in centimetres, or by classes of whole centimetres where there are many sizes.
    const auto classes_by = [&](long long width) {
        std::map<long long, std::vector<std::size_t>> by_size;
        for (const std::size_t i : sources) {
            const long long size = std::max(1LL, std::llround(diameter_at(folder, i) * sizes_per_metre));
            by_size[size / width].push_back(i);
        }
        return by_size;
    };
    long long width = 1;
    auto by_size = classes_by(width);
    while (by_size.size() > most_classes) {
        by_size = classes_by(++width);
    }
    blocks.class_width_m = width == 1 ? 0.0 : static_cast<double>(width) / sizes_per_metre;
    for (const auto& [size, cells] : by_size) {
        const double diameter_m = width == 1
                                      ? static_cast<double>(size) / sizes_per_metre
                                      : static_cast<double>((2 * size + 1) * width) / (2.0 * sizes_per_metre);
        blocks.classes.push_back({diameter_m, cells.size()});
        for (const std::size_t i : cells) {
            blocks.zones.values[i] = static_cast<double>(blocks.classes.size());
        }
    }
    return blocks;
}

}  // namespace coupling::rockyfor3d
