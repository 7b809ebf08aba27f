// Writes a synthetic valley as a project, for measuring how time and memory grow with the area.
//
//   valley FOLDER [SIDE_M [ROCKS]]     SIDE_M: 5000 by default, cells of 1 m
//
// With ROCKS rocks in all (100000). A straight valley with fractal relief: flanks of 34 degrees, a floor 200
// m wide with a road and 200 houses, about 300 trees per hectare on the flanks. No real place; nothing about
// it was fitted to one.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <stdexcept>
#include <string>

#include "config/grid/ascii_grid.hpp"
#include "config/grid/raster.hpp"
#include "config/random/stream.hpp"

namespace {

constexpr double half_floor_m = 100.0;
constexpr double tangent_of_flanks = 0.67;
constexpr double west_m = 600'000.0;
constexpr double south_m = 200'000.0;
constexpr double trees_per_ha = 300.0;
constexpr double steep_deg = 52.0;  // a tenth of the cells
constexpr int houses = 200;

double uniform_at(std::uint64_t id, std::uint32_t event, std::size_t number) {
    return config::RandomStream{{.seed = 1, .id = id}, config::Purpose::test}.uniforms_of(event)[number];
}

/// Relief of one wave length: heights at nodes, straight between them.
double octave_m(double x_m, double y_m, double wave_m, std::uint32_t octave) {
    const double column = std::floor(x_m / wave_m);
    const double row = std::floor(y_m / wave_m);
    const double east = x_m / wave_m - column;
    const double north = y_m / wave_m - row;
    const auto node = [&](double i, double j) {
        constexpr std::uint64_t nodes_in_a_row = 1U << 20U;
        return uniform_at(static_cast<std::uint64_t>(row + j) * nodes_in_a_row +
                              static_cast<std::uint64_t>(column + i),
                          octave, 0) -
               0.5;
    };
    return (1.0 - north) * ((1.0 - east) * node(0, 0) + east * node(1, 0)) +
           north * ((1.0 - east) * node(0, 1) + east * node(1, 1));
}

/// Above sea, at a place in metres from the south-western corner.
double height_m(double x_m, double y_m, double side_m) {
    const double from_floor_m = std::max(0.0, std::abs(x_m - 0.5 * side_m) - half_floor_m);
    const double roughness = std::min(1.0, from_floor_m / half_floor_m);
    double relief_m = 0.0;
    double wave_m = 320.0;
    double size_m = 60.0;
    for (std::uint32_t octave = 0; octave < 8; ++octave, wave_m *= 0.5, size_m *= 0.55) {
        relief_m += size_m * octave_m(x_m, y_m, wave_m, octave);
    }
    return 600.0 + tangent_of_flanks * from_floor_m + roughness * relief_m;
}

std::ofstream opened(const std::filesystem::path& file) {
    std::ofstream out{file};
    if (!out) {
        throw std::runtime_error{"cannot write " + file.string()};
    }
    out << std::fixed << std::setprecision(1);
    return out;
}

void write_heights(const std::filesystem::path& folder, int side) {
    config::Raster<float> heights{{.columns = side,
                                   .rows = side,
                                   .x_west_m = west_m,
                                   .y_south_m = south_m,
                                   .cell_width_m = 1.0,
                                   .cell_height_m = 1.0},
                                  0.0F};
    for (std::size_t i = 0; i < heights.values.size(); ++i) {
        const config::Cell cell = heights.frame.cell_of(i);
        constexpr double per_centimetre = 100.0;
        heights.values[i] = static_cast<float>(
            std::round(per_centimetre * height_m(heights.frame.x_centre_m(cell.column) - west_m,
                                                 heights.frame.y_centre_m(cell.row) - south_m, side)) /
            per_centimetre);
    }
    std::ofstream out = opened(folder / "dem.asc");
    config::write_ascii_grid(out, heights);
}

void write_trees(const std::filesystem::path& folder, double side_m) {
    std::ofstream out = opened(folder / "trees.csv");
    out << "x_m,y_m,species,dbh_cm\n";
    constexpr double m2_per_ha = 10'000.0;
    const auto count = static_cast<std::uint64_t>(side_m * side_m / m2_per_ha * trees_per_ha);
    for (std::uint64_t tree = 0; tree < count; ++tree) {
        const double x_m = side_m * uniform_at(tree, 1U << 10U, 0);
        if (std::abs(x_m - 0.5 * side_m) > half_floor_m) {
            out << west_m + x_m << ',' << south_m + side_m * uniform_at(tree, 1U << 10U, 1) << ",PIAB,"
                << 12.0 + 48.0 * uniform_at(tree, 1U << 10U, 2) << '\n';
        }
    }
}

void write_targets(const std::filesystem::path& folder, double side_m) {
    std::ofstream out = opened(folder / "targets.csv");
    out << "target_id,name,wkt\n";
    const double road_m = west_m + 0.5 * side_m;
    out << "road,road (synthetic),\"LINESTRING (" << road_m << ' ' << south_m + 1.0 << ", " << road_m << ' '
        << south_m + side_m - 1.0 << ")\"\n";
    for (int house = 0; house < houses; ++house) {
        const double x_m = road_m + (house % 2 == 0 ? -80.0 : 68.0);
        const double y_m = south_m + (house + 1) * side_m / (houses + 1);
        constexpr double size_m = 12.0;
        out << "house_" << house << ",house (synthetic),\"POLYGON ((" << x_m << ' ' << y_m << ", "
            << x_m + size_m << ' ' << y_m << ", " << x_m + size_m << ' ' << y_m + size_m << ", " << x_m << ' '
            << y_m + size_m << ", " << x_m << ' ' << y_m << "))\"\n";
    }
}

void write_scenario(const std::filesystem::path& folder, const std::string& rocks) {
    opened(folder / "scenario.ini") << "; A synthetic valley, for measurements of time and memory only.\n"
                                       "[run]\nseed = 1\n\n"
                                       "[terrain]\ndem = dem.asc\nground = fine_debris\n\n"
                                       "[trees]\nfile = trees.csv\n\n"
                                       "[release]\nsteeper_than_deg = "
                                    << steep_deg << "\nrocks = " << rocks
                                    << "\ndiameter_m = 0.8\ndensity_kgpm3 = 2700\n\n"
                                       "[targets]\nfile = targets.csv\n\n"
                                       "[output]\npercentiles = no\n";
}

}  // namespace

int main(int argc, char** argv) {
    try {
        if (argc < 2 || argc > 4) {
            std::cerr << "usage: valley FOLDER [SIDE_M [ROCKS]]\n";
            return 2;
        }
        const std::filesystem::path folder = argv[1];
        const int side = argc > 2 ? std::stoi(argv[2]) : 5000;
        std::filesystem::create_directories(folder);
        write_heights(folder, side);
        write_trees(folder, side);
        write_targets(folder, side);
        write_scenario(folder, argc > 3 ? argv[3] : "100000");
        return 0;
    } catch (const std::exception& error) {
        std::cerr << "valley: " << error.what() << '\n';
        return 1;
    }
}
