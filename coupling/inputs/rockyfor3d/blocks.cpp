#include "coupling/inputs/rockyfor3d/blocks.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <sstream>
#include <utility>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "coupling/inputs/tables/csv_row.hpp"

namespace coupling::rockyfor3d {
namespace {

constexpr int ignored_rim = 2;             ///< rows and columns
constexpr double largest_m = 20.0;         ///< diameter that a run takes
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

void refuse_large_blocks(const Folder& folder, const std::vector<std::size_t>& sources) {
    const auto large = std::count_if(sources.begin(), sources.end(),
                                     [&](std::size_t i) { return diameter_at(folder, i) > largest_m; });
    if (large > 0) {
        config::fail(
            config::ExitCode::data, {},
            config::joined(std::to_string(large), " source cells with blocks larger than a sphere of 20 m"),
            "blocks that fall as one: at most 4189 m3", "correct d1, d2 and d3");
    }
}

/// Mean sides, each block's longest first, and density.
BlockClass means_of(const Folder& folder, const std::vector<std::size_t>& cells) {
    BlockClass block;
    block.cells = cells.size();
    const auto count = static_cast<double>(cells.size());
    for (const std::size_t i : cells) {
        std::array<double, 3> sides_m{folder.d1.values[i], folder.d2.values[i], folder.d3.values[i]};
        std::sort(sides_m.begin(), sides_m.end(), std::greater<>{});
        for (std::size_t axis = 0; axis < sides_m.size(); ++axis) {
            block.sides_m[axis] += sides_m[axis] / count;
        }
        block.density_kgpm3 += folder.rock_density.values[i] / count;
    }
    return block;
}

/// A corner as WKT has it, to the millimetre and without exponents.
std::string corner_text(double x_m, double y_m) {
    std::ostringstream out;
    CsvRow{out}.number<3>(x_m).number<3>(y_m).end();
    std::string text = out.str();
    text.pop_back();
    text[text.find(',')] = ' ';
    return text;
}

/// The cells of a zone as rectangles, one for each run of cells in a row.
std::string polygons_of(const config::Raster<double>& zones, double zone) {
    const config::GridFrame& frame = zones.frame;
    std::string text;
    for (int row = 0; row < frame.rows; ++row) {
        for (int first = 0; first < frame.columns; ++first) {
            int end = first;
            while (end < frame.columns && zones.at({end, row}) == zone) {
                ++end;
            }
            if (end == first) {
                continue;
            }
            const double west_m = frame.x_west_m + first * frame.cell_width_m;
            const double east_m = frame.x_west_m + end * frame.cell_width_m;
            const double north_m = frame.y_north_m() - row * frame.cell_height_m;
            const double south_m = north_m - frame.cell_height_m;
            text += config::joined(text.empty() ? "((" : ", ((", corner_text(west_m, south_m), ", ",
                                   corner_text(east_m, south_m), ", ", corner_text(east_m, north_m), ", ",
                                   corner_text(west_m, north_m), ", ", corner_text(west_m, south_m), "))");
            first = end;
        }
    }
    return config::joined("MULTIPOLYGON (", text, ")");
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
    refuse_large_blocks(folder, sources);
    blocks.density_kgpm3 = density_sum / static_cast<double>(sources.size());

    // By size in centimetres, or by classes of whole centimetres where there are many; each shape alone.
    using BlockKind = std::pair<long long, int>;
    const auto classes_by = [&](long long width) {
        std::map<BlockKind, std::vector<std::size_t>> by_size;
        for (const std::size_t i : sources) {
            const long long size = std::max(1LL, std::llround(diameter_at(folder, i) * sizes_per_metre));
            by_size[{size / width, static_cast<int>(folder.shape.values[i])}].push_back(i);
        }
        return by_size;
    };
    long long width = 1;
    auto by_size = classes_by(width);
    const long long widest = std::llround(largest_m * sizes_per_metre) + 1;
    while (by_size.size() > most_classes && width < widest) {
        by_size = classes_by(++width);
    }
    blocks.class_width_m = width == 1 ? 0.0 : static_cast<double>(width) / sizes_per_metre;
    for (const auto& [kind, cells] : by_size) {
        const long long size = kind.first;
        BlockClass block = means_of(folder, cells);
        block.diameter_m = width == 1 ? static_cast<double>(size) / sizes_per_metre
                                      : static_cast<double>((2 * size + 1) * width) / (2.0 * sizes_per_metre);
        block.form = static_cast<BlockForm>(kind.second);
        blocks.classes.push_back(block);
        for (const std::size_t i : cells) {
            blocks.zones.values[i] = static_cast<double>(blocks.classes.size());
        }
    }
    return blocks;
}

bool Blocks::are_equal_spheres() const {
    return classes.size() == 1 && classes.front().form == BlockForm::sphere &&
           !(largest_density_kgpm3 > least_density_kgpm3);
}

const char* name_of(BlockForm form) {
    switch (form) {
        case BlockForm::rectangular:
            return "box";
        case BlockForm::ellipsoid:
            return "ellipsoid";
        case BlockForm::disc:
            return "hull";
        case BlockForm::sphere:
            break;
    }
    return "sphere";
}

std::string disc_hull(const std::array<double, 3>& sides_m) {
    constexpr int corners = 16;  // the polygon has 97 % of the area of the circle [choice]
    std::ostringstream out;
    out << "x_m,y_m,z_m\n";
    CsvRow row{out};
    for (const double z_m : {-0.5 * sides_m[2], 0.5 * sides_m[2]}) {
        for (int k = 0; k < corners; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / corners;
            row.number<4>(0.5 * sides_m[0] * std::cos(angle));
            row.number<4>(0.5 * sides_m[1] * std::sin(angle)).number<4>(z_m);
            row.end();
        }
    }
    return out.str();
}

std::string sources_csv(const Blocks& blocks) {
    std::ostringstream out;
    out << "zone,diameter_m,density_kgpm3,shape,side_a_m,side_b_m,side_c_m,shape_file,wkt\n";
    CsvRow row{out};
    for (std::size_t k = 0; k < blocks.classes.size(); ++k) {
        const BlockClass& block = blocks.classes[k];
        const bool has_sides = block.form == BlockForm::rectangular || block.form == BlockForm::ellipsoid;
        row.whole(k + 1).number<3>(block.diameter_m).number<0>(block.density_kgpm3).text(name_of(block.form));
        for (const double side_m : block.sides_m) {
            has_sides ? row.number<3>(side_m) : row.empty();
        }
        block.form == BlockForm::disc ? row.text(config::joined("disc_", std::to_string(k + 1), ".csv"))
                                      : row.empty();
        row.text(polygons_of(blocks.zones, static_cast<double>(k + 1)));
        row.end();
    }
    return out.str();
}

}  // namespace coupling::rockyfor3d
