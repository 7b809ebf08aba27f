#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "config/grid/raster.hpp"
#include "coupling/inputs/places/records.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "rockfall/parameters.hpp"
#include "rockfall/terrain/breaklines.hpp"
#include "rockfall/terrain/height_noise.hpp"
#include "rockfall/terrain/terrain.hpp"
#include "rockfall/terrain/tin.hpp"

namespace coupling {

/// Ground heights as read, not yet a terrain: a grid, or points, or faces between the points.
struct HeightInput {
    std::optional<config::Raster<double>> grid;  ///< NaN: NODATA
    std::vector<Eigen::Vector3d> points;         ///< absolute coordinates
    std::vector<rockfall::TinFace> faces;        ///< checked; none: points are triangulated
    std::vector<rockfall::PointPair> lines;      ///< between points, to be edges where these are triangulated
    std::vector<std::size_t> filled_cells{};     ///< of the grid, which were holes of it
    bool has_codes = false;                      ///< faces carry the codes of their ground, plus 1
    std::optional<config::Table> mesh_parts;     ///< faces carry the number of their row in it, from 1
    std::vector<LeftOutFace> left_out;           ///< faces that lay below others
    rockfall::HeightNoise noise;                 ///< of the heights, in their coordinates
    std::string file;                            ///< name in messages
    std::string projection;                      ///< text of the .prj beside it

    /// Where codes and sources of the ground are distinguished: the frame of the grid; for points that of the
    /// maps.
    [[nodiscard]] const config::GridFrame& frame() const { return grid ? grid->frame : map_frame; }
    config::GridFrame map_frame;  ///< of the results
};

/// Reads and checks the heights that the scenario names.
std::optional<HeightInput> read_heights(Reading& reading);

/// The points of a text (tables/point_file.hpp).
std::vector<Eigen::Vector3d> read_points(std::string_view text, const std::string& file);

/// Cells of a size over the extent of a frame, from the same south-western corner; size 0 keeps the frame.
config::GridFrame with_cell_size(const config::GridFrame& frame, double cell_size_m);

/// Frame over scattered points; size 0 takes their mean spacing rounded up to 1, 2 or 5 times a power of ten.
config::GridFrame frame_over(const std::vector<Eigen::Vector3d>& points, double cell_size_m);

/// The terrain that rocks feel: heights through the contact zone, triangulated unless they have faces. Throws
/// InputError (data) for one without a face or without relief; ground that lacks inside the outline becomes a
/// problem or a warning (plausible/ground_share.hpp).
rockfall::Terrain build_terrain(const HeightInput& input, const rockfall::GroundLaw& law,
                                double mean_diameter_m, double longest_edge_m, Reading& reading);

/// Heights on the map frame for pictures: of the grid as read; for points of the terrain.
config::Raster<double> heights_on_map(const HeightInput& input, const rockfall::Terrain& terrain);

/// Whether the ground is known at the centre of a cell of a frame, which is that of the heights if these are
/// a grid.
bool has_ground(const HeightInput& input, const config::GridFrame& frame, const rockfall::Terrain& terrain,
                std::size_t cell);

}  // namespace coupling
