#pragma once

#include <string>
#include <vector>

#include "coupling/inputs/rockyfor3d/folder.hpp"

namespace coupling::rockyfor3d {

/// A tree of the project.
struct Tree {
    double x_m = 0.0;
    double y_m = 0.0;
    std::string species;  ///< code
    double dbh_cm = 0.0;
    double height_m = 0.0;
};

struct Forest {
    std::vector<Tree> trees;
    bool generated = false;     ///< from rasters, not from a list
    std::size_t too_thin = 0;   ///< left out: below 5 cm, which is no obstacle in either program
    std::size_t outside = 0;    ///< left out: off the terrain, which joins the centres of cells
    bool all_conifers = false;  ///< conif_percent is missing
};

/// The species that stand for all conifers and all broadleaved trees [choice]: the commonest of protection
/// forests.
inline constexpr const char* conifer = "PIAB";
inline constexpr const char* broadleaf = "FASY";

/// Key of the random numbers: the same folder gives the same trees.
inline constexpr std::uint64_t forest_seed = 1;

/// The trees of the list, or trees drawn from the rasters: their number per cell is the density times the
/// area, rounded at random; places even in the cell, diameters from a gamma distribution of the cell's mean
/// and deviation. Each is a conifer with the chance of conif_percent at its place; heights come from one
/// curve. Drawn tree by tree or cell by cell from streams of their own.
Forest forest_of(const Folder& folder);

}  // namespace coupling::rockyfor3d
