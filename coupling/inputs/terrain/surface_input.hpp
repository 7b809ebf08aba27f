#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "config/geometry/shape.hpp"
#include "config/table/declared.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "coupling/inputs/terrain/terrain_input.hpp"
#include "rockfall/slope/slope.hpp"

namespace coupling {

struct SurfacePolygonRow;
const config::Schema<SurfacePolygonRow>& surface_polygon_columns();
struct SlopeGroundRow;
const config::Schema<SlopeGroundRow>& slope_ground_columns();

/// An area whose ground is called by a word in place of a code: a label of terrain.surface_types.
struct GroundWord {
    std::size_t area = 0;  ///< its number
    std::string word;
    config::Place place;
};

/// Which code lies where, as read: a grid, or polygons of which later ones lie on top, or nothing; and what
/// lies where they say nothing, by the slope of the ground.
struct GroundCover {
    std::optional<config::Raster<double>> grid;
    std::vector<config::CodedPolygon> areas;  ///< those of `words` have no code yet
    std::vector<GroundWord> words{};
    std::string file{};                       ///< name in messages
    std::optional<config::Table> by_slope{};  ///< from_deg, surface
};

std::optional<GroundCover> read_ground_cover(Reading& reading);

/// The ground types of a slope and where they lie.
struct GroundMap {
    static constexpr std::uint8_t none = 255;
    std::vector<rockfall::SurfaceType> types;
    config::Raster<std::uint8_t> ids;  ///< index into types; `none`: no ground
};

/// Puts cover, types and heights together. Heights with codes of their own need no cover. Beside heights that
/// are no grid, a grid of codes has a frame of its own, which must reach over all of the terrain. Adds a
/// problem for each code that the table lacks, with the number of its cells, for ground without any code, and
/// for a grid on another frame.
std::optional<GroundMap> match_ground(const HeightInput& heights, const rockfall::Terrain& terrain,
                                      const GroundCover& cover, std::vector<rockfall::SurfaceType> types,
                                      Reading& reading);

/// The map that rocks ask, in coordinates of a terrain: cells without ground, which none of them reaches,
/// carry the first type.
rockfall::SurfaceMap surface_map(const GroundMap& ground, const Eigen::Vector2d& origin_m);

/// Tells where a grid that must lie on the DEM does not. True if it does.
bool check_frame(const config::GridFrame& frame, const std::string& file, const HeightInput& heights,
                 Reading& reading);

}  // namespace coupling
