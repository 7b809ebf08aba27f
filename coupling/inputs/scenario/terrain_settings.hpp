#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "config/options/options.hpp"

namespace coupling {

/// Which axis of a mesh points up.
enum class MeshUp : std::uint8_t { z, y };

/// What becomes of faces of a mesh that lie over each other.
enum class MeshOverhangs : std::uint8_t { refuse, keep_upper };

/// A plane rectangle instead of a map of heights: a plot of which only elevation and slope are known. It
/// begins at x = 0, y = 0.
struct PlaneGround {
    double width_m = 0.0;      ///< along x, eastwards; 0: there is a map
    double length_m = 0.0;     ///< along y, northwards
    double elevation_m = 0.0;  ///< at the middle
    double slope_deg = 0.0;
    double aspect_deg = 0.0;  ///< that it faces downhill, clockwise from north

    [[nodiscard]] bool is_given() const { return width_m > 0.0; }
};

/// The settings of section [terrain]; file names as written.
struct TerrainSettings {
    std::string dem;               ///< grid, or folder, list or VRT of tiles, or several of them; or
    std::string points;            ///< XYZ text, or
    std::string mesh;              ///< PLY, STL, DXF, contours as CSV, or XYZ text
    std::string meshes;            ///< CSV: file, surface; several meshes with a ground type each
    PlaneGround plane;             ///< instead of any of these
    std::vector<double> extent_m;  ///< west, south, east, north of the part of grids that is read; none: all
    double fill_holes_m2 = 25.0;   ///< largest hole of a grid of heights that is filled; 0 fills none
    MeshUp mesh_up = MeshUp::z;
    MeshOverhangs mesh_overhangs = MeshOverhangs::refuse;
    double longest_edge_m = 0.0;   ///< for points: longer edges are no terrain; 0 keeps all
    std::string surface;           ///< grid of surface codes, or
    std::string surface_polygons;  ///< CSV with WKT polygons and codes
    std::string surface_types;     ///< CSV: code, label, r_n, r_t, p_stop
    std::string soils;             ///< CSV of soils beside the shipped ones; optional
    std::string stopping;          ///< CSV: code, diameter_m, p_stop; optional
    std::string ground;            ///< name of a shipped surface type for all the terrain; instead of a grid
    std::string slope_grounds;     ///< CSV: from_deg, surface; ground types by slope where no map says
    std::string picture;           ///< aerial picture or map behind the maps of pages; empty: none
    std::string profile;           ///< CSV: distance_m, height_m, surface; not empty: a two-dimensional run

    [[nodiscard]] bool has_mesh() const { return !mesh.empty() || !meshes.empty(); }
};

void declare(config::Options& options, TerrainSettings& terrain);

}  // namespace coupling
