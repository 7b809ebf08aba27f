#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "coupling/results/geopackage/package.hpp"

namespace coupling {

/// Lines of the layer that a table becomes, row by row, in coordinates of the terrain.
using Lines = std::vector<std::vector<Eigen::Vector2d>>;

/// A table as its file has it, and the lines of its rows.
struct TableWithLines {
    TableLayout layout;
    std::string csv;
    Lines lines;
};

/// The projection of the rasters of a run; empty where they have none.
std::string projection_of_run(const std::filesystem::path& run);

/// Adds a layer with a line for each row; `origin_m` is added to their corners. Throws config::InputError
/// (file).
void add_lines(geopackage::GeoPackage& package, const std::string& name, const std::string& sentence,
               const TableWithLines& table, const Eigen::Vector2d& origin_m);

/// Adds a layer with a point for each row, in absolute coordinates. Throws config::InputError (file).
void add_points(geopackage::GeoPackage& package, const std::string& name, const std::string& sentence,
                const TableLayout& layout, const std::string& csv, std::span<const Eigen::Vector2d> places_m);

}  // namespace coupling
