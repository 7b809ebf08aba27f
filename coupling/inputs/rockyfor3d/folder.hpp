#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "config/grid/raster.hpp"

namespace coupling::rockyfor3d {

/// A tree of a Rockyfor3D tree file.
struct FileTree {
    double x_m = 0.0;
    double y_m = 0.0;
    double dbh_cm = 0.0;
};

/// A Rockyfor3D input folder (Dorren 2016; raster names and units as its public preparation tools write
/// them), read and checked. All rasters lie on the frame of the DEM; NaN is NODATA.
struct Folder {
    config::Raster<double> dem;               ///< m
    std::string projection;                   ///< text of dem.prj
    config::Raster<double> rock_density;      ///< kg/m3; above 0: a source
    config::Raster<double> d1, d2, d3;        ///< m
    config::Raster<double> shape;             ///< 1 rectangular, 2 ellipsoid, 3 sphere, 4 disc
    config::Raster<double> soil_type;         ///< 0 to 7
    config::Raster<double> rg70, rg20, rg10;  ///< m, height of obstacles in 70, 20, 10 % of the contacts

    // Forest: a tree file, or rasters, or neither. Where there is a tree file, the rasters are not read.
    std::optional<std::vector<FileTree>> trees;
    std::optional<config::Raster<double>> stems_pha, mean_dbh_cm, dbh_deviation_cm;
    std::optional<config::Raster<double>> conifer_percent;

    // Nets: all three or none.
    std::optional<config::Raster<double>> net_number;  ///< above 0: which net
    std::optional<config::Raster<double>> net_energy;  ///< kJ
    std::optional<config::Raster<double>> net_height;  ///< m

    std::vector<std::string> files;         ///< names of the files that were read, as they are written there
    std::vector<std::string> not_read;      ///< the other files in the folder
    std::vector<std::string> remarks;       ///< how files were read: whole sentences
    std::vector<std::string> behind_trees;  ///< rasters of a forest that the tree file goes before
};

/// Reads a folder. File names are compared without regard to case. Throws InputError with all problems at
/// once: files that are missing (file), rasters that do not lie on the DEM and values out of their range
/// (data).
Folder read_folder(const std::filesystem::path& folder);

}  // namespace coupling::rockyfor3d
