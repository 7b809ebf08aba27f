#include "coupling/inputs/scenario/terrain_settings.hpp"

namespace coupling {
namespace {

void declare_plane(config::Options& options, PlaneGround& plane) {
    options.number("terrain.plane_width_m", plane.width_m,
                   {.unit = "m",
                    .low = 0.0,
                    .high = 10'000.0,
                    .meaning = "instead of a map: a plane rectangle, so wide along x (a multiple of 10 m)"});
    options.number(
        "terrain.plane_length_m", plane.length_m,
        {.unit = "m", .low = 0.0, .high = 10'000.0, .meaning = "its length along y (a multiple of 10 m)"});
    options.number(
        "terrain.plane_elevation_m", plane.elevation_m,
        {.unit = "m", .low = -500.0, .high = 9000.0, .meaning = "its height above the sea, at its middle"});
    options.number("terrain.plane_slope_deg", plane.slope_deg,
                   {.unit = "deg", .low = 0.0, .high = 75.0, .meaning = "its slope"});
    options.number("terrain.plane_aspect_deg", plane.aspect_deg,
                   {.unit = "deg",
                    .low = 0.0,
                    .high = 360.0,
                    .meaning = "where it faces, downhill; 0 is north, 90 east"});
}

}  // namespace

void declare(config::Options& options, TerrainSettings& terrain) {
    options.file(
        "terrain.dem", terrain.dem,
        {.meaning = "ground heights in m: a grid (GeoTIFF, ESRI ASCII, .flt, XYZ; also .gz), or tiles: "
                    "a folder, a list, a VRT, or several names"});
    options.numbers("terrain.extent_m", terrain.extent_m,
                    {.unit = "m",
                     .low = -1e9,
                     .high = 1e9,
                     .meaning = "west, south, east, north of the part of the grids of heights, grounds and "
                                "sources that is read; none: all of them"});
    options.number(
        "terrain.fill_holes_m2", terrain.fill_holes_m2,
        {.unit = "m2",
         .low = 0.0,
         .high = 10'000.0,
         .meaning = "holes of a grid of heights up to this size are filled from their rim; 0: none",
         .source = "choice",
         .needs = {{"terrain.dem"}}});
    options.file("terrain.points", terrain.points,
                 {.meaning = "instead: text of x y z in m, one point a line"});
    options.file("terrain.mesh", terrain.mesh,
                 {.meaning = "instead: a mesh whose faces stay as they are (PLY, STL), contours (DXF, CSV)"});
    options.file("terrain.meshes", terrain.meshes,
                 {.meaning = "instead: CSV with file, surface: several meshes with a ground type each"});
    declare_plane(options, terrain.plane);
    options.choice(
        "terrain.mesh_up", terrain.mesh_up, {{"z", MeshUp::z}, {"y", MeshUp::y}},
        {.meaning = "which axis of the mesh points up; y: (x, y, z) becomes (x, -z, y)", .source = "choice"});
    options.choice("terrain.mesh_overhangs", terrain.mesh_overhangs,
                   {{"refuse", MeshOverhangs::refuse}, {"keep_upper", MeshOverhangs::keep_upper}},
                   {.meaning = "faces that lie over each other: refuse them, or keep the upper ones and list "
                               "the others in mesh_left_out.csv",
                    .source = "choice"});
    options.number("terrain.longest_edge_m", terrain.longest_edge_m,
                   {.unit = "m",
                    .low = 0.0,
                    .high = 10'000.0,
                    .meaning = "for points: longer triangle edges are no terrain; 0 keeps all",
                    .source = "choice"});
    options.file("terrain.surface", terrain.surface,
                 {.meaning = "ground types: grid of codes on the frame of the DEM"});
    options.file("terrain.surface_polygons", terrain.surface_polygons,
                 {.meaning = "instead: CSV with code, wkt (POLYGON); later rows lie on top"});
    options.file("terrain.surface_types", terrain.surface_types,
                 {.meaning = "CSV with code, label, r_n, r_t, p_stop; or code, name of a shipped type"});
    options.file("terrain.soils", terrain.soils,
                 {.meaning = "CSV of soils of your own, as `bannwald info pir3d_soils` shows them; for "
                             "models that use soils"});
    options.file("terrain.stopping", terrain.stopping,
                 {.meaning = "CSV with code, diameter_m, p_stop; without it p_stop is scaled by size"});
    options.text(
        "terrain.ground", terrain.ground,
        {.meaning = "shipped ground type (see `bannwald info surfaces`) where no grid or polygon says"});
    options.file(
        "terrain.slope_grounds", terrain.slope_grounds,
        {.meaning = "CSV with from_deg, surface: ground types by slope where no grid or polygon says"});
    options.file("terrain.picture", terrain.picture,
                 {.meaning = "aerial picture or map in the system of the DEM, behind the maps of pages and "
                             "over the 3-D view: GeoTIFF, or PNG or JPEG with a world file"});
    options.file(
        "terrain.profile", terrain.profile,
        {.meaning = "instead of all maps: CSV with distance_m, height_m, surface; a run in two dimensions"});
}

}  // namespace coupling
