#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "config/geometry/shape.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "coupling/inputs/release/source_start.hpp"
#include "coupling/inputs/scenario/release_settings.hpp"
#include "coupling/inputs/terrain/terrain_input.hpp"
#include "rockfall/release/release.hpp"

namespace coupling {

/// Stands for the zones that are not named; zones count from 1.
inline constexpr std::uint32_t all_other_zones = 0;

/// Points, lines or polygons from which rocks break off.
struct SourceShape {
    std::uint32_t zone = 0;
    config::Shape shape;
    config::Place place{};  ///< in the file
    std::size_t start = 0;  ///< which of the starts its rocks have
};

/// Where rocks break off, as read: a grid of zones, shapes all of one kind, or wherever it is steep.
struct SourceInput {
    std::optional<config::Raster<double>> grid;
    std::vector<SourceShape> shapes;
    std::vector<SourceStart> starts;  ///< of each shape; of a grid one that says nothing; or of zones
    std::string file;                 ///< name in messages
    bool everywhere = false;          ///< neither: all steep cells of the terrain, zone 1
    bool has_zones = false;           ///< shapes name their zones; otherwise each row is one
    bool by_zone = false;             ///< the starts are those of zones; a zone without one has no rocks
    std::map<std::uint32_t, std::size_t> start_of_zone{};  ///< all_other_zones: of those without one
};

std::optional<SourceInput> read_sources(Reading& reading);

/// Smallest and largest diameter of the rocks before they are shared out.
rockfall::DiameterRange diameters_of(const std::optional<SourceInput>& input, const ReleaseSettings& release);

/// The sources on the terrain, in its coordinates, with their rocks allotted.
///
/// A cell weighs its true surface, plan area / cos(slope); a piece of a line its length; a point 1. Cells of
/// the outer ring, where the terrain ends halfway, points off the terrain and parts of polygons off it are
/// left out with a warning. With release.steeper_than_deg only steeper cells count. Refuses sources of which
/// most lie off the terrain (plausible/source_cover.hpp), sources on NODATA, lines that leave the terrain, a
/// grid on another frame and sources of which none is left.
std::optional<std::vector<rockfall::ReleaseSource>> place_sources(const SourceInput& input,
                                                                  const HeightInput& heights,
                                                                  const rockfall::Terrain& terrain,
                                                                  Reading& reading);

}  // namespace coupling
