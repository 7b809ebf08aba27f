#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config/geometry/shape.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "coupling/inputs/systems/extent.hpp"

namespace coupling::plausible {

/// A target, net or area of a file, in coordinates of the input.
struct PlacedThing {
    std::string name;
    std::vector<config::Point2> corners;
    bool is_beyond = false;  ///< no part of it lies on the terrain
    config::Place place{};   ///< where a message about it alone stands
};

/// The things of one setting. Layers are made for a commune or a canton, and a terrain for one slope.
struct ThingsOnTerrain {
    config::Place place;  ///< the file
    std::string_view singular;
    std::vector<PlacedThing> things;
    std::string_view expected;     ///< "targets on the terrain: no rock can arrive elsewhere"
    std::string_view swap_advice;  ///< what to do about exchanged axes
    std::string cut;               ///< see cut_command
};

/// What there is to say of things beyond the terrain: one of the two, or neither.
struct BeyondTerrain {
    std::optional<config::Problem> problem{};
    std::string note{};
};

/// What the caller leaves out, because it lies wholly beyond the terrain, becomes one note with its count. It
/// is one error instead
/// - where a slip of coordinates would bring a thing onto the terrain that lies apart from all others of the
///   file: exchanged axes must not pass as a layer of a larger area;
/// - where nothing of the file lies on the terrain.
BeyondTerrain beyond_terrain(const ThingsOnTerrain& given, const Extent& terrain);

/// The same, said to the reader.
void judge_beyond_terrain(const ThingsOnTerrain& given, const Extent& terrain, Reading& reading);

/// The corners of all parts of a shape.
std::vector<config::Point2> corners_of(const config::Shape& shape);

/// Takes the areas out whose extent lies wholly beyond that of the terrain, as above: a map of ground types
/// or stands. Each has a name. Others are left as they are: cells decide there. Returns which stayed, by
/// their place before.
std::vector<std::size_t> take_out_areas_beyond(std::vector<config::CodedPolygon>& areas,
                                               std::vector<std::string> names, ThingsOnTerrain given,
                                               const Extent& terrain, Reading& reading);

}  // namespace coupling::plausible
